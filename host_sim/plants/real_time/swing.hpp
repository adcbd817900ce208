// The free swing of a Puma 560.
#pragma once

#include <host_sim/plants/real_time/measured.hpp>
#include <robots/puma560.hpp>

namespace host_sim::real_time {

inline FreeMinute<robots::Puma560> puma560_minute() {
  return {hanging<robots::Puma560>({0.0, 1.5, 1.5, 0.1, 0.2, 0.0})};
}

}  // namespace host_sim::real_time

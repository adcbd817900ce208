#include <host_sim/plants/real_time/swing.hpp>

namespace host_sim::real_time {

std::vector<Row> swing_rows() {
  std::vector<Row> rows;
  puma560_minute().add(rows, 1e-4);
  return rows;
}

}  // namespace host_sim::real_time

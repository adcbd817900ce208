// What each improvement of the articulated-body algorithm is worth: a textbook form with one, some or all of them.
#pragma once

#include <stability/routes.hpp>
#include <string>
#include <vector>

namespace stability {

struct AblationRow {
  std::string scenario, scalar, variant;
  double forward = 0.0;
};

/// Every variant on the scenarios that show a difference; of ST7 the median over 300 random sizes.
std::vector<AblationRow> ablation();

}  // namespace stability

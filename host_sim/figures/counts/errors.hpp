// How exact the forms of forward dynamics are on every robot and count model.
#pragma once

#include <string>
#include <vector>

namespace counts {

/// Forward errors of one form on one robot: the largest, over seeded states, of the difference to quadruple precision
/// relative to the state's largest acceleration.
struct Errors {
  std::string robot, algorithm, parameters;
  double in_float = 0.0, in_double = 0.0;
};

/// Of every robot, or of one; a line on standard error for each.
std::vector<Errors> errors(const std::string& robot = {});

}  // namespace counts

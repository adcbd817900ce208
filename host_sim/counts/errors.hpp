// How exact the forms of forward dynamics are on every robot and count model.
#pragma once

#include <string>
#include <vector>

namespace counts {

/// Forward errors over numbers T, one for each form in the order of forms.hpp: the largest, over seeded states, of the
/// difference to quadruple precision relative to the state's largest acceleration. A source for each R and T.
template <class R, class T>
std::vector<double> errors_of();

/// Errors of one form on one robot.
struct Errors {
  std::string robot, algorithm, parameters;
  double in_float = 0.0, in_double = 0.0;
};

/// Of every robot, or of one; a line on standard error for each.
std::vector<Errors> errors(const std::string& robot = {});

}  // namespace counts

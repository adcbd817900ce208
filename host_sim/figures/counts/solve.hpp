// The forms of forward dynamics of a robot behind plain functions, so that a source of its own compiles them.
#pragma once

#include <vector>

namespace counts {

/// A form on a robot over FloatOrDouble: accelerations from positions, speeds and efforts.
using Solve = std::vector<double> (*)(const std::vector<double>& q, const std::vector<double>& qd,
                                      const std::vector<double>& tau);

/// Of every form, in the order of forms.hpp. A source for each R.
template <class R>
std::vector<Solve> solves_of();

}  // namespace counts

// Angles of a description: exact where they are multiples of 90 degrees, in degrees where a whole number says the same.
#pragma once

#include <axial/robot/link_parameters.hpp>

#include <optional>

namespace description {

/// The angle in (-180, 180] degrees as a header reproduces it: a multiple of 90 degrees where it is one to within
/// `rounding` rad, a decimal number of degrees where that gives the same double, radians otherwise.
axial::Angle canonical_angle(long double radians, double rounding = 1e-13);

/// The shortest number of degrees from which Angle::from_degrees makes this very angle, if one of up to 15 digits does.
std::optional<double> exact_degrees(const axial::Angle& angle);

/// Nothing in it is turned: cosine 1, sine 0.
constexpr bool is_zero(const axial::Angle& angle) { return angle.radians == 0.0; }

}  // namespace description

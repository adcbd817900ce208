// Constant angles of a chain, with sines and cosines that are exact where the angle is.
#pragma once

#include <axial/scalar/sincos.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A constant angle: its value in radians and its sine-cosine pair.
struct Angle {
  double radians = 0.0;  ///< its value
  double cos = 1.0;      ///< its cosine
  double sin = 0.0;      ///< its sine
  /// From radians; sine and cosine are the library's own, within 1 ulp.
  static constexpr Angle from_radians(double radians) {
    if (!(radians > -1e9 && radians < 1e9)) return {radians, radians, radians};
    const auto pair = sincos(radians);
    return {radians, pair.cos, pair.sin};
  }
  /// From degrees; multiples of 90 have exact sines and cosines, so that structural zeros are recognised.
  static constexpr Angle from_degrees(double degrees) {
    constexpr double radian = 3.14159265358979323846 / 180.0;
    if (!(degrees > -1e9 && degrees < 1e9)) return {degrees, degrees, degrees};
    const auto quarters = static_cast<long long>(degrees / 90.0);
    if (static_cast<double>(quarters) * 90.0 != degrees) return from_radians(degrees * radian);
    constexpr double sines[] = {0.0, 1.0, 0.0, -1.0};
    const auto quadrant = static_cast<unsigned>(((quarters % 4) + 4) % 4);
    return {degrees * radian, sines[(quadrant + 1) % 4], sines[quadrant]};
  }
};

}  // namespace axial

#include <axial/options/end.hpp>

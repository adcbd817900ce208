// The oracle's number types: double, long double and 113-bit quadruple precision (libquadmath).
#pragma once

#include <quadmath.h>

#include <cmath>
#include <string>

namespace oracle {

__extension__ typedef __float128 quad;

inline double sin(double x) { return std::sin(x); }
inline double cos(double x) { return std::cos(x); }
inline double abs(double x) { return std::fabs(x); }
inline long double sin(long double x) { return std::sin(x); }
inline long double cos(long double x) { return std::cos(x); }
inline long double abs(long double x) { return std::fabs(x); }
inline quad sin(quad x) { return sinq(x); }
inline quad cos(quad x) { return cosq(x); }
inline quad abs(quad x) { return fabsq(x); }

/// The number that decimal digits stand for, to the last bit of quad.
inline quad parse(const std::string& digits) { return strtoflt128(digits.c_str(), nullptr); }

/// pi/2, rounded to T.
template <class T>
T right_angle() {
  static const T value = static_cast<T>(parse("1.5707963267948966192313216916397514420985846996876"));
  return value;
}

/// How many right angles an angle is, if it is T's nearest number to a multiple; otherwise false.
template <class T>
bool is_right_angle(T angle, int& quarters) {
  const T count = angle / right_angle<T>();
  quarters = static_cast<int>(count < T(0) ? count - T(0.5) : count + T(0.5));
  return angle == T(quarters) * right_angle<T>();
}

/// Sine and cosine of a constant angle, exact at right angles.
template <class T>
void sincos_of_constant(T angle, T& sine, T& cosine) {
  constexpr int sines[] = {0, 1, 0, -1};
  int quarters = 0;
  if (!is_right_angle(angle, quarters)) {
    sine = sin(angle), cosine = cos(angle);
    return;
  }
  sine = T(sines[quarters & 3]), cosine = T(sines[(quarters + 1) & 3]);
}

}  // namespace oracle

// Arithmetic of bounds: how large a quantity can be, and how far its computed value can be from the exact one.
#pragma once

#include <axial/fixed/words/round.hpp>
#include <axial/scalar/math.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A vector or number of at most `size` (its norm), computed within `error` (the norm of the difference). Both are
/// worst cases, products hold the second order too: whatever is computed with Balls is proved.
struct Ball {
  double size = 0.0, error = 0.0;  ///< norm of the value, and of its error, at most

  /// Norm of the computed value, at most.
  constexpr double largest() const { return size + error; }
};

/// Bounds of a sum.
constexpr Ball operator+(const Ball& a, const Ball& b) { return {a.size + b.size, a.error + b.error}; }
/// Bounds of a product, its error's second order included.
constexpr Ball operator*(const Ball& a, const Ball& b) {
  return {a.size * b.size, a.size * b.error + b.size * a.error + a.error * b.error};
}
/// A constant multiple; the constant's own rounding is counted where it is rounded.
constexpr Ball operator*(double c, const Ball& b) { return {magnitude(c) * b.size, magnitude(c) * b.error}; }

/// How an arithmetic rounds, for the analysis: its word, its modes, and the error of a sine or cosine.
struct WordRounding {
  int bits;                 ///< of a word
  bool nearest, high_word;  ///< results to nearest or down; products exact or by their upper word
  double turn_error;        ///< of one sine or cosine of a joint
  bool tabled = false;      ///< constants come from a table, each column at one exponent: the looped form

  constexpr double capacity() const { return detail::power_of_two(bits - 1) - 1.0; }  ///< largest raw value of a word
  /// The exponent of a quantity that reaches at most `size`, with a little room for its rounding errors.
  constexpr int exponent(double size) const {
    const double room = 1.0 + 256.0 / detail::power_of_two(bits - 1);
    return detail::fitting_exponent(size * room, capacity());
  }
  /// Unit of numbers at an exponent.
  static constexpr double ulp(int exponent) { return detail::power_of_two(-exponent); }
  /// Error of one stored component at an exponent.
  constexpr double store(int exponent) const { return (nearest ? 0.5 : 1.0) * ulp(exponent); }
  /// Error of a component moved to an exponent; nothing is lost on the way to a finer one.
  constexpr double move(int from, int to) const { return from <= to ? 0.0 : store(to); }
};

/// Rounding of an arithmetic S whose sines and cosines come from axial::sincos.
template <class S>
constexpr WordRounding rounding_of(bool tabled = false) {
  return {S::bits, S::nearest, S::high_word,
          integer::sincos_error + (S::bits == 32 ? 0.0 : detail::power_of_two(-S::unit - 1)), tabled};
}

}  // namespace axial

#include <axial/options/end.hpp>

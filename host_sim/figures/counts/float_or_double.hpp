// A number of which a run says whether it is a float or a double: one instantiation of a kernel gives both results.
#pragma once

#include <axial/scalar/sincos.hpp>

namespace counts {

/// Which of the two a run computes in.
enum class Precision { in_float, in_double };

/// Holds a float or a double. Every operation, comparison and sine is the one that float or double has, whichever
/// `precision` names: so results and decisions are those of the kernel over float or over double. None is inlined, to
/// leave a compiler little to do, and none is a constant expression: what was computed where the precision is not
/// known yet would not compile.
class FloatOrDouble {
 public:
  static inline Precision precision = Precision::in_double;  ///< of all numbers; set before a run, never within one

  constexpr FloatOrDouble() = default;
  /// The nearest float or double.
  static constexpr FloatOrDouble constant(double value) {
    FloatOrDouble result;
    result.value_ = value;
    return result;
  }

  double value() const;  ///< exact in double

  FloatOrDouble operator-() const;
  friend FloatOrDouble operator+(FloatOrDouble a, FloatOrDouble b);
  friend FloatOrDouble operator-(FloatOrDouble a, FloatOrDouble b);
  friend FloatOrDouble operator*(FloatOrDouble a, FloatOrDouble b);
  friend FloatOrDouble operator/(FloatOrDouble a, FloatOrDouble b);
  friend bool operator<(FloatOrDouble a, FloatOrDouble b);
  friend bool operator>(FloatOrDouble a, FloatOrDouble b);
  friend axial::SinCos<FloatOrDouble> sincos(FloatOrDouble x);

 private:
  double value_ = 0.0;  // of a constant unrounded: it is rounded wherever it is used
};

}  // namespace counts

/// As a number of kernels.
template <>
struct axial::NumberTraits<counts::FloatOrDouble> {
  static constexpr bool is_number = true;
  static constexpr counts::FloatOrDouble constant(double value) { return counts::FloatOrDouble::constant(value); }
  static counts::FloatOrDouble epsilon();
};

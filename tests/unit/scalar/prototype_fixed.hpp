// A minimal fixed-point type with unequal exponents: it proves that the kernels' vocabulary of rounding is enough.
#pragma once

#include <axial/scalar/rounding.hpp>
#include <axial/spatial/mat3.hpp>
#include <cmath>

namespace prototype {

/// raw * 2^E in 32 bits, and a sum of products in 64 bits. Nothing mixes exponents or widens by itself.
template <int E>
struct Fx {
  std::int32_t raw{};
  double value() const { return std::ldexp(static_cast<double>(raw), E); }
};
template <int E>
struct Acc {
  std::int64_t raw{};
};

template <int E, int F>
constexpr Acc<E + F> operator*(Fx<E> a, Fx<F> b) {
  return {std::int64_t{a.raw} * b.raw};
}
template <int E>
constexpr Fx<E> operator+(Fx<E> a, Fx<E> b) {
  return {a.raw + b.raw};
}
template <int E>
constexpr Fx<E> operator-(Fx<E> a, Fx<E> b) {
  return {a.raw - b.raw};
}
template <int E>
constexpr Fx<E> operator-(Fx<E> a) {
  return {-a.raw};
}
template <int E>
constexpr bool operator>(Fx<E> a, Fx<E> b) {
  return a.raw > b.raw;
}
template <int E>
constexpr Acc<E> operator+(Acc<E> a, Acc<E> b) {
  return {a.raw + b.raw};
}
template <int E>
constexpr Acc<E> operator-(Acc<E> a, Acc<E> b) {
  return {a.raw - b.raw};
}
template <int E>
constexpr Acc<E> operator-(Acc<E> a) {
  return {-a.raw};
}

/// raw / 2^shift, to nearest; to the left where shift is negative.
constexpr std::int64_t shifted(std::int64_t raw, int shift) {
  if (shift <= 0) return raw * (std::int64_t{1} << -shift);
  return (raw + (std::int64_t{1} << (shift - 1))) >> shift;
}

/// Sines and cosines: |x| <= 1 with 30 fractional bits.
using Unit = Fx<-30>;
/// A turned quantity keeps the exponent of what was turned.
template <int E>
constexpr Fx<E + 30> turned(const Acc<E>& x) {
  return {static_cast<std::int32_t>(shifted(x.raw, 30))};
}

template <int E>
Fx<E> from(double value) {
  return {static_cast<std::int32_t>(std::lround(std::ldexp(value, -E)))};
}

/// 1/D with 20 fractional bits, for D > 2^-11.
template <int E>
constexpr Fx<-20> reciprocal(const Fx<E>& d) {
  return {static_cast<std::int32_t>((std::int64_t{1} << (20 - E)) / d.raw)};
}

}  // namespace prototype

namespace axial {
template <int E>
struct NumberTraits<prototype::Fx<E>> {
  static constexpr bool is_number = true;
  static constexpr prototype::Fx<E> constant(double value) {
    for (int i = E; i < 0; ++i)
      value *= 2.0;
    return {static_cast<std::int32_t>(value)};
  }
};
template <int E>
struct NumberTraits<prototype::Acc<E>> {
  static constexpr bool is_number = true;
};
}  // namespace axial

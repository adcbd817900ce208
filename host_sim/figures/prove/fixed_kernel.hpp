// Fixed point over recorded words: what the library's templates ask of a word that is no native integer.
#pragma once

#include <host_sim/figures/prove/recorded.hpp>

#include <axial/fixed.hpp>

namespace axial {

template <bool to_nearest, bool upper_word>
struct Arithmetic<prove::Int32, to_nearest, upper_word, false> {
  using Word = prove::Int32;
  using Wide = prove::Int64;
  using Bits = prove::Uint64;
  using Upper = prove::Uint32;
  static constexpr bool nearest = to_nearest, high_word = upper_word, checked = false;
  static constexpr int bits = 32, unit = 30;
  static constexpr double capacity = 2147483647.0;
};

namespace detail {

template <>
struct SignedOf<prove::Uint32> {
  using type = prove::Int32;
};

template <>
inline constexpr WordRounding joint_rounding<prove::Int32>{32, true, false, 0.0};

/// Positions: angles as they are, for sincos() below asks for the next turn only; lengths as inputs.
template <class Robot, bool nearest, bool high, class Values>
struct FixedView<Robot, Arithmetic<prove::Int32, nearest, high, false>, Values, role::Position> {
  using S = Arithmetic<prove::Int32, nearest, high, false>;
  const Values& values;
  template <int I>
  constexpr auto operator[](Index<I>) const {
    if constexpr (Robot::chain.links[I].type == JointType::revolute) {
      return Bam<S>{values.values[I].raw};
    } else {
      return Fx<Values::exponent(I), S>{prove::input_word("q" + std::to_string(I + 1), values.values[I].raw)};
    }
  }
};

}  // namespace detail

/// The pair of the next turn, as inputs: what integer::sincos gives has a proof of its own (sine.cpp).
template <bool nearest, bool high>
SinCos<Fx<30, Arithmetic<prove::Int32, nearest, high, false>>> sincos(
    const Bam<Arithmetic<prove::Int32, nearest, high, false>>& angle) {
  const auto pair = integer::sincos(static_cast<std::uint32_t>(angle.raw));
  const std::string number = std::to_string(++prove::Program::active().turns);
  return {{prove::input_word("sin" + number, pair.sin)}, {prove::input_word("cos" + number, pair.cos)}};
}

}  // namespace axial

template <>
class std::numeric_limits<prove::Int32> : public std::numeric_limits<std::int32_t> {};

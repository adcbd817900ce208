// A word that records what is done to it: fixed-point kernels run over it as over std::int32_t.
#pragma once

#include <host_sim/figures/prove/program.hpp>

#include <axial/scalar/inline.hpp>

#include <cstdint>
#include <stdexcept>
#include <type_traits>

namespace prove {

template <int width, bool is_signed>
struct Native;
template <>
struct Native<32, true> {
  using type = std::int32_t;
};
template <>
struct Native<32, false> {
  using type = std::uint32_t;
};
template <>
struct Native<64, true> {
  using type = std::int64_t;
};
template <>
struct Native<64, false> {
  using type = std::uint64_t;
};

/// An integer of `width` bits with its value in this run and, unless it is a constant, the node that made it. The node
/// is congruent to the value modulo 2^width.
template <int width, bool is_signed>
class Recorded {
 public:
  using Value = typename Native<width, is_signed>::type;

  constexpr Recorded() = default;
  template <class T, std::enable_if_t<std::is_integral_v<T>, int> = 0>
  constexpr Recorded(T value) : value_{static_cast<Value>(value)} {}  // NOLINT(google-explicit-constructor)
  Recorded(Value value, int node) : value_{value}, node_{node} {}
  /// As between native integers: to a wider word by value, else modulo 2^width.
  template <int from, bool from_signed>
  constexpr explicit Recorded(const Recorded<from, from_signed>& x)
      : value_{static_cast<Value>(x.value())}, node_{x.is_constant() ? -1 : x.node_for(width)} {}

  [[nodiscard]] constexpr Value value() const { return value_; }
  [[nodiscard]] constexpr bool is_constant() const { return node_ < 0; }
  /// The node behind it, of a constant a new one: the congruent integer that is nearest to zero.
  [[nodiscard]] int node() const {
    return is_constant() ? Program::active().constant(static_cast<std::make_signed_t<Value>>(value_)) : node_;
  }
  /// The node whose value is that of the word, not only congruent to it.
  [[nodiscard]] int settled() const {
    Program& p = Program::active();
    return is_constant() ? p.constant(value_) : p.settle(node_, value_, width, is_signed);
  }
  [[nodiscard]] int node_for(int wider) const { return wider > width ? settled() : node_; }

  friend constexpr Recorded operator+(const Recorded& a, const Recorded& b) {
    return combine(Kind::add, static_cast<Value>(Bits(a.value_) + Bits(b.value_)), a, b);
  }
  friend constexpr Recorded operator-(const Recorded& a, const Recorded& b) {
    return combine(Kind::subtract, static_cast<Value>(Bits(a.value_) - Bits(b.value_)), a, b);
  }
  friend constexpr Recorded operator*(const Recorded& a, const Recorded& b) {
    return combine(Kind::multiply, static_cast<Value>(Bits(a.value_) * Bits(b.value_)), a, b);
  }
  friend constexpr Recorded operator-(const Recorded& a) { return Recorded{0} - a; }
  friend constexpr Recorded operator<<(const Recorded& a, int power) {
    const auto value = static_cast<Value>(power >= width ? 0 : Bits(a.value_) << power);
    if (a.is_constant()) return value;
    return {value, Program::active().shift(Kind::times_power, a.node_, power)};
  }
  /// Down; a sign is a choice, and is claimed to be the one of this run.
  friend constexpr Recorded operator>>(const Recorded& a, int power) {
    const auto value = static_cast<Value>(a.value_ >> (power >= width ? width - 1 : power));
    if (a.is_constant()) return value;
    const Recorded x{value, Program::active().shift(Kind::floor_power, a.settled(), power)};
    return power == width - 1 ? x.pinned() : x;
  }
  /// With a mask that is the same in every run.
  friend constexpr Recorded operator&(const Recorded& a, const Recorded& b) {
    const auto value = static_cast<Value>(a.value_ & b.value_);
    if (a.is_constant() && b.is_constant()) return value;
    return a.is_constant() ? b.masked(a.value_) : a.masked(b.constant_value("a mask"));
  }
  /// With a mask that is the same in every run, or undone by another ^.
  friend constexpr Recorded operator^(const Recorded& a, const Recorded& b) {
    const auto value = static_cast<Value>(a.value_ ^ b.value_);
    if (a.is_constant() && b.is_constant()) return value;
    if (a.is_constant()) return b.flipped(a.value_);
    return b.is_constant() ? a.flipped(b.value_) : exclusive(a, b, value);
  }
  /// With bits that were zero because of a shift.
  friend constexpr Recorded operator|(const Recorded& a, const Recorded& b) {
    const auto value = static_cast<Value>(a.value_ | b.value_);
    if (a.is_constant() && b.is_constant()) return value;
    return a.is_constant() ? b.filled(a.value_) : a.filled(b.constant_value("the right operand of |"));
  }

 private:
  using Bits = std::uint64_t;

  static constexpr Recorded combine(Kind kind, Value value, const Recorded& a, const Recorded& b) {
    if (a.is_constant() && b.is_constant()) return value;
    if (kind == Kind::add && a.is_constant() && a.value_ == 0) return b;
    if (kind != Kind::multiply && b.is_constant() && b.value_ == 0) return a;
    return {value, Program::active().combine(kind, a.node(), b.node())};
  }
  /// This value as a constant; that it is one is a claim.
  [[nodiscard]] Recorded pinned() const {
    Program::active().pin(node_);
    return value_;
  }
  [[nodiscard]] Value constant_value(const char* what) const {
    if (!is_constant()) throw std::logic_error(std::string(what) + " depends on data");
    return value_;
  }
  [[nodiscard]] Recorded masked(Value mask) const {
    if (mask == 0) return 0;
    if (mask == static_cast<Value>(~Value{0})) return *this;
    if ((mask & (mask + 1)) != 0) throw std::logic_error("a mask with holes");
    Program& p = Program::active();
    const int power = 64 - __builtin_clzll(static_cast<unsigned long long>(mask)), whole = settled();
    const int above = p.shift(Kind::times_power, p.shift(Kind::floor_power, whole, power), power);
    const Recorded low{static_cast<Value>(value_ & mask), p.combine(Kind::subtract, whole, above)};
    return power == 1 ? low.pinned() : low;
  }
  [[nodiscard]] Recorded flipped(Value mask) const {
    if (mask == 0) return *this;
    if (mask == static_cast<Value>(~Value{0})) return Recorded{-1} - *this;
    throw std::logic_error("a ^ with a part of a word");
  }
  static Recorded exclusive(const Recorded& a, const Recorded& b, Value value) {
    const Program& p = Program::active();
    for (const auto* x : {&a, &b}) {
      const Node n = p.at(x->node_);
      const int other = x == &a ? b.node_ : a.node_;
      if (n.kind == Kind::exclusive_or && n.left == other) return {value, n.right};
      if (n.kind == Kind::exclusive_or && n.right == other) return {value, n.left};
    }
    return {value, Program::active().combine(Kind::exclusive_or, a.node_, b.node_)};
  }
  [[nodiscard]] Recorded filled(Value bits) const {
    const Node n = Program::active().at(node_);
    if (bits == 0) return *this;
    if (n.kind != Kind::times_power || bits < 0 || Integer{bits} >= prove::power_of_two(n.power))
      throw std::logic_error("a | with bits that may be set");
    return *this + Recorded{bits};
  }

  Value value_{};
  int node_ = -1;
};

using Int32 = Recorded<32, true>;
using Uint32 = Recorded<32, false>;
using Int64 = Recorded<64, true>;
using Uint64 = Recorded<64, false>;

/// An input of the active program; if it is new it stays within sines and cosines.
inline Int32 input_word(const std::string& name, std::int32_t value) {
  constexpr std::int32_t one = 1 << 30;
  return {value, Program::active().input(name, value, -one, one)};
}

/// What kernels ask of their words beyond operators: found beside the words, as those of std::int32_t are in integer.
///@{
inline Int64 multiply(const Int32& a, const Int32& b) { return Int64{a} * Int64{b}; }
inline Int32 multiply_high(const Int32& a, const Int32& b) { return Int32{multiply(a, b) >> 32}; }
inline Uint32 multiply_high_unsigned(const Uint32& a, const Uint32& b) { return Uint32{(Uint64{a} * Uint64{b}) >> 32}; }
/// A choice like that of a mask: the run's, and a claim that it always goes the same way.
inline int leading_zeros(const Uint32& x) {
  const int zeros = __builtin_clz(x.value());
  if (!x.is_constant()) {
    const Integer low = prove::power_of_two(31 - zeros);
    Program::active().claim(x.settled(), low, 2 * low - 1, true);
  }
  return zeros;
}
///@}

}  // namespace prove

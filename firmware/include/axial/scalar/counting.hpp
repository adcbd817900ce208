// A number that records what is done to it: run a kernel over it and read the kernel's cost.
#pragma once

#include <axial/scalar/sincos.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Operations that a kernel's outputs need. Multiplications by +-1 and negations are free, expressions of constants
/// alone are off-line, equal expressions are computed once and what no output needs is not computed: as an optimising
/// compiler leaves it.
struct Operations {
  int mul = 0, add = 0, div = 0, sincos = 0;  ///< operations of that kind; `sincos` counts pairs
  /// All operations but the sine-cosine pairs.
  constexpr int total() const { return mul + add + div; }
  /// Equality of all four counts.
  constexpr bool operator==(const Operations& o) const {
    return mul == o.mul && add == o.add && div == o.div && sincos == o.sincos;
  }
};

/// The record of one run: every operation once, in order.
class Trace {
 public:
  /// What made a value.
  enum class Kind : unsigned char { input, constant, mul, add, sub, div, neg, sine, cosine };
  /// A value: how it was made, and of which.
  struct Node {
    Kind kind = Kind::input;    ///< what made it
    int left = -1, right = -1;  ///< operand's index in the record, -1 for none
    double value = 0.0;         ///< of a constant
  };

  constexpr int input() { return push({Kind::input, -1, -1, 0.0}); }  ///< a run-time input; returns its index
  /// The index of an operation on recorded values: of an equal one where there is one, else of a new one.
  constexpr int record(Node node) {
    const bool commutes = node.kind == Kind::mul || node.kind == Kind::add;
    if (commutes && node.right < node.left) {
      const int left = node.left;
      node.left = node.right;
      node.right = left;
    }
    std::uint32_t slot = hash(node);
    while (slots_[slot] != 0) {
      if (same(nodes_[slots_[slot] - 1], node)) return slots_[slot] - 1;
      slot = (slot + 1) % slots;
    }
    const int index = push(node);
    slots_[slot] = index + 1;
    return index;
  }
  /// Marks a value as an output of the kernel.
  constexpr void need(int node) { live_[node] = true; }
  /// Number of operations that the needed values depend on.
  constexpr Operations operations() const {
    bool live[capacity] = {};
    for (int i = 0; i < size_; ++i)
      live[i] = live_[i];
    Operations total;
    for (int i = size_; i-- > 0;) {
      if (!live[i]) continue;
      if (nodes_[i].left >= 0) live[nodes_[i].left] = true;
      if (nodes_[i].right >= 0) live[nodes_[i].right] = true;
      tally(total, i, live);
    }
    return total;
  }
  /// Whether the record was too short, so that its counts say nothing.
  constexpr bool overflowed() const { return size_ >= capacity; }

 private:
  static constexpr int capacity = 12288;
  static constexpr std::uint32_t slots = 32768;

  static constexpr std::uint32_t hash(const Node& n) {
    std::uint64_t h = static_cast<std::uint64_t>(n.kind) + 8 * static_cast<std::uint64_t>(n.left + 1);
    h = h * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(n.right + 1);
    h = h * 0x9e3779b97f4a7c15u + __builtin_bit_cast(std::uint64_t, n.value + 0.0);
    h *= 0x9e3779b97f4a7c15u;
    return static_cast<std::uint32_t>(h >> 49);
  }
  static constexpr bool same(const Node& a, const Node& b) {
    return a.kind != Kind::input && a.kind == b.kind && a.left == b.left && a.right == b.right &&
           !(a.value < b.value) && !(b.value < a.value);
  }
  constexpr int push(const Node& node) {
    if (size_ < capacity) nodes_[size_++] = node;
    return size_ - 1;
  }
  constexpr void tally(Operations& total, int i, const bool (&live)[capacity]) const {
    const Kind kind = nodes_[i].kind;
    total.mul += kind == Kind::mul ? 1 : 0;
    total.add += kind == Kind::add || kind == Kind::sub ? 1 : 0;
    total.div += kind == Kind::div ? 1 : 0;
    total.sincos += kind == Kind::cosine || (kind == Kind::sine && !pair_is_needed(i, live)) ? 1 : 0;
  }
  // A sine whose cosine is needed too costs nothing more.
  constexpr bool pair_is_needed(int sine, const bool (&live)[capacity]) const {
    for (int i = 0; i < size_; ++i)
      if (live[i] && nodes_[i].kind == Kind::cosine && nodes_[i].left == nodes_[sine].left) return true;
    return false;
  }

  Node nodes_[capacity] = {};
  int slots_[slots] = {};  // open addressing: 1 + node, 0 where free
  bool live_[capacity] = {};
  int size_ = 0;
};

/// Scalar that records its history in a Trace. A constant of the model belongs to no trace.
class Counting {
  using Kind = Trace::Kind;

 public:
  constexpr Counting() = default;
  /// A run-time input.
  constexpr explicit Counting(Trace& trace) : trace_(&trace), node_(trace.input()) {}
  /// A constant of the model.
  constexpr static Counting constant(double value) {
    Counting c;
    c.value_ = value;
    return c;
  }

  /// Marks this value as an output.
  constexpr void need() const {
    if (trace_ != nullptr) trace_->need(node_);
  }

  /// An operation: recorded if an operand depends on a run-time input, else folded.
  ///@{
  friend constexpr Counting operator*(Counting a, Counting b) { return combine(Kind::mul, a, b, a.value_ * b.value_); }
  friend constexpr Counting operator/(Counting a, Counting b) {
    return combine(Kind::div, a, b, b.value_ < 0.0 || b.value_ > 0.0 ? a.value_ / b.value_ : 0.0);
  }
  friend constexpr Counting operator+(Counting a, Counting b) { return combine(Kind::add, a, b, a.value_ + b.value_); }
  friend constexpr Counting operator-(Counting a, Counting b) { return combine(Kind::sub, a, b, a.value_ - b.value_); }
  constexpr Counting operator-() const { return apply(Kind::neg, -value_); }
  ///@}
  // Comparisons are not arithmetic. Between constants they are true; else they say what a healthy state says.
  /// Between constants as it is, else false.
  friend constexpr bool operator<(Counting a, Counting b) {
    return a.is_constant() && b.is_constant() && a.value_ < b.value_;
  }
  /// Comparison of constants as it is, else true.
  friend constexpr bool operator>(Counting a, Counting b) {
    return !(a.is_constant() && b.is_constant()) || a.value_ > b.value_;
  }

  /// A sine-cosine pair; counts once however many of the two are needed.
  friend constexpr SinCos<Counting> sincos(Counting x) {
    return {x.apply(Kind::sine, 0.0), x.apply(Kind::cosine, 0.0)};
  }

 private:
  constexpr Counting(Trace& trace, const Trace::Node& node) : trace_(&trace), node_(trace.record(node)) {}

  constexpr bool is_constant() const { return trace_ == nullptr; }
  constexpr int node_in(Trace& trace) const {
    return trace_ != nullptr ? node_ : trace.record({Kind::constant, -1, -1, value_});
  }
  // Not inlined: a kernel is thousands of operations, and nobody times a count.
  [[gnu::noinline]] constexpr Counting apply(Kind kind, double folded) const {
    return trace_ == nullptr ? constant(folded) : Counting(*trace_, {kind, node_, -1, 0.0});
  }
  [[gnu::noinline]] static constexpr Counting combine(Kind kind, Counting a, Counting b, double folded) {
    Trace* const trace = a.trace_ != nullptr ? a.trace_ : b.trace_;
    if (trace == nullptr) return constant(folded);
    return Counting(*trace, {kind, a.node_in(*trace), b.node_in(*trace), 0.0});
  }

  Trace* trace_ = nullptr;
  int node_ = -1;
  double value_ = 0.0;
};

/// The counting scalar as a number of kernels.
template <>
struct NumberTraits<Counting> {
  static constexpr bool is_number = true;                                                 ///< T is a number
  static constexpr Counting constant(double value) { return Counting::constant(value); }  ///< a constant of the model
  /// Machine epsilon of double.
  static constexpr Counting epsilon() { return Counting::constant(std::numeric_limits<double>::epsilon()); }
};

}  // namespace axial

#include <axial/options/end.hpp>

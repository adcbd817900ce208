#pragma once
/// Numbers that nobody wants to see among numbers that everybody does, made and judged by their bits: whatever a
/// compiler was told of NaN and infinity is told of no line here.

#include <axial/axial.hpp>

#include <cstdint>
#include <cstring>

namespace axial::apps {

/// What became of a call: it said that something is wrong, or ok, rightly or not.
enum class Verdict { refused, right, wrong };

template <class T>
using BitsOfNumber = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
template <class T>
inline constexpr BitsOfNumber<T> exponent_bits =
    BitsOfNumber<T>{sizeof(T) == 4 ? 0xFFu : 0x7FFu} << (sizeof(T) == 4 ? 23 : 52);

/// Whether objects that hold nothing but numbers T hold neither NaN nor infinity.
template <class T, class X, class... Others>
bool all_finite(const X& x, const Others&... others) {
  static_assert(std::is_trivially_copyable_v<X> && sizeof(X) % sizeof(T) == 0);
  constexpr std::size_t bytes = sizeof(X), one = sizeof(T);
  BitsOfNumber<T> words[bytes / one];
  std::memcpy(words, &x, sizeof(X));
  bool finite = true;
  for (const auto word : words)
    finite = finite && (word & exponent_bits<T>) != exponent_bits<T>;
  return (finite && ... && all_finite<T>(others));
}

/// Draws what a call is asked; remembers whether all of it was finite.
class Draw {
 public:
  /// The next call: of four, one is asked numbers alone that a robot may see.
  void next() { finite_ = true, share_ = (share_ + 1) % 4; }
  [[nodiscard]] bool finite() const { return finite_; }

  std::uint32_t bits() {
    state_ ^= state_ << 13, state_ ^= state_ >> 17, state_ ^= state_ << 5;
    return state_ * 0x9E3779B1u;
  }
  /// `size` times what is between -1 and 1, or a hostile number.
  template <class T>
  T number(double size) {
    const T x = bits() % 16 < share_ ? hostile<T>() : usual<T>(size);
    finite_ = finite_ && all_finite<T>(x);
    return x;
  }
  template <class Joints>
  Joints joints(double size) {
    Joints all{};
    for (auto& x : all.values)
      x = number<std::decay_t<decltype(x)>>(size);
    return all;
  }
  template <class T>
  Vec3<T> vector(double size) {
    const T x = number<T>(size), y = number<T>(size);
    return {x, y, number<T>(size)};
  }
  template <class T>
  PayloadBody<T> load() {
    PayloadBody<T> load;
    load.mass = number<T>(0.25) + T(0.25), load.com = vector<T>(0.02);
    load.inertia_com.xx = load.inertia_com.yy = load.inertia_com.zz = number<T>(0.002) + T(0.002);
    finite_ = finite_ && all_finite<T>(load.mass, load.inertia_com.xx);
    return load;
  }
  /// What a scene names.
  template <class S, class T>
  Inputs<S, T> inputs() {
    using Scene = scene_of<S>;
    Inputs<S, T> in{};
    if constexpr (Scene::template has<RuntimeGravity>) in.gravity = {vector<T>(5.0)};
    if constexpr (Scene::template has<Payload>) in.payload = load<T>();
    if constexpr (Scene::template has<TipWrench>) in.tip_wrench = {vector<T>(0.5), vector<T>(0.5)};
    if constexpr (Scene::template has<BaseMotion>) in.base_motion = {vector<T>(1.0), vector<T>(1.0), vector<T>(1.0)};
    if constexpr (Scene::template has<RuntimeTool>) in.tool.position = vector<T>(0.05);
    if constexpr (Scene::template has<SineCosines>)
      for (int i = 0; i < joint_count<S>; ++i) {
        auto& turn = in.turns[i];
        const bool turns = robot_of<S>::chain.links[i].type == JointType::revolute;
        const T sine = turns ? number<T>(0.6) : T(0);
        turn.sin = sine;
        if constexpr (sizeof(T) == 4)
          turn.cos = __builtin_sqrtf(T(1) - sine * sine);
        else
          turn.cos = __builtin_sqrt(T(1) - sine * sine);
        finite_ = finite_ && all_finite<T>(turn);
      }
    return in;
  }

 private:
  template <class T>
  T usual(double size) {
    return static_cast<T>(size * (static_cast<double>(bits()) / 2147483648.0 - 1.0));
  }
  template <class T>
  T hostile() {
    using Bits = BitsOfNumber<T>;
    constexpr Bits infinity = exponent_bits<T>, sign = Bits{1} << (8 * sizeof(T) - 1), lowest = infinity & -infinity;
    const Bits all[] = {infinity,      infinity | sign,     infinity | lowest >> 1,
                        infinity | 1u, infinity - 1,        lowest - 1,
                        lowest,        sign | (lowest - 1), Bits{bits()} << (8 * sizeof(T) - 32) | bits()};
    T x;
    const Bits chosen = all[bits() % 9];
    std::memcpy(&x, &chosen, sizeof(x));
    return x;
  }
  std::uint32_t state_ = 20261127u, share_ = 0;
  bool finite_ = true;
};

/// An answer with a status: ok is right where what was asked and what was answered is finite.
template <class... Finite>
Verdict judged(const Status& status, Finite... finite) {
  return !status.ok() ? Verdict::refused : (... && finite) ? Verdict::right : Verdict::wrong;
}

}  // namespace axial::apps

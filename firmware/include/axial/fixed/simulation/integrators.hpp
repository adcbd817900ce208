// How words are summed over time: integrators in fixed point.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/dynamics/forward_dynamics.hpp>
#include <axial/fixed/simulation/motion.hpp>
#include <axial/simulation/integrators.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// product 2^-shift to nearest, halves up; sets `spilt` where that is more than 64 bits. Below 2^63 - 2^61.
AXIAL_INLINE constexpr std::int64_t moved_product(std::int64_t product, int shift, bool& spilt) {
  constexpr int most = 62;
  const int right = select(is_negative(most - shift), most, select(is_negative(shift), 0, shift));
  const int left = select(is_negative(most + shift), most, select(is_negative(shift), -shift, 0));
  const auto up = static_cast<std::int64_t>(((static_cast<std::uint64_t>(product) << 1) >> right) & 1U);
  const std::int64_t whole = (product >> right) + select(is_negative(-right), 1, 0) * up;
  const auto moved = static_cast<std::int64_t>(static_cast<std::uint64_t>(whole) << left);
  spilt = spilt | ((moved >> left) != whole);
  return moved;
}

/// word + rest 2^-32 += change 2^-32, with rest in [-1/2, 1/2): nothing is lost but where words end.
struct FineSum {
  /// What comes out: the nearest word, and what it lacks.
  std::int64_t word{0};
  std::int32_t rest{0};

  AXIAL_INLINE constexpr FineSum(std::int32_t word_before, std::int32_t rest_before, std::int64_t change, bool& spilt) {
    const std::uint64_t whole = static_cast<std::uint64_t>(std::int64_t{word_before}) << 32;
    const auto before = static_cast<std::int64_t>(whole + static_cast<std::uint64_t>(std::int64_t{rest_before}));
    const std::uint64_t sum = static_cast<std::uint64_t>(before) + static_cast<std::uint64_t>(change);
    const auto after = static_cast<std::int64_t>(sum);
    spilt = spilt | (((before ^ after) & (change ^ after)) < 0);
    word = static_cast<std::int64_t>(sum + 0x80000000U) >> 32;
    rest = static_cast<std::int32_t>(static_cast<std::uint32_t>(sum));
  }
};

/// Sums of words: 64 bits per quantity, of which kernels see the upper word, to nearest. Angles wrap, exactly. A speed
/// or a slide that leaves its word becomes the word that no limit allows, so that the state which it is in is not kept.
template <class S, class Word>
struct Summation<S, Stored<Word>> {
  using T = Stored<Word>;
  using Step = FixedStep;
  using Time = std::uint64_t;
  using Q = Positions<robot_of<S>, T>;
  using V = Velocities<robot_of<S>, T>;
  static constexpr bool is_there = true;
  static constexpr int joints = joint_count<S>;
  AXIAL_INLINE static constexpr FixedStep half(const FixedStep& h) { return h.half(); }
  AXIAL_INLINE static constexpr FixedStep sixth(const FixedStep& h) { return h.sixth(); }
  template <class F>
  AXIAL_INLINE static constexpr void each(int, const F& f) {
    each_of(f, std::make_integer_sequence<int, joints>{});
  }

  template <class X, int I, class A, class... More>
  AXIAL_INLINE static constexpr void add_velocity(X& x, Index<I>, const FixedStep& h, const A& a, const More&... more) {
    constexpr int shift = A::exponent(I) - V::exponent(I) - 32;
    add(x.qd[I], x.qd_rest[I], h.seconds(), shift, a.values[I], more.values[I]...);
  }
  template <class X, int I, class... Rates>
  AXIAL_INLINE static constexpr void add_position(X& x, Index<I>, const FixedStep& h, const Rates&... rates) {
    if constexpr (turns<I>) {
      bool wraps = false;
      const std::int64_t change =
          moved_product(product(h.turns().mantissa, rates.values[I]...), V::exponent(I) + h.turns().shift - 64, wraps);
      const FineSum sum(x.q[I].raw, x.q_rest[I], change, wraps);
      x.q[I].raw = static_cast<std::int32_t>(sum.word), x.q_rest[I] = sum.rest;
    } else {
      constexpr int shift = V::exponent(I) - Q::exponent(I) - 32;
      add(x.q[I], x.q_rest[I], h.seconds(), shift, rates.values[I]...);
    }
  }
  template <class Coefficient, class To, class From, class Rate, int I>
  AXIAL_INLINE static constexpr bool subtract(To& to, const From& from, const Rate& rate, Index<I>) {
    using Words = Arithmetic<Word, true, false>;
    constexpr double coefficient = Coefficient::of(I);
    bool spilt = false;
    const Fx<From::exponent(I), Words> whole{from.values[I].raw};
    if constexpr (coefficient > 0.0) {
      const Fx<Rate::exponent(I), Words> by{rate.values[I].raw};
      to.values[I].raw = saturated<To::exponent(I)>(spilt, whole - Literal<bits_of(coefficient), Words>{} * by).raw;
    } else {
      constexpr Literal<bits_of(1.0), Words> one{};
      to.values[I].raw = saturated<To::exponent(I)>(spilt, one * whole).raw;
    }
    return spilt;
  }
  /// Whether a step is kept: all ones, or 0. A bool for so many words becomes a branch.
  AXIAL_INLINE static constexpr int is_kept(const Status& asked, const Status& led_to) {
    return says(led_to, Status::Code::ok) & ~lost(asked);
  }
  template <class X, int I>
  AXIAL_INLINE static constexpr void keep_joint(int keep, const X& moved, X& x, Index<I>) {
    const auto kept = [keep](auto next, auto last) AXIAL_INLINE { return (next & keep) | (last & ~keep); };
    x.q[I].raw = kept(moved.q[I].raw, x.q[I].raw), x.q_rest[I] = kept(moved.q_rest[I], x.q_rest[I]);
    x.qd[I].raw = static_cast<Word>(kept(moved.qd[I].raw, x.qd[I].raw));
    x.qd_rest[I] = kept(moved.qd_rest[I], x.qd_rest[I]);
  }

  /// The first joint whose speed or slide is beyond its limits, from where formats wrap; or that h is no step.
  template <class X>
  AXIAL_INLINE static constexpr Status judged(const X& x, const FixedStep& h, int) {
    const Status found = beyond(x.q, x.qd);
    return status_from(select(h.is_step(), static_cast<int>(found.code), static_cast<int>(Status::Code::input_limit)),
                       select(h.is_step(), found.joint, -1));
  }
  /// Accelerations of a state or of inputs beyond their limits are 0; of an angle beyond its own they are right.
  AXIAL_INLINE static constexpr bool is_lost(const Status& status) { return is_negative(lost(status)); }
  AXIAL_INLINE static constexpr void name_lost(Status& status, const Q& q, const V& qd) {
    const Status found = beyond(q, qd);
    const bool lost = is_lost(status), fine = found.ok(), told = lost | fine;
    status = status_from(select(told, static_cast<int>(status.code), static_cast<int>(found.code)),
                         select(told, status.joint, found.joint));
  }

 private:
  /// All ones where a is b, else 0; by signs.
  AXIAL_INLINE static constexpr int same(int a, int b) {
    const int off = a ^ b;
    return ~((off | -off) >> (8 * static_cast<int>(sizeof(int)) - 1));
  }
  AXIAL_INLINE static constexpr int says(const Status& status, Status::Code code) {
    return same(static_cast<int>(status.code), static_cast<int>(code));
  }
  AXIAL_INLINE static constexpr int lost(const Status& status) {
    using Code = Status::Code;
    int slid = 0;
    each(joints, [&](auto i) AXIAL_INLINE {
      if constexpr (!turns<decltype(i)::value>) slid |= same(status.joint, decltype(i)::value);
    });
    return says(status, Code::speed_limit) | says(status, Code::input_limit) | says(status, Code::payload_limit) |
           (slid & says(status, Code::position_limit));
  }
  template <int I>
  static constexpr bool turns = turns_of<typename scene_of<S>::Robot>.of[I];
  template <class F, int... I>
  AXIAL_INLINE static constexpr void each_of(const F& f, std::integer_sequence<int, I...>) {
    (f(Index<I>{}), ...);
  }
  /// h rate, or h (a + 2 b + 2 c + d), exactly: below 6 2^60.
  AXIAL_INLINE static constexpr std::int64_t product(std::int32_t h, const T& rate) {
    return integer::multiply(rate.raw, h);
  }
  AXIAL_INLINE static constexpr std::int64_t product(std::int32_t h, const T& a, const T& b, const T& c, const T& d) {
    return product(h, a) + product(h, d) + 2 * (product(h, b) + product(h, c));
  }
  /// value += h rate of a format that ends.
  template <class Value, class... Rates>
  AXIAL_INLINE static constexpr void add(Value& value, std::int32_t& rest, const FixedStep::Scale& h, int shift,
                                         const Rates&... rates) {
    using Own = typename Value::Word;
    bool spilt = false;
    const std::int64_t change = moved_product(product(h.mantissa, rates...), shift + h.shift, spilt);
    const FineSum sum(value.raw, rest, change, spilt);
    const auto word = static_cast<Own>(sum.word);
    spilt = spilt | (word != sum.word);
    value.raw = static_cast<Own>(select(spilt, int{(std::numeric_limits<Own>::min)()}, int{word}));
    rest = sum.rest;
  }
  AXIAL_INLINE static constexpr Status beyond(const Q& q, const V& qd) {
    int first = -1, code = 0;
    each(joints, [&](auto i) AXIAL_INLINE {
      constexpr int joint = decltype(i)::value;
      const auto see = [&](std::int32_t outside, Status::Code own) AXIAL_INLINE {
        code = select((outside != 0) & is_negative(first), static_cast<int>(own), code);
        first = first_found(first, outside != 0, joint);
      };
      constexpr const auto& limits = fixed_limits_of<S, Word>.joints[joint];
      see(limits.speed.outside(qd.values[joint]), Status::Code::speed_limit);  // first: a lost speed moves the slide
      if constexpr (!turns<joint>) see(limits.outside(q.values[joint]), Status::Code::position_limit);
    });
    return status_from(code, first);
  }
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

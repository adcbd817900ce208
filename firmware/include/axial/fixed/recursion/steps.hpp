// Steps of kernels that are others in fixed point: sine_cosines() of the angles themselves, friction in the format of
// the link's effort, what resists a joint's drive, and stages that are functions of their own where registers are few.
#pragma once

#include <axial/fixed/links/fixed_links.hpp>
#include <axial/fixed/words/arithmetic.hpp>
#include <axial/fixed/words/integer_product.hpp>
#include <axial/recursion/drives.hpp>
#include <axial/recursion/joint_screws.hpp>
#include <axial/recursion/resistance.hpp>
#include <axial/recursion/stages.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Words with the exponent InputFormats::sine_cosine.
template <class S, class Word>
struct PairsOf<S, Stored<Word>> {
  using T = Stored<Word>;
  AXIAL_INLINE static constexpr void fill(const Positions<robot_of<S>, T>& q, Joints<robot_of<S>, SinCos<T>>& turns) {
    check_fixed_scene<scene_of<S>, Word>();
    using A = ArithmeticOf<scene_of<S>, Word>;
    for (int i = 0; i < joint_count<S>; ++i) {
      const bool turns_it = detail::described_by<S>::chain.links[i].type == JointType::revolute;
      const auto pair = sincos(Bam<A>{turns_it ? static_cast<std::int32_t>(q[i].raw) : 0});
      turns[i] = {{pair.sin.raw}, {pair.cos.raw}};
    }
  }
};

/// Whether the processor puts products together from halves, and has eight registers for them.
inline constexpr bool has_few_registers = AXIAL_LONG_MULTIPLY == 0;

/// Solves that are repeated find what they share in registers, or with few of those on the stack: 4.7 kB of seven
/// joints, where stage by stage it is less than 1 kB at a time, in less code. A single solve of a smaller arm gains by
/// what it knows of the other stages.
template <class Word, bool nearest, bool high, bool checked>
struct StagesOver<Arithmetic<Word, nearest, high, checked>> {
  template <class Links>
  static constexpr bool apart = has_few_registers &&
                                (Links::halvings() > 0 || Links::second_solve());  ///< as in recursion/stages.hpp
};

}  // namespace detail

/// What belongs to the direction of a speed, 0 at rest.
template <class Link, int E, class S, class F, class B>
AXIAL_INLINE constexpr auto effort_by_direction(const Link& link, const Fx<E, S>& qd, const F& forward,
                                                const B& backward) {
  if constexpr (is_zero_v<F> && is_zero_v<B>) {
    return Zero{};
  } else {
    const quantity::JointEffort effort;
    using Effort = decltype(link.sum(effort, qd));
    const Fx<E, S> still{};
    return select(qd > still, Effort(link.sum(effort, forward)),
                  select(qd < still, Effort(link.sum(effort, backward)), Effort{}));
  }
}

/// A lower bound of D is proved: a reciprocal of fixed length.
template <int E, class S, class Scale>
AXIAL_INLINE constexpr auto resistance(const Fx<E, S>& d, const Scale&) {
  return Resistance{inverse_of(d), std::false_type{}, std::true_type{}};
}

/// Resistance of a link's joint: formats may be made for a usual resistance rather than the least. A joint that feels
/// less than that has a status.
template <class Link, int E, class S, class Scale>
AXIAL_INLINE constexpr auto resistance_at(const Link& link, const Fx<E, S>& d, const Scale& scale) {
  if constexpr (Link::usually_resisted) {
    bool lost = false;
    const auto inverse = inverse_of(link.resisting(lost, d));
    return Resistance{inverse, lost, std::true_type{}};
  } else {
    return resistance(d, scale);
  }
}

}  // namespace axial

#include <axial/options/end.hpp>

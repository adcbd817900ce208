// The state that forward dynamics starts from, and the positions that kinematics and separation start from, against the
// declared limits, in fixed point: beyond them formats wrap.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/limits/inputs_check.hpp>
#include <axial/fixed/limits/joint_limits.hpp>
#include <axial/recursion/forward_soundness.hpp>
#include <axial/recursion/position_soundness.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Joints that are looked at together: two bits each in a word.
inline constexpr int joints_a_word = 15;

/// What is outside the declared limits.
struct Outside {
  int first = -1;          ///< twice the first joint, 1 more where it is its speed; negative for none
  std::int32_t wraps = 0;  ///< not 0 where a format may wrap: every angle has one, so only speeds and slides can
};

/// Two bits of joint I behind those of the joints before: its position, its speed. Where pairs of sines and cosines are
/// given, a turning joint's position is not read and not looked at.
template <class S, class Word, int I, class Q, class V>
AXIAL_INLINE constexpr std::uint32_t with_joint(std::uint32_t found, const Q& q, const V& qd) {
  constexpr const auto& limits = fixed_limits_of<S, Word>.joints[I];
  constexpr bool any_angle = limits.span == (std::numeric_limits<std::uint32_t>::max)();
  constexpr bool unread = scene_of<S>::template has<SineCosines> && turns_of<typename scene_of<S>::Robot>.of[I];
  found = found + found;
  if constexpr (!any_angle && !unread) found -= static_cast<std::uint32_t>(limits.outside(q.values[I]));
  return found + found - static_cast<std::uint32_t>(limits.speed.outside(qd.values[I]));
}

template <class S, class Word, int First, class Q, class V, int... I>
AXIAL_INLINE constexpr Outside outside_limits(const Q& q, const V& qd, std::integer_sequence<int, I...>) {
  constexpr int size = static_cast<int>(sizeof...(I)), all = 2 * size;
  constexpr std::uint32_t wrapping =
      (0U | ... | ((turns_of<typename scene_of<S>::Robot>.of[First + I] ? 1U : 3U) << (all - 2 - 2 * I)));
  std::uint32_t found = 0;
  ((found = with_joint<S, Word, First + I>(found, q, qd)), ...);
  // A 1 behind the last bit, so that zeros end there.
  const int ahead = integer::detail::leading_zeros(found + found + 1U) - (31 - all);
  const Outside here{(2 * First + ahead) | ~((ahead - all) >> 31), static_cast<std::int32_t>(found & wrapping)};
  if constexpr (First + size < joint_count<S>) {
    constexpr int left = joint_count<S> - First - size;
    const Outside there =
        outside_limits<S, Word, First + size>(q, qd, std::make_integer_sequence<int, smaller(left, joints_a_word)>{});
    return {first_found(here.first, true, there.first), here.wraps | there.wraps};
  } else {
    return here;
  }
}

/// Whether the run-time inputs are within what is declared; `ok` where the scene has none.
template <class S, class Word>
AXIAL_INLINE constexpr Status::Code inputs_outside(const Inputs<S, Stored<Word>>& in) {
  const int inputs = static_cast<int>(check_fixed_inputs<S>(in).code);
  if constexpr (scene_of<S>::template has<Payload>)
    return static_cast<Status::Code>(
        select(payload_within<S>(in.payload), inputs, static_cast<int>(Status::Code::payload_limit)));
  else
    return static_cast<Status::Code>(inputs);
}

/// State and inputs of a solve, looked at before it: about 10 instructions per joint on a Cortex-M3, always.
template <class S, class Word>
struct StateCheck<S, Stored<Word>> {
  using T = Stored<Word>;
  Outside joints;
  Status::Code inputs;
  Status shared{};  // of joints that share drives

  AXIAL_INLINE constexpr StateCheck(const Inputs<S, T>& in, const Positions<robot_of<S>, T>& q,
                                    const Velocities<robot_of<S>, T>& qd)
      : joints(outside_limits<S, Word, 0>(q, qd,
                                          std::make_integer_sequence<int, smaller(joint_count<S>, joints_a_word)>{})),
        inputs(inputs_outside<S>(in)) {
    if constexpr (shares_drives_in<typename scene_of<S>::Robot>)
      shared = SharedLimits<S, Word>::status(q, qd, NoMotion{});
  }

  /// Names in the result what the state or the inputs are beyond, inputs first, then the first joint from the base, and
  /// sets its accelerations to 0 where a format may have wrapped.
  template <class Result>
  AXIAL_INLINE constexpr void judge(Result& result) const {
    const bool bad = inputs != Status::Code::ok;
    const std::int32_t kept = (joints.wraps - 1) >> 31 & (static_cast<std::int32_t>(bad) - 1);
    for (int i = 0; i < joint_count<S>; ++i)
      result.values[i].raw &= static_cast<Word>(kept);
    name(result.status);
  }
  /// Puts what is beyond into the status alone.
  AXIAL_INLINE constexpr void name(Status& status) const {
    const bool bad = inputs != Status::Code::ok;
    const int named = ~(joints.first >> 31),
              limit = static_cast<int>(Status::Code::position_limit) + (joints.first & 1);
    const int code = (limit & named) | (static_cast<int>(status.code) & ~named);
    const int joint = (joints.first >> 1 & named) | (status.joint & ~named);
    status = {static_cast<Status::Code>(select(bad, static_cast<int>(inputs), code)), select(bad, -1, joint)};
    if constexpr (shares_drives_in<typename scene_of<S>::Robot>)
      status = status_from(select(status.ok(), static_cast<int>(shared.code), static_cast<int>(status.code)),
                           select(status.ok(), shared.joint, status.joint));
  }
};

template <class S, class Word, class Q, int... I>
AXIAL_INLINE constexpr int first_slide_outside(const Q& q, std::integer_sequence<int, I...>) {
  int first = -1;
  auto look = [&](auto i) AXIAL_INLINE {
    if constexpr (!turns_of<typename scene_of<S>::Robot>.of[i])
      first = first_found(first, fixed_limits_of<S, Word>.joints[i].outside(q.values[i]) != 0, i);
  };
  (look(Index<I>{}), ...);
  return first;
}

/// Inputs beyond what is declared, or the first slide beyond its limits, from where formats wrap. Every
/// angle has its place in them.
template <class S, class Word>
AXIAL_INLINE constexpr Status position_status(const Inputs<S, Stored<Word>>& in,
                                              const Positions<robot_of<S>, Stored<Word>>& q) {
  const Status::Code inputs = inputs_outside<S>(in);
  const int slide = first_slide_outside<S, Word>(q, std::make_integer_sequence<int, joint_count<S>>{});
  constexpr int limit = static_cast<int>(Status::Code::position_limit);
  const bool bad = inputs != Status::Code::ok;
  return {static_cast<Status::Code>(select(bad, static_cast<int>(inputs), limit & ~(slide >> 31))),
          select(bad, -1, slide)};
}

template <class S, class Word>
struct PositionCheck<S, Stored<Word>> {
  using T = Stored<Word>;
  AXIAL_INLINE static constexpr void name(Status& status, const Inputs<S, T>& in, const Positions<robot_of<S>, T>& q) {
    status = position_status<S>(in, q);
    if constexpr (shares_drives_in<typename scene_of<S>::Robot>)
      if (status.ok()) status = SharedLimits<S, Word>::of_position(q, true);
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>

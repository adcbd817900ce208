// The positions that kinematics and separation start from against the declared limits: beyond them slides wrap.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/limits/joint_limits.hpp>
#include <axial/fixed/limits/state_check.hpp>
#include <axial/recursion/position_soundness.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

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

// Checks of run-time requests in fixed point: raw words against raw limits.
#pragma once

#include <axial/control/limits.hpp>
#include <axial/fixed/limits/fixed_limits.hpp>
#include <axial/fixed/limits/inputs_check.hpp>
#include <axial/fixed/limits/joint_limits.hpp>
#include <axial/fixed/limits/state_check.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// x, or the nearest number that a word holds; no branch.
template <class Word>
constexpr Word nearest_word(std::int64_t x) {
  constexpr std::int64_t most = (std::numeric_limits<Word>::max)();
  const std::int64_t over = x - most, under = -most - x;
  const std::int64_t cut = x - (over & ~(over >> 63));
  return static_cast<Word>(cut + (under & ~(under >> 63)));
}

/// Words of the scene, which gives efforts their formats.
template <class S, class Word>
struct LimitsFor<S, Stored<Word>> {
  using T = Stored<Word>;
  using Joint = typename FixedLimits<S, Word>::Joint;
  static constexpr const Joint& joint(int i) { return fixed_limits_of<S, Word>.joints[i]; }

  static constexpr bool reaches(const Joint& l, const Fixed32& q) { return l.reaches(q); }
  static constexpr Fixed32 nearest_position(const Joint& l, const Fixed32& q) {
    return static_cast<const PositionRange&>(l).nearest(q);
  }
  static constexpr Status::Code position_violation(const Joint&, const Fixed32&) {
    return Status::Code::position_limit;
  }
  static constexpr bool allows(const RawMost<Word>& most, const T& x) { return most.allows(x); }
  static constexpr int clamp(const RawMost<Word>& most, T& x) {
    const int outside = static_cast<int>(most.outside(x));
    x = most.nearest(x);
    return outside;
  }
  static constexpr T nearest(const RawMost<Word>& most, const T& x) { return most.nearest(x); }
  static constexpr Status check_inputs(const Inputs<S, T>& in) { return {inputs_outside<S>(in), -1}; }
  /// What is wrong with a state: beyond its limits formats wrap.
  static constexpr Status check_state(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd) {
    return check_request<S>(q, qd, Accelerations<robot_of<S>, T>{});
  }
};

/// Values of drives are held against the limits of joints too.
template <class S, class Word>
struct SharedCheck<S, Stored<Word>> {
  using T = Stored<Word>;
  template <class Check, class U, class V, class A>
  static constexpr Status status(const Check&, const U& u, const V& ud, const A& udd) {
    return SharedLimits<S, Word>::status(u, ud, udd);
  }
  template <class Check, class U>
  static constexpr Status status(const Check&, const U& u) {
    return SharedLimits<S, Word>::of_position(u);
  }
};

}  // namespace detail

/// Whether a run-time payload is within what the robot declares, on raw words in the formats of InputFormats.
template <class S, class Word>
[[nodiscard]] constexpr Status check_payload(const PayloadBody<Stored<Word>>& load) {
  return {detail::payload_within<S>(load) ? Status::Code::ok : Status::Code::payload_limit, -1};
}

}  // namespace axial

#include <axial/options/end.hpp>

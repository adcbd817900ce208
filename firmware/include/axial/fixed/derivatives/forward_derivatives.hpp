// Derivatives of forward dynamics in fixed point, each with a proved bound of its error: accelerations, M^-1 and both
// Jacobians by the structure's answers to one drive per joint, held against M in words.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/derivatives/acceleration_drift.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Derivatives of forward dynamics, and how far each can be from the exact one.
template <class S, class T, class... Wanted>
struct CertifiedDerivatives : ForwardDynamicsDerivatives<S, T, Wanted...> {
  /// Bounds of the results in their formats; the largest word where nothing is known. Its status says nothing.
  ForwardDynamicsDerivatives<S, T, Wanted...> bound{};
};

namespace detail {

/// First joint whose acceleration is beyond what it declares, -1 for none: where the equations at `x` tell, by more
/// than a 256th, which is what Jacobians may be off for; else as the plain answer has it.
template <class S, class T, class Solve, class Requests>
AXIAL_INLINE constexpr int first_beyond(const CertifiedDynamics<S, T>& answer, const Solve& solve, const Requests& x) {
  using C = Certificate<S, T>;
  int first = -1;
  for (int i = 0; i < C::size; ++i) {
    const std::int64_t most = certificate_of<S, T>.inside[i], corrected = std::int64_t{x[i].raw} + solve.correction[i];
    const std::int64_t raw = select_wide(solve.known, corrected, in_requests(answer, i));
    const std::int64_t room = select_wide(solve.known, (most >> 8) + solve.bound[i], 0);
    first = first_found(first, is_less_wide(most + room, wide_magnitude(raw)), i);
  }
  return first;
}

/// Results of inverse dynamics that those of forward dynamics need; looped or certified, a function that is called
/// for each of its accelerations.
template <class S, class T, class Result, bool apart = scene_of<S>::template has<Looped>>
AXIAL_INLINE constexpr auto slopes_for(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                                       const Accelerations<robot_of<S>, T>& qdd, const Inputs<S, T>& in) {
  constexpr bool position = Result::template has<with_acceleration_by_position>;
  constexpr bool velocity = Result::template has<with_acceleration_by_velocity>;
  if constexpr (apart)
    return called([&]() AXIAL_INLINE { return slopes_for<S, T, Result, false>(q, qd, qdd, in); });
  else if constexpr (position && velocity)
    return inverse_dynamics_derivatives<S>(q, qd, qdd, in);
  else if constexpr (position)
    return inverse_dynamics_derivatives<S, with_efforts, with_mass_matrix, with_position_jacobian>(q, qd, qdd, in);
  else if constexpr (velocity)
    return inverse_dynamics_derivatives<S, with_efforts, with_mass_matrix, with_velocity_jacobian>(q, qd, qdd, in);
  else
    return inverse_dynamics_derivatives<S, with_efforts, with_mass_matrix>(q, qd, qdd, in);
}

/// Robots whose M is eliminated in words.
template <class S, class Word>
constexpr void check_looped_solve() {
  check_resistance<scene_of<S>, recursion::ArticulatedBodies>();
  static_assert(drive_units<S, Word>.resisted,
                "axial: looped derivatives of forward dynamics in fixed point lose a joint that moves by itself a "
                "hundred thousand times more easily than with all that it carries; take Looped out of the scene");
}

/// Where derivatives start: from forward dynamics, and the structure's answers to one drive per joint.
template <class S, class T, bool looped>
struct DerivativeStart {};
/// In the looped form, whose articulated bodies have no formats, from an elimination of M in words.
template <class S, class T>
struct DerivativeStart<S, T, true> {
  using Word = typename T::Word;
  static constexpr int size = joint_count<S>;
  std::int32_t columns[size][size] = {};  ///< what answers unit efforts

  /// Solves for what efforts leave at rest, and for unit efforts.
  template <class Result, class Q, class V, class Tau, class Input>
  AXIAL_INLINE constexpr Status accelerate(const Q& q, const V& qd, const Tau& tau, const Input& in,
                                           CertifiedDynamics<S, T>& answer) {
    static_assert((check_looped_solve<S, Word>(), true));
    const auto rest = slopes_for<S, T, Result>(q, qd, typename Certificate<S, T>::Requests{}, in);
    const DriveSolve<S, Word> eliminated(rest.M);
    std::int64_t left[size] = {};
    for (int i = 0; i < size; ++i)
      left[i] = std::int64_t{tau[i].raw} - rest.tau[i].raw;
    std::int32_t words[size] = {};
    int spilt = -1;
    eliminated.accelerations(left, words, spilt);
    for (int i = 0; i < size; ++i) {
      answer.values[i] = {words[i]};
      columns[i][i] = std::int32_t{1} << looped_columns<S, T>.drive[i];
      eliminated.solve(columns[i]);
    }
    return driven_status<S, Word>(words, eliminated.lost(), spilt);
  }
};

/// What there is to say about an answer that the solver calls `plain`; `beyond` is the first joint beyond what it
/// declares, `spilt` the first that has an entry beyond its format.
AXIAL_INLINE constexpr Status derivatives_status(Status plain, int beyond, bool accurate, int spilt) {
  const bool outside = !is_negative(beyond), spills = !is_negative(spilt), answer = is_answer(plain.code);
  int code = select(spills, static_cast<int>(Status::Code::saturated), static_cast<int>(plain.code));
  int joint = select(spills, spilt, plain.joint);
  code = select(accurate, code, static_cast<int>(Status::Code::inaccurate)), joint = select(accurate, joint, -1);
  code = select(outside, static_cast<int>(Status::Code::acceleration_limit), code),
  joint = select(outside, beyond, joint);
  return {static_cast<Status::Code>(select(answer, code, static_cast<int>(plain.code))),
          select(answer, joint, plain.joint)};
}

template <class Result>
inline constexpr bool is_certified = false;
template <class S, class T, class... Wanted>
inline constexpr bool is_certified<CertifiedDerivatives<S, T, Wanted...>> = true;

/// How far d qdd / d q is off where its accelerations are; nothing where no bounds are asked for.
template <class Result, class S, class T, class SlopesAt>
AXIAL_INLINE constexpr auto drift_of(const DerivativeSolve<S, T>& solve, const SlopesAt& slopes_at) {
  if constexpr (is_certified<Result>)
    return AccelerationDrift<S, T>(solve, slopes_at);
  else
    return NoDrift{};
}

/// Results in words, with their bounds where those are CertifiedDerivatives.
template <class Result, class S, class T>
AXIAL_INLINE constexpr Result derivatives_in_words(const Positions<robot_of<S>, T>& q,
                                                   const Velocities<robot_of<S>, T>& qd, const EffortsOf<S, T>& tau,
                                                   const Inputs<S, T>& in) {
  static_assert(std::is_same_v<T, Fixed32>,
                "axial: derivatives of forward dynamics in fixed point are those of Fixed32");
  check_forward_derivable<scene_of<S>, T>();
  using Solve = DerivativeSolve<S, T>;
  Result result{};
  NoBounds none;
  auto& bound = [&]() AXIAL_INLINE -> auto& {
    if constexpr (is_certified<Result>)
      return result.bound;
    else
      return none;
  }
  ();
  CertifiedDynamics<S, T> answer{};
  const StateCheck<S, T> check(in, q, qd);
  constexpr bool looped = scene_of<S>::template has<Looped>;
  DerivativeStart<S, T, looped> start;
  if constexpr (looped)
    answer.status = start.template accelerate<Result>(q, qd, tau, in, answer);
  else
    answer.status = solve<route_over<S, T>, scene_of<S>, T>(in, q, qd, tau, answer);
  const Status plain = answer.status;
  typename Solve::C::Requests x{};
  static_cast<void>(requested<S>(answer, x));

  constexpr bool apart = looped || is_certified<Result>;
  const auto slopes_at = [&](const auto& qdd) AXIAL_INLINE { return slopes_for<S, T, Result, apart>(q, qd, qdd, in); };
  const auto needs = slopes_at(x);
  Solve solve;
  if constexpr (looped)
    solve.set_columns(start.columns);
  else
    solve.set_inverse(q, in);
  solve.hold_against(needs.M);
  solve.correct(tau, needs.tau);
  const int beyond = first_beyond<S, T>(answer, solve, x);
  const bool formatted = (check.joints.wraps == 0) & (check.inputs == Status::Code::ok);
  const bool solved = is_answer(plain.code) & formatted & solve.system.proved;
  const bool known = solved & solve.known, inside = is_negative(beyond);
  if constexpr (Result::template has<with_inverse_mass_matrix>)
    solve.write_inverse(result.M_inverse, bound.M_inverse, solved);
  if constexpr (Result::template has<with_acceleration_by_position>) {
    const auto drift = drift_of<Result>(solve, slopes_at);
    solve.write_slopes(by::Position{}, needs.dtau_dq, drift, result.dqdd_dq, bound.dqdd_dq, known & inside);
  }
  if constexpr (Result::template has<with_acceleration_by_velocity>)
    solve.write_slopes(by::Velocity{}, needs.dtau_dqd, NoDrift{}, result.dqdd_dqd, bound.dqdd_dqd, solved);

  const bool tight = publish<S, T>(answer, solve, x, known), accurate = tight & solve.is_accurate();
  for (int i = 0; i < Solve::size; ++i) {
    result.qdd.values[i] = answer.values[i];
    if constexpr (is_certified<Result>) bound.qdd.values[i] = answer.bound.values[i];
  }
  result.qdd.status = derivatives_status(plain, beyond, accurate, solve.spilt);
  check.judge(result.qdd);
  return result;
}

}  // namespace detail

/// forward_dynamics_derivatives() in 32 bits, with a bound of each result's error.
/// M^-1 starts from the structure's answers to one drive per joint, in the looped form from an elimination of M, is
/// refined once by M in words, and what M leaves of it bounds every solution (mass_inverse.hpp): M, both Jacobians and
/// the efforts at the accelerations found come with certified errors from one pass of inverse_dynamics_derivatives().
/// By how much d qdd / d q is off where those accelerations are, further passes tell (acceleration_drift.hpp). In and
/// out as there, and `bound`: |exact - result|, each in the format of the result, where the robot is what it declares
/// and the inputs are what their words say; the largest word where nothing is known. Status: of forward_dynamics()
/// where it has no answer, and everything is 0; acceleration_limit with the first joint that accelerates at more than
/// it declares by a 256th, and dqdd_dq, whose formats end there, is 0; inaccurate where row sums of |1 - M B| are above
/// 2^-10 in the units of the words, or an acceleration is off by more than a 128th of what its joint declares, at most;
/// saturated with a joint that has an entry beyond its format, which is 0 then, with the largest word for a bound. Up
/// to eight joints. Cost: forward dynamics, inverse_dynamics_derivatives(), and for each joint two solves; looped one
/// pass of inverse_dynamics_derivatives() more, and an elimination; for bounds of dqdd_dq a pass for each joint, and
/// two.
template <class S, class... Wanted, class T>
[[nodiscard]] constexpr CertifiedDerivatives<S, T, Wanted...> certified_forward_dynamics_derivatives(
    const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd, const EffortsOf<S, T>& tau,
    const Inputs<S, T>& in = no_inputs<S, T>()) {
  return detail::derivatives_in_words<CertifiedDerivatives<S, T, Wanted...>, S, T>(q, qd, tau, in);
}

namespace derivatives {

/// Derivatives in words: the certified ones without their bounds.
template <class S, class Word>
struct ForwardOver<S, Stored<Word>> {
  /// The results that are wanted.
  template <class... Wanted, class... Arguments>
  AXIAL_INLINE static constexpr ForwardDynamicsDerivatives<S, Stored<Word>, Wanted...> of(const Arguments&... all) {
    using Result = ForwardDynamicsDerivatives<S, Stored<Word>, Wanted...>;
    return detail::derivatives_in_words<Result, S, Stored<Word>>(all...);
  }
};

}  // namespace derivatives

}  // namespace axial

#include <axial/options/end.hpp>

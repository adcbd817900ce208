// Where derivatives of forward dynamics in words start: accelerations, derivatives of inverse dynamics there, and a
// matrix near M^-1.
#pragma once

#include <axial/fixed/derivatives/derivative_solve.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

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

}  // namespace axial::detail

#include <axial/options/end.hpp>

// How far a result in fixed point can be from the exact one: known to the compiler, usable in a static_assert.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/algorithm.hpp>
#include <axial/fixed/closed_form/scara.hpp>
#include <axial/fixed/links/fixed_links.hpp>
#include <axial/fixed/transmissions/driven_forward_error.hpp>
#include <axial/fixed/transmissions/shared_drives_error.hpp>
#include <axial/scene/joint_roles.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The largest error of each result of an algorithm, for every state inside the declared limits, in its SI unit.
template <int N>
struct ErrorBound {
  static constexpr int size = N;  ///< number of results
  double of[N] = {};              ///< one per result, in its SI unit

  constexpr double operator[](int i) const { return of[i]; }  ///< bound of result i; the index is not checked
  /// The largest bound.
  [[nodiscard]] constexpr double worst() const {
    double most = 0.0;
    for (const double error : of)
      most = error > most ? error : most;
    return most;
  }
};

namespace algorithm {
/// What error_bound() alone is asked for.
///@{
struct Momentum {};         ///< M(q) qd of momentum_terms()
struct MomentumDrift {};    ///< what changes it besides the drives
struct RequestedTorque {};  ///< inverse_dynamics() of what to_fixed_request() makes of real numbers
///@}
}  // namespace algorithm

namespace detail {

template <class Scene, class Word, class Default, class Recursion>
inline constexpr auto& ranges_for =
    ranges_of<Scene, with_rotors<Scene, parameters_of<Scene, Default>>, ArithmeticOf<Scene, Word>, Recursion>;

template <int N>
constexpr ErrorBound<N> bounds_of(const Row<double, N>& errors) {
  ErrorBound<N> bound;
  for (int i = 0; i < N; ++i)
    bound.of[i] = errors[i];
  return bound;
}
template <int N>
constexpr ErrorBound<N> bounds_of(const Ranges<N>& ranges, Ball LinkRange::*quantity) {
  ErrorBound<N> bound;
  for (int i = 0; i < N; ++i)
    bound.of[i] = (ranges.range[i].*quantity).error;
  return bound;
}

/// Refuses what fixed point does not compute: nothing is certified of it.
template <class S, class Recursion>
constexpr void check_bound() {
  check_fixed_scene<scene_of<S>, std::int32_t>();
  static_cast<void>(sizeof(Inputs<S, Fixed32>));
  Forms<scene_of<S>, Fixed32>::template check<said_as<Recursion>>();
}

/// Errors of separated terms, as Separated has the terms.
template <class S>
constexpr Separated<S, double> errors_of(const bounds::SeparatedBounds<joint_count<S>>& all) {
  constexpr int n = joint_count<S>;
  Separated<S, double> errors{};
  for (int i = 0; i < n; ++i) {
    errors.G[i] = all.G[i].bound.error;
    for (int j = 0; j < n; ++j)
      errors.A[i][j] = all.A[i][j].bound.error, errors.C[i][j] = all.C[i][j].bound.error;
    for (int k = 0; k < n * (n - 1) / 2; ++k)
      errors.B[i][k] = all.B[i][k].bound.error;
  }
  return errors;
}

/// Errors of joint values that an algorithm answers, or is given, by their role.
///@{
template <class S, class T>
constexpr auto errors_of_role(role::Effort) {
  return ErrorsOf<S, T>::efforts(0.0);
}
template <class S, class T>
constexpr auto errors_of_role(role::Velocity) {
  return Row<double, joint_count<S>>{};
}
template <class S, class T, class A, class B>
constexpr auto errors_of_role(role::Product<A, B>) {
  using Exponent = RoleExponent<S, typename T::Word>;
  constexpr auto rounding = rounding_of<ArithmeticOf<scene_of<S>, typename T::Word>>();
  const auto errors_a = errors_of_role<S, T>(A{});
  const auto errors_b = errors_of_role<S, T>(B{});
  Row<double, joint_count<S>> errors{};
  for (int i = 0; i < joint_count<S>; ++i) {
    const auto a = bounds::word_of({Exponent::largest(A{}, i), errors_a[i]}, Exponent::of(A{}, i));
    const auto b = bounds::word_of({Exponent::largest(B{}, i), errors_b[i]}, Exponent::of(B{}, i));
    const auto product = a * b;
    errors[i] = product.bound.error + product.terms.rounding(Exponent::of(role::Product<A, B>{}, i), rounding);
  }
  return errors;
}
///@}
template <class Role>
inline constexpr bool is_product = false;
template <class A, class B>
inline constexpr bool is_product<role::Product<A, B>> = true;

}  // namespace detail

/// `error_bound<Scene>(algorithm::inverse_dynamics)`, N m or N per joint; the inputs are taken as the words say. Every
/// rounding of every stored quantity is in it, to second order and beyond, and the errors of sines and cosines:
/// doc/guides/ranges.md. Also for bias and gravity, the closed form, forward dynamics (rad/s^2 or m/s^2), the mass
/// matrix (a bound per row), and for poses and Jacobians the positions (m) of a link's frame. Source: the recursions of
/// doc/guides/ranges.md.
template <class S, class T = Fixed32, class Algorithm,
          std::enable_if_t<
              detail::is_one_of<Algorithm, algorithm::InverseDynamics, algorithm::Bias, algorithm::Gravity>, int> = 0>
[[nodiscard]] constexpr auto error_bound(Algorithm) {
  static_assert((detail::check_bound<S, recursion::NewtonEuler>(), true));
  return detail::bounds_of(detail::ErrorsOf<S, T>::efforts(0.0));
}
/// Error bounds of an algorithm that answers products of joint values, such as power (W).
template <class S, class T = Fixed32, class Algorithm,
          class Role = typename detail::RoleSaid<typename Algorithm::template Answer<S, T>>::type,
          std::enable_if_t<detail::is_product<Role>, int> = 0>
[[nodiscard]] constexpr auto error_bound(Algorithm) {
  static_assert((detail::check_bound<S, recursion::NewtonEuler>(), true));
  return detail::bounds_of(detail::errors_of_role<S, T>(Role{}));
}
/// Error bounds of the torque of a real request, N m or N: its conversion into words is in it. The request is inside
/// the declared limits, as declared.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::RequestedTorque) {
  static_assert((detail::check_bound<S, recursion::NewtonEuler>(), true));
  return detail::bounds_of(detail::ErrorsOf<S, T>::efforts(0.5));
}
/// Error bounds of the SCARA's closed form, N m or N.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::ClosedForm) {
  using A = detail::ArithmeticOf<scene_of<S>, typename T::Word>;
  return detail::bounds_of(closed_form::detail::ScaraTable<S, A>::value, &LinkRange::joint_effort);
}
/// Error bounds of the SCARA's separated terms in closed form, each where Separated has it, in its SI unit.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr Separated<S, double> error_bound(algorithm::ClosedFormSeparation) {
  using A = detail::ArithmeticOf<scene_of<S>, typename T::Word>;
  return detail::errors_of<S>(closed_form::detail::scara_terms<S>(
      mechanism_of<scene_of<S>, FullParameters>, rounding_of<A>(), closed_form::detail::ScaraTable<S, A>::value,
      SeparatedExponents<S, T>::all()));
}
/// Error bounds of the mass matrix, one per row: of its entries up to the diagonal, in their SI units.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::MassMatrix) {
  static_assert((detail::check_bound<S, recursion::CompositeBodies>(), true));
  return detail::bounds_of(detail::ErrorsOf<S, T>::rows());
}
/// Error bounds of the origins of the links' frames, m.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::ForwardKinematics) {
  static_assert((detail::check_bound<S, recursion::Kinematics>(), true));
  return detail::bounds_of(detail::ErrorsOf<S, T>::origins());
}
/// Error bounds of the joints' momenta, N m s or N s.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::Momentum) {
  static_assert((detail::check_bound<S, recursion::Momenta>(), true));
  return detail::bounds_of(detail::ErrorsOf<S, T>::momenta());
}
/// Error bounds of the drifts of the joints' momenta, N m or N.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::MomentumDrift) {
  static_assert((detail::check_bound<S, recursion::Momenta>(), true));
  return detail::bounds_of(detail::ErrorsOf<S, T>::drifts());
}
/// Error bounds of the tool's Jacobian, one per column: the norm of its linear part, in m (of a slide's in 1).
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::Jacobian) {
  static_assert((detail::check_bound<S, recursion::Kinematics>(), true));
  return detail::bounds_of(detail::ErrorsOf<S, T>::columns());
}
/// Error bounds of accelerations, rad/s^2 or m/s^2.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::ForwardDynamics) {
  if constexpr (detail::has_shared_drives<S>) {
    return detail::bounds_of(detail::DrivenForwardError<S, T>::accelerations());
  } else {
    static_assert((detail::check_bound<S, recursion::ArticulatedBodiesAtRest>(), true));
    return detail::bounds_of(
        detail::ranges_for<scene_of<S>, typename T::Word, FullParameters, recursion::ArticulatedBodiesAtRest>,
        &LinkRange::joint_acceleration);
  }
}

}  // namespace axial

#include <axial/options/end.hpp>

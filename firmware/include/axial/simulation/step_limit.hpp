// How large a step may be for what is stiff in a robot.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/simulation/driven_stiffness.hpp>
#include <axial/simulation/integrators.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A largest step, and what there is to say about it. Stands where a number T is asked for.
template <class T>
struct StepLimit {
  T seconds{};      ///< s; infinite where no step is too large, 0 where the status is not ok
  Status status{};  ///< not_finite or angle_range; about no joint

  /// What there is to say against a step of h seconds: nothing, that there is no limit to hold it against, or
  /// input_limit where it is longer, or none.
  [[nodiscard]] constexpr Status judge(const T& h) const {
    return !status.ok() || h <= seconds ? status : Status{Status::Code::input_limit, -1};
  }
  /// the seconds
  [[nodiscard]] AXIAL_INLINE constexpr operator T() const { return seconds; }  // NOLINT(google-explicit-constructor)
};

namespace detail {

/// Says which numbers have no limits: one sentence of words whose sums are not there.
template <class S, class T>
constexpr auto check_limited() {
  check_summed<S, T>();
  static_assert(!is_word<T> || !Summation<S, T>::is_there,
                "axial: how large a step may be is asked in float; give step_limit() axial::to_real<float>(q)");
}

/// w^1/2 M(q)^-1 w^1/2 of the diagonal w, column by column: accelerations of the structure at rest under unit efforts.
template <class Links, class Input, class Q, class T, int N>
constexpr Square<T, N> weighted_mobility(const Links& links, const Input& in, const Q& q, const T (&weight)[N]) {
  Square<T, N> a{};
  Accelerations<robot_of<typename Links::Scene>, T> tau{}, qdd{};
  auto screws = joint_screws(links, in, q);
  auto structure = aba::structure_at_rest(links, in, screws);
  aba::Unwatched unwatched;
  for (int j = 0; j < links.size(); ++j) {
    if (!(weight[j] > T(0))) continue;
    const T root = square_root(weight[j]);
    tau[j] = T(1);
    aba::respond(links, screws, structure, tau, unwatched,
                 [&](auto i, const auto& own) AXIAL_INLINE { qdd[i] = T(own); });
    tau[j] = T(0);
    for (int i = 0; i < links.size(); ++i)
      a.values[i][j] = square_root(weight[i]) * qdd[i] * root;
  }
  return a;
}

/// How stiff springs, dampers and drives are for what they move.
template <class S, class T>
struct StiffnessAt {
  /// bounds at q
  template <class Links, class Q, class Stiffness>
  static constexpr StiffBounds<T> run(const Links& links, const Q& q, const Inputs<S, T>& in, const Stiffness& drive) {
    constexpr int n = joint_count<S>;
    T springs[n] = {}, dampers[n] = {};
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      springs[i] = T(spring_slope(links.link(i)) + drive.stiffness[i]);
      dampers[i] = T(friction_damping(links.link(i), T(0)) + drive.damping[i]);
    });
    return {largest_eigenvalue_bound(weighted_mobility(links, in, q, springs), links.size()),
            largest_eigenvalue_bound(weighted_mobility(links, in, q, dampers), links.size())};
  }
};

// x^2 + 4 y, rooted, without squares that overflow or vanish.
template <class T>
constexpr T root_of(const T& x, const T& y) {
  const T side = T(2) * square_root(y), most = x > side ? x : side;
  if (!(most > T(0)) || !is_finite(most)) return most;
  const T a = x / most, b = side / most;
  return most * square_root(a * a + b * b);
}
/// The largest h with h^2 k + 2 h d <= 4.
template <class T>
constexpr T limit_of(SemiImplicitEuler, const StiffBounds<T>& bounds) {
  return T(4) / (bounds.damping + root_of(bounds.damping, bounds.stiffness));
}
/// Undamped, h w <= 2^(3/2), where the region of stability leaves the imaginary axis; else inside the largest half disc
/// in it, of radius 2.616 (found on a grid of 0.01 degrees).
template <class T>
constexpr T limit_of(RungeKutta4, const StiffBounds<T>& bounds) {
  const T reach = bounds.damping > T(0) ? T(2.615) : T(2.8284271247461900976);
  return reach * T(2) / (bounds.damping + root_of(bounds.damping, bounds.stiffness));
}
template <class T>
constexpr T limit_of(LinearlyImplicitEuler, const StiffBounds<T>&) {
  return std::numeric_limits<T>::infinity();
}

/// Collects what is asked: inputs and positions.
struct SoundPositions {
  using Roles = axial::Roles<role::Position, role::None>;  ///< of its arguments
  /// into `all`
  template <class Links, class Input, class Q, class All>
  static constexpr void run(const Links& links, const Input& in, const Q& q, All& all) {
    collect_inputs(all, links, in);
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      links.link(i).on_joint([&](auto kind) AXIAL_INLINE { all.position(kind, q[i]); });
    });
  }
};

template <class Method, class T, class System, class Q, class S, class Stiffness>
constexpr StepLimit<T> step_limit_in(const System& system, const Q& q, const Inputs<S, T>& in, const Stiffness& drive) {
  const auto links = system.template links<T>();
  Soundness<T> all;
  const StiffBounds<T> bounds = execute<StiffnessAt<S, T>>(links, q, in, drive);
  execute<SoundPositions>(links, in, q, all);
  all.number(bounds.stiffness), all.number(bounds.damping);
  for (int i = 0; i < system.size(); ++i)
    all.number(T(drive.stiffness[i])), all.number(T(drive.damping[i]));
  const Status status = all.status();
  return {status.ok() ? limit_of(Method{}, bounds) : T(0), status};
}

}  // namespace detail

/// The largest step, s, with which a method is stable for the springs and dampers of a robot at position q: joint
/// springs, viscous and smoothed friction (its steepest slope), and the drive's own `stiffness` where given. Infinite
/// without any, and for LinearlyImplicitEuler. Where q, an input or a stiffness is NaN, or something overflows, there
/// is no such step: 0 and the status not_finite; angle_range where sines are not exact. Guaranteed of the motion
/// linearised there, M x'' + D x' + K x = 0: a mode with |x^T M x| = 1 has k = x^T K x at most the largest eigenvalue
/// of M^-1 K, d likewise, and the limit holds for every such pair. Bounds of both eigenvalues come from traces of
/// powers (largest_eigenvalue_bound), so the limit is below the true one of springs alone by at most n^(1/64), 3 % of
/// six joints; where joints that share drives have springs and drives a stiffness too, by sqrt(2) at most. M changes
/// with q, so ask again, or keep a margin; stiffness of gravity, of centrifugal efforts and of contacts is not in it.
/// Costs n structures at rest and O(n^3): for a set-up, not for a tick.
template <class Method, class S, class T, class Stiffness = NoStiffness>
[[nodiscard]] constexpr StepLimit<T> step_limit(const Positions<robot_of<S>, T>& q,
                                                const Inputs<S, T>& in = no_inputs<S, T>(),
                                                const Stiffness& drive = {}) {
  detail::check_limited<S, T>();
  if constexpr (detail::is_word<T>)
    return {};
  else
    return detail::step_limit_in<Method, T>(detail::StaticSystem<S>{}, q, in, drive);
}
/// Overload for a run-time model.
template <class Method, int N, class... F, class T, class Stiffness = NoStiffness, class M = Model<N, F...>>
[[nodiscard]] constexpr StepLimit<T> step_limit(const Model<N, F...>& model, const Positions<M, T>& q,
                                                const Inputs<M, T>& in = no_inputs<M, T>(),
                                                const Stiffness& drive = {}) {
  detail::check_limited<M, T>();
  if constexpr (detail::is_word<T>)
    return {};
  else
    return detail::step_limit_in<Method, T>(detail::ModelSystem<M>{model}, q, in, drive);
}

}  // namespace axial

#include <axial/options/end.hpp>

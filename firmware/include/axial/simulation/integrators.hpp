// Integrators: how a robot moves on by one step of time.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/links/soundness.hpp>
#include <axial/simulation/system.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Where an integrator asks for efforts.
template <class S, class T>
struct Instant {
  const Positions<robot_of<S>, T>& q;    ///< rad or m
  const Velocities<robot_of<S>, T>& qd;  ///< rad/s or m/s
  T time;                                ///< s since step 0
};

/// Efforts and inputs that do not change during a step: what a controller holds. Without any, the robot moves freely.
template <class S, class T>
struct Held {
  EffortsOf<S, T> tau{};  ///< N m or N
  Inputs<S, T> in{};      ///< run-time inputs that the scene names
  /// Fills in efforts and inputs, the same at any instant.
  template <class Where>
  constexpr void operator()(const Where&, EffortsOf<S, T>& effort, Inputs<S, T>& input) const {
    effort = tau, input = in;
  }
};

namespace detail {

/// What drives the robot at an instant.
template <class S, class T>
struct Driven {
  EffortsOf<S, T> tau{};
  Inputs<S, T> in{};
};

template <class Drive, class S, class T>
inline constexpr bool tells_stiffness =
    std::is_invocable_v<const Drive&, const Instant<S, T>&, EffortsOf<S, T>&, Inputs<S, T>&, DriveStiffness<S, T>&>;

template <class S, class T, class Drive>
constexpr Driven<S, T> ask(const Drive& drive, const Instant<S, T>& instant) {
  Driven<S, T> driven{};
  if constexpr (tells_stiffness<Drive, S, T>) {
    DriveStiffness<S, T> ignored{};
    drive(instant, driven.tau, driven.in, ignored);
  } else {
    drive(instant, driven.tau, driven.in);
  }
  return driven;
}

// What is not finite comes first: no later step is right.
constexpr Status first_trouble(const Status& a, const Status& b) {
  return a.ok() || b.code == Status::Code::not_finite ? b : a;
}

}  // namespace detail

/// Semi-implicit (symplectic) Euler: qd' = qd + h a(q, qd), q' = q + h qd'. First order, one evaluation; its energy
/// error stays bounded where there is no friction.
struct SemiImplicitEuler {
  /// order of its error in h, and how often it asks for accelerations
  static constexpr int order = 1, evaluations = 1;

  /// One step of h seconds; `system` answers accelerations. Out: status of forward dynamics.
  template <class System, class X, class T, class Drive>
  [[nodiscard]] static constexpr Status step(const System& system, X& x, T h, const Drive& drive) {
    using S = typename System::Subject;
    const auto driven = detail::ask<S, T>(drive, {x.q, x.qd, x.time(h)});
    const auto a = system.accelerations(x.q, x.qd, driven.tau, driven.in);
    move(system.size(), x, h, a);
    return a.status;
  }

  /// qd += h a, q += h qd.
  template <class X, class T, class A>
  static constexpr void move(int joints, X& x, T h, const A& a) {
    for (int i = 0; i < joints; ++i) {
      detail::add_velocity(x, i, h * a[i]);
      detail::add_position(x, i, h * x.qd[i]);
    }
  }
};

/// The classical Runge-Kutta method of fourth order, four evaluations.
struct RungeKutta4 {
  /// order of its error in h, and how often it asks for accelerations
  static constexpr int order = 4, evaluations = 4;

  /// One step of h seconds; `system` answers accelerations. Out: the first status of the four that was not ok.
  template <class System, class X, class T, class Drive>
  [[nodiscard]] static constexpr Status step(const System& system, X& x, T h, const Drive& drive) {
    using S = typename System::Subject;
    const T half = h * T(0.5), time = x.time(h);
    const auto a = slope<S>(system, x.q, x.qd, time, drive);
    const auto b = behind(system, x, half, a, time + half, drive);
    const auto c = behind(system, x, half, b, time + half, drive);
    const auto d = behind(system, x, h, c, static_cast<T>(x.steps + 1) * h, drive);
    const T sixth = h / T(6);
    for (int i = 0; i < system.size(); ++i) {
      detail::add_position(x, i, sixth * (a.qd[i] + (T(2) * (b.qd[i] + c.qd[i]) + d.qd[i])));
      detail::add_velocity(x, i, sixth * (a.qdd[i] + (T(2) * (b.qdd[i] + c.qdd[i]) + d.qdd[i])));
    }
    return detail::first_trouble(detail::first_trouble(a.status, b.status), detail::first_trouble(c.status, d.status));
  }

 private:
  template <class S, class T>
  struct Slope {
    Velocities<robot_of<S>, T> qd{};
    FreeAccelerations<robot_of<S>, T> qdd{};
    Status status{};
  };

  template <class S, class System, class Q, class V, class T, class Drive>
  [[nodiscard]] static constexpr Slope<S, T> slope(const System& system, const Q& q, const V& qd, T time,
                                                   const Drive& drive) {
    const auto driven = detail::ask<S, T>(drive, {q, qd, time});
    const auto a = system.accelerations(q, qd, driven.tau, driven.in);
    return {qd, a, a.status};
  }
  /// The slope where the slope `last` leads in h.
  template <class System, class X, class T, class Last, class Drive>
  [[nodiscard]] static constexpr auto behind(const System& system, const X& x, T h, const Last& last, T time,
                                             const Drive& drive) {
    auto q = x.q;
    auto qd = x.qd;
    for (int i = 0; i < system.size(); ++i)
      q[i] += h * last.qd[i], qd[i] += h * last.qdd[i];
    return slope<typename System::Subject>(system, q, qd, time, drive);
  }
};

/// Linearly implicit Euler: (M + h D + h^2 K) a = tau - c - g - passive - h K qd, then as SemiImplicitEuler. K and D
/// are the joints' springs, their viscous and smoothed dry friction, and the drive's own stiffness where it tells it
/// (DriveStiffness); they are folded into the articulated inertias, so the step is one recursion, O(n). First order; no
/// step is too large for springs and dampers (of the linear part it is backward Euler), what it does not resolve it
/// damps.
struct LinearlyImplicitEuler {
  /// order of its error in h, and how often it asks for accelerations
  static constexpr int order = 1, evaluations = 1;

  /// One step of h seconds; `system` answers accelerations. Out: status of forward dynamics.
  template <class System, class X, class T, class Drive>
  [[nodiscard]] static constexpr Status step(const System& system, X& x, T h, const Drive& drive) {
    using S = typename System::Subject;
    const Instant<S, T> instant{x.q, x.qd, x.time(h)};
    detail::Driven<S, T> driven{};
    if constexpr (detail::tells_stiffness<Drive, S, T>) {
      DriveStiffness<S, T> stiffness{};
      drive(instant, driven.tau, driven.in, stiffness);
      return solved(system, x, h, driven, stiffness);
    } else {
      drive(instant, driven.tau, driven.in);
      return solved(system, x, h, driven, NoStiffness{});
    }
  }

 private:
  template <class System, class X, class T, class Driven, class Stiffness>
  [[nodiscard]] static constexpr Status solved(const System& system, X& x, T h, const Driven& driven,
                                               const Stiffness& stiffness) {
    const auto a = detail::implicit_accelerations(system, h, x.q, x.qd, driven.tau, driven.in, stiffness);
    SemiImplicitEuler::move(system.size(), x, h, a);
    return a.status;
  }
};

namespace detail {

/// One step on a copy of the state, which is kept where it is finite.
template <class Method, class System, class X, class T, class Drive>
constexpr Status advance_in(const System& system, X& x, T h, const Drive& drive) {
  X moved = x;
  const Status status = Method::step(system, moved, h, drive);
  Soundness<T> all;
  for (int i = 0; i < system.size(); ++i)
    all.number(moved.q[i]), all.number(moved.qd[i]);
  const bool finite = all.status().ok() & (status.code != Status::Code::not_finite);
  for (int i = 0; i < system.size(); ++i)
    keep_joint(finite, moved, x, i);
  x.steps += static_cast<std::uint64_t>(finite);
  return finite ? status : Status{Status::Code::not_finite, -1};
}

}  // namespace detail

/// Moves x on by one step of h seconds: advance<RungeKutta4>(x, h, drive), x a Motion or a CompensatedMotion.
/// `drive(instant, tau, in)` fills the efforts and inputs at an Instant; one with a fourth argument, a
/// DriveStiffness&, tells an implicit method how stiff it is. A Held drive does not change during the step.
/// Out: the first status of forward dynamics that was not ok. Where it is not_finite, or the moved state is not finite
/// (an input was not, or something overflowed: not_finite, joint -1), x stays as it was, its count of steps too; with
/// every other status x is moved all the same. See step_limit.hpp for how large h may be.
template <class Method, class X, class Drive>
[[nodiscard]] constexpr Status advance(X& x, typename X::Scalar h, const Drive& drive) {
  detail::check_fixed_base<typename X::Subject>();
  if constexpr (detail::is_word<typename X::Scalar> || !every_joint_is_resisted<typename X::Subject>())
    return {};  // which was refused
  else
    return detail::advance_in<Method>(detail::StaticSystem<typename X::Subject>{}, x, h, drive);
}
/// Overload for a run-time model.
template <class Method, int N, class... F, class X, class Drive>
[[nodiscard]] constexpr Status advance(const Model<N, F...>& model, X& x, typename X::Scalar h, const Drive& drive) {
  detail::check_fixed_base<Model<N, F...>>();
  if constexpr (detail::is_word<typename X::Scalar>)
    return {};
  else
    return detail::advance_in<Method>(detail::ModelSystem<Model<N, F...>>{model}, x, h, drive);
}

}  // namespace axial

#include <axial/options/end.hpp>

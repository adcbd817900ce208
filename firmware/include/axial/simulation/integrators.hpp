// Integrators: how a robot moves on by one step of time.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/simulation/system.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Where an integrator asks for efforts.
template <class S, class T>
struct Instant {
  const Positions<robot_of<S>, T>& q;           ///< rad or m
  const Velocities<robot_of<S>, T>& qd;         ///< rad/s or m/s
  typename detail::Summation<S, T>::Time time;  ///< s since step 0; in fixed point a count of half steps
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

/// Whether a drive tells how stiff it is; in fixed point, which has no implicit method, none does.
template <class Drive, class S, class T, bool word = is_word<T>>
inline constexpr bool tells_stiffness =
    std::is_invocable_v<const Drive&, const Instant<S, T>&, EffortsOf<S, T>&, Inputs<S, T>&, DriveStiffness<S, T>&>;
template <class Drive, class S, class T>
inline constexpr bool tells_stiffness<Drive, S, T, true> = false;

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

// What leaves no later step right comes first.
template <class Sums>
AXIAL_INLINE constexpr Status first_of(const Status& a, const Status& b) {
  const bool lost = Sums::is_lost(a), later = Sums::is_lost(b), told = !a.ok(), kept = lost | (told & !later);
  return status_from(select(kept, static_cast<int>(a.code), static_cast<int>(b.code)), select(kept, a.joint, b.joint));
}

}  // namespace detail

/// Semi-implicit (symplectic) Euler: qd' = qd + h a(q, qd), q' = q + h qd'. First order, one evaluation; its energy
/// error stays bounded where there is no friction.
struct SemiImplicitEuler {
  /// order of its error in h, and how often it asks for accelerations
  static constexpr int order = 1, evaluations = 1;

  /// One step of h seconds; `system` answers accelerations. Out: status of forward dynamics.
  template <class System, class X, class Step, class Drive>
  [[nodiscard]] static constexpr Status step(const System& system, X& x, const Step& h, const Drive& drive) {
    using S = typename System::Subject;
    const auto driven = detail::ask<S, typename X::Scalar>(drive, {x.q, x.qd, x.time(h)});
    const auto a = system.accelerations(x.q, x.qd, driven.tau, driven.in);
    move(system.size(), x, h, a);
    return a.status;
  }

  /// qd += h a, q += h qd.
  template <class X, class Step, class A>
  static constexpr void move(int joints, X& x, const Step& h, const A& a) {
    using Sums = detail::SummationOf<X>;
    Sums::each(joints, [&](auto i) AXIAL_INLINE {
      Sums::add_velocity(x, i, h, a);
      Sums::add_position(x, i, h, x.qd);
    });
  }
};

/// The classical Runge-Kutta method of fourth order, four evaluations.
struct RungeKutta4 {
  /// order of its error in h, and how often it asks for accelerations
  static constexpr int order = 4, evaluations = 4;

  /// One step of h seconds; `system` answers accelerations. Out: the first status of the four that was not ok.
  template <class System, class X, class Step, class Drive>
  [[nodiscard]] static constexpr Status step(const System& system, X& x, const Step& h, const Drive& drive) {
    using Sums = detail::SummationOf<X>;
    const Step half = Sums::half(h);
    const Start<X>& start = x;  // until its last slope is known
    const auto a = slope(system, start, x.time(h), drive);
    const auto b = behind(system, start, half, a, x.time(h, 1), drive);
    const auto c = behind(system, start, half, b, x.time(h, 1), drive);
    const auto d = behind(system, start, h, c, x.time(h, 2), drive);
    const Step sixth = Sums::sixth(h);
    Sums::each(system.size(), [&](auto i) AXIAL_INLINE {
      Sums::add_position(x, i, sixth, a.qd, b.qd, c.qd, d.qd);
      Sums::add_velocity(x, i, sixth, a.qdd, b.qdd, c.qdd, d.qdd);
    });
    return detail::first_of<Sums>(detail::first_of<Sums>(a.status, b.status),
                                  detail::first_of<Sums>(c.status, d.status));
  }

 private:
  template <class X>
  using Start = Motion<typename X::Subject, typename X::Scalar>;
  template <class S, class T>
  struct Slope {
    Velocities<robot_of<S>, T> qd{};
    FreeAccelerations<subject_of<S, T>, T> qdd{};
    Status status{};
  };

  template <class System, class S, class T, class Time, class Drive>
  [[nodiscard]] static constexpr Slope<S, T> slope(const System& system, const Motion<S, T>& x, const Time& time,
                                                   const Drive& drive) {
    const auto driven = detail::ask<S, T>(drive, {x.q, x.qd, time});
    const auto a = system.accelerations(x.q, x.qd, driven.tau, driven.in);
    return {x.qd, a, a.status};
  }
  /// The slope where the slope `last` leads in h.
  template <class System, class X, class Step, class Last, class Time, class Drive>
  [[nodiscard]] static constexpr auto behind(const System& system, X x, const Step& h, const Last& last,
                                             const Time& time, const Drive& drive) {
    using Sums = detail::SummationOf<X>;
    Sums::each(system.size(), [&](auto i) AXIAL_INLINE {
      Sums::add_position(x, i, h, last.qd);
      Sums::add_velocity(x, i, h, last.qdd);
    });
    return slope(system, x, time, drive);
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
  template <class System, class X, class Step, class Drive>
  [[nodiscard]] static constexpr Status step(const System& system, X& x, const Step& h, const Drive& drive) {
    using S = typename System::Subject;
    using T = typename X::Scalar;
    static_assert(!detail::is_word<T>,
                  "axial: formats follow from how stiff a robot is; declare it and take LinearlyImplicitFor");
    const Instant<S, T> instant{x.q, x.qd, x.time(h)};
    detail::Driven<S, T> driven{};
    if constexpr (detail::is_word<T>) {
      return {};  // which was refused
    } else if constexpr (detail::tells_stiffness<Drive, S, T>) {
      DriveStiffness<S, T> stiffness{};
      drive(instant, driven.tau, driven.in, stiffness);
      return solved(system, x, h, driven, stiffness);
    } else {
      drive(instant, driven.tau, driven.in);
      return solved(system, x, h, driven, NoStiffness{});
    }
  }

 private:
  template <class System, class X, class Step, class Driven, class Stiffness>
  [[nodiscard]] static constexpr Status solved(const System& system, X& x, const Step& h, const Driven& driven,
                                               const Stiffness& stiffness) {
    const auto a = detail::implicit_accelerations(system, h, x.q, x.qd, driven.tau, driven.in, stiffness);
    SemiImplicitEuler::move(system.size(), x, h, a);
    return a.status;
  }
};

namespace detail {

/// One step on a copy of the state, which is kept where it is one.
template <class Method, class System, class X, class Step, class Drive>
constexpr Status advance_in(const System& system, X& x, const Step& h, const Drive& drive) {
  using Sums = SummationOf<X>;
  X moved = x;
  const Status asked = Method::step(system, moved, h, drive), led_to = Sums::judged(moved, h, system.size());
  const auto keep = Sums::is_kept(asked, led_to);
  Sums::each(system.size(), [&](auto i) AXIAL_INLINE { Sums::keep_joint(keep, moved, x, i); });
  x.steps += static_cast<std::uint64_t>(keep & 1);
  return first_of<Sums>(asked, led_to);
}

}  // namespace detail

/// Whether a method is for one step alone, which it knows.
template <class Method>
inline constexpr bool knows_its_step = false;

/// Moves x on by one step of h seconds: advance<RungeKutta4>(x, h, drive), x a Motion or a CompensatedMotion.
/// `drive(instant, tau, in)` fills the efforts and inputs at an Instant; one with a fourth argument, a
/// DriveStiffness&, tells an implicit method how stiff it is. A Held drive does not change during the step.
/// Out: the first status of forward dynamics that was not ok. Where it is not_finite, or the moved state is not finite
/// (an input was not, or something overflowed: not_finite, joint -1), x stays as it was, its count of steps too; with
/// every other status x is moved all the same. See step_limit.hpp for how large h may be.
/// In fixed point (fixed/simulation/integrators.hpp) a state has limits instead: see there.
template <class Method, class X, class Drive>
[[nodiscard]] constexpr Status advance(X& x, StepOf<typename X::Subject, typename X::Scalar> h, const Drive& drive) {
  static_assert(!knows_its_step<Method>, "axial: this method knows its step; call advance<Method>(x, drive)");
  detail::check_fixed_base<typename X::Subject>();
  if constexpr (!detail::SummationOf<X>::is_there || !every_joint_is_resisted<typename X::Subject>())
    return {};  // which was refused
  else
    return detail::advance_in<Method>(detail::StaticSystem<typename X::Subject>{}, x, h, drive);
}
/// Overload for a run-time model.
template <class Method, int N, class... F, class X, class Drive>
[[nodiscard]] constexpr Status advance(const Model<N, F...>& model, X& x,
                                       StepOf<typename X::Subject, typename X::Scalar> h, const Drive& drive) {
  detail::check_fixed_base<Model<N, F...>>();
  if constexpr (!detail::SummationOf<X>::is_there)
    return {};
  else
    return detail::advance_in<Method>(detail::ModelSystem<Model<N, F...>>{model}, x, h, drive);
}

}  // namespace axial

#include <axial/options/end.hpp>

// Dry friction that sticks: a joint at rest stays there, exactly, while what pulls it is less than breaks it away.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/mass_matrix.hpp>
#include <axial/recursion/drives.hpp>
#include <axial/simulation/declared_stiffness.hpp>
#include <axial/simulation/driven_stiffness.hpp>
#include <axial/simulation/integrators.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Whether a robot's friction is smooth somewhere; what a run-time model adds is not known.
template <class R>
constexpr bool is_smoothed() {
  if constexpr (is_described<R>)
    for (const LinkParameters& link : R::chain.links)
      if (link.smooth_speed > 0.0) return true;
  return false;
}

/// Dry friction of a joint, N m or N, as its drive spends it: when sliding forward and backward at the speed at hand,
/// what breaks it away, and what forward dynamics takes at that speed.
template <class T>
struct DryFriction {
  T forward{}, backward{}, breaks_forward{}, breaks_backward{}, taken{};

  template <class Link>
  AXIAL_INLINE static constexpr DryFriction of(const Link& link, const T& qd) {
    const T fall = reciprocal(T(T(One{}) + qd * qd * link.inverse_stribeck_speed2()));
    const T forward = T(link.coulomb_forward()), backward = T(link.coulomb_backward());
    const T more_forward = T(link.stribeck_forward()), more_backward = T(link.stribeck_backward());
    return {forward + more_forward * fall, backward + more_backward * fall, forward + more_forward,
            backward + more_backward, T(friction_effort(link, qd) - link.viscous() * qd)};
  }
};

/// How a joint moves in a step: forward, backward, or not at all.
struct Contact {
  int direction = 0;
  AXIAL_INLINE constexpr bool sticks() const { return direction == 0; }

  /// By a speed: of a joint at rest not at all.
  template <class T>
  AXIAL_INLINE static constexpr Contact of_speed(const T& qd) {
    return {select(qd > T(0), 1, select(qd < T(0), -1, 0))};
  }
  /// After a step that led to the speed v, with the effort `holds` that kept the joint where it sticks: it slides where
  /// that breaks it away, and sticks where friction would turn it around.
  template <class T>
  AXIAL_INLINE constexpr Contact after(const T& v, const T& holds, const DryFriction<T>& dry) const {
    const int broken = select(holds > dry.breaks_forward, 1, select(holds < dry.breaks_backward, -1, 0));
    return {select(sticks(), broken, select(turned(v), 0, direction))};
  }
  /// Whether a speed is against the direction.
  template <class T>
  AXIAL_INLINE constexpr bool turned(const T& v) const {
    return direction > 0 ? v < T(0) : v > T(0);
  }
};

}  // namespace detail

/// Linearly implicit Euler, of friction whose dry part sticks: Coulomb's effort against the direction of motion, and at
/// rest whatever is less than the static effort of that side. A joint that sticks has the speed 0 and its position to
/// the last bit, however long; the others move as if it were locked, to the root of epsilon. Which joints stick is
/// found in a fixed number of passes, each a linearly implicit step in which a joint that sticks has a damper as heavy
/// as the root of 1/epsilon of its inertia: first those at rest; then those that the damper would have to hold with
/// more than their static effort slide, and those that friction would turn around stick. A change that more passes
/// would find is the next step's. A drive may tell how stiff it is (DriveStiffness). The scene names Friction; a joint
/// without a dry part pays for it in vain, and none has a smooth_speed(): smooth friction does not stick. Float and
/// double; for words StickingFor.
struct StickingEuler {
  /// order of its error in h, and how often it asks for accelerations
  static constexpr int order = 1, evaluations = 4;

  /// One step of h seconds; `system` answers accelerations. Out: status of forward dynamics in the last pass.
  template <class System, class X, class Step, class Drive>
  [[nodiscard]] static constexpr Status step(const System& system, X& x, const Step& h, const Drive& drive) {
    using S = typename System::Subject;
    using T = typename X::Scalar;
    static_assert(!detail::is_word<T>,
                  "axial: how joints are held in fixed point follows from the step; take StickingFor");
    static_assert(scene_of<S>::template has<Friction>,
                  "axial: what sticks is dry friction; name Friction in the scene");
    static_assert(!detail::is_smoothed<robot_of<S>>(),
                  "axial: friction that sticks has no smooth_speed(); take it out, or take LinearlyImplicitEuler");
    if constexpr (detail::is_word<T>)
      return {};  // which was refused
    else
      return passes<S, T>(system, x, h, drive);
  }

 private:
  template <class S, class T, class System, class X, class Drive>
  [[nodiscard]] static constexpr Status passes(const System& system, X& x, const T& h, const Drive& drive) {
    const Instant<S, T> instant{x.q, x.qd, x.time(h)};
    detail::Driven<S, T> driven{};
    DriveStiffness<S, T> told{};
    if constexpr (detail::tells_stiffness<Drive, S, T>)
      drive(instant, driven.tau, driven.in, told);
    else
      drive(instant, driven.tau, driven.in);
    State<S, T> state(system, x, driven.in, h);
    Status status{};
    for (int pass = 0; pass < evaluations; ++pass) {
      if (pass > 0) state.change(system.size());
      status = state.solve(system, x, h, driven, told);
    }
    state.move(system.size(), x, h);
    return status;
  }
  /// Joints in a step.
  template <class S, class T>
  struct State {
    static constexpr int n = joint_count<S>;
    detail::DryFriction<T> dry[n] = {};
    detail::Contact contact[n] = {};
    T damper[n] = {}, v[n] = {};  // N m s/rad or N s/m; speed after the step

    template <class System, class X>
    constexpr State(const System& system, const X& x, const Inputs<S, T>& in, const T& h) {
      const auto links = system.template links<T>();
      for_each_link(execute<Actuators>(links), [&](auto i) AXIAL_INLINE {
        dry[i] = detail::DryFriction<T>::of(execute<Actuators>(links).link(i), x.qd[i]);
      });
      const auto mass = system.masses(x.q, in);
      const T heavy = reciprocal(T(h * square_root(NumberTraits<T>::epsilon())));
      for (int i = 0; i < system.size(); ++i)
        contact[i] = detail::Contact::of_speed(x.qd[i]), damper[i] = heavy * mass(i, i);
    }
    constexpr void change(int size) {
      for (int i = 0; i < size; ++i)
        contact[i] = contact[i].after(v[i], T(damper[i] * v[i]), dry[i]);
    }
    template <class System, class X, class Driven>
    constexpr Status solve(const System& system, const X& x, const T& h, const Driven& driven,
                           const DriveStiffness<S, T>& told) {
      auto tau = driven.tau;
      DriveStiffness<S, T> held = told;
      for (int i = 0; i < system.size(); ++i) {
        const T slides = select(contact[i].direction > 0, dry[i].forward, dry[i].backward);
        held.damping[i] = held.damping[i] + select(contact[i].sticks(), damper[i], T(0));
        tau[i] = tau[i] + dry[i].taken - select(contact[i].sticks(), T(damper[i] * x.qd[i]), slides);
      }
      const auto a = detail::implicit_accelerations(system, h, x.q, x.qd, tau, driven.in, held);
      for (int i = 0; i < system.size(); ++i)
        v[i] = x.qd[i] + h * a[i];
      return a.status;
    }
    template <class X>
    constexpr void move(int size, X& x, const T& h) {
      using Sums = detail::SummationOf<X>;
      for (int i = 0; i < size; ++i) {
        const bool turned = contact[i].turned(v[i]), rests = contact[i].sticks() | turned;
        Sums::set_velocity(x, i, select(rests, T(0), v[i]));
        Sums::add_position(x, i, h, x.qd);
      }
    }
  };
};

namespace detail {

/// A drive as stiff as `Stiff` says, besides what it tells itself.
template <class Stiff, class S, class T, class Drive>
struct DeclaredDrive {
  const Drive& drive;
  template <class Where>
  constexpr void operator()(const Where& at, EffortsOf<S, T>& tau, Inputs<S, T>& in, DriveStiffness<S, T>& told) const {
    if constexpr (tells_stiffness<Drive, S, T>)
      drive(at, tau, in, told);
    else
      drive(at, tau, in);
    for (int i = 0; i < joint_count<S>; ++i) {
      told.stiffness[i] = told.stiffness[i] + static_cast<T>(Stiff::stiffness[i]);
      told.damping[i] = told.damping[i] + static_cast<T>(Stiff::damping[i]);
    }
  }
};
/// A step of StickingFor; in words by fixed/simulation/sticking.hpp.
template <class Stiff, class S, class T>
struct StepHeld {
  static_assert(!is_word<T>,
                "axial: joints are held in fixed point by axial/fixed/simulation/sticking.hpp, of Fixed32; include it");
  template <class System, class X, class Step, class Drive>
  static constexpr Status run(const System& system, X& x, const Step& h, const Drive& drive) {
    if constexpr (is_word<T>)
      return {};  // which was refused
    else
      return StickingEuler::step(system, x, h, DeclaredDrive<Stiff, S, T, Drive>{drive});
  }
};

template <class T>
constexpr T limit_of(StickingEuler, const StiffBounds<T>&) {
  return std::numeric_limits<T>::infinity();
}
}  // namespace detail

/// StickingEuler of a step and a stiffness that the compiler knows, as LinearlyImplicitFor has them. It is the method
/// of fixed point, where a joint that sticks is held exactly: the others move as if it were locked, in words; and where
/// WithEndStops do not yield: a joint that would pass a position limit arrives at it, and leaves it when it is pulled
/// away. An angle whose limits are a whole turn apart or more has none of them. There a scene without Friction may have
/// stops, viscous friction and springs are implicit where joints share no drives, and it is Fixed32's.
template <class Stiff>
struct StickingFor {
  /// order of its error in h, and how often it solves for accelerations in words; else as StickingEuler
  static constexpr int order = 1, evaluations = 5;
  static constexpr double seconds = Stiff::step;  ///< of a step

  /// One step of h seconds, which is Stiff::step: advance<Method>(x, drive). Out: status of the last pass.
  template <class System, class X, class Step, class Drive>
  [[nodiscard]] static constexpr Status step(const System& system, X& x, const Step& h, const Drive& drive) {
    return detail::StepHeld<Stiff, typename System::Subject, typename X::Scalar>::run(system, x, h, drive);
  }
};
/// It is for one step.
template <class Stiff>
inline constexpr bool knows_its_step<StickingFor<Stiff>> = true;

}  // namespace axial

#include <axial/options/end.hpp>

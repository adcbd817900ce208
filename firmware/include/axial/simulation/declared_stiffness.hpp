// The linearly implicit step of a stiffness that the compiler knows: for numbers with formats, and for any other.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/links/inputs_soundness.hpp>
#include <axial/robot/chain.hpp>
#include <axial/simulation/integrators.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// K of joint i: the drive's, and the spring's where the scene has it.
template <class S, class Stiff>
constexpr double declared_stiffness(int i) {
  constexpr bool springs = scene_of<S>::template has<JointSprings>;
  return Stiff::stiffness[i] + (springs ? robot_of<S>::chain.links[i].spring_stiffness : 0.0);
}
/// h D + h^2 K of joint i, kg m^2 or kg.
template <class S, class Stiff>
constexpr double stiff_inertia(int i) {
  constexpr double h = Stiff::step;
  const double viscous = scene_of<S>::template has<Friction> ? robot_of<S>::chain.links[i].viscous : 0.0;
  return h * (Stiff::damping[i] + viscous + h * declared_stiffness<S, Stiff>(i));
}

/// The robot whose rotors are as heavy as a step makes them, and whose drives are strong enough for what it adds to
/// efforts: formats follow from both.
template <class S, class Stiff>
struct StiffRobot {
  static constexpr auto chain = [] {
    auto heavier = robot_of<S>::chain;
    for (int i = 0; i < heavier.size; ++i) {
      LinkParameters& link = heavier.links[i];
      const bool has_rotor = scene_of<S>::template has<RotorInertia>;
      const double rotor = has_rotor ? link.gear * link.gear * link.rotor_inertia : 0.0;
      link.rotor_inertia = rotor + stiff_inertia<S, Stiff>(i), link.gear = 1.0;
      const bool drives =
          link.drive_speed_limit < LinkParameters::unlimited && link.drive_speed_limit > link.speed_limit;
      const double speed = drives ? link.drive_speed_limit : link.speed_limit;
      link.effort_limit += Stiff::step * declared_stiffness<S, Stiff>(i) * speed;
    }
    return heavier;
  }();
};
/// The scene with that robot, rotors named.
template <class S, class Stiff, class Scene = scene_of<S>>
struct StiffScene;
template <class S, class Stiff, class R, class... Features>
struct StiffScene<S, Stiff, Scene<R, Features...>> {
  using Robot = StiffRobot<S, Stiff>;
  using type = std::conditional_t<Scene<R, Features...>::template has<RotorInertia>, Scene<Robot, Features...>,
                                  Scene<Robot, Features..., RotorInertia>>;
};

/// h K of joint i.
template <class S, class Stiff>
struct StiffEffort {
  static constexpr double of(int i) { return Stiff::step * declared_stiffness<S, Stiff>(i); }
};

/// The same values of another robot's joints, whose formats are the same.
template <class To, class From>
AXIAL_INLINE constexpr To same_values(const From& from) {
  To to;
  for (int i = 0; i < To::size; ++i)
    to[i] = from[i];
  return to;
}

}  // namespace detail

/// Linearly implicit Euler as LinearlyImplicitEuler, of a step and a stiffness that the compiler knows: in fixed point
/// formats follow from them, so that this is the implicit method there. `Stiff` declares `static constexpr`: step (s),
/// stiffness[] (N m/rad, N/m) and damping[] (N m s/rad, N s/m) of what drives each joint, none negative; efforts are
/// the drive's at the state, as ever. Viscous friction and joint springs of the scene are in it by themselves, smooth
/// friction is not. (M + h D + h^2 K) is the mass matrix of a robot with heavier rotors, so a step is one
/// forward dynamics of that robot, by its route.
template <class Stiff>
struct LinearlyImplicitFor {
  /// order of its error in h, and how often it asks for accelerations
  static constexpr int order = 1, evaluations = 1;
  static constexpr double seconds = Stiff::step;  ///< of a step

  /// One step of h seconds, which is Stiff::step: advance<Method>(x, drive). Out: status of forward dynamics, or
  /// saturated where an effort does not fit its format.
  template <class System, class X, class Step, class Drive>
  [[nodiscard]] static constexpr Status step(const System& system, X& x, const Step& h, const Drive& drive) {
    using S = typename System::Subject;
    using T = typename X::Scalar;
    using Sums = detail::SummationOf<X>;
    using H = typename detail::StiffScene<S, Stiff>::type;
    static_assert(!detail::shares_drives_in<typename scene_of<S>::Robot>,
                  "axial: LinearlyImplicitFor has no joints that share drives; take LinearlyImplicitEuler in float");
    const auto driven = detail::ask<S, T>(drive, {x.q, x.qd, x.time(h)});
    EffortsOf<H, T> left{};
    int lost = -1;
    Sums::each(system.size(), [&](auto i) AXIAL_INLINE {
      const bool spilt = Sums::template subtract<detail::StiffEffort<S, Stiff>>(left, driven.tau, x.qd, i);
      lost = first_found(lost, spilt, i);
    });
    auto a = forward_dynamics<H>(detail::same_values<Positions<robot_of<H>, T>>(x.q),
                                 detail::same_values<Velocities<robot_of<H>, T>>(x.qd), left,
                                 __builtin_bit_cast(Inputs<H, T>, driven.in));
    Sums::name_lost(a.status, x.q, x.qd);
    SemiImplicitEuler::move(system.size(), x, h, a);
    return detail::first_of<Sums>(status_of_first(Status::Code::saturated, lost), a.status);
  }
};
/// It is for one step.
template <class Stiff>
inline constexpr bool knows_its_step<LinearlyImplicitFor<Stiff>> = true;

/// Moves x on by one step of a method that knows it: advance<LinearlyImplicitFor<Stiff>>(x, drive). Else as advance().
template <class Method, class X, class Drive>
[[nodiscard]] constexpr Status advance(X& x, const Drive& drive) {
  using S = typename X::Subject;
  detail::check_fixed_base<S>();
  if constexpr (!detail::SummationOf<X>::is_there || !every_joint_is_resisted<S>()) {
    return {};  // which was refused
  } else {
    constexpr StepOf<S, typename X::Scalar> h(Method::seconds);
    return detail::advance_in<Method>(detail::StaticSystem<S>{}, x, h, drive);
  }
}

}  // namespace axial

#include <axial/options/end.hpp>

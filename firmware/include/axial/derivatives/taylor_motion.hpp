// Joint values that change in time, and Newton and Euler's recursion over Taylor numbers.
#pragma once

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/links/differentiated_links.hpp>
#include <axial/spatial/taylor_screw.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// Joint values with their first and half of their second derivative by time, as kernels index them.
template <class Values, class First, class Second>
struct TaylorValues {
  const Values& values;  ///< referred to
  const First& first;    ///< referred to, per second
  const Second& second;  ///< referred to, per second squared
  /// Value of joint i with its rates.
  template <class I>
  AXIAL_INLINE constexpr auto operator[](I i) const {
    return with_rates(values[i], first[i], half(second[i]));
  }
};
template <class Values, class First, class Second>
TaylorValues(const Values&, const First&, const Second&) -> TaylorValues<Values, First, Second>;

/// z-screw of a joint that moves in time.
template <class Screw, class Q>
AXIAL_INLINE constexpr auto moving_screw(Revolute, const Screw& screw, const Q& q) {
  const auto& rate = linear_of(q);
  return taylor_screw(screw, screw.shift, TurnRates{rate, quadratic_of(q), half(rate) * rate});
}
/// Prismatic overload: the shift changes.
template <class Screw, class Q>
AXIAL_INLINE constexpr auto moving_screw(Prismatic, const Screw& screw, const Q& q) {
  return taylor_screw(screw, with_rates(screw.shift, linear_of(q), quadratic_of(q)), TurnRates<Zero, Zero, Zero>{});
}
/// z-screws of all joints that move in time, by the sines and cosines of `plain` links.
template <class Plain, class Links, class Input, class Q>
AXIAL_INLINE constexpr auto moving_screws(const Plain& plain, const Links& links, const Input& in, const Q& q) {
  auto screws = joint_screws(plain, in, q.values);
  return map_links(links, [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    return link.on_joint([&](auto joint) AXIAL_INLINE { return link.shape(moving_screw(joint, screws[i], q[i])); });
  });
}

/// Calls each(k, effort) for every drive that joints share, as run_in_time() does for joints.
template <class Links, class Input, class U, class V, class A, class J, class S, class Each>
AXIAL_INLINE constexpr void run_drives_in_time(const Links& plain, const Input& in, const U& u, const V& ud,
                                               const A& udd, const J& u3, const S& u4, const Each& each);

/// Calls each(i, effort) for every joint, from the tips on, with a Taylor number: its effort, how that changes and half
/// of how the change changes. RNEA itself, over Taylor numbers. `q3` and `q4` are the third and fourth derivatives of
/// q.
template <class Links, class Input, class Q, class V, class A, class J, class S, class Each>
AXIAL_INLINE constexpr void run_in_time(const Links& plain, const Input& in, const Q& q, const V& qd, const A& qdd,
                                        const J& q3, const S& q4, const Each& each) {
  if constexpr (is_driven<Links>) {
    run_drives_in_time(plain, in, q, qd, qdd, q3, q4, each);
  } else {
    using T = typename Links::Scalar;
    auto links = differentiated<Taylor<T, T, T>>(plain);
    const TaylorValues position{q, qd, qdd};
    rnea::propagate_inward(links, in, position, moving_screws(plain, links, in, position), TaylorValues{qd, qdd, q3},
                           TaylorValues{qdd, q3, q4},
                           [&](auto i, const auto&, const auto& effort) AXIAL_INLINE { each(i, effort); });
  }
}

/// As run_in_time() for the joints that drives share; answers what of their rotors, where those are bodies, drive k
/// feels besides: of_rotor(k). `speeds` and `accelerations` are the drives', with their rates.
template <class Links, class Input, class Q, class V, class A, class J, class S, class W, class B, class Each>
AXIAL_INLINE constexpr auto run_joints_in_time(const Links& plain, const Input& in, const Q& q, const V& qd,
                                               const A& qdd, const J& q3, const S& q4, const W& speeds,
                                               const B& accelerations, const Each& each) {
  if constexpr (Links::Scene::template has<RotorDynamics>) {
    using Kernels = DrivenKernels<Links>;
    using T = typename Links::Scalar;
    const auto links = differentiated<Taylor<T, T, T>>(plain.joints());
    const TaylorValues position{q, qd, qdd};
    const auto motions =
        Kernels::propagate_inward(plain, links, in, position, moving_screws(plain.joints(), links, in, position),
                                  TaylorValues{qd, qdd, q3}, TaylorValues{qdd, q3, q4}, speeds, accelerations, each);
    return [&plain, &in, links, motions](auto k)
               AXIAL_INLINE { return Kernels::effort_on_rotor(plain, links, in, k, motions); };
  } else {
    run_in_time(plain.joints(), in, q, qd, qdd, q3, q4, each);
    return [](auto) AXIAL_INLINE { return Zero{}; };
  }
}

template <class Links, class Input, class U, class V, class A, class J, class S, class Each>
AXIAL_INLINE constexpr void run_drives_in_time(const Links& plain, const Input& in, const U& u, const V& ud,
                                               const A& udd, const J& u3, const S& u4, const Each& each) {
  typename Links::JointValues effort{}, rate{}, curve{};
  const TaylorValues accelerations{udd, u3, u4};
  const auto of_rotor = run_joints_in_time(plain, in, plain.positions(u), plain.rates(ud), plain.rates(udd),
                                           plain.rates(u3), plain.rates(u4), TaylorValues{ud, udd, u3}, accelerations,
                                           [&](auto i, const auto& x) AXIAL_INLINE {
                                             plain.write(effort, i, value_at_0(x));
                                             plain.write(rate, i, linear_of(x));
                                             plain.write(curve, i, quadratic_of(x));
                                           });
  const auto own = plain.actuator_efforts(effort), first = plain.actuator_efforts(rate);
  const auto second = plain.actuator_efforts(curve);
  plain.each_drive([&](auto k) AXIAL_INLINE {
    each(k, with_rates(own[k], first[k], second[k]) + plain.drives().link(k).rotor() * accelerations[k] + of_rotor(k));
  });
}

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>

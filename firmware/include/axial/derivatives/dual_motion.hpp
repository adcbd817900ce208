// Joint values along a direction, and Newton and Euler's recursion over dual numbers.
#pragma once

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/links/differentiated_links.hpp>
#include <axial/recursion/friction_slope.hpp>
#include <axial/spatial/dual_screw.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// Joint values with their direction, as kernels index them.
template <class Values, class Slopes>
struct DualValues {
  const Values& values;  ///< referred to
  const Slopes& slopes;  ///< referred to, in the values' units
  /// Value of joint i with its direction.
  template <class I>
  AXIAL_INLINE constexpr auto operator[](I i) const {
    return with_slope(values[i], slopes[i]);
  }
};
template <class Values, class Slopes>
DualValues(const Values&, const Slopes&) -> DualValues<Values, Slopes>;

/// z-screw of a joint that moves along a direction.
template <class Screw, class D>
AXIAL_INLINE constexpr auto dual_screw(Revolute, const Screw& screw, const D& slope) {
  return axial::dual_screw(screw, screw.shift, slope);
}
/// Prismatic overload: the shift changes.
template <class Screw, class D>
AXIAL_INLINE constexpr auto dual_screw(Prismatic, const Screw& screw, const D& slope) {
  return axial::dual_screw(screw, with_slope(screw.shift, slope), Zero{});
}
/// z-screws of all joints along a direction, by the sines and cosines of `plain` links.
template <class Plain, class Links, class Input, class Q>
AXIAL_INLINE constexpr auto dual_screws(const Plain& plain, const Links& links, const Input& in, const Q& q) {
  auto screws = joint_screws(plain, in, q.values);
  return map_links(links, [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    return link.on_joint([&](auto joint)
                             AXIAL_INLINE { return link.shape(dual_screw(joint, screws[i], q.slopes[i])); });
  });
}

/// Calls each(k, effort) for every drive that joints share, as run_along() does for joints.
template <class Links, class Input, class U, class V, class A, class Each>
AXIAL_INLINE constexpr void run_along_drives(const Links& plain, const Input& in, const U& u, const V& ud, const A& udd,
                                             const Each& each);

/// Calls each(i, effort) for every joint, from the tips on, with a dual number: its effort and how that changes along
/// the direction. RNEA itself, over dual numbers.
template <class Links, class Input, class Q, class V, class A, class Each>
AXIAL_INLINE constexpr void run_along(const Links& plain, const Input& in, const Q& q, const V& qd, const A& qdd,
                                      const Each& each) {
  if constexpr (is_driven<Links>) {
    run_along_drives(plain, in, q, qd, qdd, each);
  } else {
    using T = typename Links::Scalar;
    auto links = differentiated<Dual<T, T>>(plain);
    rnea::propagate_inward(links, in, q, dual_screws(plain, links, in, q), qd, qdd,
                           [&](auto i, const auto&, const auto& effort) AXIAL_INLINE { each(i, effort); });
  }
}

/// As run_along() for the joints that drives share; answers what of their rotors, where those are bodies, drive k feels
/// besides: of_rotor(k).
template <class Links, class Input, class Q, class W, class B, class V, class A, class Each>
AXIAL_INLINE constexpr auto run_along_joints(const Links& plain, const Input& in, const Q& q, const W& qd, const B& qdd,
                                             const V& ud, const A& udd, const Each& each) {
  if constexpr (Links::Scene::template has<RotorDynamics>) {
    using Kernels = DrivenKernels<Links>;
    using T = typename Links::Scalar;
    const auto links = differentiated<Dual<T, T>>(plain.joints());
    const auto screws = dual_screws(plain.joints(), links, in, q);
    const auto motions = Kernels::propagate_inward(plain, links, in, q, screws, qd, qdd, ud, udd, each);
    return [&plain, &in, links, motions](auto k)
               AXIAL_INLINE { return Kernels::effort_on_rotor(plain, links, in, k, motions); };
  } else {
    run_along(plain.joints(), in, q, qd, qdd, each);
    return [](auto) AXIAL_INLINE { return Zero{}; };
  }
}

template <class Links, class Input, class U, class V, class A, class Each>
AXIAL_INLINE constexpr void run_along_drives(const Links& plain, const Input& in, const U& u, const V& ud, const A& udd,
                                             const Each& each) {
  const auto q = plain.positions(u.values), dq = plain.rates(u.slopes);
  const auto qd = plain.rates(ud.values), dqd = plain.rates(ud.slopes), qdd = plain.rates(udd.values);
  const auto dqdd = plain.rates(udd.slopes);  // of another type where accelerations do not change
  typename Links::JointValues efforts{}, changes{};
  const auto of_rotor = run_along_joints(plain, in, DualValues{q, dq}, DualValues{qd, dqd}, DualValues{qdd, dqdd}, ud,
                                         udd, [&](auto i, const auto& effort) AXIAL_INLINE {
                                           plain.write(efforts, i, value_of(effort));
                                           plain.write(changes, i, slope_of(effort));
                                         });
  const auto own = plain.actuator_efforts(efforts), change = plain.actuator_efforts(changes);
  plain.each_drive([&](auto k) AXIAL_INLINE {
    const auto drive = plain.drives().link(k);
    each(k, with_slope(own[k], change[k]) + friction_effort(drive, ud[k]) + drive.rotor() * udd[k] + of_rotor(k));
  });
}

}  // namespace derivatives

/// Friction at a speed that changes: dry friction jumps at rest, where no slope describes it.
template <class Link, class V, class D>
AXIAL_INLINE constexpr auto friction_effort(const Link& link, const Dual<V, D>& qd) {
  return with_slope(friction_effort(link, qd.value), friction_slope(link, qd.value) * qd.slope);
}

}  // namespace axial

#include <axial/options/end.hpp>

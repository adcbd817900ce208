// Joint values along a direction, and Newton and Euler's recursion over dual numbers.
#pragma once

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/links/differentiated_links.hpp>
#include <axial/recursion/friction_slope.hpp>
#include <axial/spatial/moving_screws.hpp>

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

/// Calls each(i, effort) for every joint, from the tips on, with a dual number: its effort and how that changes along
/// the direction. RNEA itself, over dual numbers.
struct Along {
  /// the algorithm
  template <class Links, class Input, class Q, class V, class A, class Each>
  AXIAL_INLINE static constexpr void run(const Links& plain, const Input& in, const Q& q, const V& qd, const A& qdd,
                                         const Each& each) {
    using T = typename Links::Scalar;
    auto links = differentiated<Dual<T, T>>(plain);
    rnea::propagate_inward(links, in, q, dual_screws(plain, links, in, q), qd, qdd,
                           [&](auto i, const auto&, const auto& effort) AXIAL_INLINE { each(i, effort); });
  }
};

}  // namespace derivatives

/// Friction at a speed that changes: dry friction jumps at rest, where no slope describes it.
template <class Link, class V, class D>
AXIAL_INLINE constexpr auto friction_effort(const Link& link, const Dual<V, D>& qd) {
  return with_slope(friction_effort(link, qd.value), friction_slope(link, qd.value) * qd.slope);
}

}  // namespace axial

#include <axial/options/end.hpp>

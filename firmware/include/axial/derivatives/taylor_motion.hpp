// Joint values that change in time, and Newton and Euler's recursion over Taylor numbers.
#pragma once

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/links/differentiated_links.hpp>
#include <axial/spatial/moving_screws.hpp>

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

/// Calls each(i, effort) for every joint, from the tips on, with a Taylor number: its effort, how that changes and half
/// of how the change changes. RNEA itself, over Taylor numbers. `q3` and `q4` are the third and fourth derivatives of
/// q.
struct InTime {
  /// the algorithm
  template <class Links, class Input, class Q, class V, class A, class J, class S, class Each>
  AXIAL_INLINE static constexpr void run(const Links& plain, const Input& in, const Q& q, const V& qd, const A& qdd,
                                         const J& q3, const S& q4, const Each& each) {
    using T = typename Links::Scalar;
    auto links = differentiated<Taylor<T, T, T>>(plain);
    const TaylorValues position{q, qd, qdd};
    rnea::propagate_inward(links, in, position, moving_screws(plain, links, in, position), TaylorValues{qd, qdd, q3},
                           TaylorValues{qdd, q3, q4},
                           [&](auto i, const auto&, const auto& effort) AXIAL_INLINE { each(i, effort); });
  }
};

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>

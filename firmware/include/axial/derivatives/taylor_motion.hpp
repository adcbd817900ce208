// Joint values that change in time or along a direction, and Newton and Euler's recursion over Taylor numbers.
#pragma once

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/links/links.hpp>
#include <axial/recursion/drive_slopes.hpp>
#include <axial/spatial/taylor_screw.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// A link of a table that keeps numbers with derivatives; its constants are plain ones.
template <class Number, class Link>
struct DifferentiatedLink : Link {
  /// The form in which this view keeps a result.
  template <class V>
  AXIAL_INLINE static constexpr auto shape(const V& v) {
    return v.template dense<Number>();
  }
};
/// Links of a table that keep numbers with derivatives.
template <class Number, class Links>
struct DifferentiatedTable : Links {
  using Dense = Number;  ///< what kernels keep
  AXIAL_INLINE constexpr auto link(int i) const {
    return DifferentiatedLink<Number, decltype(Links::link(i))>{Links::link(i)};
  }  ///< link i as algorithms see it
};
/// Links that may keep numbers with derivatives: those that the compiler knows keep whatever type comes.
template <class Number, class Links>
AXIAL_INLINE constexpr auto differentiated(const Links& links) {
  if constexpr (Links::unrolled)
    return links;
  else
    return DifferentiatedTable<Number, Links>{links};
}

/// Joint values with their first and half of their second derivative, as kernels index them; along a direction with the
/// first alone.
template <class Values, class First, class Second>
struct TaylorValues {
  static constexpr bool cut_off = std::is_same_v<Second, CutOff>;  ///< whether a second derivative is asked for
  const Values& values;                                            ///< referred to
  const First& first;                                              ///< referred to, per second or unit of a direction
  const Second& second;                                            ///< referred to, per second squared

  /// in time
  AXIAL_INLINE constexpr TaylorValues(const Values& at_0, const First& rates, const Second& curves)
      : values(at_0), first(rates), second(curves) {}
  /// along a direction
  AXIAL_INLINE constexpr TaylorValues(const Values& at_0, const First& slopes)
      : values(at_0), first(slopes), second(Dual<Zero, Zero>::quadratic) {}

  /// What a kernel over numbers T computes with.
  template <class T>
  using Of = Taylor<T, T, std::conditional_t<cut_off, CutOff, T>>;
  /// Value of joint i with its rates.
  template <class I>
  AXIAL_INLINE constexpr auto operator[](I i) const {
    if constexpr (cut_off)
      return with_slope(values[i], first[i]);
    else
      return with_rates(values[i], first[i], half(second[i]));
  }
};
template <class Values, class First>
TaylorValues(const Values&, const First&) -> TaylorValues<Values, First, CutOff>;
template <class Values, class First, class Second>
TaylorValues(const Values&, const First&, const Second&) -> TaylorValues<Values, First, Second>;

/// z-screw of a joint that moves.
template <class Screw, class Q>
AXIAL_INLINE constexpr auto moving_screw(Revolute, const Screw& screw, const Q& q) {
  const auto& rate = linear_of(q);
  if constexpr (std::is_same_v<std::decay_t<decltype(quadratic_of(q))>, CutOff>)
    return taylor_screw(screw, screw.shift, TurnRates{rate, CutOff{}, CutOff{}});
  else
    return taylor_screw(screw, screw.shift, TurnRates{rate, quadratic_of(q), half(rate) * rate});
}
/// Prismatic overload: the shift changes.
template <class Screw, class Q>
AXIAL_INLINE constexpr auto moving_screw(Prismatic, const Screw& screw, const Q& q) {
  return taylor_screw(screw, with_rates(screw.shift, linear_of(q), quadratic_of(q)), TurnRates<Zero, Zero, Zero>{});
}
/// z-screws of all joints that move, by the sines and cosines of `plain` links.
template <class Plain, class Links, class Input, class Q>
AXIAL_INLINE constexpr auto moving_screws(const Plain& plain, const Links& links, const Input& in, const Q& q) {
  auto screws = joint_screws(plain, in, q.values);
  return map_links(links, [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    return link.on_joint([&](auto joint) AXIAL_INLINE { return link.shape(moving_screw(joint, screws[i], q[i])); });
  });
}

/// Calls each(i, effort) for every joint, from the tips on, with a Taylor number: its effort, how that changes and,
/// unless it is cut off, half of how the change changes. RNEA itself, over Taylor numbers.
struct Along {
  /// the algorithm
  template <class Links, class Input, class Q, class V, class A, class Each>
  AXIAL_INLINE static constexpr void run(const Links& plain, const Input& in, const Q& q, const V& qd, const A& qdd,
                                         const Each& each) {
    auto links = differentiated<typename Q::template Of<typename Links::Scalar>>(plain);
    rnea::propagate_inward(links, in, q, moving_screws(plain, links, in, q), qd, qdd,
                           [&](auto i, const auto&, const auto& effort) AXIAL_INLINE { each(i, effort); });
  }
};
/// The same along a motion in time; `q3` and `q4` are the third and fourth derivatives of q.
struct InTime {
  /// the algorithm
  template <class Links, class Input, class Q, class V, class A, class J, class S, class Each>
  AXIAL_INLINE static constexpr void run(const Links& plain, const Input& in, const Q& q, const V& qd, const A& qdd,
                                         const J& q3, const S& q4, const Each& each) {
    const TaylorValues position{q, qd, qdd};
    Along::run(plain, in, position, TaylorValues{qd, qdd, q3}, TaylorValues{qdd, q3, q4}, each);
  }
};

}  // namespace derivatives

/// Friction at a speed that changes: dry friction jumps at rest, where no slope describes it.
template <class Link, class V, class D>
AXIAL_INLINE constexpr auto friction_effort(const Link& link, const Dual<V, D>& qd) {
  return with_slope(friction_effort(link, qd.value), friction_slope(link, qd.value) * qd.linear);
}
}  // namespace axial

#include <axial/options/end.hpp>

// A base that is free: what pushes it, and what the links that it carries add to it.
#pragma once

#include <axial/base/base_solve.hpp>
#include <axial/base/water.hpp>
#include <axial/recursion/moving_base.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Force that the environment exerts on the base, N m and N at the origin of frame 0; zero by type unless the scene
/// names BaseWrench.
template <class Links, class Input>
AXIAL_INLINE constexpr auto base_load(const Links&, const Input& in) {
  if constexpr (Links::Scene::template has<BaseWrench>)
    return in.base_wrench;
  else
    return ForceVector<ZeroVec3, ZeroVec3>{};
}

/// force_on_water of the base body.
template <class Links, class Input, class Body, class P, class U, class DW, class A>
AXIAL_INLINE constexpr auto base_force_on_water(const Links& links, const Input& in, const Body& body, const P& p,
                                                const U& rate, const DW& dw, const A& a) {
  if constexpr (Links::Scene::template has<Underwater>)
    return water_force(body, water_of_base(links), body.body(), base_immersion(links, in), p, rate, dw, a);
  else
    return ForceVector<ZeroVec3, ZeroVec3>{};
}

namespace detail {
template <int I, class Links, class Left, class Sum>
AXIAL_INLINE constexpr auto with_roots_from(const Links& links, const Left& left, const Sum& sum) {
  if constexpr (I >= Links::capacity)
    return sum;
  else if constexpr (Links::template parent_of<I> < 0)
    return with_roots_from<I + 1>(links, left, sum + left[Index<I>{}].on_parent);
  else
    return with_roots_from<I + 1>(links, left, sum);
}
}  // namespace detail

/// own + what an inward pass left to frame 0: the sum over the links that the base carries.
template <class Links, class Left, class Own>
AXIAL_INLINE constexpr auto with_roots(const Links& links, const Left& left, const Own& own) {
  if constexpr (Links::unrolled) {
    return detail::with_roots_from<0>(links, left, own);
  } else {
    auto sum = own.template dense<typename Links::Scalar>();
    for (int i = 0; i < links.size(); ++i)
      if (links.parent_index(i) < 0) sum = sum + left[i].on_parent;
    return sum;
  }
}

}  // namespace axial

#include <axial/options/end.hpp>

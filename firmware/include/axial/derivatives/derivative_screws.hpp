// The z-screws of all joints for derivatives of long arms, whose flash counts: every sine comes out of one function.
#pragma once

#include <axial/recursion/joint_screws.hpp>

#include <type_traits>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// Whether sines are called: of arms of five joints and more that the compiler knows, where none are packed. A call
/// takes some twenty instructions more than the same in line, and stands for 45 of them.
template <class Links>
constexpr bool calls_sines() {
  using T = typename Links::Scalar;
  if constexpr (Links::unrolled && std::is_floating_point_v<T> && !Links::Scene::template has<SineCosines>)
    return Links::capacity > 4 && !packing_pays<T>(detail::revolute_joints<Links>());
  else
    return false;
}
/// sincos() as a function of its own.
template <class T>
[[gnu::noinline]] constexpr SinCos<T> called_sincos(T x) {
  return sincos(x);
}

/// joint_screws(), in less flash where that takes little time; the bits are the same.
template <class Links, class Input, class Q>
AXIAL_INLINE constexpr auto screws(const Links& links, const Input& in, const Q& q) {
  if constexpr (calls_sines<Links>())
    return map_links(links, [&](auto i) AXIAL_INLINE {
      if constexpr (Links::Scene::Robot::chain.links[i].type == JointType::revolute)
        return links.link(i).z(q[i], called_sincos(q[i]));
      else
        return links.link(i).z(q[i]);
    });
  else
    return joint_screws(links, in, q);
}

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>

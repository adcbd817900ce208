// How each joint moves the links beyond it: the columns of every link's Jacobian, in frames that are about to turn.
#pragma once

#include <axial/recursion/joint_axis.hpp>
#include <axial/recursion/moving_base.hpp>
#include <axial/recursion/passes.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The motion that a joint gives to a link which it does not move, where links have a type each.
struct Unmoved {};

/// Motion of a joint's link at one unit of its rate.
template <class Joint, class Link>
AXIAL_INLINE constexpr auto unit_motion(Joint joint, const Link&) {
  return along_axis(joint, One{});
}

/// Where a pass for one joint starts: nothing moves.
template <class Links>
AXIAL_INLINE constexpr auto unmoved(const Links& links) {
  if constexpr (Links::unrolled)
    return Unmoved{};
  else
    return MotionVector{no_motion(links), no_motion(links)};
}

/// Motion of one unit of joint m's rate in frame i before joint i's own z-screw, for every link i beyond link m. There
/// the axis of a link's parent is constant, and composite bodies that are about to be borne by the parent stand ready.
template <class Links, class Screws, class I>
AXIAL_INLINE constexpr auto motions_of_joint(const Links& links, const Screws& screws, I m) {
  auto first = [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    auto inner = links.link(m);
    return inner.on_joint([&](auto kind)
                              AXIAL_INLINE { return link.shape(to_child(link.x(), unit_motion(kind, inner), link)); });
  };
  auto next = [&](auto i, auto parent, const auto& motion) AXIAL_INLINE {
    auto link = links.link(i);
    return link.shape(to_child(link.x(), to_child(screws[parent], motion, links.link(parent)), link));
  };
  return outward(links, unmoved(links), [&](auto i, const auto& motion) AXIAL_INLINE {
    if constexpr (Links::unrolled) {
      constexpr int parent = Links::template parent_of<decltype(i)::value>;
      if constexpr (parent == I::value)
        return first(i);
      else if constexpr (std::is_same_v<std::decay_t<decltype(motion)>, Unmoved>)
        return Unmoved{};
      else
        return next(i, Index<parent>{}, motion);
    } else {
      const int parent = links.parent_index(i);
      return parent == m ? first(i) : parent > m ? next(i, parent, motion) : std::decay_t<decltype(motion)>{};
    }
  });
}

/// Motions of all links with all joints: motions[m][i].
template <class Links, class Screws>
AXIAL_INLINE constexpr auto joint_motions(const Links& links, const Screws& screws) {
  return map_links(links, [&](auto m) AXIAL_INLINE { return motions_of_joint(links, screws, m); });
}

}  // namespace axial

#include <axial/options/end.hpp>

// The z-screws of all joints: the only place where an algorithm looks at q.
#pragma once

#include <axial/dynamics/passes.hpp>

namespace axial {

/// z-screw of every joint at q (rad or m): one sine-cosine pair a revolute joint, shared by all that follows.
template <class Links, class Input, class Q>
AXIAL_INLINE constexpr auto joint_screws(const Links& links, const Input&, const Q& q) {
  return map_links(links, [&](auto i) AXIAL_INLINE { return links.link(i).z(q[i]); });
}

}  // namespace axial

// What a spatial vector has along a joint's axis, which is the z axis of the link's frame.
#pragma once

#include <axial/links/link_constants.hpp>
#include <axial/spatial/spatial_vector.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Component of a force along the joint: the moment about its axis, or the force along it.
template <class F>
AXIAL_INLINE constexpr auto along_joint(Revolute, const F& f) {
  return f.moment.z;
}
/// Prismatic overload: the force along the joint.
template <class F>
AXIAL_INLINE constexpr auto along_joint(Prismatic, const F& f) {
  return f.force.z;
}

/// Component of a force along a joint whose motion is given: its power at one unit of rate.
template <class M, class F>
AXIAL_INLINE constexpr auto along_motion(const M& motion, const F& force) {
  return dot(motion.angular, force.moment) + dot(motion.linear, force.force);
}

/// A joint acceleration as a motion of its link.
template <class A>
AXIAL_INLINE constexpr auto along_axis(Revolute, const A& qdd) {
  return MotionVector{along_z(qdd), ZeroVec3{}};
}
/// Prismatic overload: a linear motion.
template <class A>
AXIAL_INLINE constexpr auto along_axis(Prismatic, const A& qdd) {
  return MotionVector{ZeroVec3{}, along_z(qdd)};
}

}  // namespace axial

#include <axial/options/end.hpp>

// A chain on a base with given motion, as a longer chain on a fixed one: three massless slides and three massless turns
// carry it, and their rates are the ones that give frame 0 the motion. Lagrange's equations then need nothing new.
#pragma once

#include <oracle/lagrange.hpp>

namespace oracle {

/// Motion of frame 0 in its own axes; the acceleration of its origin is without gravity.
template <class T>
struct BaseMotion {
  Vec3<T> angular_velocity{}, angular_acceleration{}, linear_acceleration{};
};

namespace moving_base {

template <class T>
Link<T> carrier(Joint type) {
  Link<T> link;
  link.type = type, link.alpha = right_angle<T>(), link.theta = right_angle<T>();  // turns the axes in a ring
  return link;
}
template <class T>
Chain<T> carriers() {
  Chain<T> chain;
  for (int i = 0; i < 6; ++i) {
    chain.links.push_back(carrier<T>(i < 3 ? Joint::prismatic : Joint::revolute));
    chain.links.back().parent = i - 1;
  }
  return chain;
}

}  // namespace moving_base

/// As inverse_dynamics, on a moving base; chain.gravity is in axes of frame 0.
template <class T>
Vector<T> inverse_dynamics_on_moving_base(const Chain<T>& chain, const BaseMotion<T>& motion, const Vector<T>& q,
                                          const Vector<T>& qd, const Vector<T>& qdd, const Load<T>& load = {}) {
  Chain<T> longer = moving_base::carriers<T>();
  Vector<T> position(6, T(0)), speed(6, T(0)), acceleration(6, T(0));
  const auto poses = link_poses(longer, position);
  const Mat3<T>& R = poses[5].rotation;
  const Vec3<T> w = R * motion.angular_velocity, a = R * motion.linear_acceleration;
  Vec3<T> turning{}, dw = R * motion.angular_acceleration;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<T> slide = poses[i].rotation.c2, axis = poses[i + 3].rotation.c2;
    acceleration[i] = dot(slide, a);
    speed[i + 3] = dot(axis, w);
    dw = dw - speed[i + 3] * cross(turning, axis);  // the axis itself turns with those before it
    turning = turning + speed[i + 3] * axis;
  }
  for (std::size_t i = 3; i < 6; ++i)
    acceleration[i] = dot(poses[i].rotation.c2, dw);
  for (Link<T> link : chain.links) {
    link.parent += 6;
    longer.links.push_back(link);
  }
  longer.gravity = R * chain.gravity;
  position.insert(position.end(), q.begin(), q.end());
  speed.insert(speed.end(), qd.begin(), qd.end());
  acceleration.insert(acceleration.end(), qdd.begin(), qdd.end());
  Load<T> carried = load;
  if (!load.links.empty()) carried.links.insert(carried.links.begin(), 6, Wrench<T>{});
  const Vector<T> tau = inverse_dynamics(longer, position, speed, acceleration, carried);
  return Vector<T>(tau.begin() + 6, tau.end());
}

}  // namespace oracle

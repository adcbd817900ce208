// Copies the description of a robot into an oracle chain. Data only: no function of firmware/ is called.
#pragma once

#include <axial/robot/chain.hpp>
#include <oracle/chain.hpp>

namespace oracle {

/// An angle as the library holds it: exactly k right angles where its sine and cosine say so.
template <class T>
T angle_from_axial(const axial::Angle& angle) {
  if (angle.sin == 0.0) return angle.cos > 0.0 ? T(0) : T(2) * right_angle<T>();
  if (angle.cos == 0.0) return angle.sin > 0.0 ? right_angle<T>() : -right_angle<T>();
  return T(angle.radians);
}

template <class T>
Link<T> link_from_axial(const axial::LinkParameters& p, int parent) {
  Link<T> link;
  link.type = p.type == axial::JointType::revolute ? Joint::revolute : Joint::prismatic;
  link.parent = parent;
  link.alpha = angle_from_axial<T>(p.alpha), link.a = T(p.a), link.d = T(p.d);
  link.theta = angle_from_axial<T>(p.theta);
  link.gamma = angle_from_axial<T>(p.gamma), link.b = T(p.b);
  link.mass = T(p.mass);
  link.com = {T(p.com[0]), T(p.com[1]), T(p.com[2])};
  const auto& I = p.inertia_com;
  link.inertia = symmetric(T(I[0]), T(I[1]), T(I[2]), T(I[3]), T(I[4]), T(I[5]));
  link.rotor_inertia = T(p.rotor_inertia), link.gear = T(p.gear);
  link.viscous = T(p.viscous);
  link.coulomb_forward = T(p.coulomb_forward), link.coulomb_backward = T(p.coulomb_backward);
  link.static_friction = T(p.static_friction), link.stribeck_speed = T(p.stribeck_speed);
  link.smooth_speed = T(p.smooth_speed);
  link.spring_stiffness = T(p.spring_stiffness), link.spring_rest = T(p.spring_rest);
  return link;
}

template <class T>
Pose<T> pose_from_axial(const axial::FixedPose& pose) {
  const auto& R = pose.rotation;
  const auto& p = pose.position;
  return {{{T(R[0]), T(R[3]), T(R[6])}, {T(R[1]), T(R[4]), T(R[7])}, {T(R[2]), T(R[5]), T(R[8])}},
          {T(p[0]), T(p[1]), T(p[2])}};
}

template <class T, int N>
Chain<T> from_axial(const axial::Chain<N>& source) {
  Chain<T> chain;
  for (int i = 0; i < N; ++i)
    chain.links.push_back(link_from_axial<T>(source.links[i], source.parent(i)));
  chain.gravity = {T(source.gravity.x), T(source.gravity.y), T(source.gravity.z)};
  chain.base = pose_from_axial<T>(source.base.pose);
  chain.tool = pose_from_axial<T>(source.tool.pose);
  return chain;
}

/// The oracle's chain of a robot type.
template <class T, class Robot>
Chain<T> of_robot() {
  return from_axial<T>(Robot::chain);
}

}  // namespace oracle

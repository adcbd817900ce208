// The oracle's links as the library's descriptions, so that one chain feeds both.
#pragma once

#include <axial/links/model.hpp>
#include <oracle/chain.hpp>
#include <stdexcept>

namespace cases {

inline axial::Angle to_axial_angle(double radians) {
  int quarters = 0;
  return oracle::is_right_angle(radians, quarters) ? axial::Angle::from_degrees(90.0 * quarters)
                                                   : axial::Angle::from_radians(radians);
}

inline axial::LinkParameters to_axial(const oracle::Link<double>& link) {
  axial::LinkParameters p;
  p.type = link.type == oracle::Joint::revolute ? axial::JointType::revolute : axial::JointType::prismatic;
  p.parent = link.parent < 0 ? axial::LinkParameters::base : link.parent;
  p.alpha = to_axial_angle(link.alpha), p.a = link.a, p.d = link.d, p.theta = to_axial_angle(link.theta);
  p.gamma = to_axial_angle(link.gamma), p.b = link.b;
  p.mass = link.mass;
  p.com[0] = link.com.x, p.com[1] = link.com.y, p.com[2] = link.com.z;
  const oracle::Mat3<double>& I = link.inertia;
  const double inertia[] = {I.c0.x, I.c1.y, I.c2.z, I.c0.y, I.c0.z, I.c1.z};
  for (int i = 0; i < 6; ++i)
    p.inertia_com[i] = inertia[i];
  p.rotor_inertia = link.rotor_inertia, p.gear = link.gear;
  p.viscous = link.viscous;
  p.coulomb_forward = link.coulomb_forward, p.coulomb_backward = link.coulomb_backward;
  p.static_friction = link.static_friction, p.stribeck_speed = link.stribeck_speed;
  p.smooth_speed = link.smooth_speed;
  p.spring_stiffness = link.spring_stiffness, p.spring_rest = link.spring_rest;
  return p;
}

inline axial::FixedPose to_axial(const oracle::Pose<double>& pose) {
  const auto& R = pose.rotation;
  const auto& p = pose.position;
  return {{R.c0.x, R.c1.x, R.c2.x, R.c0.y, R.c1.y, R.c2.y, R.c0.z, R.c1.z, R.c2.z}, {p.x, p.y, p.z}};
}

/// An axial::Model with the links, gravity, base and tool of a chain.
template <class Model>
Model to_model(const oracle::Chain<double>& chain) {
  Model model;
  for (const auto& link : chain.links)
    if (!model.add(to_axial(link))) throw std::length_error("the chain does not fit the model");
  model.set_gravity(chain.gravity.x, chain.gravity.y, chain.gravity.z);
  model.set_base(to_axial(chain.base));
  model.set_tool(to_axial(chain.tool));
  return model;
}

}  // namespace cases

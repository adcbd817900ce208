// The constants that the algorithms use, derived from a link's description.
#pragma once

#include <axial/model/chain.hpp>

namespace axial {

/// Kind of a joint as a type.
struct Revolute {};
struct Prismatic {};

/// Constants of one link in its own frame, SI.
template <class T>
struct LinkConstants {
  bool prismatic = false;
  int parent = -1;
  T cos_alpha{}, sin_alpha{}, a{};             ///< x-screw
  T cos_theta{}, sin_theta{}, theta{}, d{};    ///< constant part of the z-screw
  T mass{}, hx{}, hy{}, hz{};                  ///< kg, first moment in kg m
  T jxx{}, jyy{}, jzz{}, jxy{}, jxz{}, jyz{};  ///< inertia about the frame's origin, kg m^2
  T jzz_jyy{}, jxx_jzz{}, jyy_jxx{};           ///< its differences, which the gyroscopic moments use
  T rotor{};                                   ///< gear^2 J on the joint, kg m^2 or kg
};

/// Constants of a link from its description. Parallel-axis theorem for the inertia about the origin.
constexpr LinkConstants<double> link_constants(const LinkParameters& p, int parent) {
  const double m = p.mass, x = p.com[0], y = p.com[1], z = p.com[2];
  LinkConstants<double> c;
  c.prismatic = p.type == JointType::prismatic;
  c.parent = parent;
  c.cos_alpha = p.alpha.cos, c.sin_alpha = p.alpha.sin, c.a = p.a;
  c.cos_theta = p.theta.cos, c.sin_theta = p.theta.sin, c.theta = p.theta.radians, c.d = p.d;
  c.mass = m, c.hx = m * x, c.hy = m * y, c.hz = m * z;
  c.jxx = p.inertia_com[0] + m * (y * y + z * z);
  c.jyy = p.inertia_com[1] + m * (x * x + z * z);
  c.jzz = p.inertia_com[2] + m * (x * x + y * y);
  c.jxy = p.inertia_com[3] - m * x * y;
  c.jxz = p.inertia_com[4] - m * x * z;
  c.jyz = p.inertia_com[5] - m * y * z;
  c.jzz_jyy = c.jzz - c.jyy, c.jxx_jzz = c.jxx - c.jzz, c.jyy_jxx = c.jyy - c.jxx;
  c.rotor = p.gear * p.gear * p.rotor_inertia;
  return c;
}

/// The same constants in another number format.
template <class T>
constexpr LinkConstants<T> converted(const LinkConstants<double>& c) {
  using N = NumberTraits<T>;
  return {c.prismatic,
          c.parent,
          N::constant(c.cos_alpha),
          N::constant(c.sin_alpha),
          N::constant(c.a),
          N::constant(c.cos_theta),
          N::constant(c.sin_theta),
          N::constant(c.theta),
          N::constant(c.d),
          N::constant(c.mass),
          N::constant(c.hx),
          N::constant(c.hy),
          N::constant(c.hz),
          N::constant(c.jxx),
          N::constant(c.jyy),
          N::constant(c.jzz),
          N::constant(c.jxy),
          N::constant(c.jxz),
          N::constant(c.jyz),
          N::constant(c.jzz_jyy),
          N::constant(c.jxx_jzz),
          N::constant(c.jyy_jxx),
          N::constant(c.rotor)};
}

}  // namespace axial

// The constants that the algorithms use, derived from a link's description. Those of the drive are a table of their
// own: a scene that names neither Friction nor JointSprings holds none of it.
#pragma once

#include <axial/robot/chain_parameters.hpp>

#include <cstddef>

#include <axial/options/begin.hpp>

namespace axial {

/// Kind of a joint as a type.
///@{
struct Revolute {};
struct Prismatic {};
///@}

/// Constants of one link in its own frame, SI.
template <class T>
struct LinkConstants {
  bool prismatic = false;                      ///< whether its joint slides
  int parent = -1;                             ///< index of the link that carries its joint, negative for the base
  T cos_alpha{}, sin_alpha{}, a{};             ///< x-screw
  T cos_theta{}, sin_theta{}, theta{}, d{};    ///< constant part of the z-screw
  T mass{}, hx{}, hy{}, hz{};                  ///< kg, first moment in kg m
  T jxx{}, jyy{}, jzz{}, jxy{}, jxz{}, jyz{};  ///< inertia about the frame's origin, kg m^2
  T jzz_jyy{}, jxx_jzz{}, jyy_jxx{};           ///< its differences, which the gyroscopic moments use
  T rotor{};                                   ///< gear^2 J on the joint, kg m^2 or kg
};

/// The z-screw of a branch, along the parent's z axis: before the x-screw.
template <class T>
struct BranchConstants {
  T cos_gamma{}, sin_gamma{}, b{};  ///< turn (its cosine and sine), shift in m
};

/// Constants of a link in a tree. Looped tables of robots without a branch hold LinkConstants only.
template <class T>
struct TreeLinkConstants : LinkConstants<T> {
  BranchConstants<T> branch{};  ///< the identity where there is no branch
  /// Whether there is anything before the x-screw.
  constexpr bool branches() const {
    return branch.sin_gamma < T(0) || branch.sin_gamma > T(0) || branch.cos_gamma < T(0) || branch.b < T(0) ||
           branch.b > T(0);
  }
};

/// Constants of a link from its description. Parallel-axis theorem for the inertia about the origin.
constexpr TreeLinkConstants<double> link_constants(const LinkParameters& p, int parent) {
  const double m = p.mass, x = p.com[0], y = p.com[1], z = p.com[2];
  TreeLinkConstants<double> c;
  c.branch = {p.gamma.cos, p.gamma.sin, p.b};
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

/// The numbers among the constants, in an order that is the same for every T.
template <class T>
inline constexpr T LinkConstants<T>::*link_numbers[] = {
    &LinkConstants<T>::cos_alpha, &LinkConstants<T>::sin_alpha, &LinkConstants<T>::a,
    &LinkConstants<T>::cos_theta, &LinkConstants<T>::sin_theta, &LinkConstants<T>::theta,
    &LinkConstants<T>::d,         &LinkConstants<T>::mass,      &LinkConstants<T>::hx,
    &LinkConstants<T>::hy,        &LinkConstants<T>::hz,        &LinkConstants<T>::jxx,
    &LinkConstants<T>::jyy,       &LinkConstants<T>::jzz,       &LinkConstants<T>::jxy,
    &LinkConstants<T>::jxz,       &LinkConstants<T>::jyz,       &LinkConstants<T>::jzz_jyy,
    &LinkConstants<T>::jxx_jzz,   &LinkConstants<T>::jyy_jxx,   &LinkConstants<T>::rotor};

/// The numbers among the constants of a branch, in an order that is the same for every T.
template <class T>
inline constexpr T BranchConstants<T>::*branch_numbers[] = {&BranchConstants<T>::cos_gamma,
                                                            &BranchConstants<T>::sin_gamma, &BranchConstants<T>::b};

/// Link constants in another number format.
template <class T>
constexpr void convert(const TreeLinkConstants<double>& c, LinkConstants<T>& result) {
  result.prismatic = c.prismatic;
  result.parent = c.parent;
  for (std::size_t i = 0; i < sizeof(link_numbers<T>) / sizeof(link_numbers<T>[0]); ++i)
    result.*link_numbers<T>[i] = NumberTraits<T>::constant(c.*link_numbers<double>[i]);
}
/// Link constants with those of the branch in another number format.
template <class T>
constexpr void convert(const TreeLinkConstants<double>& c, TreeLinkConstants<T>& result) {
  convert(c, static_cast<LinkConstants<T>&>(result));
  for (std::size_t i = 0; i < sizeof(branch_numbers<T>) / sizeof(branch_numbers<T>[0]); ++i)
    result.branch.*branch_numbers<T>[i] = NumberTraits<T>::constant(c.branch.*branch_numbers<double>[i]);
}
/// Link constants as a row of a table of either kind.
template <class Row>
constexpr Row converted_row(const TreeLinkConstants<double>& c) {
  Row row{};
  convert(c, row);
  return row;
}

/// Friction and spring of one joint, on the joint side, SI.
template <class T>
struct DriveConstants {
  T viscous{};                                ///< N m s/rad or N s/m
  T coulomb_forward{}, coulomb_backward{};    ///< N m or N, friction while moving forward (>= 0) and backward (<= 0)
  T stribeck_forward{}, stribeck_backward{};  ///< breakaway beyond Coulomb: static effort - Coulomb
  T inverse_stribeck_speed2{};                ///< 1 / speed^2
  T inverse_smooth_speed{};                   ///< 0 where the sign of the speed is taken as it is
  T spring_stiffness{}, spring_rest{};        ///< N m/rad or N/m; rad or m
};

/// Drive constants from a link's description; unused ones are 0.
constexpr DriveConstants<double> drive_constants(const LinkParameters& p) {
  DriveConstants<double> c;
  c.viscous = p.viscous, c.coulomb_forward = p.coulomb_forward, c.coulomb_backward = p.coulomb_backward;
  if (p.static_friction > 0.0) {
    c.stribeck_forward = p.static_friction - p.coulomb_forward;
    c.stribeck_backward = -p.static_friction - p.coulomb_backward;
    c.inverse_stribeck_speed2 = 1.0 / (p.stribeck_speed * p.stribeck_speed);
  }
  if (p.smooth_speed > 0.0) c.inverse_smooth_speed = 1.0 / p.smooth_speed;
  c.spring_stiffness = p.spring_stiffness, c.spring_rest = p.spring_rest;
  return c;
}

/// The constants in an order that is the same for every T.
template <class T>
inline constexpr T DriveConstants<T>::*drive_numbers[] = {&DriveConstants<T>::viscous,
                                                          &DriveConstants<T>::coulomb_forward,
                                                          &DriveConstants<T>::coulomb_backward,
                                                          &DriveConstants<T>::stribeck_forward,
                                                          &DriveConstants<T>::stribeck_backward,
                                                          &DriveConstants<T>::inverse_stribeck_speed2,
                                                          &DriveConstants<T>::inverse_smooth_speed,
                                                          &DriveConstants<T>::spring_stiffness,
                                                          &DriveConstants<T>::spring_rest};

/// Drive constants in another number format.
template <class T>
constexpr DriveConstants<T> converted(const DriveConstants<double>& c) {
  DriveConstants<T> result;
  for (std::size_t i = 0; i < sizeof(drive_numbers<T>) / sizeof(drive_numbers<T>[0]); ++i)
    result.*drive_numbers<T>[i] = NumberTraits<T>::constant(c.*drive_numbers<double>[i]);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>

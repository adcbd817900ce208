// What a joint's drive adds by itself, derived from a link's description. A table of its own: a scene that names
// neither Friction nor JointSprings holds none of it.
#pragma once

#include <axial/robot/chain_parameters.hpp>

#include <cstddef>

#include <axial/options/begin.hpp>

namespace axial {

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

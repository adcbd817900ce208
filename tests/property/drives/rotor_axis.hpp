// Where the oracle has a rotor turn that a link describes.
#pragma once

#include <oracle/from_axial.hpp>
#include <oracle/rotors.hpp>

namespace property {

/// The axis of a rotor as angles, of an axis that was given: alpha in [0, pi].
inline oracle::RotorAxis<oracle::quad> rotor_axis(const axial::LinkParameters& p, int parent) {
  using oracle::quad;
  const int carrier = p.rotor_carrier == axial::LinkParameters::previous ? parent : p.rotor_carrier;
  const quad x = p.rotor_axis[0], y = p.rotor_axis[1], z = p.rotor_axis[2];
  if (x == 0 && y == 0 && z == 0)
    return {carrier, oracle::angle_from_axial<quad>(p.gamma), oracle::angle_from_axial<quad>(p.alpha)};
  return {carrier, atan2q(x, -y), atan2q(sqrtq(x * x + y * y), z)};
}
template <class Robot>
oracle::Vector<oracle::RotorAxis<oracle::quad>> rotor_axes() {
  oracle::Vector<oracle::RotorAxis<oracle::quad>> axes;
  for (int i = 0; i < Robot::chain.size; ++i)
    axes.push_back(rotor_axis(Robot::chain.links[i], Robot::chain.parent(i)));
  return axes;
}

}  // namespace property

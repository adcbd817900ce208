// Serial arms as robot descriptions have them, in frames that are not Denavit-Hartenberg's: schema serial-arms/1 of
// tests/data.
#pragma once

#include <oracle/chain.hpp>
#include <string>

namespace cases {

/// One revolute joint with the link that it moves; everything of the link in the joint's frame.
struct DescribedJoint {
  oracle::Vec3<double> origin;   ///< m, in the frame before
  int roll, pitch, yaw;          ///< quarters of a turn about the fixed axes x, y, z of the frame before, in this order
  double mass;                   ///< kg
  oracle::Vec3<double> com;      ///< m
  oracle::Mat3<double> inertia;  ///< kg m^2, about the centre of mass
  double position_min, position_max;
};

struct ArmDescription {
  std::vector<DescribedJoint> joints;
  double speed, acceleration;  ///< limits of every joint
};

/// An arm of rival_models.json by name; throws if there is none.
ArmDescription load_arm(const std::string& name);

}  // namespace cases

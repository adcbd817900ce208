// Constant poses of descriptions.
#pragma once

#include <axial/robot/chain.hpp>

namespace description {

/// Sets the rotation to Rz(yaw) Ry(pitch) Rx(roll), in radians or degrees; right angles are exact.
void set_rotation(axial::FixedPose& pose, double roll, double pitch, double yaw, bool degrees = false);

/// Its rotation is orthonormal to 1e-6 and turns right-handed; everything is finite.
bool is_rotation(const axial::FixedPose& pose);

}  // namespace description

// What the errors of a recording may be.
#pragma once

#include <host_sim/boards/demo/recording.hpp>

#include <vector>

namespace host_sim {

/// Largest torque error that the float kernels are allowed, relative to the joint's largest torque over the trajectory.
/// Rounding gathers along the chain and the last joints of a long arm carry next to nothing, so these get twice as
/// much.
constexpr double float_bound(int joints) { return joints <= 6 ? 5e-7 : 1e-6; }

/// Each joint's bound in float, N m or N; `scales` as in summary.hpp.
std::vector<double> float_bounds(const std::vector<double>& scales);

/// Each joint's bound in 32-bit fixed point, N m or N: the certified error of the kernel, the torque's rounding to the
/// float of the wire, and what the rounding of the set-points moves the exact torque by, at worst over the recording.
std::vector<double> fixed32_bounds(const Recording& recording, const Robot& robot);

}  // namespace host_sim

// Every kernel's exact result by the oracle.
#pragma once

#include <host_sim/robots/robots/robot.hpp>
#include <host_sim/tools/analysis/error_scales.hpp>

#include <string>
#include <vector>

namespace host_sim {

/// Result of a kernel in 113-bit precision, rounded to double, in the kernels image's order. `torque` is the input of
/// forward dynamics. Throws std::runtime_error for an unknown kernel.
Values exact_result(const std::string& kernel, const Robot& robot, const SetPoint& state, const Values& torque);

}  // namespace host_sim

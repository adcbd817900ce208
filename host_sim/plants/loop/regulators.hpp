// The linear-quadratic regulator: its image in QEMU, or its source on the host.
#pragma once

#include <host_sim/plants/loop/controllers.hpp>

namespace host_sim::loop {

/// For robots_of_single_drives(); on the host also for wrist_arm, by its drives. Throw std::runtime_error that names
/// them.
std::unique_ptr<Controller> regulator_on_host(const std::string& robot);
std::unique_ptr<Controller> regulator_in_firmware(const std::string& board, const std::string& robot);

/// N m or N, as the robot declares them; of the drives where joints share them.
std::vector<double> effort_limits(const std::string& robot);

}  // namespace host_sim::loop

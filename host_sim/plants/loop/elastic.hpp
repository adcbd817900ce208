// The controller of an arm with elastic joints: its image in QEMU, or its source on the host.
#pragma once

#include <host_sim/plants/loop/controllers.hpp>

namespace host_sim::loop {

/// Hz of joints with locked motors for which there is a controller on the host; the image is one of 12.
std::vector<int> resonances();
/// Throw std::runtime_error that names the robots, or the resonances, there are.
std::unique_ptr<Controller> elastic_on_host(const std::string& robot, int resonance);
std::unique_ptr<Controller> elastic_in_firmware(const std::string& board, const std::string& robot);

}  // namespace host_sim::loop

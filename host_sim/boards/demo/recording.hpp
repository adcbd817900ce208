// The main job as it was seen: what was asked of the firmware and what it answered.
#pragma once

#include <host_sim/boards/link/firmware.hpp>
#include <host_sim/robots/robots/robot.hpp>
#include <host_sim/robots/trajectory/set_point.hpp>

#include <vector>

namespace host_sim {

/// One tick. The set-point holds the very float values that were sent; torques in N m or N.
struct Sample {
  SetPoint asked;
  std::vector<double> torque;  ///< the firmware's
  std::vector<double> exact;   ///< the oracle's, for the same floats
  unsigned count = 0;          ///< instructions or cycles of this torque, an empty bracket subtracted
};

struct Recording {
  std::vector<Sample> samples;
  link::Hello hello{};
  link::Stats stats{};
};

/// Streams a trajectory in lock-step, collects the torques, then ends the emulator.
/// Throws std::runtime_error when a frame is lost or the firmware refuses a set-point, and says which.
Recording stream(SerialLine& line, const Robot& robot, const Trajectory& trajectory);

}  // namespace host_sim

// ./axial demo: the main job on an emulated board, checked and drawn.
#pragma once

#include <string>

namespace host_sim {

struct DemoOptions {
  std::string robot = "scara";
  std::string board = "stm32f405";
  std::string number = "float";        ///< what the firmware computes in: float or fixed32
  std::string trajectory;              ///< file; empty for the robot's own cycle
  std::string output = "output/demo";  ///< folder
  std::string json;                    ///< file; empty for none but the one in the folder
  bool without_picture = false;        ///< data alone
};

/// Runs the demo and returns the exit status: 0 when every error is within its bound, else 1.
/// Throws std::runtime_error when it cannot run or a frame is lost.
int run_demo(const DemoOptions& options);

}  // namespace host_sim

// ./axial report --on-board: error and instructions of every kernel as the boards themselves compute it.
#pragma once

#include <string>

namespace host_sim {

struct OnBoardOptions {
  std::string robot;                       ///< empty for all
  std::string board;                       ///< empty for all
  std::string output = "output/on_board";  ///< folder
  std::string json;                        ///< file; empty for none but the one in the folder
};

/// Runs the kernels images and returns the exit status: 0 when every error is within its bound, else 1.
/// Throws std::runtime_error when an image cannot be run or prints something else.
int run_on_board(const OnBoardOptions& options);

}  // namespace host_sim

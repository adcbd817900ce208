// Error and work of every kernel, robot, scalar and board.
#pragma once

#include <host_sim/boards/on_board/kernel_output.hpp>
#include <host_sim/robots/robots/robot.hpp>
#include <host_sim/tools/analysis/error_statistics.hpp>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace host_sim {

struct OnBoardRow {
  std::string subject, robot, scalar, variant, board;
  double error = 0.0;      ///< largest, relative as error_scales() says
  double error_rms = 0.0;  ///< relative likewise
  double bound = 0.0;      ///< of `error`
  Range work;              ///< over the states
  std::string unit_of_work;
};

/// One row for each kernel and scalar of an output.
std::vector<OnBoardRow> rows_of(const KernelOutput& output, const Robot& robot, const std::string& board);

/// `work` is the largest over the states.
nlohmann::json to_json(const std::vector<OnBoardRow>& rows);

}  // namespace host_sim

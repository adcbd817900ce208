// The report's rows: error and work of every kernel, robot, scalar and board.
#pragma once

#include <host_sim/analysis/error_statistics.hpp>
#include <host_sim/report/kernel_output.hpp>
#include <host_sim/robots/robot.hpp>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace host_sim {

struct ReportRow {
  std::string subject, robot, scalar, variant, board;
  double error = 0.0;      ///< largest, relative as error_scales() says
  double error_rms = 0.0;  ///< relative likewise
  double bound = 0.0;      ///< of `error`
  Range work;              ///< over the states
  std::string unit_of_work;
  bool pareto = false;  ///< no row of the same job, robot and board is as exact and as cheap
};

/// One row for each kernel and scalar of an output.
std::vector<ReportRow> rows_of(const KernelOutput& output, const Robot& robot, const std::string& board);

/// Marks the rows on the front of error and largest work; a job is what computes the same (closed form and recursion).
void mark_pareto_front(std::vector<ReportRow>& rows);

/// With the fields that every machine-readable `report` has; `work` is the largest over the states.
nlohmann::json to_json(const std::vector<ReportRow>& rows);

}  // namespace host_sim

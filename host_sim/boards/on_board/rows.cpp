#include <host_sim/boards/on_board/rows.hpp>

#include <host_sim/boards/on_board/exact_kernels.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <stdexcept>
#include <utility>

namespace host_sim {

namespace {

using Key = std::pair<std::string, std::string>;  // kernel, scalar
using Group = std::vector<const Evaluation*>;

std::map<Key, Group> grouped(const KernelOutput& output) {
  std::map<Key, Group> groups;
  for (const Evaluation& e : output.evaluations)
    groups[{e.kernel, e.scalar}].push_back(&e);
  return groups;
}

/// The torque that forward dynamics was given: the result of inverse dynamics in the same scalar.
const Values& torque_of(const std::map<Key, Group>& groups, const Evaluation& e) {
  for (const Evaluation* torque : groups.at({"inverse_dynamics", e.scalar}))
    if (torque->state == e.state) return torque->result;
  throw std::runtime_error("no torque of state " + std::to_string(e.state));
}

/// Forward dynamics multiplies rounding by the mass matrix's condition, so it is allowed more.
double bound_of(const Key& key) {
  const bool inverts = key.first == "forward_dynamics" || key.first == "forward_dynamics_derivatives";
  if (key.second == "double") return inverts ? 1e-11 : 1e-12;
  return inverts ? 1e-4 : 2e-6;
}

void add_errors(ErrorStatistics& errors, const Values& result, const Values& exact, const Values& scales) {
  if (result.size() != exact.size()) throw std::runtime_error("a kernel printed a wrong count of numbers");
  for (std::size_t i = 0; i < result.size(); ++i)
    if (scales[i] > 0.0) {
      errors.add(result[i] / scales[i], exact[i] / scales[i]);
    } else {
      errors.add(result[i], exact[i]);
    }
}

OnBoardRow row_of(const Key& key, const Group& group, const std::vector<Values>& exact) {
  const Values scales = error_scales(key.first, exact);
  ErrorStatistics errors;
  OnBoardRow row;
  row.subject = key.first, row.scalar = key.second, row.variant = "unrolled", row.bound = bound_of(key);
  for (std::size_t i = 0; i < group.size(); ++i) {
    add_errors(errors, group[i]->result, exact[i], scales);
    row.work.add(group[i]->count);
  }
  row.error = errors.largest(), row.error_rms = errors.rms();
  return row;
}

}  // namespace

std::vector<OnBoardRow> rows_of(const KernelOutput& output, const Robot& robot, const std::string& board) {
  const auto groups = grouped(output);
  std::vector<OnBoardRow> rows;
  for (const auto& [key, group] : groups) {
    std::vector<Values> exact;
    for (const Evaluation* e : group)
      exact.push_back(exact_result(key.first, robot, output.states[e->state], torque_of(groups, *e)));
    OnBoardRow row = row_of(key, group, exact);
    row.robot = robot.name, row.board = board, row.unit_of_work = output.counter;
    rows.push_back(row);
  }
  return rows;
}

nlohmann::json to_json(const std::vector<OnBoardRow>& rows) {
  nlohmann::json json = nlohmann::json::array();
  for (const OnBoardRow& row : rows)
    json.push_back({{"subject", row.subject},
                    {"robot", row.robot},
                    {"scalar", row.scalar},
                    {"variant", row.variant},
                    {"board", row.board},
                    {"error", row.error},
                    {"error_rms", row.error_rms},
                    {"error_bound", row.bound},
                    {"work", row.work.max},
                    {"work_min", row.work.min},
                    {"unit_of_work", row.unit_of_work}});
  return json;
}

}  // namespace host_sim

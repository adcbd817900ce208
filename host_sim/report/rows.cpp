#include <host_sim/report/rows.hpp>

#include <host_sim/analysis/pareto.hpp>
#include <host_sim/report/exact_kernels.hpp>

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
  const bool inverts = key.first == "forward_dynamics";
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

ReportRow row_of(const Key& key, const Group& group, const std::vector<Values>& exact) {
  const Values scales = error_scales(key.first, exact);
  ErrorStatistics errors;
  ReportRow row;
  row.subject = key.first, row.scalar = key.second, row.variant = "unrolled", row.bound = bound_of(key);
  for (std::size_t i = 0; i < group.size(); ++i) {
    add_errors(errors, group[i]->result, exact[i], scales);
    row.work.add(group[i]->count);
  }
  row.error = errors.largest(), row.error_rms = errors.rms();
  return row;
}

/// What is interchangeable: the closed form and separation compute what inverse dynamics computes.
std::string job_of(const ReportRow& row) {
  const bool torque = row.subject == "closed_form" || row.subject == "separation";
  const std::string kernel = torque ? "inverse_dynamics" : row.subject;
  return kernel + "/" + row.robot + "/" + row.board;
}

}  // namespace

std::vector<ReportRow> rows_of(const KernelOutput& output, const Robot& robot, const std::string& board) {
  const auto groups = grouped(output);
  std::vector<ReportRow> rows;
  for (const auto& [key, group] : groups) {
    std::vector<Values> exact;
    for (const Evaluation* e : group)
      exact.push_back(exact_result(key.first, robot, output.states[e->state], torque_of(groups, *e)));
    ReportRow row = row_of(key, group, exact);
    row.robot = robot.name, row.board = board, row.unit_of_work = output.counter;
    rows.push_back(row);
  }
  return rows;
}

void mark_pareto_front(std::vector<ReportRow>& rows) {
  std::map<std::string, std::vector<ReportRow*>> jobs;
  for (ReportRow& row : rows)
    jobs[job_of(row)].push_back(&row);
  for (const auto& [job, members] : jobs) {
    std::vector<ErrorAndWork> choices;
    for (const ReportRow* row : members)
      choices.push_back({row->error, static_cast<double>(row->work.max)});
    const std::vector<bool> front = pareto_front(choices);
    for (std::size_t i = 0; i < members.size(); ++i)
      members[i]->pareto = front[i];
  }
}

nlohmann::json to_json(const std::vector<ReportRow>& rows) {
  nlohmann::json json = nlohmann::json::array();
  for (const ReportRow& row : rows)
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
                    {"unit_of_work", row.unit_of_work},
                    {"pareto", row.pareto}});
  return json;
}

}  // namespace host_sim

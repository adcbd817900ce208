#include <algorithm>
#include <oracle/compare.hpp>
#include <stability/compiled/row.hpp>
#include <utility>

namespace stability {
namespace {

constexpr double most_times = 16.0, most_roundings = 10.0;

template <int... Part>
Compiled robot_of(const std::string& name, std::integer_sequence<int, Part...>) {
  for (const Compiled& robot : {compiled_robot<Part + 1>(name)...})
    if (robot.solve != nullptr) return robot;
  return {};
}
Compiled robot_of(const std::string& name) {
  return robot_of(name, std::make_integer_sequence<int, AXIAL_COMPILED_PARTS>{});
}

Row row_of(const Scenario& scenario, const Reference& reference, const Compiled& robot, Scalar scalar) {
  const Answer answer = robot.solve(scenario, scalar);
  Row row{scenario.name, scenario.family, name_of(scalar), "default", name_of(answer.status), scenario.size()};
  row.condition = reference.condition, row.absolute = scenario.measure == cases::Measure::absolute;
  if (scenario.singular) {
    row.pass = !answer.status.ok() && is_finite(answer.qdd);
    return row;
  }
  const Answer bodies = solve(scenario, Route::articulated_body, scalar);
  const double size = row.absolute ? oracle::largest(reference.qdd) : 1.0;
  row.forward = forward_error(scenario, reference, answer.qdd);
  row.backward = backward_error(scenario, reference, answer.qdd);
  row.gate.forward =
      std::max(most_times * forward_error(scenario, reference, bodies.qdd), most_roundings * epsilon_of(scalar) * size);
  row.pass = row.forward <= row.gate.forward || !answer.status.ok();
  return row;
}

}  // namespace

std::vector<Row> default_rows(const std::string& filter) {
  std::vector<Row> rows;
  for (const Scenario& scenario : cases::scenarios()) {
    const Compiled robot = robot_of(scenario.name);
    if (robot.solve == nullptr || scenario.name.find(filter) == std::string::npos) continue;
    const Reference reference = reference_of(scenario);
    for (const Scalar scalar : scalars)
      rows.push_back(row_of(scenario, reference, robot, scalar));
  }
  return rows;
}

Route default_route(const std::string& scenario) { return robot_of(scenario).route; }

}  // namespace stability

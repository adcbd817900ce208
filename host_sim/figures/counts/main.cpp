// Writes what every algorithm costs for every robot of the program, and the forward errors of forward dynamics, as JSON
// on standard output.
#include <host_sim/figures/counts/errors.hpp>
#include <host_sim/figures/counts/rows.hpp>
#include <host_sim/tools/output/command_line.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace {

// The errors stand where a form is counted, and once more where forward_dynamics takes it.
void add_errors(nlohmann::ordered_json& object, const counts::Row& row, const std::vector<counts::Errors>& errors) {
  if (row.route.empty()) return;
  object["route"] = row.route;
  for (const auto& e : errors)
    if (e.robot == row.robot && e.algorithm == row.route && e.parameters == row.parameters)
      object["error_float"] = e.in_float, object["error_double"] = e.in_double;
}

nlohmann::ordered_json table(const std::string& robot) {
  const auto rows = counts::rows(robot);
  const auto errors = counts::errors(robot);
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const auto& row : rows) {
    nlohmann::ordered_json object{
        {"robot", row.robot},  {"algorithm", row.algorithm}, {"parameters", row.parameters}, {"mul", row.cost.mul},
        {"add", row.cost.add}, {"div", row.cost.div},        {"sincos", row.cost.sincos}};
    add_errors(object, row, errors);
    array.push_back(object);
  }
  return array;
}

}  // namespace

int main(int argc, char** argv) {
  host_sim::CommandLine line("operation counts of every algorithm, robot and count model");
  std::string robot;
  line.option("--robot", robot, "only this robot");
  return line.run(argc, argv, [&] {
    std::printf("%s\n", table(robot).dump(1).c_str());
    return 0;
  });
}

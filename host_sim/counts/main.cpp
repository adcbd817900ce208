// Writes what every algorithm costs for every robot and count model, and the forward errors of forward dynamics, as
// JSON on standard output.
#include <host_sim/counts/congruence_rows.hpp>
#include <host_sim/counts/errors.hpp>
#include <host_sim/counts/rows.hpp>
#include <host_sim/output/command_line.hpp>

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

nlohmann::ordered_json table(const std::string& robot, bool with_errors) {
  const auto rows = counts::rows(robot);
  const auto errors = with_errors ? counts::errors(robot) : std::vector<counts::Errors>{};
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

nlohmann::ordered_json congruences() {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const auto& row : counts::congruence_rows())
    array.push_back({{"congruence", row.congruence},
                     {"mul", row.cost.mul},
                     {"add", row.cost.add},
                     {"scenario", "rods, straight, zigzag and curled"},
                     {"links", row.links},
                     {"error_float", row.in_float},
                     {"error_double", row.in_double}});
  return array;
}

}  // namespace

int main(int argc, char** argv) {
  host_sim::CommandLine line("operation counts of every algorithm, robot and count model");
  std::string robot;
  bool without_errors = false, only_congruences = false;
  line.option("--robot", robot, "only this robot");
  line.flag("--without-errors", without_errors, "counts alone");
  line.flag("--congruences", only_congruences, "instead: ours beside a dense and a planar-rotation congruence");
  return line.run(argc, argv, [&] {
    const auto rows = only_congruences ? congruences() : table(robot, !without_errors);
    std::printf("%s\n", rows.dump(1).c_str());
    return 0;
  });
}

// work_precision: error of every integrator against its work, as a table and as JSON.
#include <host_sim/plants/simulation/work_precision.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace {

using namespace host_sim::simulation;

void print(const std::vector<WorkRow>& rows) {
  host_sim::Table table(
      {"motion", "robot", "scalar", "integrator", "step, s", "kernel calls", "time / kernel", "error", "front"});
  for (const WorkRow& r : rows)
    table.add({r.subject, r.robot, r.scalar, r.variant, host_sim::significant(r.step), std::to_string(r.work),
               host_sim::significant(r.time_ratio),
               std::isfinite(r.error) ? host_sim::significant(r.error, 2) : "diverged", r.pareto ? "yes" : ""});
  std::printf("%s", table.text().c_str());
}

}  // namespace

int main(int count, char** arguments) {
  std::string json;
  host_sim::CommandLine line("error of integrators against work", "work_precision");
  line.option("--json", json, "the rows as an array of objects");
  return line.run(count, arguments, [&] {
    const auto rows = work_precision([](const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); });
    print(rows);
    if (!json.empty()) host_sim::write_json(json, to_json(rows));
    return 0;
  });
}

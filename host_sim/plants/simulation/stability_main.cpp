// stability_motion: the stability scenarios of motions, as a table and as JSON.
#include <host_sim/plants/simulation/rows.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace {

using namespace host_sim::simulation;

std::vector<Row> measure(const std::string& filter) {
  std::vector<Row> rows;
  for (const MotionScenario& scenario : motion_scenarios()) {
    if (scenario.name.find(filter) == std::string::npos) continue;
    const auto begin = std::chrono::steady_clock::now();
    const auto own = scenario.measure();
    rows.insert(rows.end(), own.begin(), own.end());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    std::fprintf(stderr, "%s: %.1f s\n", scenario.name.c_str(), took.count());
  }
  return rows;
}

std::string table_of(const std::vector<Row>& rows) {
  host_sim::Table table({"scenario", "scalar", "integrator", "step, s", "time, s", "of", "error", "gate", "verdict"});
  for (const Row& r : rows)
    table.add({r.scenario, r.scalar, r.route, host_sim::significant(r.step), host_sim::significant(r.seconds),
               r.quantity, host_sim::significant(r.error, 2),
               std::isfinite(r.gate) ? host_sim::significant(r.gate, 2) : "",
               r.pass ? r.status : r.status + ", MISSED"});
  return table.text();
}

}  // namespace

int main(int count, char** arguments) {
  std::string filter, json;
  host_sim::CommandLine line("stability scenarios of motions: integrators against exact and reference motions",
                             "stability_motion");
  line.option("--filter", filter, "only scenarios whose names hold this");
  line.option("--json", json, "the rows as an array of objects");
  return line.run(count, arguments, [&] {
    const auto rows = measure(filter);
    if (rows.empty()) throw std::runtime_error("no scenario's name holds '" + filter + "'");
    std::printf("%s", table_of(rows).c_str());
    if (!json.empty()) host_sim::write_json(json, to_json(rows));
    long missed = 0;
    for (const Row& r : rows)
      missed += r.pass ? 0 : 1;
    std::printf("%zu rows, %ld outside their gates\n", rows.size(), missed);
    return missed == 0 ? 0 : 1;
  });
}

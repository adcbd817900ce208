// plant_rows: what robots in real time are off, as a table and as JSON.
#include <host_sim/plants/real_time/rows.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace {

using namespace host_sim::real_time;

std::string shown(double x) { return x > 0.0 && std::isfinite(x) ? host_sim::significant(x, 2) : ""; }

std::string table_of(const std::vector<Row>& rows) {
  host_sim::Table table({"robot", "motion", "method", "scalar", "step, s", "error", "energy drift", "gate", "verdict"});
  for (const Row& r : rows)
    table.add({r.robot, r.motion, r.method, r.scalar, host_sim::significant(r.step), shown(r.error),
               shown(r.energy_drift), shown(r.gate), r.pass() ? "ok" : "MISSED"});
  return table.text();
}

}  // namespace

int main(int count, char** arguments) {
  std::string json;
  host_sim::CommandLine line("robots integrated at a fixed step in float and in words, against double", "plant_rows");
  line.option("--json", json, "the rows as an array of objects");
  return line.run(count, arguments, [&] {
    const auto found = rows();
    std::printf("%s", table_of(found).c_str());
    if (!json.empty()) host_sim::write_json(json, to_json(found));
    bool passed = true;
    for (const Row& r : found)
      passed = passed && r.pass();
    return passed ? 0 : 1;
  });
}

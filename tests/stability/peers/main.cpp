// The engines beside ours: a table of ratios, and JSON.
#include <cstdio>
#include <host_sim/tools/output/command_line.hpp>
#include <stability/json.hpp>
#include <stability/peers/compare.hpp>

namespace {

using stability::cell;
using stability::Comparison;
using stability::Json;
using stability::number;

Json json_of(const Comparison& row) {
  const bool said = !row.said.empty();
  return {{"kind", "peer"},
          {"scenario", row.scenario},
          {"family", row.family},
          {"scalar", row.scalar},
          {"route", row.engine},
          {"joints", row.joints},
          {"instances", row.instances},
          {"forward_error", said ? Json(nullptr) : number(row.nominal_error)},
          {"forward_error_absolute", row.absolute},
          {"backward_error", nullptr},
          {"median_error", said ? Json(nullptr) : number(row.engine_error)},
          {"our_median_error", said ? Json(nullptr) : number(row.our_error)},
          {"ratio", said ? Json(nullptr) : number(row.ratio)},
          {"gate", row.excluded || said ? Json(nullptr) : Json(stability::admissible_ratio)},
          {"pass", row.pass},
          {"status", said           ? "answers " + row.said
                     : row.excluded ? "excluded"
                                    : "ok"}};
}

void print(const Comparison& row) {
  if (!row.said.empty())
    std::printf("%-28s %-6s %-17s answers %s\n", row.scenario.c_str(), row.scalar.c_str(), row.engine.c_str(),
                row.said.c_str());
  else
    std::printf("%-28s %-6s %-17s %8s %8s %8s %8s  %s\n", row.scenario.c_str(), row.scalar.c_str(), row.engine.c_str(),
                cell(row.nominal_error).c_str(), cell(row.engine_error).c_str(), cell(row.our_error).c_str(),
                cell(row.ratio).c_str(),
                row.excluded ? "excluded"
                : row.pass   ? "ok"
                             : "FAIL");
}

struct Options {
  std::string scenario, json;
  int instances = 50;
};

int run(const Options& options) {
  const auto peers = stability::all_peers();
  Json all = Json::array();
  int failed = 0;
  std::printf("%-28s %-6s %-17s %8s %8s %8s %8s\n", "scenario", "scalar", "engine", "error", "median", "ours", "ratio");
  for (const auto& scenario : cases::scenarios()) {
    if (scenario.name.find(options.scenario) == std::string::npos) continue;
    std::fprintf(stderr, "stability: engines on %s\n", scenario.name.c_str());
    for (const Comparison& row : stability::compare(scenario, peers, options.instances)) {
      print(row);
      all.push_back(json_of(row));
      failed += !row.pass;
    }
  }
  if (all.empty()) throw std::runtime_error("no scenario's name holds '" + options.scenario + "'");
  std::printf("%zu comparisons, in %d an engine is more than %g times more exact\n", all.size(), failed,
              stability::admissible_ratio);
  if (!options.json.empty()) stability::write(options.json, all);
  return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** values) {
  Options options;
  host_sim::CommandLine line("Other engines' forward dynamics on stiff and extreme chains", "stability");
  line.option("--scenario", options.scenario, "only scenarios whose names hold this");
  line.option("--instances", options.instances, "perturbed instances a scenario").range(1, 1000);
  line.option("--json", options.json, "write the rows as an array of objects");
  return line.run(count, values, [&] { return run(options); });
}

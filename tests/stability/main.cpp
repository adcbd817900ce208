// Runs the suite: a table, and JSON for the pictures.
#include <cstdio>
#include <host_sim/tools/output/command_line.hpp>
#include <stability/ablation.hpp>
#include <stability/compiled/rows.hpp>
#include <stability/derivatives.hpp>
#include <stability/fixed/rows.hpp>
#include <stability/json.hpp>
#include <stability/rows.hpp>

namespace {

using stability::cell;
using stability::Json;
using stability::number;

Json json_of(const stability::Row& row) {
  return {{"kind", "gate"},
          {"scenario", row.scenario},
          {"family", row.family},
          {"scalar", row.scalar},
          {"route", row.route},
          {"joints", row.joints},
          {"condition", number(row.condition)},
          {"forward_error", number(row.forward)},
          {"forward_error_absolute", row.absolute},
          {"backward_error", number(row.backward)},
          {"gate", number(row.gate.forward)},
          {"gate_backward", number(row.gate.backward)},
          {"pass", row.pass},
          {"status", row.status}};
}

Json json_of(const stability::DerivativeRow& row) {
  return {{"kind", "derivatives"},
          {"scenario", row.scenario},
          {"family", row.family},
          {"scalar", row.scalar},
          {"route", row.block},
          {"joints", row.joints},
          {"condition", number(row.condition)},
          {"forward_error", number(row.error)},
          {"backward_error", nullptr},
          {"gate", number(row.gate)},
          {"pass", row.pass},
          {"status", row.status}};
}

Json json_of(const stability::AblationRow& row) {
  return {{"kind", "ablation"},
          {"scenario", row.scenario},
          {"scalar", row.scalar},
          {"route", row.variant},
          {"forward_error", number(row.forward)},
          {"backward_error", nullptr},
          {"gate", nullptr},
          {"pass", true},
          {"status", "ok"}};
}

void print(const stability::DerivativeRow& row) {
  std::printf("%-34s %-6s %-22s %8s %8s %8s %8s  %-4s %s\n", row.scenario.c_str(), row.scalar.c_str(),
              row.block.c_str(), cell(row.condition).c_str(), cell(row.error).c_str(), "", cell(row.gate).c_str(),
              row.pass ? "ok" : "FAIL", row.status.c_str());
}

void print(const stability::Row& row) {
  std::printf("%-34s %-6s %-22s %8s %8s %8s %8s  %-4s %s\n", row.scenario.c_str(), row.scalar.c_str(),
              row.route.c_str(), cell(row.condition).c_str(), cell(row.forward).c_str(), cell(row.backward).c_str(),
              cell(row.gate.forward).c_str(), row.pass ? "ok" : "FAIL", row.status.c_str());
}

/// Scenarios down, variants across.
void print(const std::vector<stability::AblationRow>& rows) {
  std::string last;
  for (const auto& row : rows) {
    const std::string name = row.scenario + " " + row.scalar;
    if (name != last) std::printf("\n%-34s", name.c_str());
    std::printf(" %s:%s", row.variant.c_str(), cell(row.forward).c_str());
    last = name;
  }
  std::printf("\n");
}

struct Options {
  std::string scenario, json;
  bool ablation = false;
};

/// Rows in a table and in JSON; how many missed their gates.
template <class Row>
std::ptrdiff_t take(const std::vector<Row>& rows, Json& all) {
  std::ptrdiff_t failed = 0;
  for (const Row& row : rows) {
    print(row);
    all.push_back(json_of(row));
    failed += !row.pass;
  }
  return failed;
}

void tell(const std::string& name) { std::fprintf(stderr, "stability: %s\n", name.c_str()); }

int run(const Options& options) {
  auto rows = stability::all_rows(options.scenario, tell);
  for (const auto& more : {stability::default_rows(options.scenario), stability::fixed_rows(options.scenario)})
    rows.insert(rows.end(), more.begin(), more.end());
  if (rows.empty()) throw std::runtime_error("no scenario's name holds '" + options.scenario + "'");
  std::printf("%-34s %-6s %-22s %8s %8s %8s %8s  %-4s %s\n", "scenario", "scalar", "route", "cond(M)", "forward",
              "backward", "gate", "", "status");
  Json all = Json::array();
  const auto derived = stability::derivative_rows(options.scenario, tell);
  const std::ptrdiff_t failed = take(rows, all) + take(derived, all);
  std::printf("%zu answers, %td outside their gates\n", rows.size() + derived.size(), failed);
  if (options.ablation) {
    const auto ablation = stability::ablation();
    print(ablation);
    for (const auto& row : ablation)
      all.push_back(json_of(row));
  }
  if (!options.json.empty()) stability::write(options.json, all);
  return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** values) {
  Options options;
  host_sim::CommandLine line("Forward dynamics on stiff and extreme chains", "stability");
  line.option("--scenario", options.scenario, "only scenarios whose names hold this");
  line.option("--json", options.json, "write the rows as an array of objects");
  line.flag("--ablation", options.ablation, "also what each improvement of the articulated bodies is worth");
  return line.run(count, values, [&] { return run(options); });
}

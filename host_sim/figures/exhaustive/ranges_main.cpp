// Overflows, certified errors and bounds of fixed point, robot by robot, over as many states as there is time for.
#include <host_sim/figures/exhaustive/ranges_rows.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>
#include <robots/robots.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <stdexcept>

namespace {

using exhaustive::Options;
using nlohmann::ordered_json;

void print(const ordered_json& rows) {
  host_sim::Table overflow({"robot", "kernel", "arithmetic", "states", "overflows"});
  host_sim::Table error({"robot", "joint", "worst error", "float", "worst by search", "certified", "looseness"});
  host_sim::Table bound({"robot", "quantity", "nearest to its bound"});
  const auto number = [](const ordered_json& value) { return host_sim::significant(value.get<double>(), 3); };
  for (const auto& one : rows) {
    const std::string robot = one["robot"];
    if (one["subject"] == "overflow")
      overflow.add({robot, one["kernel"], one["arithmetic"], host_sim::grouped(one["states"].get<std::uint64_t>()),
                    std::to_string(one["overflows"].get<std::uint64_t>())});
    else if (one["subject"] == "bound")
      bound.add({robot, one["quantity"], number(one["nearest"])});
    else
      error.add({robot, std::to_string(one["joint"].get<int>()), number(one["error"]), number(one["error_float"]),
                 number(one["error_searched"]), number(one["certified"]), number(one["looseness"])});
  }
  for (const auto* table : {&overflow, &error, &bound})
    std::printf("%s\n", table->text().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  host_sim::CommandLine line("overflows, certified errors and bounds of fixed point", "exhaustive");
  Options options;
  std::string json;
  line.option("--states", options.states).range(std::uint64_t{1000}, std::uint64_t{1} << 40);
  line.option("--processes", options.processes).range(1, 64);
  line.option("--seed", options.seed);
  line.flag("--overflows", options.overflows_only);
  line.option("--robot", options.robot);
  line.option("--json", json);
  line.option("--commit", options.commit);
  return line.run(argc, argv, [&] {
    ordered_json rows = ordered_json::array();
    bool holds = true, known = false;
    const auto visit = [&](auto robot) {
      using R = typename decltype(robot)::Robot;
      if (options.robot != "all" && options.robot != R::name) return;
      known = true;
      exhaustive::add_rows<R>(options, rows, holds);
    };
    robots::All::for_each(visit), robots::Published::for_each(visit);
    if (!known) throw std::runtime_error("no robot is called '" + options.robot + "'");
    print(rows);
    if (!json.empty()) host_sim::write_json(json, rows);
    if (!holds) std::fprintf(stderr, "exhaustive: a bound does not hold\n");
    return holds ? 0 : 1;
  });
}

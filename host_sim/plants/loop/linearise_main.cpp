// linearise: an arm at a point of its cycle as a linear system, for solvers of other people.
#include <host_sim/plants/loop/linear_arm.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace {

using namespace host_sim::loop;

struct Options {
  std::string robot = "puma560", format = "tinympc", output = "output/lqr";
  double at = 1.0, tick = 0.01, rho = 1e-3;
  int horizon = 10;
};

nlohmann::json by_rows(const Table2& table) {
  nlohmann::json rows = nlohmann::json::array();
  for (int i = 0; i < table.rows; ++i) {
    nlohmann::json row = nlohmann::json::array();
    for (int j = 0; j < table.columns; ++j)
      row.push_back(table(i, j));
    rows.push_back(row);
  }
  return rows;
}

nlohmann::json to_json(const LinearArm& arm) {
  return {{"robot", arm.robot},  {"time_s", arm.at.time},
          {"tick_s", arm.tick},  {"q", arm.at.q},
          {"qd", arm.at.qd},     {"qdd", arm.at.qdd},
          {"tau", arm.tau},      {"A", by_rows(arm.A)},
          {"B", by_rows(arm.B)}, {"Q", arm.Q},
          {"R", arm.R},          {"x_min", arm.low_x},
          {"x_max", arm.high_x}, {"u_min", arm.low_u},
          {"u_max", arm.high_u}};
}

int write(const Options& options) {
  host_sim::make_folder(options.output);
  const LinearArm arm = linear_arm(options.robot, options.at, options.tick);
  const bool header = options.format == "tinympc";
  const std::string path = options.output + "/linear-" + options.robot + (header ? ".hpp" : ".json");
  if (header) {
    std::ofstream file(path);
    file << tinympc_header(arm, options.horizon, options.rho);
    if (!file) throw std::runtime_error("cannot write " + path);
  } else {
    host_sim::write_json(path, to_json(arm));
  }
  std::printf("%s: %s at %g s, %d states and %d efforts, a step is %g s\n", path.c_str(), arm.robot.c_str(),
              arm.at.time, arm.B.rows, arm.B.columns, arm.tick);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  host_sim::CommandLine line("an arm at a point of its cycle as a linear system", "linearise");
  line.option("--robot", options.robot, "that has a cycle in host_sim/robots/trajectories").show_default();
  line.option("--export", options.format, "tinympc: a header; json").one_of({"tinympc", "json"}).show_default();
  line.option("--at", options.at, "s into the cycle").show_default().range(0.0, 3600.0);
  line.option("--tick", options.tick, "s, of a step").show_default().range(1e-5, 1.0);
  line.option("--horizon", options.horizon, "stages of the problem").show_default().range(2, 1000);
  line.option("--rho", options.rho, "penalty of TinyMPC's iteration").show_default().range(1e-9, 1e9);
  line.option("--output", options.output, "folder of the file").show_default();
  return line.run(count, arguments, [&] { return write(options); });
}

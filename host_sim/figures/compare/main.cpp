// Writes the errors of Newton-Euler, separation and closed form, and of two-rate feed-forward, as JSON on standard
// output.
#include <host_sim/figures/compare/methods.hpp>
#include <host_sim/robots/trajectory/files.hpp>
#include <host_sim/tools/output/command_line.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace {

nlohmann::ordered_json measured(const std::string& trajectories) {
  nlohmann::ordered_json methods = nlohmann::ordered_json::array(), rates = methods;
  for (const std::string& name : compare::robots()) {
    std::fprintf(stderr, "compare: errors of %s\n", name.c_str());
    for (const auto& e : compare::method_errors(name))
      methods.push_back({{"robot", e.robot},
                         {"method", e.method},
                         {"scalar", e.scalar},
                         {"error", e.error},
                         {"error_rms", e.error_rms}});
    const auto robot = host_sim::find_robot(name);
    const auto cycle = host_sim::load_trajectory(trajectories + "/" + name + ".json", name, robot.limits);
    for (const auto& e : compare::two_rate_errors(name, cycle))
      rates.push_back({{"robot", e.robot},
                       {"ticks", e.ticks},
                       {"error", e.error},
                       {"error_rms", e.error_rms},
                       {"error_ahead", e.error_ahead}});
  }
  return {{"methods", methods}, {"two_rate", rates}};
}

}  // namespace

int main(int argc, char** argv) {
  host_sim::CommandLine line("errors of the ways to a torque");
  std::string trajectories;
  line.option("trajectories", trajectories, "folder of the robots' cycles").required();
  return line.run(argc, argv, [&] {
    std::printf("%s\n", measured(trajectories).dump(1).c_str());
    return 0;
  });
}

// Writes the errors of every number system as JSON on standard output.
#include <host_sim/numbers/errors.hpp>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <exception>

namespace {

nlohmann::ordered_json measured(const std::string& robot) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const std::string& name : robot.empty() ? numbers::robots() : std::vector<std::string>{robot}) {
    std::fprintf(stderr, "numbers: errors of %s\n", name.c_str());
    for (const auto& row : numbers::rows(name)) {
      nlohmann::ordered_json object{{"robot", row.robot},   {"algorithm", row.algorithm}, {"scalar", row.scalar},
                                    {"states", row.states}, {"error", row.error},         {"error_rms", row.error_rms}};
      if (row.certified) object["error_certified"] = *row.certified;
      rows.push_back(object);
    }
  }
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("errors of a torque in every number system");
  std::string robot;
  app.add_option("--robot", robot, "only this robot");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    std::printf("%s\n", measured(robot).dump(1).c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "numbers: %s\n", error.what());
    return 1;
  }
}

// robot_regressor: what identify.py and excite.py ask of the library: a robot's parameters, limits, regressor, header.
#include <host_sim/description/header.hpp>
#include <host_sim/description/table.hpp>
#include <host_sim/identification/regressor.hpp>
#include <host_sim/identification/robot_file.hpp>
#include <host_sim/output/command_line.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

namespace {

using namespace host_sim::identification;

nlohmann::json limit(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); }

nlohmann::json joint(const axial::LinkParameters& link) {
  return {{"prismatic", link.type == axial::JointType::prismatic},
          {"position_min", limit(link.position_min)},
          {"position_max", limit(link.position_max)},
          {"speed", limit(link.speed_limit)},
          {"acceleration", limit(link.acceleration_limit)},
          {"effort", limit(link.effort_limit)},
          {"parameters", to_parameters(link)}};
}

void describe(const description::Description& robot) {
  nlohmann::json joints = nlohmann::json::array();
  for (const description::Link& link : robot.links)
    joints.push_back(joint(link.parameters));
  const nlohmann::json all = {{"name", robot.name}, {"parameters", parameter_names}, {"joints", joints}};
  std::printf("%s\n", all.dump().c_str());
}

template <class T>
bool read(T* values, std::size_t count) {
  return std::fread(values, sizeof(T), count, stdin) == count;
}

// A request: a count, then so many states q, qd, qdd. The answer: [Y, known] of each.
void answer(const description::Description& robot) {
  const Regressor regressor(robot);
  const auto n = static_cast<std::size_t>(regressor.joints());
  const std::size_t width = n * (static_cast<std::size_t>(regressor.columns()) + 1);
  for (std::int64_t count = 0; read(&count, 1);) {
    std::vector<double> states(static_cast<std::size_t>(count) * 3 * n), rows(static_cast<std::size_t>(count) * width);
    if (!read(states.data(), states.size())) throw std::runtime_error("a request ends early");
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const double* state = states.data() + i * 3 * n;
      regressor.evaluate(state, state + n, state + 2 * n, rows.data() + i * width);
    }
    std::fwrite(rows.data(), sizeof(double), rows.size(), stdout);
    std::fflush(stdout);
  }
}

// What is known now is assumed no more.
void forget_missing_rotors(std::vector<std::string>& assumptions) {
  const auto names_rotors = [](const std::string& text) { return text.rfind(description::no_rotors, 0) == 0; };
  assumptions.erase(std::remove_if(assumptions.begin(), assumptions.end(), names_rotors), assumptions.end());
}

// `values`: a JSON file of "name", "source", "parameters" (all links'), "notes", "rotors_fitted", "fitted", "figures".
void write_header(description::Description robot, const std::string& values, const std::string& path) {
  const auto json = nlohmann::json::parse(description::read_text(values));
  const auto parameters = json.at("parameters").get<std::vector<double>>();
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    Parameters own{};
    for (std::size_t p = 0; p < own.size(); ++p)
      own[p] = parameters.at(i * own.size() + p);
    robot.links[i].parameters = with_parameters(robot.links[i].parameters, own);
  }
  robot.name = json.at("name").get<std::string>();
  robot.source += json.at("source").get<std::string>();
  for (const auto& note : json.at("notes"))
    robot.notes.push_back(note.get<std::string>());
  robot.fitted = json.at("fitted").get<std::vector<std::string>>();
  if (json.at("rotors_fitted").get<bool>()) forget_missing_rotors(robot.assumptions);
  const auto rewritten = description::write_header(path, robot, json.at("figures").get<std::vector<std::string>>());
  std::fputs(description::said_of(path, rewritten).c_str(), stderr);
}

}  // namespace

int main(int count, char** arguments) {
  std::string robot, tip, values, path;
  host_sim::CommandLine line("a robot's parameters, limits and regressor, for identify.py and excite.py",
                             "robot_regressor");
  line.option("--robot", robot, "name as in robots/README.md, a table (.json) or a URDF").required();
  line.option("--tip", tip, "where the chain of a URDF ends");
  line.verb("describe", "name, limits and standard parameters as JSON", [&] { describe(find_robot(robot, tip)); });
  line.verb("answer", "regressors of the states that come in on standard input, in binary",
            [&] { answer(find_robot(robot, tip)); });
  auto header = line.verb("header", "writes the header of the robot with other parameters",
                          [&] { write_header(find_robot(robot, tip), values, path); });
  header.option("--values", values, "JSON: name, source, parameters, notes, rotors_fitted, fitted, figures").required();
  header.option("-o", path, "the header").required();
  return line.run(count, arguments, [] { return 0; });
}

#include <host_sim/robots/description/header.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/identification/regressor.hpp>
#include <host_sim/robots/identification/service.hpp>
#include <host_sim/tools/output/command_line.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

namespace host_sim::identification {

namespace {

nlohmann::json limit(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); }

nlohmann::json limits(const axial::LinkParameters& of) {
  return {{"position_min", limit(of.position_min)},
          {"position_max", limit(of.position_max)},
          {"speed", limit(of.speed_limit)},
          {"acceleration", limit(of.acceleration_limit)},
          {"effort", limit(of.effort_limit)}};
}

// Of what a log has a column: a joint, or a drive that joints share. Its unit is m where a slide follows it one to one,
// else rad; `periodic`: a turn of it leaves all joints where they were.
nlohmann::json value(const description::Description& robot, const axial::DriveMatrix<description::most_links>& g,
                     int k) {
  const auto& owner = robot.links[static_cast<std::size_t>(g.owner[k])].parameters;
  const bool slides = owner.type == axial::JointType::prismatic;
  bool periodic = true;
  for (int i = 0; i < robot.size(); ++i)
    if (g.is_moved(i, k))
      periodic = periodic && robot.links[static_cast<std::size_t>(i)].parameters.type == axial::JointType::revolute &&
                 g.ratio[i][k] == std::round(g.ratio[i][k]);
  auto all =
      limits(description::shares_drives(robot) ? axial::detail::drive_by_itself(owner, g.is_alone(g.owner[k])) : owner);
  all["prismatic"] = slides && std::abs(g.ratio[g.owner[k]][k]) == 1.0;
  all["periodic"] = periodic;
  return all;
}

// "joints": of what a log has columns. "links": all of the tree, with the index of the drive that each owns (null:
// none), how drives move its joint (q = ratios u + offset) and the joint's own limits.
void describe(const description::Description& robot) {
  const auto g = description::drive_matrix(robot);
  nlohmann::json joints = nlohmann::json::array(), links = nlohmann::json::array();
  for (int k = 0; k < g.drives; ++k)
    joints.push_back(value(robot, g, k));
  for (int i = 0; i < robot.size(); ++i) {
    const auto& parameters = robot.links[static_cast<std::size_t>(i)].parameters;
    auto link = limits(parameters);
    link["parameters"] = to_parameters(parameters);
    link["drive"] = g.drive_of(i) < 0 ? nlohmann::json() : nlohmann::json(g.drive_of(i));
    link["ratios"] = std::vector<double>(g.ratio[i], g.ratio[i] + g.drives);
    link["offset"] = g.offset[i];
    links.push_back(link);
  }
  const nlohmann::json all = {{"name", robot.name},
                              {"parameters", parameter_names},
                              {"shares_drives", description::shares_drives(robot)},
                              {"joints", joints},
                              {"links", links}};
  std::printf("%s\n", all.dump().c_str());
}

template <class T>
bool read(T* values, std::size_t count) {
  return std::fread(values, sizeof(T), count, stdin) == count;
}

// A request: a count, then so many states q, qd, qdd. The answer: [Y, known] of each.
void answer(const description::Description& robot) {
  const Regressor regressor(robot);
  const auto n = static_cast<std::size_t>(regressor.drives());
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

// A header that was identified before says so already.
void add_note(std::vector<std::string>& notes, const std::string& note) {
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
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
    add_note(robot.notes, note.get<std::string>());
  robot.fitted = json.at("fitted").get<std::vector<std::string>>();
  if (json.at("rotors_fitted").get<bool>()) forget_missing_rotors(robot.assumptions);
  if (!robot.assumptions.empty())
    robot.fitted.emplace_back("what is fitted is assumed no longer, unless it is not determined");
  const auto rewritten = description::write_header(path, robot, json.at("figures").get<std::vector<std::string>>());
  std::fputs(description::said_of(path, rewritten).c_str(), stderr);
}

}  // namespace

int serve(CommandLine& line, int count, char** arguments, const std::function<description::Description()>& find) {
  std::string values, path;
  line.verb("describe", "name, limits and standard parameters as JSON", [&] { describe(find()); });
  line.verb("answer", "regressors of the states that come in on standard input, in binary", [&] { answer(find()); });
  auto header = line.verb("header", "writes the header of the robot with other parameters",
                          [&] { write_header(find(), values, path); });
  header.option("--values", values, "JSON: name, source, parameters, notes, rotors_fitted, fitted, figures").required();
  header.option("-o", path, "the header").required();
  return line.run(count, arguments, [] { return 0; });
}

}  // namespace host_sim::identification

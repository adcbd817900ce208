#include <host_sim/robots/commissioning/gravity.hpp>
#include <host_sim/robots/commissioning/service.hpp>
#include <host_sim/robots/description/coordinates.hpp>
#include <host_sim/robots/description/header.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/tools/output/command_line.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <sstream>

namespace host_sim::commissioning {

namespace {

using description::Description;
using nlohmann::json;

json limit(double value) { return std::isfinite(value) ? json(value) : json(); }

// Joint k, or drive k by the joint that owns it. A drive is told in metres where it moves its own slide one to one.
json joint(const Description& robot, const axial::DriveMatrix<description::most_links>& g, int k) {
  const int owner = g.owner[k];
  const description::Link& given = robot.links[static_cast<std::size_t>(owner)];
  axial::LinkParameters link = given.parameters;
  const bool shares = description::shares_drives(robot), alone = g.is_alone(owner);
  const bool slides = link.type == axial::JointType::prismatic && std::abs(g.ratio[owner][k]) == 1.0;
  if (shares) link = axial::detail::drive_by_itself(link, alone);
  return {{"name", given.joint},
          {"prismatic", slides},
          {"alone", !shares || alone},
          {"position_min", limit(link.position_min)},
          {"position_max", limit(link.position_max)},
          {"effort", limit(link.effort_limit)},
          {"coulomb_forward", link.coulomb_forward},
          {"coulomb_backward", link.coulomb_backward},
          {"static_friction", link.static_friction}};
}

void describe(const Description& robot) {
  const auto g = description::drive_matrix(robot);
  json joints = json::array(), moved = json::array();
  for (int k = 0; k < g.drives; ++k)
    joints.push_back(joint(robot, g, k));
  for (int i = 0; i < robot.size(); ++i) {
    const auto& link = robot.links[static_cast<std::size_t>(i)].parameters;
    const std::vector<double> ratios(g.ratio[i], g.ratio[i] + g.drives);
    moved.push_back({{"ratios", ratios},
                     {"offset", g.offset[i]},
                     {"position_min", limit(link.position_min)},
                     {"position_max", limit(link.position_max)}});
  }
  const axial::Angle alpha = robot.links.front().parameters.alpha;
  const json all = {{"name", robot.name},
                    {"joints", joints},
                    {"shares_drives", description::shares_drives(robot)},
                    {"links", moved},
                    {"gravity", {robot.gravity.x, robot.gravity.y, robot.gravity.z}},
                    {"first_axis", {0.0, -alpha.sin, alpha.cos}}};
  std::printf("%s\n", all.dump().c_str());
}

template <class T>
bool read(T* values, std::size_t count) {
  return std::fread(values, sizeof(T), count, stdin) == count;
}

// A request: a count, then so many q. The answer: the parts of each.
void answer(const Description& robot, const std::string& at) {
  std::array<double, 3> place{};
  std::istringstream(at) >> place[0] >> place[1] >> place[2];
  const GravityParts gravity(robot, place);
  const auto n = static_cast<std::size_t>(gravity.values()), width = n * GravityParts::parts;
  for (std::int64_t count = 0; read(&count, 1);) {
    const auto states = static_cast<std::size_t>(count);
    std::vector<double> q(states * n), rows(states * width);
    if (!read(q.data(), q.size())) throw std::runtime_error("a request ends early");
    for (std::size_t i = 0; i < states; ++i)
      gravity.evaluate(q.data() + i * n, rows.data() + i * width);
    std::fwrite(rows.data(), sizeof(double), rows.size(), stdout);
    std::fflush(stdout);
  }
}

// Friction as found: beside a declared breakaway effort, Coulomb's keeps its share of it.
void mend_friction(axial::LinkParameters& link, double forward, double backward) {
  const double found = 0.5 * (forward - backward);
  if (link.static_friction > 0.0) {
    const double share = found / link.static_friction;
    link.static_friction = found;
    link.coulomb_forward *= share, link.coulomb_backward *= share;
  } else {
    link.coulomb_forward = forward, link.coulomb_backward = backward;
  }
}

// Of drives that joints share friction alone: what their zeros and signs are is in no row of a chain.
void mend_joint(Description& robot, int i, const json& found) {
  if (!found.at("friction").is_null())
    mend_friction(robot.links[static_cast<std::size_t>(i)].parameters, found.at("friction").at(0).get<double>(),
                  found.at("friction").at(1).get<double>());
  if (const auto zero = found.at("zero").get<double>(); zero != 0.0) description::shift_zero(robot, i, zero);
  if (found.at("turned").get<bool>()) description::turn_axis(robot, i);
}

// `values`: a JSON file of "name", "source", "notes", "fitted", "gravity", "joints" (zero, turned, friction each).
void write_header(Description robot, const std::string& values, const std::string& path) {
  const auto all = json::parse(description::read_text(values));
  const auto g = description::drive_matrix(robot);
  for (int k = 0; k < g.drives; ++k)
    mend_joint(robot, g.owner[k], all.at("joints").at(static_cast<std::size_t>(k)));
  const auto down = all.at("gravity").get<std::array<double, 3>>();
  robot.gravity = {down[0], down[1], down[2]};
  robot.name = all.at("name").get<std::string>();
  robot.source += all.at("source").get<std::string>();
  for (const auto& note : all.at("notes"))
    robot.notes.push_back(note.get<std::string>());
  robot.fitted = all.at("fitted").get<std::vector<std::string>>();
  const auto rewritten = description::write_header(path, robot, {});
  std::fputs(description::said_of(path, rewritten).c_str(), stderr);
}

}  // namespace

int serve(CommandLine& line, int count, char** arguments, const std::function<Description()>& find) {
  std::string at = "0 0 0", values, path;
  line.option("--at", at, "where the mass is, in the tool's axes: three numbers, m");
  line.verb("describe", "name, gravity and joints as JSON", [&] { describe(find()); });
  line.verb("answer", "gravity's parts at the positions that come in on standard input, in binary",
            [&] { answer(find(), at); });
  auto header = line.verb("header", "writes the mended header", [&] { write_header(find(), values, path); });
  header.option("--values", values, "JSON: name, source, notes, fitted, gravity, joints").required();
  header.option("-o", path, "the header").required();
  return line.run(count, arguments, [] { return 0; });
}

}  // namespace host_sim::commissioning

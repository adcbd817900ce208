// A robot as a value: what an importer reads, an identification changes and a header is written from.
#pragma once

#include <axial/robot/chain.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace description {

/// A description that cannot be used. The message has a line a problem: what, value, remedy.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A link and the joint that moves it, in MDH frames and SI units.
struct Link {
  std::string name;   ///< of the link, as its source calls it
  std::string joint;  ///< of the joint
  axial::LinkParameters parameters{};
};

/// A robot: links from the base outwards (a parent stands before its children), and where everything comes from.
struct Description {
  std::string name;    ///< as the source calls it
  std::string source;  ///< file, table, paper: who says so
  std::vector<Link> links;
  axial::GravityVector gravity{};                  ///< m/s^2, free fall, axes of frame 0
  axial::FixedPose base{};                         ///< frame 0 in the world
  axial::FixedPose tool{};                         ///< the tool in the last link's frame
  std::optional<axial::LinkParameters> base_body;  ///< of a base that floats: mass, com, inertia in frame 0
  axial::PayloadLimit payload_limit{};
  axial::TipWrenchLimit tip_wrench_limit{};
  axial::ToolLimit tool_limit{};
  bool as_published = false;             ///< numbers that no robot should have are kept, and the header says so
  std::vector<std::string> notes;        ///< how the source was read
  std::vector<std::string> assumptions;  ///< what the source does not say and was filled in
  std::vector<std::string> fitted;       ///< what was found from measurements, and how well it explains them

  int size() const { return static_cast<int>(links.size()); }
  /// Index of the link that carries joint i, or axial::LinkParameters::base.
  int parent(int i) const {
    const int given = links[static_cast<std::size_t>(i)].parameters.parent;
    return given == axial::LinkParameters::previous ? i - 1 : given;
  }
};

/// How the assumption begins that joints have no rotors, which an identification of rotors ends.
constexpr const char* no_rotors = "no rotor inertias";

/// Links that a run-time model of a description has room for.
constexpr int most_links = 64;

/// What the drives of a description make of its joints: q = G u + q0, the first size() rows of it.
inline axial::DriveMatrix<most_links> drive_matrix(const Description& robot) {
  axial::LinkParameters links[most_links];
  const int n = robot.size() < most_links ? robot.size() : most_links;
  for (int i = 0; i < n; ++i)
    links[i] = robot.links[static_cast<std::size_t>(i)].parameters;
  auto g = axial::drive_matrix_of(links);
  while (g.drives > 0 && g.owner[g.drives - 1] >= n)  // links that are not there
    --g.drives;
  return g;
}
/// Whether joints share drives.
inline bool shares_drives(const Description& robot) {
  for (const Link& link : robot.links)
    if (link.parameters.drives.count > 0) return true;
  return false;
}

/// The run-time model of a description: Model is axial::Model<N, Features...>. Throws Refused where it does not fit.
template <class Model>
Model to_model(const Description& robot) {
  Model model;
  for (const Link& link : robot.links)
    if (!model.add(link.parameters))
      throw Refused(link.parameters.drives.count > 0 && robot.size() <= most_links
                        ? "joints share drives ('" + link.name + "' follows others), which is not known here: " +
                              "describe them without, and give each joint's own effort"
                        : "link '" + link.name + "' does not fit: at most " + std::to_string(most_links) +
                              " joints, and a parent stands before its children");
  if (!model.drives_are_sound())
    throw Refused("the drives of " + robot.name + " do not move its joints independently of each other");
  model.set_gravity(robot.gravity.x, robot.gravity.y, robot.gravity.z);
  model.set_base(robot.base);
  model.set_tool(robot.tool);
  return model;
}

/// A robot of the project's own headers, struct R with a chain, as a description; links are called link1, link2, ...
template <class R>
Description from_robot() {
  Description robot;
  robot.name = R::name, robot.source = std::string("robots/") + R::name + ".hpp";
  for (int i = 0; i < R::chain.size; ++i) {
    const std::string number = std::to_string(i + 1);
    robot.links.push_back({"link" + number, "joint" + number, R::chain.links[i]});
  }
  robot.as_published = true;  // its own header has said so where it had to
  robot.gravity = R::chain.gravity, robot.base = R::chain.base.pose, robot.tool = R::chain.tool.pose;
  robot.payload_limit = R::chain.payload_limit, robot.tip_wrench_limit = R::chain.tip_wrench_limit;
  robot.tool_limit = R::chain.tool_limit;
  if (R::chain.has_base_body) robot.base_body = R::chain.base_body;
  return robot;
}

}  // namespace description

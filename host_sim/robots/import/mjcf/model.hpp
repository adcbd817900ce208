// The bodies of an MJCF in a row, frames and default classes resolved: before anything is chosen or cut.
#pragma once

#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/import/bodies.hpp>
#include <host_sim/robots/import/mjcf/attributes.hpp>
#include <host_sim/robots/import/mjcf/settings.hpp>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace importer::mjcf {

struct JointNode {
  Attributes attributes;
  std::string name;
  bool named = false;
  std::string type;                                        ///< hinge, slide, ball
  Vector axis = Vector::UnitZ(), anchor = Vector::Zero();  ///< in the body's frame
  double zero = 0.0;                                       ///< rad or m: its position as the file draws it
  bool limited = false;
  double lower = 0.0, upper = 0.0;

  bool turns() const { return type == "hinge"; }
};

/// What is fixed to a body, in the frame that its own pose is given in.
struct Fixed {
  Attributes attributes;
  Pose frame;  ///< in the body's
};

struct BodyNode {
  std::string name, place;
  bool named = false;
  int parent = -1;  ///< in the row, -1 for the world, which is the first
  Pose pose;        ///< in its parent's frame
  bool free = false;
  std::string free_joint;
  std::vector<JointNode> joints;
  std::vector<Fixed> geoms, sites;
  std::optional<Attributes> inertial;

  bool moves() const { return !joints.empty() || free; }
};

struct Model {
  std::string name;
  Element root;  ///< what all attributes point into
  Settings settings;
  std::optional<Defaults> defaults;
  std::vector<BodyNode> bodies;            ///< in MuJoCo's order: parents first, as they stand
  std::vector<std::vector<int>> children;  ///< of each body
  std::map<std::string, int> body_of_name, body_of_site;
  std::map<std::string, std::pair<int, std::size_t>> joint_of_name;  ///< body, and which of its joints
  std::map<std::string, const Element*> tendon_of_name;
  std::vector<std::string> notes;
  std::vector<description::Finding> warnings;
  double length_digit = 1e-6;  ///< m: how fine positions are written
};

/// Reads into a model that stays where it is. Throws description::Refused with file, line, element, attribute, value
/// and remedy.
void read_model(const std::string& text, const std::string& from, Model& model);

/// Mass and inertia in the body's frame: of its <inertial> or its geoms, with the bounds of the settings.
Body inertia_of(const BodyNode& body, const Settings& settings);
/// Whether MuJoCo diagonalises it, and so knows it less exactly.
bool is_diagonalised(const BodyNode& body, const Settings& settings);

}  // namespace importer::mjcf

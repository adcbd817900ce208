// Links and joints as a file has them, whatever its format, cut to what is imported: nothing is merged or turned yet.
#pragma once

#include <host_sim/robots/description/findings.hpp>

#include <array>
#include <string>
#include <vector>

namespace importer {

using Rows = std::array<double, 9>;  ///< a rotation, row by row

/// Pose of a frame in another one.
struct Placement {
  Rows rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::array<double, 3> position{};
};

/// A number of the file that is read as another one: what --right-angles and --snap do. The verification knows of no
/// others.
struct Change {
  enum class Of {
    joint_rpy,
    joint_xyz,
    joint_axis,
    inertial_rpy,
    joint_turn,
    row_angle,      ///< of a table: alpha, theta, gamma
    row_length,     ///< a, d, b
    pose_rotation,  ///< entries of "base" or "tool"
  };
  Of of = Of::joint_rpy;
  std::string name;  ///< of the joint, or of the link whose inertial frame or row it is
  std::size_t index = 0;
  double written = 0.0, read = 0.0;  ///< rad, m; of an axis as long as it is written; of a turn in the parent's axes
};

enum class Kind { fixed, revolute, continuous, prismatic };

struct SourceJoint {
  std::string name;
  Kind kind = Kind::fixed;
  bool held = false;  ///< beside the chain: it stays where `held_at` says
  double held_at = 0.0;
  Placement origin;  ///< in the parent link's frame
  std::array<double, 3> axis{};
  bool has_limits = false;                                     ///< of position; left blank, as 0 and 0, they are none
  double lower = 0.0, upper = 0.0, speed = 0.0, effort = 0.0;  ///< 0: none given
  double damping = 0.0, friction = 0.0;
  double rotor = 0.0;                  ///< kg m^2 or kg, on the joint's side
  double stiffness = 0.0, rest = 0.0;  ///< of a spring across the joint, N m/rad or N/m; rad or m
  std::string leader;                  ///< joint that it mimics: position ratio * leader + offset; empty: none
  double ratio = 1.0, offset = 0.0;    ///< rad or m

  bool moves() const { return kind != Kind::fixed && !held; }
};

/// A link, and the joint that carries it.
struct SourceLink {
  std::string name;
  int parent = -1;  ///< index of an earlier link; -1 for the root, whose joint means nothing
  SourceJoint joint;
  bool between = false;  ///< two joints of one body: it has no mass by itself
  bool has_inertial = false;
  double mass = 0.0;
  Placement inertial;               ///< frame of the centre of mass in the link's frame
  std::array<double, 6> inertia{};  ///< kg m^2 in the inertial frame: xx yy zz xy xz yz
};

/// Two joints that two drives share, each drive behind its own gear.
struct SourceTransmission {
  enum class Law { differential, four_bar };

  std::string name;
  Law law = Law::differential;
  std::string joints[2];              ///< in the order of their roles; drive k is named by joint k
  double reductions[2] = {1.0, 1.0};  ///< of the joints
};

struct SourceTree {
  std::string name;
  std::vector<SourceLink> links;  ///< parents first; the first is the root
  std::vector<SourceTransmission> transmissions;
  bool floating = false;      ///< the root moves freely, and its body is the base's
  int tool = -1;              ///< the link whose frame is the tool's, or -1
  double length_digit = 0.0;  ///< m: how fine its joints' origins are written, at most 1e-6
  std::vector<Change> changes;
  std::vector<std::string> notes;
  std::vector<description::Finding> warnings;  ///< of what is doubtful before anything is calculated
};

}  // namespace importer

// Orocos KDL, built from the source itself: from no MDH rows, and from a URDF by another reader than theirs.
#pragma once

#include <host_sim/robots/import/urdf/urdf_reader.hpp>

#include <kdl/tree.hpp>

#include <cmath>
#include <vector>

namespace importer {

/// What a file says of a joint beside where it is; 0 where it says nothing.
struct WrittenLimits {
  bool positions = false;  ///< whether it has limits of position
  double lower = 0.0, upper = 0.0, speed = 0.0, effort = 0.0, damping = 0.0, friction = 0.0;
  double backward = 0.0;               ///< friction in the other direction, > 0
  double stiffness = 0.0, rest = 0.0;  ///< of a spring across the joint
};

/// A KDL tree and how the joints of a description stand in it.
struct Reference {
  KDL::Tree tree{"root"};
  KDL::Frame world = KDL::Frame::Identity();  ///< the tree's root in the world
  KDL::Vector gravity;                        ///< m/s^2, axes of the tree's root
  std::vector<std::string> joints;            ///< KDL joint names in the description's order
  std::vector<double> rotors;                 ///< gear^2 J of each
  int drives = 0;                             ///< how many there are
  std::vector<std::vector<double>> ratios;    ///< of joints a unit of each drive
  std::vector<double> offsets;                ///< joint positions where drives are at 0
  std::string tool_segment;                   ///< what carries the tool; empty where none is checked
  KDL::Frame tool = KDL::Frame::Identity();   ///< in that segment
  std::vector<WrittenLimits> limits;          ///< of each joint; none where they are not compared
  double changed_angle = 0.0;        ///< rad: the farthest that an angle or an axis is read from what is written
  double changed_angle_bound = 0.0;  ///< rad: the farthest that it may be
  double changed_length = 0.0;       ///< m: the farthest that an origin is
};

/// |v|. KDL's Norm() takes what is shorter than 1e-6, and longest along x, for nothing.
inline double length_of(const KDL::Vector& v) { return std::hypot(v.x(), v.y(), v.z()); }

/// Name in the tree of the segment of a table's row, counted from 1, and of a URDF's link.
inline std::string segment_name(int index) { return "segment" + std::to_string(index); }
inline std::string segment_name(const std::string& link) { return "link " + link; }

/// A segment a URDF link, fixed joints and inertial frames as they are written in the text, but for the changes that
/// are named. Throws description::Refused where these change what the file has not, or other joints move.
Reference reference_of(const std::string& text, const ReadingOptions& options, const std::vector<Change>& changes,
                       const axial::GravityVector& gravity, const std::vector<std::string>& joint_order,
                       const std::string& tool_link);

/// A segment a link of a source tree as it is now, whatever was read into it; `written` is the tree before anything in
/// it was changed, by as much as the options allow.
Reference reference_of(const SourceTree& tree, const SourceTree& written, const ReadingOptions& options,
                       const axial::GravityVector& gravity, const std::vector<std::string>& joint_order);

/// A segment a row of a JSON table, by KDL's own classical or modified Denavit-Hartenberg frames, but for the changes
/// that are named, which may be so far from what is written.
Reference reference_of(const std::string& text, const std::vector<Change>& changes, double changed_angle_bound);

}  // namespace importer

// Orocos KDL, built from the source itself and not from the MDH rows that are checked against it.
#pragma once

#include <host_sim/description/table.hpp>
#include <host_sim/import/source_tree.hpp>

#include <kdl/tree.hpp>

#include <vector>

namespace importer {

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
};

/// Name in the tree of the segment of a source's link.
std::string segment_name(int index);

/// A segment a URDF link, fixed joints and inertial frames as they are written.
Reference reference_of(const SourceTree& source, const axial::GravityVector& gravity,
                       const std::vector<std::string>& joint_order);

/// A segment a row, by KDL's own classical or modified Denavit-Hartenberg frames, bodies in them.
Reference reference_of(const description::Table& table);

}  // namespace importer

// A description beside where the frames of its source are in it: what a verification compares.
#pragma once

#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/import/source_tree.hpp>

#include <string>
#include <vector>

namespace importer {

/// A frame of the source, fixed to a link of the description.
struct TrackedFrame {
  std::string name;  ///< of the source's link
  int link = axial::LinkParameters::base;
  axial::FixedPose pose{};  ///< in that link's MDH frame; in the world where link is base
};

struct Imported {
  description::Description robot;
  std::vector<TrackedFrame> frames;
  std::vector<Change> changes;  ///< numbers of the source that are read as others
  std::vector<description::Finding> warnings;
};

}  // namespace importer

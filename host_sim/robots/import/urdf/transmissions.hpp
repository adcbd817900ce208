// Transmissions of a URDF: which joints share drives.
#pragma once

#include <host_sim/robots/import/source_tree.hpp>

#include <string>

namespace importer {

/// Adds the <transmission> elements of a URDF (of the robot, or of ros2_control) to what was read of it: differentials
/// and four-bar linkages of the transmission_interface, by their linear laws. A simple one is no coupling: its
/// reduction becomes a note. Those whose joints do not all move here are notes as well. Throws description::Refused
/// where several joints are moved by a law that is not known, and where a joint or a number cannot be used.
void read_transmissions(const std::string& text, const std::string& from, SourceTree& tree);

}  // namespace importer

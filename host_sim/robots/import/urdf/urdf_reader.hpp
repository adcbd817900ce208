// URDF by urdfdom: the tree, or the chain to one tip, as it stands in the file.
#pragma once

#include <host_sim/robots/import/reading.hpp>
#include <host_sim/robots/import/source_tree.hpp>

#include <string>

namespace importer {

/// Throws description::Refused with everything that is wrong, one line each: what urdfdom refuses, roots and tips that
/// are not there, joints that cannot be expressed (planar, floating, mimics of what does not move), bodies with
/// impossible numbers, transmissions without a linear law.
SourceTree read_urdf(const std::string& text, const std::string& from, const ReadingOptions& options);

}  // namespace importer

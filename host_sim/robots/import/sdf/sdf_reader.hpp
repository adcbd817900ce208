// SDF by libsdformat: the tree, or the chain to one tip, as it stands in the file.
#pragma once

#include <host_sim/robots/import/engine.hpp>
#include <host_sim/robots/import/reading.hpp>

#include <string>

namespace importer {

/// Files that are included are those in the folder of `from`. Throws description::Refused with file, element, value and
/// remedy: what is malformed, what changes the dynamics and is not expressed (screws, ball joints, loops, links without
/// gravity, ...); and, where this was built without libsdformat, that it is to be installed. What is left out otherwise
/// is in the notes.
EngineTree read_sdf(const std::string& text, const std::string& from, const ReadingOptions& options);

}  // namespace importer

// MJCF: the tree, or the chain to one tip, as it stands in the file.
#pragma once

#include <host_sim/robots/import/engine.hpp>
#include <host_sim/robots/import/reading.hpp>

#include <string>

namespace importer {

/// Includes are files in the folder of `from`. Throws description::Refused with file, line, element, value and remedy:
/// what is malformed, and what changes the dynamics and is not expressed (ball joints, loops, meshes for inertia, ...).
/// What is left out otherwise is in the notes.
EngineTree read_mjcf(const std::string& text, const std::string& from, const ReadingOptions& options);

}  // namespace importer

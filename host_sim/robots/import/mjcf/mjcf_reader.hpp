// MJCF: the tree, or the chain to one tip, as it stands in the file.
#pragma once

#include <host_sim/robots/import/reading.hpp>
#include <host_sim/robots/import/source_tree.hpp>

#include <axial/robot/chain.hpp>

#include <string>
#include <vector>

namespace importer {

/// What MuJoCo calls a link of the tree, and the joint that carries it: by name, or by its number in the file.
struct MjcfNames {
  std::string kind;  ///< body or site; empty for the frames between joints of one body
  std::string name, joint;
  int body = -1;        ///< number
  int which = 0;        ///< of the body's joints
  bool weighs = false;  ///< whether the body's mass is this link's
};

struct MjcfTree {
  SourceTree tree;
  axial::GravityVector gravity;  ///< in axes of the root link, as the file draws it
  std::vector<MjcfNames> names;  ///< of the tree's links
  bool is_diagonalised = false;  ///< MuJoCo diagonalises an inertia of it
};

/// Includes are files in the folder of `from`. Throws description::Refused with file, line, element, value and remedy:
/// what is malformed, and what changes the dynamics and is not expressed (ball joints, loops, meshes for inertia, ...).
/// What is left out otherwise is in the notes.
MjcfTree read_mjcf(const std::string& text, const std::string& from, const ReadingOptions& options);

}  // namespace importer

// What couples joints of an MJCF: equalities, fixed tendons; and how much its actuators can exert.
#pragma once

#include <host_sim/robots/import/mjcf/model.hpp>
#include <host_sim/robots/import/source_tree.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace importer::mjcf {

/// Where a joint is by another one: ratio * leader + offset; without a leader it stays at the offset.
struct Law {
  Attributes written;
  std::string leader;
  double ratio = 0.0, offset = 0.0;  ///< rad or m
  std::string problem;               ///< why it is not expressed; empty where it is
};

/// Of the joints that an active equality determines, by name.
std::map<std::string, Law> laws_of(const Model& model);

/// Refuses equalities of bodies that move by different joints, which close loops. `carrier` gives the moving link of
/// the tree that carries a body: -1 for what stands still, -2 for what is not in the tree.
void refuse_loops(const Model& model, const std::function<int(const std::string& body)>& carrier);

/// Refuses tendons of moving joints with springs or friction, which act on several joints at once; notes their limits.
void check_tendons(const Model& model, SourceTree& tree);

/// Limits of effort of joints that move: what their actuators can exert, at the joint whose drive moves them, and what
/// the joint lets through. Notes what has none.
void set_efforts(const Model& model, SourceTree& tree);

}  // namespace importer::mjcf

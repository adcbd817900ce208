// The engine that a format has, asked about a file as it is written: MuJoCo of an MJCF, DART of an SDF. Each is a
// program of its own, which reads questions and writes an answer, both JSON.
#pragma once

#include <host_sim/robots/import/source_tree.hpp>
#include <host_sim/robots/import/verification.hpp>

#include <axial/robot/chain.hpp>

#include <string>
#include <vector>

namespace importer {

/// What an engine calls a link of the tree, and the joint that carries it: by name, or by its number in the file.
struct EngineName {
  std::string kind;  ///< body, site, link or frame; empty for what the file does not name
  std::string name, joint;
  int body = -1;        ///< number
  int which = 0;        ///< of the body's joints
  bool weighs = false;  ///< whether the body's mass is this link's
};

/// A tree as it is read, and how the format's own engine calls its links.
struct EngineTree {
  SourceTree tree;
  axial::GravityVector gravity;   ///< in axes of the root link, as the file draws it
  std::vector<EngineName> names;  ///< of the tree's links
  bool is_diagonalised = false;   ///< the engine diagonalises an inertia of it
  std::string engine;             ///< which one it is
  std::vector<std::string> assumptions;
};

/// Differences between a file as its engine understands it and the tree that was read of it, on seeded random states:
/// poses, torques and mass matrix with rotors (Orocos KDL on the tree), bodies, and what joints have. `program` is what
/// is run, before the names of questions and answer; where it is empty, or the engine refuses the file, the figures say
/// so and nothing was compared.
EngineFigures ask_engine(std::vector<std::string> program, const std::string& file, const EngineTree& read,
                         unsigned seed, int states);

/// What an engine is asked about a file, and the figures that its answer to this gives: both as JSON. The states are
/// those of `seed`.
std::string engine_questions(const std::string& file, const EngineTree& read, unsigned seed, int states);
EngineFigures compared_with_engine(const EngineTree& read, unsigned seed, int states, const std::string& answer);

}  // namespace importer

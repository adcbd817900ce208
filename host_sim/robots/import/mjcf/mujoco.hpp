// MuJoCo itself, asked about an MJCF: its WebAssembly module (npm's mujoco-js) in node.
#pragma once

#include <host_sim/robots/import/mjcf/mjcf_reader.hpp>
#include <host_sim/robots/import/verification.hpp>

#include <string>

namespace importer {

/// Differences between a file as MuJoCo compiles it and the tree that was read of it, on seeded random states: poses of
/// bodies and sites, torques and mass matrix with rotors (Orocos KDL on the tree), bodies, and what joints have. Meshes
/// and pictures are not needed. `package` is the folder of mujoco-js; where it is empty, or MuJoCo refuses the file,
/// the figures say so and nothing was compared.
EngineFigures ask_mujoco(const std::string& package, const std::string& file, const MjcfTree& read, unsigned seed,
                         int states);

/// What MuJoCo is asked about a file, and the figures that its answer to this gives: both as JSON. The states are those
/// of `seed`.
std::string mujoco_questions(const std::string& file, const MjcfTree& read, unsigned seed, int states);
EngineFigures compared_with_mujoco(const MjcfTree& read, unsigned seed, int states, const std::string& answer);

}  // namespace importer

// A description against Orocos KDL on random states.
#pragma once

#include <host_sim/import/imported.hpp>
#include <host_sim/import/reference.hpp>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace importer {

/// Largest differences between axial::Model in double and KDL.
struct Figures {
  int states = 0;
  unsigned seed = 0;
  double pose = 0.0;         ///< entries of rotations, and positions over the larger of reach and 1 m
  double torque = 0.0;       ///< over the largest torque of all states
  double mass_matrix = 0.0;  ///< over its largest entry of all states

  bool good() const;
  /// Lines for a person, and for the header's comment.
  std::vector<std::string> lines() const;
};

constexpr double pose_bound = 1e-12, torque_bound = 1e-9;

/// Seeded states: positions inside the limits (a turn, or 1 m, where there are none), speeds to 2, accelerations to 5.
/// Every frame of the source, the tool, torque and mass matrix.
Figures verify(const Imported& imported, const Reference& reference, unsigned seed = 1, int states = 100);

}  // namespace importer

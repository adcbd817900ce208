// A description against Orocos KDL on random states.
#pragma once

#include <host_sim/robots/import/imported.hpp>
#include <host_sim/robots/import/reference.hpp>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace importer {

/// Largest differences between a tree as it is read and the format's own engine.
struct EngineFigures {
  std::string engine;   ///< its name and version; empty where it was not asked
  std::string asked;    ///< which one it would have been
  std::string why_not;  ///< what it said where it could not be asked
  int states = 0;
  double pose = 0.0;         ///< entries of rotations, and positions over the larger of reach and 1 m
  double torque = 0.0;       ///< with rotors, over the largest torque of all states
  double mass_matrix = 0.0;  ///< with rotors, over its largest entry of all states
  double body = 0.0;         ///< mass over itself, centre in m, inertia over its trace
  double joint = 0.0;        ///< limits, friction, rotors and springs, over the larger of themselves and 1
  double bound = 1e-9;       ///< of each

  bool good() const;
  std::string line() const;
};

/// Largest differences between axial::Model in double and KDL.
struct Figures {
  int states = 0;
  unsigned seed = 0;
  double pose = 0.0;         ///< entries of rotations, and positions over the larger of reach and 1 m
  double torque = 0.0;       ///< over the largest torque of all states
  double mass_matrix = 0.0;  ///< over its largest entry of all states
  double body = 0.0;    ///< of each link: mass over itself, centre in m, inertia over its trace; gravity over itself
  double limits = 0.0;  ///< of limits and friction, over themselves
  double changed_angle = 0.0, changed_length = 0.0;  ///< rad, m: how far what is read is from what is written
  double changed_angle_bound = 0.0;                  ///< rad: how far it may be
  std::vector<int> unresisted{};                     ///< drives that no mass and no rotor resists in any of the states

  EngineFigures engine{};
  /// What the lines begin with.
  std::string against = "against Orocos KDL, built from the text by another reader, on ";

  bool good() const;
  /// Lines for a person, and for the header's comment.
  std::vector<std::string> lines() const;
};

constexpr double pose_bound = 1e-12, torque_bound = 1e-9, body_bound = 1e-11, limits_bound = 1e-15;
constexpr double changed_length_bound = 1e-5;  // m

/// Seeded states: positions inside the limits (a turn, or 1 m, where there are none), speeds to 2, accelerations to 5.
/// Every frame of the source, the tool, torque and mass matrix; the body of each link from those of the source that it
/// carries; limits and friction as the source writes them, before anything is assumed.
Figures verify(const Imported& imported, const Reference& reference, unsigned seed = 1, int states = 100);

}  // namespace importer

// From a file to a verified description.
#pragma once

#include <host_sim/robots/import/imported.hpp>
#include <host_sim/robots/import/reading.hpp>
#include <host_sim/robots/import/verification.hpp>

#include <optional>
#include <string>

namespace importer {

/// What a limit is that a source does not give, or leaves blank as 0; 0: what the comment says.
struct Assumed {
  double position = 0.0;           ///< rad or m, either way; a turn, or 1 m
  double speed = 0.0;              ///< rad/s or m/s; half a turn a second, or 1 m/s
  double effort = 0.0;             ///< N m or N; unlimited
  double seconds_to_speed = 0.25;  ///< s: the time to full speed, where there is no acceleration limit
};

struct Options {
  ReadingOptions reading;  ///< its `snap` is for tables too
  std::string name;        ///< empty: the source's
  std::optional<axial::GravityVector>
      gravity;                ///< of a URDF, an MJCF or an SDF, in axes of its root; the file's, or (0, 0, -9.81)
  bool as_published = false;  ///< keep what axial compiles only with accept(as_published)
  Assumed assumed;
  std::string engine;  ///< folder of the package mujoco-js, or the program dart_engine; empty: none is asked
  unsigned seed = 1;
  int states = 100;
};

struct Result {
  Imported imported;
  Figures figures;
};

/// A URDF (urdfdom), an MJCF, an SDF, or a Denavit-Hartenberg table where the text is a JSON object. Checks, fills in
/// what is missing as named assumptions, verifies against KDL, and an MJCF and an SDF by its own engine. Throws
/// description::Refused; figures above their bounds are the caller's.
Result import_text(const std::string& text, const std::string& from, const Options& options);
Result import_file(const std::string& path, const Options& options);

/// Fills limits in that are missing, each named in the assumptions; a joint that mimics another takes that one's.
void assume_limits(description::Description& robot, const Assumed& assumed);

}  // namespace importer

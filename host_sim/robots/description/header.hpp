// A description as a readable constexpr header.
#pragma once

#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/description/kept.hpp>

#include <string>
#include <vector>

namespace description {

/// The text of a header that describes the robot: `namespace robots { struct Name { name; chain; }; }`, a line a group
/// of values, every number such that it reads back as the same double, angles in degrees where that is exact. The
/// leading comment holds source, notes, assumptions, fits, warnings and the lines of `figures` (of a verification).
/// Kept lines stand below their joint and replace what the description gives for their quantities. The same description
/// gives the same text. Throws Refused where check() does, where numbers must be accepted and the description is not
/// kept as published, and where a kept line's joint is not the robot's.
std::string header(const Description& robot, const std::vector<std::string>& figures, const Kept& kept = {});

/// Name of the struct in it: "my-arm 2" becomes "MyArm2".
std::string type_name(const Description& robot);
/// Name of the robot in it, as on a command line: "my_arm_2".
std::string plain_name(const Description& robot);

/// What writing a header changed in the one that was there before.
struct Rewritten {
  Kept kept;                      ///< lines that were kept
  std::vector<std::string> lost;  ///< code that stands in the new one no more
  std::string before;             ///< where the old one is now, if anything was lost
};

/// Writes header() to a file, with the kept lines of a header that is there. Where other lines are lost, the old file
/// is saved beside it. Throws Refused where the file cannot be written.
Rewritten write_header(const std::string& path, const Description& robot, const std::vector<std::string>& figures);

/// What to tell of that, a line each; nothing where nothing was there.
std::string said_of(const std::string& path, const Rewritten& rewritten);

}  // namespace description

// A description as a readable constexpr header.
#pragma once

#include <host_sim/description/description.hpp>

#include <string>
#include <vector>

namespace description {

/// The text of a header that describes the robot: `namespace robots { struct Name { name; chain; }; }`, a line a group
/// of values, every number such that it reads back as the same double, angles in degrees where that is exact. The
/// leading comment holds source, notes, assumptions, warnings and the lines of `figures` (of a verification). The same
/// description gives the same text. Throws Refused where check() does,
/// and where numbers must be accepted and the description is not kept as published.
std::string header(const Description& robot, const std::vector<std::string>& figures);

/// Name of the struct in it: "my-arm 2" becomes "MyArm2".
std::string type_name(const Description& robot);
/// Name of the robot in it, as on a command line: "my_arm_2".
std::string plain_name(const Description& robot);

/// Writes header() to a file. Throws Refused where the file can not be written.
void write_header(const std::string& path, const Description& robot, const std::vector<std::string>& figures);

}  // namespace description

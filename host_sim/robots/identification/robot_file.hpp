// The robot that an identification starts from.
#pragma once

#include <host_sim/robots/description/description.hpp>

namespace host_sim::identification {

/// A robot of robots/ by its name, a Denavit-Hartenberg table in JSON (host_sim/robots/description) or a URDF
/// (host_sim/robots/import) by its path; `tip`: where a URDF's chain ends, empty: every branch. Throws
/// description::Refused.
description::Description find_robot(const std::string& robot, const std::string& tip);

}  // namespace host_sim::identification

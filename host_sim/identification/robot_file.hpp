// The robot that an identification starts from.
#pragma once

#include <host_sim/description/description.hpp>

namespace host_sim::identification {

/// A robot of robots/ by its name, or a Denavit-Hartenberg table in JSON (host_sim/description) by its path. Throws
/// description::Refused.
description::Description find_robot(const std::string& robot);

}  // namespace host_sim::identification

// The project's own robots as descriptions, by name.
#pragma once

#include <host_sim/robots/description/description.hpp>

namespace description {

/// Names of robots/robots.hpp: serial arms, trees, published arms.
std::vector<std::string> known_robots();

/// Throws Refused, which names the robots there are.
Description known_robot(const std::string& name);

}  // namespace description

// What identify.py and excite.py ask of a robot, over pipes: its parameters and limits, its regressor, its header.
#pragma once

#include <host_sim/robots/description/description.hpp>

#include <functional>

namespace host_sim {
class CommandLine;
}

namespace host_sim::identification {

/// Adds the verbs describe, answer and header to a command line and runs it; `find` gives the robot once options are
/// read. Returns the exit status.
int serve(CommandLine& line, int count, char** arguments, const std::function<description::Description()>& find);

}  // namespace host_sim::identification

// What commission.py asks of a robot, over pipes: its description, gravity's parts, its mended header.
#pragma once

#include <host_sim/robots/description/description.hpp>

#include <functional>
#include <string>

namespace host_sim {
class CommandLine;
}

namespace host_sim::commissioning {

/// Adds the verbs describe, answer and header to a command line and runs it; `find` gives the robot once options are
/// read. Returns the exit status.
int serve(CommandLine& line, int count, char** arguments, const std::function<description::Description()>& find);

}  // namespace host_sim::commissioning

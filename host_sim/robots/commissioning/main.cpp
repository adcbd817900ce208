// gravity_parts: a robot by name, table or URDF, for commission.py.
#include <host_sim/robots/commissioning/service.hpp>
#include <host_sim/robots/identification/robot_file.hpp>
#include <host_sim/tools/output/command_line.hpp>

int main(int count, char** arguments) {
  std::string robot, tip;
  host_sim::CommandLine line("gravity's parts of a robot, for commission.py", "gravity_parts");
  line.option("--robot", robot, "name as in robots/README.md, a table (.json) or a URDF").required();
  line.option("--tip", tip, "where the chain of a URDF ends");
  return host_sim::commissioning::serve(line, count, arguments,
                                        [&] { return host_sim::identification::find_robot(robot, tip); });
}

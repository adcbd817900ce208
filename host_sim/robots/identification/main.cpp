// robot_regressor: a robot by name, table or URDF, for identify.py and excite.py.
#include <host_sim/robots/identification/robot_file.hpp>
#include <host_sim/robots/identification/service.hpp>
#include <host_sim/tools/output/command_line.hpp>

int main(int count, char** arguments) {
  std::string robot, tip;
  host_sim::CommandLine line("a robot's parameters, limits and regressor, for identify.py and excite.py",
                             "robot_regressor");
  line.option("--robot", robot, "name as in robots/README.md, a table (.json) or a URDF").required();
  line.option("--tip", tip, "where the chain of a URDF ends");
  return host_sim::identification::serve(line, count, arguments,
                                         [&] { return host_sim::identification::find_robot(robot, tip); });
}

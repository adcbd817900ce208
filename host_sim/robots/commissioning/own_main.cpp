// gravity_parts-own: the robot of a header (build/<preset>/own/robot.hpp, which the driver writes), for commission.py.
#include <host_sim/robots/commissioning/service.hpp>
#include <host_sim/robots/description/own_comments.hpp>
#include <host_sim/tools/output/command_line.hpp>

#include <robot.hpp>

int main(int count, char** arguments) {
  std::string header;
  host_sim::CommandLine line("gravity's parts of a header's robot, for commission.py", "gravity_parts-own");
  line.option("--robot", header, "the header that it was built with").required();
  return host_sim::commissioning::serve(line, count, arguments, [&] {
    auto robot = description::from_robot<axial::apps::Robot>();
    description::take_comments(robot, header);
    return robot;
  });
}

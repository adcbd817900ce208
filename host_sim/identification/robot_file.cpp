#include <host_sim/description/known_robots.hpp>
#include <host_sim/description/table.hpp>
#include <host_sim/identification/robot_file.hpp>

namespace host_sim::identification {

description::Description find_robot(const std::string& robot) {
  const std::string ending = ".json";
  if (robot.size() > ending.size() && robot.substr(robot.size() - ending.size()) == ending)
    return description::to_mdh(description::read_table(robot));
  if (robot.find_first_of("./") != std::string::npos)
    throw description::Refused("'" + robot +
                               "' is no Denavit-Hartenberg table (.json, host_sim/description/README.md)");
  return description::known_robot(robot);
}

}  // namespace host_sim::identification

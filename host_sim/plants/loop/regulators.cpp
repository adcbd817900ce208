#include <host_sim/plants/loop/on_host.hpp>
#include <host_sim/plants/loop/regulators.hpp>
#include <host_sim/plants/simulation/models.hpp>

#include <firmware/apps/lqr/controller.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>
#include <robots/wrist_arm.hpp>

#include <stdexcept>

namespace host_sim::loop {

namespace {

[[noreturn]] void refuse(const std::string& robot) {
  throw std::runtime_error("no regulator drives '" + robot + "'; there are: scara, puma560, wrist_arm");
}

}  // namespace

std::unique_ptr<Controller> regulator_on_host(const std::string& robot) {
  using axial::apps::LqrController;
  if (robot == "scara") return std::make_unique<OnHost<LqrController<::robots::Scara>>>();
  if (robot == "puma560") return std::make_unique<OnHost<LqrController<::robots::Puma560>>>();
  if (robot == "wrist_arm") return std::make_unique<OnHost<LqrController<::robots::WristArm>>>();
  refuse(robot);
}

std::unique_ptr<Controller> regulator_in_firmware(const std::string& board, const std::string& robot) {
  if (robot != "scara" && robot != "puma560" && robot != "wrist_arm") refuse(robot);
  return emulated(board, "lqr", robot);
}

std::vector<double> effort_limits(const std::string& robot) {
  std::vector<double> all;
  for (const auto& value : simulation::robot_values(robot))
    all.push_back(value.effort_limit);
  return all;
}

}  // namespace host_sim::loop

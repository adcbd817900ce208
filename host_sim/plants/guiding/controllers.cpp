#include <host_sim/plants/guiding/guiding.hpp>
#include <host_sim/plants/loop/on_host.hpp>

#include <firmware/apps/hand_guiding/controller.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <stdexcept>

namespace host_sim::guiding {

namespace {

template <class Robot>
std::unique_ptr<loop::Controller> host(bool fixed) {
  using axial::apps::HandGuidingController;
  if (fixed) return std::make_unique<loop::OnHost<HandGuidingController<Robot, axial::Fixed32>>>();
  return std::make_unique<loop::OnHost<HandGuidingController<Robot, float>>>();
}

[[noreturn]] void refuse(const std::string& robot) {
  throw std::runtime_error("no hand guides '" + robot + "'; there are: scara, puma560");
}

template <class Robot>
std::vector<double> steps_of() {
  constexpr double steps = axial::apps::ramp_ms * axial::apps::control_Hz / 1000.0;
  std::vector<double> all;
  for (const auto& link : Robot::chain.links)
    all.push_back(2.0 * link.effort_limit / steps);
  return all;
}

}  // namespace

std::vector<std::string> robots() { return {"scara", "puma560"}; }

std::unique_ptr<loop::Controller> on_host(const std::string& robot, const std::string& number) {
  const bool fixed = loop::is_fixed(number);
  if (robot == "scara") return host<::robots::Scara>(fixed);
  if (robot == "puma560") return host<::robots::Puma560>(fixed);
  refuse(robot);
}

std::unique_ptr<loop::Controller> in_firmware(const std::string& board, const std::string& robot,
                                              const std::string& number) {
  if (robot != "scara" && robot != "puma560") refuse(robot);
  return loop::emulated(board, loop::is_fixed(number) ? "hand-guiding-fixed" : "hand-guiding", robot);
}

std::vector<double> declared_steps(const std::string& robot) {
  if (robot == "scara") return steps_of<::robots::Scara>();
  if (robot == "puma560") return steps_of<::robots::Puma560>();
  refuse(robot);
}

}  // namespace host_sim::guiding

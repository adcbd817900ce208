#include <host_sim/description/numbers.hpp>
#include <host_sim/import/importer.hpp>

#include <cmath>
#include <functional>

namespace importer {
namespace {

using description::number;
using Parameters = axial::LinkParameters;

/// Fills one limit in where it is missing, and says for which joints.
void assume(description::Description& robot, const std::string& what,
            const std::function<bool(const Parameters&)>& is_missing, const std::function<void(Parameters&)>& fill) {
  std::string joints;
  for (auto& link : robot.links) {
    if (!is_missing(link.parameters) || link.parameters.drives.follows) continue;
    fill(link.parameters);
    joints += (joints.empty() ? "" : ", ") + link.joint;
  }
  if (!joints.empty()) robot.assumptions.push_back(what + ": " + joints);
}

bool turns(const Parameters& p) { return p.type == axial::JointType::revolute; }

}  // namespace

void assume_limits(description::Description& robot, double seconds_to_speed) {
  constexpr double turn = 6.28318530717958647692, slow_turn = 3.14159265358979323846;
  const auto unbounded = [](const Parameters& p) {
    return !std::isfinite(p.position_min) && !std::isfinite(p.position_max);
  };
  const auto no_speed = [](const Parameters& p) { return !std::isfinite(p.speed_limit); };
  assume(
      robot, "position limits of a turn either way (fixed point needs limits; wrap the angle)",
      [&](const Parameters& p) { return turns(p) && unbounded(p); },
      [](Parameters& p) { p.position_min = -turn, p.position_max = turn; });
  assume(
      robot, "position limits of 1 m either way", [&](const Parameters& p) { return !turns(p) && unbounded(p); },
      [](Parameters& p) { p.position_min = -1.0, p.position_max = 1.0; });
  assume(
      robot, "speed limit of half a turn a second", [&](const Parameters& p) { return turns(p) && no_speed(p); },
      [](Parameters& p) { p.speed_limit = slow_turn; });
  assume(
      robot, "speed limit of 1 m/s", [&](const Parameters& p) { return !turns(p) && no_speed(p); },
      [](Parameters& p) { p.speed_limit = 1.0; });
  assume(
      robot, "acceleration limits that reach full speed in " + number(seconds_to_speed) + " s",
      [](const Parameters& p) { return !std::isfinite(p.acceleration_limit); },
      [&](Parameters& p) { p.acceleration_limit = p.speed_limit / seconds_to_speed; });
  std::string unlimited;
  for (const auto& link : robot.links)
    if (!std::isfinite(link.parameters.effort_limit) && !link.parameters.drives.follows)
      unlimited += (unlimited.empty() ? "" : ", ") + link.joint;
  if (!unlimited.empty()) robot.assumptions.push_back("no effort limit: " + unlimited);
}

}  // namespace importer

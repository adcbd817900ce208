#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/import/importer.hpp>

#include <algorithm>
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
bool unbounded(const Parameters& p) { return !std::isfinite(p.position_min) && !std::isfinite(p.position_max); }

}  // namespace

/// A follower goes where its leader does: limits that it has none of.
void take_leaders_limits(description::Description& robot) {
  std::string joints;
  for (auto& link : robot.links) {
    auto& p = link.parameters;
    if (!p.drives.follows || !p.drives.complete) continue;
    const auto& leader = robot.links[static_cast<std::size_t>(p.drives.of[0])].parameters;
    const double ratio = p.drives.ratio[0], ends[] = {ratio * leader.position_min + p.drives.offset,
                                                      ratio * leader.position_max + p.drives.offset};
    const bool places = unbounded(p) && !unbounded(leader), speeds = !std::isfinite(p.speed_limit);
    if (places) p.position_min = std::min(ends[0], ends[1]), p.position_max = std::max(ends[0], ends[1]);
    if (speeds) p.speed_limit = std::abs(ratio) * leader.speed_limit;
    if (!std::isfinite(p.acceleration_limit)) p.acceleration_limit = std::abs(ratio) * leader.acceleration_limit;
    if (places || speeds) joints += (joints.empty() ? "" : ", ") + link.joint;
  }
  if (!joints.empty()) robot.assumptions.push_back("limits of the joints that they mimic: " + joints);
}

void assume_limits(description::Description& robot, const Assumed& assumed) {
  const auto no_speed = [](const Parameters& p) { return !std::isfinite(p.speed_limit); };
  constexpr double turn = 6.28318530717958647692;
  const double place = assumed.position, speed = assumed.speed;
  const auto told = [](double value, const std::string& unit, const std::string& otherwise) {
    return value > 0.0 ? number(value) + unit : otherwise;
  };
  assume(
      robot,
      "position limits of " + told(assumed.position, " rad", "a turn") +
          " either way (fixed point needs limits; wrap the angle)",
      [&](const Parameters& p) { return turns(p) && unbounded(p); },
      [&](Parameters& p) { p.position_max = place > 0.0 ? place : turn, p.position_min = -p.position_max; });
  assume(
      robot, "position limits of " + told(assumed.position, " m", "1 m") + " either way",
      [&](const Parameters& p) { return !turns(p) && unbounded(p); },
      [&](Parameters& p) { p.position_max = place > 0.0 ? place : 1.0, p.position_min = -p.position_max; });
  assume(
      robot, "speed limit of " + told(assumed.speed, " rad/s", "half a turn a second"),
      [&](const Parameters& p) { return turns(p) && no_speed(p); },
      [&](Parameters& p) { p.speed_limit = speed > 0.0 ? speed : turn / 2.0; });
  assume(
      robot, "speed limit of " + told(assumed.speed, " m/s", "1 m/s"),
      [&](const Parameters& p) { return !turns(p) && no_speed(p); },
      [&](Parameters& p) { p.speed_limit = speed > 0.0 ? speed : 1.0; });
  assume(
      robot, "acceleration limits that reach full speed in " + number(assumed.seconds_to_speed) + " s",
      [](const Parameters& p) { return !std::isfinite(p.acceleration_limit); },
      [&](Parameters& p) { p.acceleration_limit = p.speed_limit / assumed.seconds_to_speed; });
  if (assumed.effort > 0.0)
    assume(
        robot, "effort limit of " + number(assumed.effort) + " N m or N",
        [](const Parameters& p) { return !std::isfinite(p.effort_limit); },
        [&](Parameters& p) { p.effort_limit = assumed.effort; });
  take_leaders_limits(robot);
  std::string unlimited;
  for (const auto& link : robot.links)
    if (!std::isfinite(link.parameters.effort_limit) && !link.parameters.drives.follows)
      unlimited += (unlimited.empty() ? "" : ", ") + link.joint;
  if (!unlimited.empty()) robot.assumptions.push_back("no effort limit: " + unlimited);
}

}  // namespace importer

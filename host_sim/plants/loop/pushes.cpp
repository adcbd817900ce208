#include <host_sim/plants/loop/pushes.hpp>
#include <host_sim/plants/loop/regulators.hpp>
#include <host_sim/plants/simulation/models.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace host_sim::loop {

namespace {

constexpr double tick = 1e-3;

/// How far a joint is on the side that it was not pushed to.
double beyond(double off, double push) {
  if (push > 0.0) return -off;
  return push < 0.0 ? off : std::fabs(off);
}

}  // namespace

std::vector<double> push_of(const std::string& robot, int joint) {
  std::vector<double> push;
  for (const auto& link : simulation::robot_values(robot)) {
    const bool wanted = joint < 0 || static_cast<std::size_t>(joint) == push.size();
    push.push_back(!wanted ? 0.0 : link.type == axial::JointType::prismatic ? push_m : push_rad);
  }
  return push;
}

Recovery recover(const Case& situation, Controller& controller, const Watch& watch) {
  const auto limits = effort_limits(situation.robot);
  Recovery r;
  r.least = std::numeric_limits<std::uint32_t>::max();
  int ticks = 0;
  const Watch look = [&](const SetPoint& wanted, const JointState& joints, const link::Measurement& seen,
                         const link::Torque& answer) {
    const std::vector<double>& q = joints.q;
    ++ticks;
    for (std::size_t i = 0; i < q.size(); ++i) {
      const double off = q[i] - wanted.q[i], push = situation.push.empty() ? 0.0 : situation.push[i];
      if (std::fabs(off) > recovered) r.seconds = ticks * tick;
      if (const double past = beyond(off, push); !(past <= 0.0)) note_size(r.overshoot, past);
      note_size(r.effort, static_cast<double>(answer.tau[i]) / limits[i]);
    }
    r.least = std::min(r.least, answer.count), r.most = std::max(r.most, answer.count);
    if (watch) watch(wanted, joints, seen, answer);
  };
  r.tracking = follow(situation, controller, look);
  return r;
}

nlohmann::json to_json(const std::vector<PushRow>& rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const PushRow& r : rows)
    list.push_back({{"name", r.name},
                    {"robot", r.situation.robot},
                    {"board", r.board},
                    {"controller", r.controller},
                    {"parameter_error", r.situation.parameter_error},
                    {"friction", r.situation.friction},
                    {"encoder_bits", r.situation.encoder_bits},
                    {"delay_ticks", r.situation.delay},
                    {"start", r.situation.start},
                    {"seconds", r.situation.seconds},
                    {"push", r.situation.push},
                    {"recovery_seconds", r.recovery.seconds},
                    {"effort_over_limit", r.recovery.effort},
                    {"overshoot", r.recovery.overshoot},
                    {"count_least", r.recovery.least},
                    {"count_most", r.recovery.most},
                    {"joint_error_rms", r.recovery.tracking.rms},
                    {"tool_error_rms", r.recovery.tracking.tool_rms},
                    {"tool_error_max", r.recovery.tracking.tool_largest},
                    {"refused", r.recovery.tracking.refused}});
  return list;
}

}  // namespace host_sim::loop

#include <host_sim/plants/guiding/guiding.hpp>

#include <host_sim/plants/simulation/integrate.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <firmware/apps/hand_guiding/controller.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace host_sim::guiding {

namespace {

namespace simulation = host_sim::simulation;
using Values = simulation::Values<double>;
using Point = axial::Vec3<double>;

constexpr double tick = 1e-3;
constexpr int steps_a_tick = 4;

double length(const Point& v) { return std::sqrt(axial::dot(v, v)); }

std::vector<axial::LinkParameters> plant_links(const Session& session) {
  auto links = simulation::robot_links(session.robot);
  for (auto& link : links)  // grease: a fiftieth of the effort at the largest speed
    link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0,
    link.viscous = 0.02 * link.effort_limit / link.speed_limit;
  auto load = axial::apps::gripper;  // the tool of both robots is the last link's frame
  load.mass *= session.gripper;
  links.back() = simulation::carrying(links.back(), load);
  return links;
}

Values start_of(const std::string& robot) {
  if (robot == "scara") return {0.4, 0.8, 0.12};
  if (robot == "puma560") return {0.3, -0.5, 0.4, 0.3, 0.7, 0.2};
  throw std::runtime_error("no hand guides '" + robot + "'");
}

/// Grasps the tool at its place and leads it by a spring and a damper; rests for the last quarter of its time.
class Hand {
 public:
  Hand(const Point& grasped, double seconds) : start_(grasped), moving_(0.75 * seconds) {}
  Point place(double time) const {
    const double x = time < 0.0 ? 0.0 : time > moving_ ? 1.0 : time / moving_;
    const double s = x * x * x * (10.0 + x * (6.0 * x - 15.0));
    return start_ + Point{-0.10 * s, 0.12 * s, 0.04 * s * (1.0 - s) + 0.02 * s};
  }
  Point force(double time, const Point& tool, const Point& velocity) const {
    const Point own = (1.0 / tick) * (place(time) - place(time - tick));
    return stiffness * (place(time) - tool) + damping * (own - velocity);
  }

 private:
  static constexpr double stiffness = 3000.0, damping = 600.0;  // N/m, N s/m
  Point start_;
  double moving_;
};

class Arm {
 public:
  explicit Arm(const Session& session)
      : links_(plant_links(session)), model_(simulation::model_of(session.robot, links_)) {
    x_.q = start_of(session.robot);
  }

  link::Measurement read() const {
    link::Measurement m{};
    m.joints = links_.size();
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const double q = x_.q[static_cast<int>(i)];
      const bool slides = links_[i].type == axial::JointType::prismatic;
      const double turns = std::remainder(q / (2.0 * 3.14159265358979323846), 1.0);
      const auto counts = std::llround(slides ? q * axial::apps::slide_counts : std::ldexp(turns, 32));
      m.position[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(counts));
    }
    return m;
  }
  link::SetPoint here() const {
    link::SetPoint point{};
    point.joints = links_.size();
    for (std::size_t i = 0; i < links_.size(); ++i)
      point.q[i] = static_cast<float>(x_.q[static_cast<int>(i)]);
    return point;
  }
  Point tool() const { return axial::forward_kinematics(model_, x_.q, {}).tool.position; }

  /// A tick under a torque and the force of a hand, which is `time` on its way; the largest force.
  double run(const link::Torque& answer, const Hand* hand, double time) {
    Values held{};
    for (int i = 0; i < model_.size(); ++i)
      held[i] = static_cast<double>(answer.tau[static_cast<std::size_t>(i)]);
    double largest = 0.0;
    const simulation::Drive<double> drive = [&](const auto& at, Values& effort, auto&, auto&) {
      effort = held;
      if (hand == nullptr) return;
      const auto jacobian = axial::jacobian(model_, at.q, {});
      const auto velocity = axial::tool_velocity(jacobian, at.qd).linear;
      const Point force = hand->force(time, axial::forward_kinematics(model_, at.q, {}).tool.position, velocity);
      const auto felt = axial::transpose_times(jacobian, axial::ForceVector<Point, Point>{{}, force});
      for (int i = 0; i < model_.size(); ++i)
        effort[i] += felt[i];
      note_size(largest, length(force));
    };
    for (int k = 0; k < steps_a_tick; ++k)
      simulation::step(simulation::Method::rk4, model_, x_, tick / steps_a_tick, drive);
    return largest;
  }

 private:
  std::vector<axial::LinkParameters> links_;
  simulation::Model model_;
  simulation::Motion<double> x_;
};

void note(Felt& felt, const link::Torque& last, const link::Torque& now) {
  for (std::size_t i = 0; i < felt.steps.size(); ++i)
    felt.steps[i] =
        std::max(felt.steps[i], std::fabs(static_cast<double>(now.tau[i]) - static_cast<double>(last.tau[i])));
  const auto status = static_cast<link::TorqueStatus>(now.status);
  felt.refused += status != link::TorqueStatus::ok && status != link::TorqueStatus::effort_limited ? 1 : 0;
  ++felt.answers;
}

}  // namespace

Felt guide(const Session& session, loop::Controller& controller, const Watch& watch) {
  Arm arm(session);
  Felt felt;
  felt.steps.assign(declared_steps(session.robot).size(), 0.0);
  link::Torque last{};
  link::SetPoint wanted = arm.here();
  Point start = arm.tool(), let_go = start, held_at = start;
  const auto ticks = [](double seconds) { return std::lround(seconds / tick); };
  const long open = ticks(0.1), grasp = open + ticks(0.1), release = grasp + ticks(session.pull);
  const long hold = release + ticks(session.rest), end = hold + ticks(session.hold);
  Hand hand(start, session.pull);
  for (long k = 0; k < end; ++k) {
    if (k == grasp) felt.sag = start.z - arm.tool().z, start = arm.tool(), hand = Hand(start, session.pull);
    if (k == release) let_go = arm.tool(), felt.way = length(let_go - start);
    if (k == hold) held_at = arm.tool(), felt.drift = length(held_at - let_go), wanted = arm.here();
    auto measurement = arm.read();
    measurement.feeds_forward = k >= hold ? 1 : 0;
    const link::Torque answer = controller.answer(measurement, wanted);
    note(felt, last, answer);
    last = answer;
    if (watch) watch(measurement, wanted, answer);
    if (k < open) continue;  // brakes
    const bool guided = k >= grasp && k < release;
    const double time = tick * static_cast<double>(k - grasp);
    note_size(felt.largest_force, arm.run(answer, guided ? &hand : nullptr, time));
    if (guided) note_size(felt.followed, length(arm.tool() - hand.place(time)));
    if (k >= hold) note_size(felt.held, length(arm.tool() - held_at));
  }
  return felt;
}

}  // namespace host_sim::guiding

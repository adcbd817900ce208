#include <host_sim/loop/cycle.hpp>
#include <host_sim/loop/loop.hpp>

#include <host_sim/link/firmware.hpp>
#include <host_sim/simulation/integrate.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

namespace host_sim::loop {

namespace {

namespace simulation = host_sim::simulation;
using Values = simulation::Values<double>;

constexpr double tick = control_tick;
constexpr int steps_a_tick = 4;
constexpr double slide_count = 1e-7;

/// +1 or -1.
struct Signs {
  std::mt19937 engine;
  double operator()() { return (engine() & 1U) != 0U ? 1.0 : -1.0; }
};

std::vector<axial::LinkParameters> plant_links(const Case& situation) {
  auto links = simulation::robot_links(situation.robot);
  Signs sign{std::mt19937(situation.seed)};
  const auto off = [&](double& value) { value *= 1.0 + situation.parameter_error * sign(); };
  for (auto& link : links) {
    off(link.mass), off(link.rotor_inertia);
    for (double& c : link.com)
      off(c);
    for (double& i : link.inertia_com)
      off(i);
    if (situation.friction) continue;
    link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
  }
  return links;
}

Values values_of(const std::vector<double>& from) {
  Values to{};
  std::copy(from.begin(), from.end(), to.values);
  return to;
}

/// The robot in double, its encoders, and torques on their way.
class Plant {
 public:
  Plant(const Case& situation, const SetPoint& start)
      : links_(plant_links(situation)),
        model_(simulation::model_of(situation.robot, links_)),
        bits_(situation.encoder_bits),
        noisy_(situation.encoder_noise > 0.0),
        noise_(0.0, noisy_ ? situation.encoder_noise : 1.0),
        draws_(situation.seed),
        waiting_(static_cast<std::size_t>(situation.delay)) {
    x_.q = values_of(start.q), x_.qd = values_of(start.qd);
    for (std::size_t i = 0; i < situation.push.size(); ++i)
      x_.q[static_cast<int>(i)] += situation.push[i];
    // Until the first torque arrives the robot is held against gravity.
    const auto weight = axial::gravity_torque(model_, x_.q);
    for (Values& tau : waiting_)
      tau = weight;
  }

  link::Measurement read() {
    link::Measurement m{};
    m.joints = links_.size();
    for (int i = 0; i < model_.size(); ++i)
      m.position[static_cast<std::size_t>(i)] = slides(i) ? slide(x_.q[i]) : angle(x_.q[i]);
    return m;
  }

  void run(const link::Torque& answer) {
    Values tau{};
    for (int i = 0; i < model_.size(); ++i)
      tau[i] = static_cast<double>(answer.tau[static_cast<std::size_t>(i)]);
    waiting_.push_back(tau);
    const Values now = waiting_.front();
    waiting_.pop_front();
    const simulation::Drive<double> hold = [&](const auto&, Values& effort, auto&, auto&) { effort = now; };
    for (int k = 0; k < steps_a_tick; ++k)
      simulation::step(simulation::Method::rk4, model_, x_, tick / steps_a_tick, hold);
  }

  const Values& position() const { return x_.q; }
  JointState state() const {
    const int n = joints();
    return {{x_.q.values, x_.q.values + n}, {x_.qd.values, x_.qd.values + n}};
  }
  axial::Vec3<double> tool(const Values& q) const { return axial::forward_kinematics(model_, q).tool.position; }
  int joints() const { return model_.size(); }

 private:
  bool slides(int i) const { return links_[static_cast<std::size_t>(i)].type == axial::JointType::prismatic; }
  double noise() { return noisy_ ? noise_(draws_) : 0.0; }
  // Whole counts of the encoder, as binary angles.
  std::int32_t angle(double q) {
    const double turns = q / (2.0 * 3.14159265358979323846);
    const auto counts = static_cast<std::int64_t>(std::llround(std::ldexp(turns, bits_) + noise()));
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(counts << (32 - bits_)));
  }
  std::int32_t slide(double q) {
    const double step = std::max(1.0, std::round(std::ldexp(1.0 / slide_count, -bits_)));
    return static_cast<std::int32_t>(std::llround(std::round(q / slide_count / step + noise()) * step));
  }

  std::vector<axial::LinkParameters> links_;
  simulation::Model model_;
  simulation::Motion<double> x_;
  int bits_;
  bool noisy_;
  std::normal_distribution<double> noise_;
  std::mt19937 draws_;
  std::deque<Values> waiting_;
};

/// Sums of squares, and largest values.
class Statistics {
 public:
  explicit Statistics(int joints) : squares_(static_cast<std::size_t>(joints)), largest_(squares_.size()) {}

  void add(const std::vector<double>& wanted, const Values& q, const axial::Vec3<double>& off) {
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      const double e = wanted[i] - q[static_cast<int>(i)];
      squares_[i] += e * e, largest_[i] = std::max(largest_[i], std::fabs(e));
    }
    const double tool = axial::dot(off, off);
    tool_squares_ += tool, tool_largest_ = std::max(tool_largest_, std::sqrt(tool));
    ++ticks_;
  }
  Tracking result(long refused) const {
    Tracking t;
    t.largest = largest_, t.tool_largest = tool_largest_, t.ticks = ticks_, t.refused = refused;
    for (const double s : squares_)
      t.rms.push_back(std::sqrt(s / static_cast<double>(ticks_)));
    t.tool_rms = std::sqrt(tool_squares_ / static_cast<double>(ticks_));
    return t;
  }

 private:
  std::vector<double> squares_, largest_;
  double tool_squares_ = 0.0, tool_largest_ = 0.0;
  long ticks_ = 0;
};

}  // namespace

Tracking follow(const Case& situation, Controller& controller, const Watch& watch) {
  const Trajectory cycle = cycle_of(situation.robot);
  const auto first = static_cast<std::size_t>(std::lround(situation.start / tick));
  Plant plant(situation, cycle[first % cycle.size()]);
  Statistics statistics(plant.joints());
  long refused = 0;
  const auto ticks = static_cast<std::size_t>(std::lround(situation.seconds / tick));
  for (std::size_t k = 0; k < ticks; ++k) {
    const SetPoint& wanted = cycle[(first + k) % cycle.size()];
    statistics.add(wanted.q, plant.position(), plant.tool(values_of(wanted.q)) - plant.tool(plant.position()));
    auto measurement = plant.read();
    measurement.feeds_forward = situation.feeds_forward ? 1 : 0;
    const link::Torque answer = controller.answer(measurement, to_message(wanted));
    const auto status = static_cast<link::TorqueStatus>(answer.status);
    refused += status != link::TorqueStatus::ok && status != link::TorqueStatus::effort_limited ? 1 : 0;
    if (watch) watch(wanted, plant.state(), measurement, answer);
    plant.run(answer);
  }
  return statistics.result(refused);
}

bool declares_friction(const std::string& robot) {
  const auto links = simulation::robot_links(robot);
  return std::any_of(links.begin(), links.end(), [](const auto& link) {
    return link.viscous > 0.0 || link.coulomb_forward > 0.0 || link.static_friction > 0.0;
  });
}

nlohmann::json to_json(const std::vector<Row>& rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const Row& r : rows) {
    nlohmann::json row{{"name", r.name},
                       {"robot", r.situation.robot},
                       {"board", r.board},
                       {"scalar", r.number},
                       {"feeds_forward", r.situation.feeds_forward},
                       {"parameter_error", r.situation.parameter_error},
                       {"seed", r.situation.seed},
                       {"friction", r.situation.friction},
                       {"encoder_bits", r.situation.encoder_bits},
                       {"delay_ticks", r.situation.delay},
                       {"seconds", r.situation.seconds},
                       {"joint_error_rms", r.tracking.rms},
                       {"joint_error_max", r.tracking.largest},
                       {"tool_error_rms", r.tracking.tool_rms},
                       {"tool_error_max", r.tracking.tool_largest},
                       {"ticks", r.tracking.ticks},
                       {"refused", r.tracking.refused}};
    if (r.ratio > 0.0) row["ratio"] = r.ratio;
    list.push_back(row);
  }
  return list;
}

}  // namespace host_sim::loop

#include <host_sim/plants/loop/cycle.hpp>
#include <host_sim/plants/loop/loop.hpp>

#include <host_sim/boards/link/firmware.hpp>
#include <host_sim/plants/simulation/elastic.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace host_sim::loop {

namespace {

namespace simulation = host_sim::simulation;

constexpr double tick = control_tick;
constexpr int least_steps = 4;  // a tick
constexpr double slide_count = 1e-7;
constexpr double pi = 3.14159265358979323846;

/// +1 or -1.
struct Signs {
  std::mt19937 engine;
  double operator()() { return (engine() & 1U) != 0U ? 1.0 : -1.0; }
};

std::vector<axial::LinkParameters> plant_links(const Case& situation) {
  auto links = simulation::robot_links(situation.robot);
  if (situation.resonance > 0) links = simulation::elastic_links(situation.robot, links, situation.resonance);
  Signs sign{std::mt19937(situation.seed)};
  const auto off = [&](double& value) { value *= 1.0 + situation.parameter_error * sign(); };
  for (auto& link : links) {
    off(link.mass), off(link.rotor_inertia);
    link.stiffness *= 1.0 + situation.stiffness_error;
    for (double& c : link.com)
      off(c);
    for (double& i : link.inertia_com)
      off(i);
    if (situation.friction) continue;
    link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
  }
  return links;
}

link::FeedForward feed_of(const Case& situation) {
  if (!situation.feeds_forward) return link::FeedForward::none;
  return situation.as_rigid ? link::FeedForward::rigid : link::FeedForward::full;
}

/// 2 zeta sqrt(K M) of each joint, of which K is w^2 M.
std::vector<double> damping_of(const Case& situation, const std::vector<axial::LinkParameters>& links) {
  std::vector<double> damping;
  if (situation.damping_ratio > 0.0)
    for (const auto& link : links)
      damping.push_back(2.0 * situation.damping_ratio * link.stiffness / (2.0 * pi * situation.resonance));
  return damping;
}

template <class Values>
Values values_of(const std::vector<double>& from) {
  Values to{};
  std::copy(from.begin(), from.end(), to.values);
  return to;
}

/// A rigid arm, asked as an ElasticArm is. Where joints share drives, all of its values are those of the drives.
template <class M>
class RigidArm {
 public:
  using Values = axial::Joints<M, double>;
  using Motion = axial::Motion<M, double>;

  explicit RigidArm(const M& model) : model_(model) {}
  const M& model() const { return model_; }
  static Motion state(const Values& u, const Values& ud, const Values&) { return {u, ud, 0}; }
  static Values positions(const Motion& x) { return x.q; }
  static Values velocities(const Motion& x) { return x.qd; }
  static Values motors(const Values& states) { return states; }
  static Values efforts(const Values& tau) { return tau; }

 private:
  M model_;
};

/// The robot in double, its encoders, and torques on their way. Body: simulation::ElasticArm or RigidArm.
template <class Body>
class Plant : public Arm {
  using Model = std::decay_t<decltype(std::declval<const Body&>().model())>;

 public:
  using Values = axial::Joints<Model, double>;

  /// `slides`: which encoders count lengths, or numbers.
  Plant(const Case& situation, const SetPoint& start, const Model& rigid, Body arm, std::vector<bool> slides)
      : slides_(std::move(slides)),
        rigid_(rigid),
        arm_(std::move(arm)),
        bits_(situation.encoder_bits),
        noisy_(situation.encoder_noise > 0.0),
        noise_(0.0, noisy_ ? situation.encoder_noise : 1.0),
        draws_(situation.seed),
        waiting_(static_cast<std::size_t>(situation.delay)) {
    Values q = values_of<Values>(start.q);
    for (std::size_t i = 0; i < situation.push.size(); ++i)
      q[static_cast<int>(i)] += situation.push[i];
    // Until the first torque arrives the robot is held against gravity.
    const auto weight = axial::gravity_torque(rigid_, q, {});
    x_ = arm_.state(q, values_of<Values>(start.qd), weight);
    const double limit = simulation::step_limit(simulation::Method::rk4, arm_.model(), x_.q);
    steps_ = std::max(least_steps, static_cast<int>(std::ceil(tick / (0.25 * limit))));
    for (Values& tau : waiting_)
      tau = weight;
  }

  link::Measurement read() override {
    link::Measurement m{};
    m.joints = slides_.size();
    const auto seen = arm_.motors(x_.q);
    for (int i = 0; i < joints(); ++i)
      m.position[static_cast<std::size_t>(i)] = slides(i) ? slide(seen[i]) : angle(seen[i]);
    return m;
  }

  void run(const link::Torque& answer) override {
    Values tau{};
    for (int i = 0; i < joints(); ++i)
      tau[i] = static_cast<double>(answer.tau[static_cast<std::size_t>(i)]);
    waiting_.push_back(tau);
    const Values now = arm_.efforts(waiting_.front());
    waiting_.pop_front();
    const simulation::DriveOf<Motion> hold = [&](const auto&, Values& effort, auto&, auto&) { effort = now; };
    for (int k = 0; k < steps_; ++k)
      simulation::step(simulation::Method::rk4, arm_.model(), x_, tick / steps_, hold);
  }

  JointState state() const override {
    const int n = joints();
    const Values q = arm_.positions(x_), qd = arm_.velocities(x_);
    return {{q.values, q.values + n}, {qd.values, qd.values + n}};
  }
  axial::Vec3<double> tool(const std::vector<double>& q) const override {
    return axial::forward_kinematics(rigid_, values_of<Values>(q), {}).tool.position;
  }

 private:
  int joints() const { return rigid_.size(); }
  using Motion = axial::Motion<Model, double>;

  bool slides(int i) const { return slides_[static_cast<std::size_t>(i)]; }
  double noise() { return noisy_ ? noise_(draws_) : 0.0; }
  // Whole counts of the encoder, as binary angles.
  std::int32_t angle(double q) {
    const double turns = q / (2.0 * pi);
    const auto counts = static_cast<std::int64_t>(std::llround(std::ldexp(turns, bits_) + noise()));
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(counts) << (32 - bits_)));
  }
  std::int32_t slide(double q) {
    const double step = std::max(1.0, std::round(std::ldexp(1.0 / slide_count, -bits_)));
    return static_cast<std::int32_t>(std::llround(std::round(q / slide_count / step + noise()) * step));
  }

  std::vector<bool> slides_;
  Model rigid_;  // for poses and weight
  Body arm_;     // what moves
  Motion x_;
  int steps_ = least_steps;
  int bits_;
  bool noisy_;
  std::normal_distribution<double> noise_;
  std::mt19937 draws_;
  std::deque<Values> waiting_;
};

/// Sums of squares, and largest values.
class Statistics {
 public:
  explicit Statistics(std::size_t joints) : squares_(joints), largest_(joints) {}

  void add(const std::vector<double>& wanted, const std::vector<double>& q, const axial::Vec3<double>& off) {
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      const double e = wanted[i] - q[i];
      squares_[i] += e * e, note_size(largest_[i], e);
    }
    const double tool = axial::dot(off, off);
    tool_squares_ += tool, note_size(tool_largest_, std::sqrt(tool));
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

std::vector<axial::LinkParameters> rigid(std::vector<axial::LinkParameters> links) {
  for (auto& link : links)
    link.stiffness = axial::LinkParameters::unlimited;
  return links;
}

std::vector<bool> slides_of(const std::vector<axial::LinkParameters>& links) {
  std::vector<bool> slides;
  slides.reserve(links.size());
  for (const auto& link : links)
    slides.push_back(link.type == axial::JointType::prismatic);
  return slides;
}

std::unique_ptr<Arm> arm_of(const Case& situation, const SetPoint& start) {
  const auto links = plant_links(situation);
  if (simulation::shares_drives(situation.robot)) {
    const auto model = simulation::driven_model_of(situation.robot, links);
    return std::make_unique<Plant<RigidArm<simulation::DrivenModel>>>(
        situation, start, model, RigidArm<simulation::DrivenModel>(model), std::vector<bool>(start.q.size(), true));
  }
  return std::make_unique<Plant<simulation::ElasticArm>>(
      situation, start, simulation::model_of(situation.robot, links),
      simulation::ElasticArm(situation.robot, situation.resonance > 0 ? links : rigid(links),
                             damping_of(situation, links)),
      slides_of(links));
}

}  // namespace

std::unique_ptr<Arm> arm_on_host(const Case& situation, const SetPoint& start, const simulation::Model& model,
                                 const std::vector<axial::LinkParameters>& links) {
  return std::make_unique<Plant<RigidArm<simulation::Model>>>(situation, start, model,
                                                              RigidArm<simulation::Model>(model), slides_of(links));
}

Tracking follow(const Case& situation, const Trajectory& cycle, std::size_t first, Arm& arm, Controller& controller,
                const Watch& watch) {
  Statistics statistics(cycle.front().q.size());
  long refused = 0;
  const auto ticks = static_cast<std::size_t>(std::lround(situation.seconds / tick));
  for (std::size_t k = 0; k < ticks; ++k) {
    const SetPoint& wanted = cycle[(first + k) % cycle.size()];
    const JointState now = arm.state();
    statistics.add(wanted.q, now.q, arm.tool(wanted.q) - arm.tool(now.q));
    auto measurement = arm.read();
    measurement.feeds_forward = static_cast<std::uint8_t>(feed_of(situation));
    if (!wanted.q3.empty()) controller.take(derivatives_of(wanted));
    const link::Torque answer = controller.answer(measurement, to_message(wanted));
    const auto status = static_cast<link::TorqueStatus>(answer.status);
    refused += status != link::TorqueStatus::ok && status != link::TorqueStatus::effort_limited ? 1 : 0;
    if (watch) watch(wanted, now, measurement, answer);
    arm.run(answer);
  }
  return statistics.result(refused);
}

Tracking follow(const Case& situation, Controller& controller, const Watch& watch) {
  const Trajectory cycle = cycle_of(situation.robot, situation.resonance > 0);
  const auto first = static_cast<std::size_t>(std::lround(situation.start / tick));
  const auto arm = arm_of(situation, cycle[first % cycle.size()]);
  return follow(situation, cycle, first, *arm, controller, watch);
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
    if (r.situation.resonance > 0) {
      row["resonance_Hz"] = r.situation.resonance;
      row["feed_forward"] = r.situation.as_rigid ? "rigid" : "elastic";
    }
    if (r.ratio > 0.0) row["ratio"] = r.ratio;
    list.push_back(row);
  }
  return list;
}

}  // namespace host_sim::loop

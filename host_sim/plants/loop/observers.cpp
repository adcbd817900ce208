#include <host_sim/plants/loop/cycle.hpp>
#include <host_sim/plants/loop/observers.hpp>
#include <host_sim/plants/loop/on_host.hpp>
#include <host_sim/plants/loop/regulators.hpp>
#include <host_sim/plants/simulation/models.hpp>

#include <firmware/apps/ekf/controller.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>
#include <robots/wrist_arm.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <deque>
#include <stdexcept>

namespace host_sim::loop {

namespace {

constexpr int begins = 100;  // ticks that do not count
constexpr std::size_t slow_ticks = 10;

template <class Robot>
class OnHostObserver : public Observer {
 public:
  link::Torque answer(const link::Measurement& measurement, const link::SetPoint& wanted) override {
    return app_.answer(measurement, wanted);
  }
  std::vector<double> velocity() const override {
    const auto& qd = app_.app().velocity();
    return {qd.values, qd.values + axial::joint_count<Robot>};
  }

 private:
  OnHost<axial::apps::EkfController<Robot>> app_;
};

[[noreturn]] void refuse(const std::string& robot) {
  throw std::runtime_error("no filter watches '" + robot + "'; there are: scara, puma560, wrist_arm");
}

/// What encoders say, as counts and their size.
class Differences {
 public:
  explicit Differences(const std::string& robot) {
    const bool counts_numbers = simulation::shares_drives(robot);  // a drive's encoder counts all of its turns
    for (const auto& value : simulation::robot_values(robot))
      count_.push_back(counts_numbers || value.type == axial::JointType::prismatic
                           ? 1e-7
                           : 2.0 * 3.14159265358979323846 / 4294967296.0);
  }
  void add(const link::Measurement& seen) {
    past_.push_back(seen);
    if (past_.size() > slow_ticks + 1) past_.pop_front();
  }
  /// Over so many ticks, or as many as there are.
  std::vector<double> over(std::size_t ticks) const {
    const std::size_t back = std::min(ticks, past_.size() - 1);
    std::vector<double> speeds(count_.size());
    if (back == 0) return speeds;
    const auto& now = past_.back().position;
    const auto& then = past_[past_.size() - 1 - back].position;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const auto change =
          static_cast<std::int32_t>(static_cast<std::uint32_t>(now[i]) - static_cast<std::uint32_t>(then[i]));
      speeds[i] = count_[i] * change / (static_cast<double>(back) * control_tick);
    }
    return speeds;
  }

 private:
  std::vector<double> count_;
  std::deque<link::Measurement> past_;
};

/// Sums of squares by joint.
struct Squares {
  std::vector<double> sums;
  void add(const std::vector<double>& a, const std::vector<double>& b) {
    sums.resize(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      sums[i] += (a[i] - b[i]) * (a[i] - b[i]);
  }
  std::vector<double> rms(long ticks) const {
    std::vector<double> roots;
    for (const double s : sums)
      roots.push_back(std::sqrt(s / static_cast<double>(ticks)));
    return roots;
  }
};

}  // namespace

std::unique_ptr<Observer> observer_on_host(const std::string& robot) {
  if (robot == "scara") return std::make_unique<OnHostObserver<::robots::Scara>>();
  if (robot == "puma560") return std::make_unique<OnHostObserver<::robots::Puma560>>();
  if (robot == "wrist_arm") return std::make_unique<OnHostObserver<::robots::WristArm>>();
  refuse(robot);
}

std::unique_ptr<Controller> observer_in_firmware(const std::string& board, const std::string& robot) {
  if (robot != "scara" && robot != "puma560" && robot != "wrist_arm") refuse(robot);
  return emulated(board, "ekf", robot);
}

VelocityErrors observe(const Case& situation, Controller& controller, const VelocityWatch& watch) {
  const auto* const observer = dynamic_cast<const Observer*>(&controller);
  const auto limits = effort_limits(situation.robot);
  Differences differences(situation.robot);
  Squares filter, difference, slow;
  link::Torque last{};
  long ticks = 0, counted = 0;
  double changes = 0.0;
  VelocityErrors errors;
  errors.tracking =
      follow(situation, controller,
             [&](const SetPoint&, const JointState& joints, const auto& seen, const link::Torque& answer) {
               differences.add(seen);
               const auto one = differences.over(1), ten = differences.over(slow_ticks);
               const auto ours = observer != nullptr ? observer->velocity() : std::vector<double>(one.size());
               if (watch) watch(static_cast<double>(ticks) * control_tick, joints.qd, ours, one, ten);
               if (++ticks > begins) {
                 ++counted, filter.add(ours, joints.qd), difference.add(one, joints.qd), slow.add(ten, joints.qd);
                 for (std::size_t i = 0; i < limits.size(); ++i)
                   changes += std::pow(static_cast<double>(answer.tau[i] - last.tau[i]) / limits[i], 2.0);
               }
               last = answer;
             });
  if (observer != nullptr) errors.filter = filter.rms(counted);
  errors.difference = difference.rms(counted), errors.slow = slow.rms(counted);
  errors.chatter = std::sqrt(changes / static_cast<double>(counted) / static_cast<double>(limits.size()));
  return errors;
}

nlohmann::json to_json(const std::vector<ObserverRow>& rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const ObserverRow& r : rows)
    list.push_back({{"name", r.name},
                    {"robot", r.situation.robot},
                    {"board", r.board},
                    {"controller", r.controller},
                    {"encoder_bits", r.situation.encoder_bits},
                    {"encoder_noise_counts", r.situation.encoder_noise},
                    {"parameter_error", r.situation.parameter_error},
                    {"friction", r.situation.friction},
                    {"seconds", r.situation.seconds},
                    {"velocity_error_filter", r.errors.filter},
                    {"velocity_error_difference", r.errors.difference},
                    {"velocity_error_ten_ticks", r.errors.slow},
                    {"torque_change_over_limit", r.errors.chatter},
                    {"tool_error_rms", r.errors.tracking.tool_rms},
                    {"tool_error_max", r.errors.tracking.tool_largest},
                    {"count_most", r.count},
                    {"refused", r.errors.tracking.refused}});
  return list;
}

}  // namespace host_sim::loop

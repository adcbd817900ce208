// The loop around an extended Kalman filter, and what it makes of the encoders.
#pragma once

#include <host_sim/plants/loop/loop.hpp>

namespace host_sim::loop {

/// On the host it tells what the filter thinks.
class Observer : public Controller {
 public:
  /// rad/s or m/s, after the last measurement.
  virtual std::vector<double> velocity() const = 0;
};

/// For robots_of_single_drives(); on the host also for wrist_arm, by its drives. Throw std::runtime_error that names
/// them.
std::unique_ptr<Observer> observer_on_host(const std::string& robot);
std::unique_ptr<Controller> observer_in_firmware(const std::string& board, const std::string& robot);

/// Velocities by three means, each less the plant's: root mean squares by joint, rad/s or m/s.
struct VelocityErrors {
  std::vector<double> filter, difference, slow;  ///< differences of a tick, and of ten
  double chatter = 0.0;  ///< root mean square of a torque's change in a tick, over the joint's limit
  Tracking tracking;
};
/// Told after every tick: time, s; true velocities; those of the filter; differences of a tick, of ten.
using VelocityWatch = std::function<void(double, const std::vector<double>&, const std::vector<double>&,
                                         const std::vector<double>&, const std::vector<double>&)>;
/// Follows the cycle; the first tenth of a second does not count, the filter begins in it. The filter's velocities are
/// zero where `controller` is none.
VelocityErrors observe(const Case& situation, Controller& controller, const VelocityWatch& watch = {});

/// One line of results.
struct ObserverRow {
  Case situation;
  std::string controller, board, name;  ///< ekf or pd
  VelocityErrors errors;
  std::uint32_t count = 0;  ///< instructions of an answer at most, where a board counts
};
nlohmann::json to_json(const std::vector<ObserverRow>& rows);

}  // namespace host_sim::loop

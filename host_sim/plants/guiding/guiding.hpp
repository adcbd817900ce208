// An arm with a gripper that a hand guides: the plant, the hand, and what both felt.
#pragma once

#include <host_sim/plants/loop/controllers.hpp>

#include <functional>
#include <string>
#include <vector>

namespace host_sim::guiding {

namespace link = host_sim::loop::link;

/// Robots that have a hand-guiding image.
std::vector<std::string> robots();

/// Who computes: the image's source on the host, or the image in QEMU. `number`: float or fixed32. Throw
/// std::runtime_error that names what there is.
std::unique_ptr<loop::Controller> on_host(const std::string& robot, const std::string& number);
std::unique_ptr<loop::Controller> in_firmware(const std::string& board, const std::string& robot,
                                              const std::string& number);

/// A session of hand guiding: brakes open once the torque has come up, the hand takes the tool, leads it along an arc
/// and lets go; then set-points ask the controller to hold where the arm is.
struct Session {
  std::string robot = "scara";
  double gripper = 1.0;                       ///< of the mass that the firmware believes: the plant's own
  double pull = 1.6, rest = 0.4, hold = 0.4;  ///< s: guided, let go, held by set-points
};

/// What the joints and the hand felt.
struct Felt {
  double largest_force = 0.0;     ///< N, of the hand
  double followed = 0.0;          ///< m, from the hand to the tool at most while it guides
  double way = 0.0;               ///< m, that the tool went
  double drift = 0.0;             ///< m, from where the hand let go to where it comes to rest, 0.4 s later
  double held = 0.0;              ///< m, that the tool moves while set-points hold it
  double sag = 0.0;               ///< m, that the tool drops in the tenth of a second before the hand takes it
  std::vector<double> steps;      ///< N m or N, largest change of each joint's effort between two answers
  long refused = 0, answers = 0;  ///< answers without a fresh torque
};

/// Told after each tick: what was measured and wanted, what was answered.
using Watch = std::function<void(const link::Measurement&, const link::SetPoint&, const link::Torque&)>;

Felt guide(const Session& session, loop::Controller& controller, const Watch& watch = {});

/// What the image declares: N m or N per answer.
std::vector<double> declared_steps(const std::string& robot);

}  // namespace host_sim::guiding

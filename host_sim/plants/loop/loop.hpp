// A robot that follows its cycle in a closed loop, and how well.
#pragma once

#include <host_sim/plants/loop/controllers.hpp>
#include <host_sim/plants/simulation/models.hpp>
#include <host_sim/robots/trajectory/set_point.hpp>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace host_sim::loop {

/// What differs between the robot and its model, and between the robot and what is seen of it.
struct Case {
  std::string robot = "scara";
  bool feeds_forward = true;
  double parameter_error = 0.0;  ///< every mass, centre of mass, inertia and rotor times 1 +- this
  unsigned seed = 0;             ///< of the signs
  bool friction = false;         ///< the plant has the robot's declared friction, of which the model knows nothing
  int encoder_bits = 32;       ///< a turn; on slides the nearest step of 0.1 um to a metre over 2^bits, of drives that
                               ///< joints share likewise, whatever their unit is
  double encoder_noise = 0.0;  ///< counts of that encoder, standard deviation, before it counts
  int delay = 0;               ///< ticks between a measurement and the torque that answers it
  double seconds = 10.0;
  double start = 0.0;            ///< s into the cycle, in motion as it is wanted
  bool as_rigid = false;         ///< feed-forward of rigid joints, by a controller that knows elastic ones
  int resonance = 0;             ///< Hz of each joint with its motor locked (ElasticArm); 0: rigid joints
  double damping_ratio = 0.0;    ///< of that swing, by the transmission
  double stiffness_error = 0.0;  ///< the plant's stiffness over the firmware's, less 1
  std::vector<double> push;      ///< rad or m, by which each joint is off then; none where it is not pushed
};

/// Tracking errors over a motion.
struct Tracking {
  std::vector<double> rms, largest;           ///< of each joint, rad or m, or of each drive that joints share
  double tool_rms = 0.0, tool_largest = 0.0;  ///< of the tool point, m
  long ticks = 0;
  long refused = 0;  ///< answers without a fresh torque
};

/// The plant's joints, or the drives that they share, as they are: rad or m, and per second.
struct JointState {
  std::vector<double> q, qd;
};

/// What a loop is closed around: a simulated arm, on this host or on a board.
class Arm {
 public:
  Arm() = default;
  Arm(const Arm&) = delete;
  Arm& operator=(const Arm&) = delete;
  virtual ~Arm() = default;
  /// What its encoders say; feeds_forward is the loop's to fill.
  virtual link::Measurement read() = 0;
  /// A tick under a controller's answer.
  virtual void run(const link::Torque& answer) = 0;
  virtual JointState state() const = 0;
  /// The tool point of such positions, m.
  virtual axial::Vec3<double> tool(const std::vector<double>& q) const = 0;
};

/// Told after every tick: wanted motion, the joints when they were measured, what was measured, the answer.
using Watch = std::function<void(const SetPoint&, const JointState&, const link::Measurement&, const link::Torque&)>;

/// The cycle of host_sim/robots/trajectories, again and again; with elastic joints its moves have four continuous
/// derivatives and encoders are on the motors. The plant is in double, by four Runge-Kutta steps a tick or as many as
/// its springs need, under a torque that is held.
Tracking follow(const Case& situation, Controller& controller, const Watch& watch = {});
/// The same of any arm, which stands where `cycle` is at `first`.
Tracking follow(const Case& situation, const Trajectory& cycle, std::size_t first, Arm& arm, Controller& controller,
                const Watch& watch = {});
/// An arm in double on this host, as follow() has it: of a robot whose joints share no drives, rigid.
std::unique_ptr<Arm> arm_on_host(const Case& situation, const SetPoint& start, const simulation::Model& model,
                                 const std::vector<axial::LinkParameters>& links);

/// Whether a plant of this robot can have friction.
bool declares_friction(const std::string& robot);

/// One line of results.
struct Row {
  Case situation;
  std::string board, number, name;  ///< board "host" where the sources ran there
  Tracking tracking;
  double ratio = 0.0;  ///< tool error of the feedback alone in the same situation over this; 0: not asked
};
nlohmann::json to_json(const std::vector<Row>& rows);

}  // namespace host_sim::loop

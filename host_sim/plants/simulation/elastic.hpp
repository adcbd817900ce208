// Arms with elastic joints as plants: Spong's model as a chain of twice the joints.
#pragma once

#include <host_sim/plants/simulation/integrate.hpp>

#include <string>
#include <vector>

namespace host_sim::simulation {

/// A robot whose links stand behind springs: M(q) qdd + c + g = tau_l = K (theta - q) + D (theta-d - q-d) of the links,
/// B theta-dd + tau_l + friction(theta-d) = tau_m of the motors, B = gear^2 J (Spong 1987). To an integrator it is a
/// rigid chain: each elastic joint is one of the motor, which carries the rotor's inertia, friction and no mass, and
/// behind it, about the same axis, one of the deflection q - theta with the spring K and the damper D. Deflections are
/// states by themselves, so a spring that is nearly rigid loses no digits to theta - q. Joints without a stiffness stay
/// single.
class ElasticArm {
 public:
  /// `links` with their stiffness and rotors; `damping` D of each joint, N m s/rad or N s/m, or none. At most twelve
  /// states. Throws std::runtime_error where an elastic joint has no rotor, or a spring of its own about the link.
  ElasticArm(const std::string& robot, const std::vector<axial::LinkParameters>& links,
             const std::vector<double>& damping = {});

  /// What an integrator, a step limit and the energy are asked of.
  const Model& model() const { return model_; }
  int joints() const { return static_cast<int>(motor_.size()); }

  /// The state in which the links stand at q and move at qd with springs that carry `tau_l` steadily.
  Motion<double> state(const Values<double>& q, const Values<double>& qd, const Values<double>& tau_l = {}) const;
  Values<double> positions(const Motion<double>& x) const { return whole(x.q); }    ///< of the links, rad or m
  Values<double> velocities(const Motion<double>& x) const { return whole(x.qd); }  ///< of the links
  Values<double> motors(const Values<double>& states) const;       ///< those of q, qd or qdd that are the motors'
  Values<double> deflections(const Values<double>& states) const;  ///< those of the springs, q - theta
  /// Efforts of the motors where the chain takes them.
  Values<double> efforts(const Values<double>& tau_m) const;

 private:
  Values<double> whole(const Values<double>& states) const;

  Model model_;
  std::vector<int> motor_, spring_;  ///< which joint of the chain; a rigid joint has no spring: -1
  std::vector<double> stiffness_;
};

/// Links so elastic that each joint with its motor locked, and the others rigid in the middle of their travel, swings
/// at `resonance` Hz: K = w^2 M_ii of the links alone, as harmonic drives are told apart. Where no rotor is declared it
/// is as heavy as the links, gear^2 J = M_ii.
std::vector<axial::LinkParameters> elastic_links(const std::string& robot,
                                                 const std::vector<axial::LinkParameters>& links, double resonance);

}  // namespace host_sim::simulation

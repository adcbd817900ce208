// Stiff and extreme chains for the forward error of forward dynamics: five named families, generated. Every number is a
// float and every twist an exact right angle, so that float, double and quad solve one and the same problem.
// stiff_scenarios.json holds some of them with 30-digit accelerations: the tests check that the generators reproduce
// those bit by bit, and the quad reference those digits.
#pragma once

#include <cases/case_file.hpp>

namespace cases {

struct Scenario {
  std::string name;
  oracle::Chain<double> chain;
  oracle::Vector<double> q, qd, tau;
  double gate_double, gate_float;  ///< admissible max |error| / max |qdd| of articulated bodies

  int size() const { return chain.size(); }
};

/// ST1: uniform rods of 1 m, planar: straight, zigzag, curled with 10, 30, 100, 300 links, moving with 30 and 100.
/// cond(M) is 4 N^4, which articulated bodies do not feel. (`moving` with 30 links is the file's; 100 are drawn like
/// it.)
std::vector<Scenario> rods();
/// ST6: a z-y-x wrist whose first two links are massless, 2^-2 to 2^-14 rad from gimbal lock.
std::vector<Scenario> gimbal();
/// ST11: a centre of mass 2^4 to 2^12 m from its joint, and a second arm at its end.
std::vector<Scenario> far_com();
/// ST12: a nominal 6R arm with lengths and masses scaled by powers of two.
std::vector<Scenario> scaled_arm();
/// ST17: the wrist of ST6 with rotors of 2^-20 kg m^2.
std::vector<Scenario> gimbal_with_rotors();
/// All of them.
std::vector<Scenario> scenarios();

/// The nominal 6R arm of ST12, at the state that the other families start from.
Scenario nominal_arm();
/// The same arm, masses times 2^mass and lengths times 2^length; gravity is scaled with the lengths where asked, and
/// then the accelerations of revolute joints must not change by a bit.
Scenario scaled(const Scenario& scenario, int length, int mass, bool with_gravity);

/// Accelerations in quad by oracle::recursive_forward_dynamics.
Values reference_acceleration(const Scenario& scenario);

}  // namespace cases

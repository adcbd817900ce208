// Stiff and extreme chains for the forward error of forward dynamics: named families ST1 to ST17, generated. Every
// number is a float and every twist an exact right angle (ST9's excepted: a float), so that float, double and quad
// solve one and the same problem. stiff_scenarios.json holds half of them with 30-digit accelerations: the tests check
// that the generators reproduce those bit by bit, and the quad reference those digits.
#pragma once

#include <cases/case_file.hpp>
#include <limits>

namespace cases {

/// What articulated bodies may be off by in one type of numbers; infinity: not gated.
struct Gate {
  double forward = std::numeric_limits<double>::infinity();   ///< max |error| / max |qdd|
  double backward = std::numeric_limits<double>::infinity();  ///< residual effort over the sum of the terms' sizes
};

/// How the forward error of a scenario is measured.
enum class Measure { relative, absolute };

struct Scenario {
  std::string name;
  oracle::Chain<double> chain;
  oracle::Vector<double> q, qd, tau;
  Gate in_double, in_float;
  std::string family{};                 ///< ST1 to ST17
  Measure measure = Measure::relative;  ///< absolute: rad/s^2, where the exact answer is next to zero
  bool singular = false;                ///< no answer exists: it must be reported
  bool equilibrium = false;             ///< tau is the gravity torque, rounded to float

  int size() const { return chain.size(); }
};

/// ST1: uniform rods of 1 m, planar: straight, zigzag, curled, moving with 10, 30, 100, 300 links. cond(M) is 4 N^4,
/// which articulated bodies do not feel. (`moving` with 30 links is the file's; the others are drawn like it.)
std::vector<Scenario> rods();
/// ST2: boxes with twists of +-90 degrees, random states, N = 12, 50, 100 (the file's where it has them).
std::vector<Scenario> spatial_chains();
/// ST3: links half or twice the size of the one before, mass by its cube.
std::vector<Scenario> size_ratios();
/// ST4: an arm of 2^-10 kg links with a tip of 1 to 2^30 kg.
std::vector<Scenario> heavy_tips();
/// ST5: an arm with a tip of 2^-10 to 2^-30 kg.
std::vector<Scenario> light_tips();
/// ST6: a z-y-x wrist whose first two links are massless, 2^-2 to 2^-14 rad from gimbal lock.
std::vector<Scenario> gimbal();
/// ST7: massless links that are legitimate, and two singular chains.
std::vector<Scenario> massless_links();
/// ST7: three cubes, the first two massless, `elbow` rad from straight; the side in m.
Scenario massless_elbow(double side, double elbow);
/// ST8: rotor inertias of 2^-40 to 2^20 kg m^2.
std::vector<Scenario> rotors();
/// ST9: two joints on one axis, or 2^-10 rad off, with almost nothing between.
std::vector<Scenario> coaxial();
/// ST10: joint rates up to 1280 rad/s.
std::vector<Scenario> high_speeds();
/// ST11: a centre of mass 2^4 to 2^12 m from its joint, and a second arm at its end.
std::vector<Scenario> far_com();
/// ST12: a nominal 6R arm with lengths and masses scaled by powers of two.
std::vector<Scenario> scaled_arm();
/// ST13: ten rods with alternating efforts of +-2^20 N m.
std::vector<Scenario> opposing_drives();
/// ST14: the nominal arm held by its own gravity torque.
std::vector<Scenario> gravity_hold();
/// ST15: ten slides on one axis.
std::vector<Scenario> telescopes();
/// ST16: links of 2^-10 and 2^10 kg in turn.
std::vector<Scenario> mass_ratios();
/// ST17: the wrist of ST6 with rotors of 2^-20 kg m^2.
std::vector<Scenario> gimbal_with_rotors();
/// All of them.
std::vector<Scenario> scenarios();

/// The nominal 6R arm of ST12, at the state that the other families start from.
Scenario nominal_arm();
/// The same scenario, masses times 2^mass and lengths times 2^length, time as it is; gravity is scaled with the lengths
/// where asked, and then the accelerations of revolute joints must not change by a bit, those of slides by 2^length.
Scenario scaled(const Scenario& scenario, int length, int mass, bool with_gravity);
/// The same with every size, mass, inertia, position, speed and effort that is not zero off by up to one part in 16.
Scenario perturbed(const Scenario& scenario, unsigned seed);

/// Accelerations in quad by oracle::recursive_forward_dynamics.
Values reference_acceleration(const Scenario& scenario);

}  // namespace cases

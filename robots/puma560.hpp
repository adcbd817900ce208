// Unimation Puma 560, MDH frames: B. Armstrong, O. Khatib, J. Burdick, "The Explicit Dynamic Model and Inertial
// Parameters of the PUMA 560 Arm", IEEE ICRA 1986.
//
// measured:  masses and centres of mass of links 2 to 6 and the inertias about the principal axes (the authors took an
//            arm apart); link 1 only as its inertia about joint 1, so that it has no mass here.
// published: rotor inertias and gear ratios (mdl_puma560akb of P. Corke's Robotics Toolbox for MATLAB, whose table
//            this is; its Izz of link 3 is 0.066, the toolbox's standard-DH model has 0.086); friction (the toolbox's
//            standard-DH model, after P. Corke, B. Armstrong-Helouvry, IEEE ICRA 1994: motor side, carried to the
//            joint here); joint ranges (the toolbox's, with the signs of these joint angles); greatest torques (quoted
//            from the 1986 paper's table of motors and drives, not checked against a copy of it).
// assumed:   speeds and accelerations; the greatest payload (2.5 kg, as usually quoted for this arm; its reach and
//            inertia are ours).
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Puma 560's drives: rotor and friction on the motor side, carried to the joint.
struct Puma560Drives {
  static constexpr double deg = 3.14159265358979323846 / 180.0;  ///< rad in a degree

  /// Rotor in kg m^2; friction: viscous N m s/rad times gear^2, Coulomb N m (forward, backward) times |gear|.
  static constexpr axial::Link drive(const axial::Link& link, double rotor, double gear, double viscous, double forward,
                                     double backward) {
    const double ratio = gear < 0.0 ? -gear : gear;
    return link.rotor_inertia(rotor, gear).viscous(viscous * gear * gear).coulomb(forward * ratio, backward * ratio);
  }
};

/// Unimation Puma 560, six revolute joints.
struct Puma560 : Puma560Drives {
  static constexpr const char* name = "puma560";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81), axial::payload_limit(2.5, 0.25, 0.05),
      drive(
          axial::revolute().a(0.0).alpha_deg(0).d(0.0)
          .inertia_com(0.0, 0.0, 0.35).accept(axial::as_published)  // no mass: the paper has what torques can tell
          .position_limits(-160 * deg, 160 * deg)
          .speed_limit(1.4).acceleration_limit(6.0).effort_limit(97.6),
          291e-6, -62.6111, 1.48e-3, 0.395, -0.435),
      drive(
          axial::revolute().a(0.0).alpha_deg(-90).d(0.2435)
          .mass(17.4).com(0.068, 0.006, -0.016).inertia_com(0.130, 0.524, 0.539)
          .position_limits(-225 * deg, 45 * deg)
          .speed_limit(1.2).acceleration_limit(6.0).effort_limit(186.4),
          409e-6, 107.815, 0.817e-3, 0.126, -0.071),
      drive(
          axial::revolute().a(0.4318).alpha_deg(0).d(-0.0934)
          .mass(4.8).com(0.0, -0.070, 0.014).inertia_com(0.066, 0.0125, 0.066)
          .position_limits(-45 * deg, 225 * deg)
          .speed_limit(2.1).acceleration_limit(10.0).effort_limit(89.4),
          299e-6, -53.7063, 1.38e-3, 0.132, -0.105),
      drive(
          axial::revolute().a(-0.0203).alpha_deg(90).d(0.4331)
          .mass(0.82).com(0.0, 0.0, -0.019).inertia_com(1.8e-3, 1.8e-3, 1.3e-3)
          .position_limits(-110 * deg, 170 * deg)
          .speed_limit(3.9).acceleration_limit(25.0).effort_limit(24.2),
          35e-6, 76.0364, 71.2e-6, 11.2e-3, -16.9e-3),
      drive(
          axial::revolute().a(0.0).alpha_deg(-90)
          .mass(0.34).inertia_com(0.3e-3, 0.3e-3, 0.4e-3)
          .position_limits(-100 * deg, 100 * deg)
          .speed_limit(4.2).acceleration_limit(25.0).effort_limit(20.1),
          35e-6, 71.923, 82.6e-6, 9.26e-3, -14.5e-3),
      drive(
          axial::revolute().a(0.0).alpha_deg(90)
          .mass(0.09).com(0.0, 0.0, 0.032).inertia_com(0.15e-3, 0.15e-3, 0.04e-3)
          .position_limits(-266 * deg, 266 * deg)
          .speed_limit(3.9).acceleration_limit(25.0).effort_limit(21.3),
          35e-6, 76.686, 36.7e-6, 3.96e-3, -10.5e-3));
  // clang-format on
};

}  // namespace robots

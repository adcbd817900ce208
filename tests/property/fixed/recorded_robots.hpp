// Robots whose certified bounds are recorded: small, so that an analysis is compiled in seconds, and together with all
// that an analysis looks at.
#pragma once

#include <axial/robot/chain.hpp>

namespace property::recorded {

using namespace axial;

/// A slide, a wrist with rotors, gravity along no axis, all that a chain can declare.
struct Crane {
  static constexpr auto chain = axial::chain(gravity(1.0, -3.0, -9.0), payload_limit(1.5, 0.1, 0.02),
                                             tip_wrench_limit(30.0, 4.0), tool_limit(0.3),
                                             prismatic()
                                                 .d(0.2)
                                                 .alpha_deg(90)
                                                 .mass(4)
                                                 .com(0.1, 0, 0.05)
                                                 .inertia_com(0.03, 0.04, 0.05)
                                                 .rotor_inertia(2e-5, 900)
                                                 .viscous(12)
                                                 .coulomb(7)
                                                 .position_limits(-0.3, 0.7)
                                                 .speed_limit(0.8)
                                                 .acceleration_limit(3)
                                                 .effort_limit(300),
                                             revolute()
                                                 .a(0.35)
                                                 .alpha_deg(-90)
                                                 .d(0.12)
                                                 .mass(2.5)
                                                 .com(0.15, 0.02, -0.01)
                                                 .inertia_com(0.02, 0.05, 0.045, 0.002, 0, 0)
                                                 .rotor_inertia(3e-5, 100)
                                                 .viscous(0.7)
                                                 .coulomb(0.9)
                                                 .spring(4, 0.2)
                                                 .position_limits(-2.5, 2)
                                                 .speed_limit(3)
                                                 .acceleration_limit(20)
                                                 .effort_limit(60),
                                             revolute()
                                                 .a(0.25)
                                                 .alpha_deg(40)
                                                 .mass(0.9)
                                                 .com(0.08, 0.01, 0.03)
                                                 .inertia_com(0.002, 0.006, 0.005)
                                                 .rotor_inertia(1e-5, 50)
                                                 .viscous(0.1)
                                                 .coulomb(0.3)
                                                 .speed_limit(6)
                                                 .acceleration_limit(60)
                                                 .effort_limit(20),
                                             axial::tool(0.05, 0.02, 0.15));
};
/// A tree: two fingers on a turning palm.
struct Finger {
  static constexpr Link finger(double side) {
    return revolute()
        .parent(0)
        .branch_deg(70 * side, 0.06)
        .a(0.04)
        .alpha_deg(90)
        .theta_deg(20)
        .mass(0.4)
        .com(0.05, 0.01 * side, 0)
        .inertia_com(2e-4, 9e-4, 8e-4)
        .rotor_inertia(5e-7, 200)
        .position_limits(0, 1.4)
        .speed_limit(4)
        .acceleration_limit(30 + 10 * side)
        .effort_limit(3);
  }
};
struct Hand : Finger {
  static constexpr auto chain = axial::chain(gravity(0, -9.81, 0), tip_wrench_limit(10.0, 1.0),
                                             revolute()
                                                 .d(2.6)
                                                 .mass(1.1)
                                                 .com(0, 0.01, 0.05)
                                                 .inertia_com(2e-3, 2e-3, 1e-3)
                                                 .rotor_inertia(2e-6, 120)
                                                 .speed_limit(7)
                                                 .acceleration_limit(70)
                                                 .effort_limit(8),
                                             finger(1), finger(-1));
};

/// Drives that could move what they carry ten thousand times as fast as is declared.
struct FeatherLinks {
  static constexpr Link link(double rotor) {
    return revolute()
        .mass(0.02)
        .com(0.03, 0.01, 0)
        .inertia_com(2e-5, 3e-5, 2e-5)
        .rotor_inertia(rotor, 100)
        .speed_limit(3)
        .acceleration_limit(20)
        .effort_limit(90);
  }
};
struct Feather : FeatherLinks {
  static constexpr auto chain =
      axial::chain(gravity(0, 0, -9.81), link(2e-8), link(1e-8).a(0.2).alpha_deg(90), link(3e-9).a(0.1).alpha_deg(-60));
};
struct BeltLinks {
  static constexpr Link link(double mass) {
    return revolute()
        .mass(mass)
        .com(0.1, 0.02, 0)
        .inertia_com(0.01, 0.02, 0.02)
        .rotor_inertia(2e-5, 80)
        .viscous(0.4)
        .coulomb(0.5)
        .position_limits(-2, 2)
        .speed_limit(3)
        .acceleration_limit(25)
        .effort_limit(40);
  }
};
/// Two joints that share two drives, behind one that has its own.
struct Belt : BeltLinks {
  static constexpr auto chain =
      axial::chain(gravity(0, -9.81, 0), tip_wrench_limit(20.0, 3.0), link(3.0), link(2.0).a(0.3).alpha_deg(90),
                   link(1.0).a(0.25).driven_by(1, -0.7).drive_limits(-2, 2, 3, 25));
};

struct BentLinks {
  static constexpr Link link(double theta) {
    return revolute()
        .alpha_deg(180)
        .theta_deg(theta)
        .mass(2)
        .com(0.12, 0, -0.03)
        .inertia_com(0.01, 0.03, 0.04)
        .speed_limit(4)
        .acceleration_limit(25)
        .effort_limit(60);
  }
};
/// The closed form's arm with its second joint off a quarter turn.
struct BentScara : BentLinks {
  static constexpr auto chain = axial::chain(gravity(0, 0, -9.81), link(90), link(25).a(0.35),
                                             prismatic()
                                                 .a(0.3)
                                                 .mass(1.2)
                                                 .com(0.04, 0, -0.1)
                                                 .inertia_com(0.004, 0.005, 0.002)
                                                 .position_limits(-0.2, 0.2)
                                                 .speed_limit(1)
                                                 .acceleration_limit(10)
                                                 .effort_limit(50));
};

}  // namespace property::recorded

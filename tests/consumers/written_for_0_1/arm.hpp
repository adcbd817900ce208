// An arm of somebody's own, with everything that a description may say of a link.
#pragma once
#include <axial/axial.hpp>

struct Arm {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, 0.0, -9.81),
                                             axial::revolute()
                                                 .d(0.3)
                                                 .mass(4.0)
                                                 .com(0.0, 0.01, -0.1)
                                                 .inertia_com(0.03, 0.03, 0.01, 0.0, 0.0, 0.001)
                                                 .rotor_inertia(1e-4, 100.0)
                                                 .viscous(0.5)
                                                 .coulomb(1.0)
                                                 .position_limits_deg(-170.0, 170.0)
                                                 .speed_limit(3.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(120.0),
                                             axial::revolute()
                                                 .alpha_deg(-90.0)
                                                 .mass(3.0)
                                                 .com(0.2, 0.0, 0.0)
                                                 .inertia_com(0.01, 0.04, 0.04)
                                                 .position_limits(-2.0, 2.0)
                                                 .speed_limit(3.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(100.0),
                                             axial::prismatic()
                                                 .a(0.4)
                                                 .d(0.1)
                                                 .mass(1.0)
                                                 .com(0.0, 0.0, 0.05)
                                                 .inertia_com(0.002, 0.002, 0.001)
                                                 .position_limits(0.0, 0.2)
                                                 .speed_limit(1.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(80.0));
};

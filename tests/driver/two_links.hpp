// A small arm for the verbs that take a header: quick to compile, with friction, and limits for fixed point.
#pragma once

#include <axial/axial.hpp>

namespace robots {

struct TwoLinks {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.81, 0.0),
                                             axial::revolute()
                                                 .mass(4.0)
                                                 .com(0.25, 0.0, 0.0)
                                                 .inertia_com(0.01, 0.04, 0.04)
                                                 .viscous(0.5)
                                                 .coulomb(1.5)
                                                 .position_limits(-2.0, 2.0)
                                                 .speed_limit(3.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(120.0),
                                             axial::revolute()
                                                 .a(0.5)
                                                 .mass(2.0)
                                                 .com(0.2, 0.0, 0.0)
                                                 .inertia_com(0.005, 0.02, 0.02)
                                                 .coulomb(0.75)
                                                 .position_limits(-2.5, 2.5)
                                                 .speed_limit(4.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(50.0));
};

}  // namespace robots

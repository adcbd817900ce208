// Franka Emika Panda (FER), seven revolute joints, MDH frames as the maker publishes them.
//
// published: MDH rows, flange, and the limits of position, speed, acceleration and torque (the maker's documentation
//            of the control interface, "limits for Panda").
// published: inertial parameters of C. Gaz, M. Cognetti, A. Oliva, P. Robuffo Giordano, A. De Luca, "Dynamic
//            Identification of the Franka Emika Panda Robot With Retrieval of Feasible Parameters Using Penalty-Based
//            Optimization", IEEE RA-L 4(4), 2019, as the maker distributes them in its robot description: one feasible
//            set of link parameters that fits measured torques. They are not the mass of the parts; only their base
//            combinations were identified, and c_z of link 1 can not be seen at all (printings differ).
//            Rotor inertias are part of that fit, so none is declared. tests/data/gaz_panda_basefit.json is a
//            different set: adjusted to the authors' generated code, and no longer positive definite link by link.
// assumed:   no friction (the paper's is a sigmoid, which viscous and Coulomb terms do not express).
#pragma once

#include <axial/model/chain.hpp>

namespace robots {

struct Panda {
  static constexpr const char* name = "panda";

  // A line a group of values.
  // clang-format off
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::revolute().a(0.0).alpha_deg(0).d(0.333)
          .mass(4.970684).com(0.003875, 0.002081, -0.04762)
          .inertia_com(0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169)
          .position_limits(-2.8973, 2.8973).speed_limit(2.175).acceleration_limit(15.0).effort_limit(87.0),
      axial::revolute().a(0.0).alpha_deg(-90)
          .mass(0.646926).com(-0.003141, -0.02872, 0.003495)
          .inertia_com(0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704)
          .position_limits(-1.7628, 1.7628).speed_limit(2.175).acceleration_limit(7.5).effort_limit(87.0),
      axial::revolute().a(0.0).alpha_deg(90).d(0.316)
          .mass(3.228604).com(0.027518, 0.039252, -0.066502)
          .inertia_com(0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805)
          .position_limits(-2.8973, 2.8973).speed_limit(2.175).acceleration_limit(10.0).effort_limit(87.0),
      axial::revolute().a(0.0825).alpha_deg(90)
          .mass(3.587895).com(-0.05317, 0.104419, 0.027454)
          .inertia_com(0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641)
          .position_limits(-3.0718, -0.0698).speed_limit(2.175).acceleration_limit(12.5).effort_limit(87.0),
      axial::revolute().a(-0.0825).alpha_deg(-90).d(0.384)
          .mass(1.225946).com(-0.011953, 0.041065, -0.038437)
          .inertia_com(0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229)
          .position_limits(-2.8973, 2.8973).speed_limit(2.61).acceleration_limit(15.0).effort_limit(12.0),
      axial::revolute().a(0.0).alpha_deg(90)
          .mass(1.666555).com(0.060149, -0.014117, -0.010517)
          .inertia_com(0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341)
          .position_limits(-0.0175, 3.7525).speed_limit(2.61).acceleration_limit(20.0).effort_limit(12.0),
      axial::revolute().a(0.088).alpha_deg(90)
          .mass(0.735522).com(0.010517, -0.004252, 0.061597)
          .inertia_com(0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741)
          .position_limits(-2.8973, 2.8973).speed_limit(2.61).acceleration_limit(20.0).effort_limit(12.0),
      axial::tool(0.0, 0.0, 0.107));
  // clang-format on
};

}  // namespace robots

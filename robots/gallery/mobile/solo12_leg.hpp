// a leg of the Solo 12.
//
// data:     Gepetto/example-robot-data, commit 39aa94379908,
//           robots/solo_description/robots/solo12.urdf;
//           BSD-3-Clause, LAAS-CNRS, University of Edinburgh, INRIA; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   solo12.urdf (URDF), links of 'base_link' to 'FL_FOOT', whose frame is the tool's
// assumed:  gravity of 9.81 m/s^2 along -z of link 'base_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: FL_HAA, FL_HFE, FL_KFE
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 2.4e-16 of the largest, mass matrix within
//           4.1e-16 of its largest entry (bound 1e-09), bodies within 8e-17 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// a leg of the Solo 12.
struct Solo12Leg {
  static constexpr const char* name = "solo12_leg";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(axial::FixedPose{{0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      axial::tool(axial::FixedPose{{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
                                   {-0.16, 0.0, 0.05945}}),
      // 0: FL_HAA moves FL_SHOULDER
      axial::revolute().a(0.0875).alpha_deg(90).d(0.1946).theta_deg(90)
          .mass(0.14853845).com(0.0, -0.01, -0.078707).inertia_com(0.00041107, 0.00041193, 3.024e-05, 0.0, 0.0, -4.671e-05)
          .position_limits(-10.0, 10.0).speed_limit(1000.0).acceleration_limit(4000.0).effort_limit(1000.0),
      // 1: FL_HFE moves FL_UPPER_LEG
      axial::revolute().alpha_deg(90)
          .mass(0.14853845).com(-0.078707, 1.377e-05, 0.03335853).inertia_com(3.024e-05, 0.00041107, 0.00041193, 0.0, 4.671e-05, 0.0)
          .position_limits(-10.0, 10.0).speed_limit(1000.0).acceleration_limit(4000.0).effort_limit(1000.0),
      // 2: FL_KFE moves FL_LOWER_LEG
      axial::revolute().a(-0.16)
          .mass(0.03763607).com(-0.10224903071020168, 0.0, 0.05934921122913205).inertia_com(2.690086377949433e-06, 0.0001488193037682854, 0.00014913921739033597, 0.0, 3.0991871808848403e-06, 0.0)
          .position_limits(-10.0, 10.0).speed_limit(1000.0).acceleration_limit(4000.0).effort_limit(1000.0)
  );
  // clang-format on
};

}  // namespace robots

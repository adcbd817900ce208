// Which recursion a kernel is.
#pragma once

#include <axial/options/begin.hpp>

namespace axial {

/// Which recursion walks over links: a number system with formats has others for each.
namespace recursion {
struct NewtonEuler {};              ///< inverse dynamics
struct MotionEfforts {};            ///< the same where efforts are told from those that drive a motion
struct CompositeBodies {};          ///< the mass matrix
struct ArticulatedBodies {};        ///< the classical form
struct ArticulatedBodiesAtRest {};  ///< of the split form
struct Kinematics {};               ///< poses and Jacobians
struct Separation {};               ///< the separated terms
struct Momenta {};                  ///< joint momenta and their drift
struct BaseForce {};                ///< what carries the robot
}  // namespace recursion

}  // namespace axial

#include <axial/options/end.hpp>

// Seeded states of a robot and their exact accelerations.
#pragma once

#include <host_sim/robots/robots/driven_robot.hpp>

#include <iterator>

namespace counts {

/// A state inside the declared limits and its exact acceleration, by joints, or by drives where joints share them.
/// Positions, speeds and efforts are floats, so that float, double and quad solve one problem; the robot's constants
/// are not, and their rounding is part of the error.
struct State {
  oracle::Vector<double> q, qd, tau;
  oracle::Vector<oracle::quad> qdd;
};

/// Of a chain and the limits of its joints, or drives, as they are declared.
std::vector<State> seeded_states(const oracle::DrivenChain<oracle::quad>& chain,
                                 const std::vector<axial::LinkParameters>& limits);

/// Of a robot.
template <class R>
std::vector<State> seeded_states() {
  const auto& drives = host_sim::DrivesOf<R>::chain.links;
  return seeded_states(host_sim::driven_robot<oracle::quad, R>(), {std::begin(drives), std::end(drives)});
}

}  // namespace counts

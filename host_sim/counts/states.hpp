// Seeded states of a robot and their exact accelerations.
#pragma once

#include <axial/robot/chain.hpp>
#include <oracle/from_axial.hpp>

#include <iterator>

namespace counts {

/// A state inside the declared limits and its exact acceleration. Positions, speeds and efforts are floats, so that
/// float, double and quad solve one problem; the robot's constants are not, and their rounding is part of the error.
struct State {
  oracle::Vector<double> q, qd, tau;
  oracle::Vector<oracle::quad> qdd;
};

/// Of a chain and its links as they are declared.
std::vector<State> seeded_states(const oracle::Chain<oracle::quad>& chain,
                                 const std::vector<axial::LinkParameters>& links);

/// Of a robot.
template <class R>
std::vector<State> seeded_states() {
  return seeded_states(oracle::of_robot<oracle::quad, R>(), {std::begin(R::chain.links), std::end(R::chain.links)});
}

}  // namespace counts

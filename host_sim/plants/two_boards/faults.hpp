// What goes wrong on the line between two boards, and how it ends.
#pragma once

#include <host_sim/robots/trajectory/set_point.hpp>

#include <functional>
#include <string>
#include <vector>

namespace host_sim::two_boards {

/// Images of one robot on two boards.
struct Boards {
  std::string controller, controller_app, arm, arm_app, robot;
};

struct FaultRow {
  std::string fault, ends;  ///< what goes wrong; how it has to end
  bool held = false;
  std::string found;  ///< where it does not
};

/// Every fault, on boards that are started anew for it; `at` is told how many are done. A broken tick of the line is
/// waited for, so it takes a minute or two.
std::vector<FaultRow> faults_of_line(const Boards& boards, const Trajectory& cycle,
                                     const std::function<void(std::size_t done)>& at);
std::size_t fault_count();

}  // namespace host_sim::two_boards

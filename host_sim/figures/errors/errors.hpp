// How exact every algorithm is in every number system, on the same states.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace errors {

/// One kernel, by the names of firmware/apps/size/matrix.txt: the probe of these names has the same source.
struct Kernel {
  std::string robot, scene, algorithm, variant, scalar;
};

/// A vector or a matrix among the results of a kernel that has several.
struct Block {
  std::string name;             ///< as the library's member
  double error;                 ///< relative to its largest entry over all states
  double error_in_state;        ///< relative to its largest entry in the same state: large where all of it cancels
  double error_in_most_states;  ///< the same, not exceeded in 99 of 100 states
  double error_uncancelled;     ///< relative to the larger of that and a hundredth of its largest over all states
};

/// Errors over seeded states inside the declared limits, relative as host_sim::error_scales() says.
struct Row {
  Kernel kernel;
  int states;
  double error, error_rms;
  std::optional<double>
      error_torque;  ///< of accelerations: M(q) times their error, relative to the joint's largest torque
  std::optional<double> certified;  ///< what the analysis proves of any state, of a torque in fixed point
  std::vector<Block> blocks;        ///< of derivatives, and of motors behind springs
  int joints;                       ///< values of each argument: drives, where joints share them
};

/// Empty: all.
struct Choice {
  std::string robot, algorithm, scalar;
};

/// Rows of the kernels that the matrix lists. Throws std::runtime_error when there is none of these names, naming those
/// that there are.
std::vector<Row> rows(const Choice& choice);

}  // namespace errors

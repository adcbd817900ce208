// What races: one algorithm of one implementation over a fixed set of states. Plain arrays only, so that translation
// units compiled for different processors can meet here.
#pragma once

#include <memory>
#include <vector>

namespace bench {

/// Behind `forward_dynamics`, which takes the default route, stand routes of ours that a scene names.
enum class Algorithm {
  inverse_dynamics,
  gravity,
  bias,
  mass_matrix,
  inverse_dynamics_derivatives,
  forward_dynamics,
  articulated_body,
  split_articulated_body,
  composite_body,
  forward_dynamics_derivatives
};

constexpr bool is_forward(Algorithm algorithm) { return algorithm >= Algorithm::forward_dynamics; }

inline const char* name_of(Algorithm algorithm) {
  constexpr const char* names[] = {"inverse_dynamics",
                                   "gravity",
                                   "bias",
                                   "mass_matrix",
                                   "inverse_dynamics_derivatives",
                                   "forward_dynamics",
                                   "articulated_body",
                                   "split_articulated_body",
                                   "composite_body",
                                   "forward_dynamics_derivatives"};
  return names[static_cast<int>(algorithm)];
}

/// Joint values of a number of states, one state after the other; tau gives the acceleration qdd.
struct States {
  int joints = 0, count = 0;
  std::vector<double> q, qd, qdd, tau;
};

class Contender {
 public:
  virtual ~Contender() = default;
  /// Evaluates states first, ..., first + count - 1. This is what is timed: the states are held in the contender's own
  /// types.
  virtual void run(int first, int count) = 0;
  /// Result of one state: N values, or the N x N mass matrix row by row; of derivatives the values that they are of.
  virtual std::vector<double> result(int state) = 0;
};

using Contenders = std::vector<std::unique_ptr<Contender>>;

}  // namespace bench

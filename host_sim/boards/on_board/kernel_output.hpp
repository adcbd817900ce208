// What the `kernels` image prints, as data (format: firmware/apps/kernels/README.md).
#pragma once

#include <host_sim/robots/trajectory/set_point.hpp>

#include <string>
#include <vector>

namespace host_sim {

/// One evaluation of a kernel: its cost and its result, in the order that the format documents.
struct Evaluation {
  std::string kernel, scalar;  ///< e.g. inverse_dynamics, float
  std::size_t state = 0;
  unsigned count = 0;  ///< instructions
  std::vector<double> result;
};

struct KernelOutput {
  std::string counter;           ///< what `count` counts: instructions or cycles
  std::vector<SetPoint> states;  ///< the floats that the kernels were given
  std::vector<Evaluation> evaluations;
};

/// Throws std::runtime_error with the offending line, or when the output ends early.
KernelOutput parse_kernel_output(const std::string& text);

}  // namespace host_sim

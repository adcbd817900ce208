// Which choices are worth having: no other is as exact and as cheap.
#pragma once

#include <cstddef>
#include <vector>

namespace host_sim {

struct ErrorAndWork {
  double error = 0.0, work = 0.0;
};

/// For each choice whether it lies on the Pareto front: none other is at most as bad in both and better in one.
inline std::vector<bool> pareto_front(const std::vector<ErrorAndWork>& choices) {
  const auto dominates = [](const ErrorAndWork& a, const ErrorAndWork& b) {
    return a.error <= b.error && a.work <= b.work && (a.error < b.error || a.work < b.work);
  };
  std::vector<bool> front;
  for (const ErrorAndWork& choice : choices) {
    bool beaten = false;
    for (const ErrorAndWork& other : choices)
      beaten = beaten || dominates(other, choice);
    front.push_back(!beaten);
  }
  return front;
}

}  // namespace host_sim

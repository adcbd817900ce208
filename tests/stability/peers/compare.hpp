// Our forward dynamics (articulated bodies, and the form that is taken by default) beside the engines, on perturbed
// instances of every scenario.
#pragma once

#include <stability/measure.hpp>
#include <stability/peers/engine.hpp>

namespace stability {

/// Medians over the instances.
struct Comparison {
  std::string scenario, family, engine, scalar;
  int joints = 0, instances = 0;
  bool absolute = false;
  double nominal_error = 0.0;  ///< the engine's on the scenario itself; infinite: NaN, or an exception
  double engine_error = 0.0;
  double our_error = 0.0;
  double ratio = 0.0;  ///< ours over theirs, instance by instance, both taken as 8 eps at least
  bool excluded = false;
  bool pass = false;
  std::string said;  ///< what the engine answers where there is no answer: it cannot say so
};

/// How many times more exact an engine may be.
constexpr double admissible_ratio = 10.0;

/// One scenario, all engines that have a model of it. S03_grow is excluded: hopeless for all.
std::vector<Comparison> compare(const Scenario& scenario, const std::vector<Peer>& peers, int instances);

/// Every engine of this build.
std::vector<Peer> all_peers();

}  // namespace stability

// An arm that is off its motion, and how a controller brings it back.
#pragma once

#include <host_sim/plants/loop/loop.hpp>

namespace host_sim::loop {

/// rad or m: so near is where it is wanted.
constexpr double recovered = 1e-3;
/// rad of a turning joint, m of a slide.
constexpr double push_rad = 0.1, push_m = 0.01;

/// Pushes of one joint, or of every one (-1).
std::vector<double> push_of(const std::string& robot, int joint);

/// How an arm came back.
struct Recovery {
  double seconds = 0.0;               ///< until every joint stays `recovered`
  double effort = 0.0;                ///< largest torque over the joint's declared limit
  double overshoot = 0.0;             ///< rad or m, at most beyond where it is wanted, or off where it was not pushed
  std::uint32_t least = 0, most = 0;  ///< instructions or cycles of an answer, where a board counts
  Tracking tracking;                  ///< of the whole run
};
Recovery recover(const Case& situation, Controller& controller, const Watch& watch = {});

/// One line of results.
struct PushRow {
  Case situation;
  std::string controller, board, name;  ///< lqr or pd; board "host" where the sources ran there
  Recovery recovery;
};
nlohmann::json to_json(const std::vector<PushRow>& rows);

}  // namespace host_sim::loop

// Contacts of a simulated Panda: are they detected, how soon, and what is taken for one that is none.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace host_sim::collide {

/// One number system's answer.
struct Row {
  std::string scalar;
  double seconds = 0.0;          ///< of motion without, and again with contacts
  int contacts = 0, missed = 0;  ///< steps of 5 % of a joint's effort limit; not detected while they last
  std::vector<double> delays;    ///< s, of those detected
  int false_alarms = 0;          ///< in the motion without contacts, and between contacts
  int refused = 0;               ///< samples with a bad status
  double headroom = 0.0;         ///< largest residual without contacts over its threshold

  double longest() const;
  double median() const;
};

/// One instant of the motion with contacts: N m.
struct Instant {
  double time = 0.0;
  double external[7] = {}, residual[7] = {}, threshold[7] = {};
  bool detected = false;
};
using Watch = std::function<void(const Instant&)>;

/// Both motions, by an observer over `float` or fixed point ("float", "fixed32").
Row run(const std::string& scalar, double seconds, unsigned seed, const Watch& watch = {});

}  // namespace host_sim::collide

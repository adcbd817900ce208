// What each congruence costs a link, and how exact forward dynamics is with it on long chains.
#pragma once

#include <axial/scalar/counting.hpp>
#include <host_sim/figures/counts/inertia_step.hpp>

#include <string>
#include <vector>

namespace counts {

/// The run-time model of the long chains.
using LongChain = axial::Model<300>;

/// One congruence, one length of chain: rods that lie straight, zigzag and curled (ST1 of tests/cases/scenarios.hpp).
struct CongruenceRow {
  std::string congruence;
  axial::Operations cost;  ///< a revolute joint with general a, alpha and d; theta's sine and cosine are given
  int links;
  double in_float, in_double;  ///< largest max |error| / max |qdd|, against quadruple precision
};

/// 10, 30, 100 and 300 links by every congruence.
std::vector<CongruenceRow> congruence_rows();

}  // namespace counts

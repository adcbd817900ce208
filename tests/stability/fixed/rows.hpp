// Scenarios that fit the declared limits of a robot, in 32-bit fixed point.
#pragma once

#include <stability/rows.hpp>

namespace stability {

/// Without a gate. Throws std::logic_error if R is not the chain of the scenario.
template <class R>
Row fixed_row(const Scenario& scenario);

/// Those whose names hold `filter`.
std::vector<Row> fixed_rows(const std::string& filter);

}  // namespace stability

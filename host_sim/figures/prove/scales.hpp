// What each word of a program stands for.
#pragma once

#include <host_sim/figures/prove/formula.hpp>
#include <host_sim/figures/prove/program.hpp>

#include <map>

namespace prove {

/// Binary exponents of the nodes' units: what a node stands for is value 2^-scale.
using Scales = std::map<int, int>;

/// From those of inputs and results to those of all other nodes: a shift keeps what a word stands for, a sum's terms
/// and the sum have one unit, a product's constant is the formula's. `values` are those of the formula's terms in the
/// run. Where two ways lead to a node and disagree, the first one holds.
Scales scales_of(const Program& program, const Formula& formula, const std::vector<long double>& values,
                 const Scales& known);

/// What a node of known scale stands for in the recorded run.
long double real_value(const Program& program, int node, const Scales& scales);

}  // namespace prove

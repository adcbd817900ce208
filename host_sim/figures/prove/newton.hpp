// Newton's steps towards a reciprocal: they correct the word that they start from, so their errors are not those of
// their operands, which is all that pairs of nodes and terms tell.
#pragma once

#include <host_sim/figures/prove/names.hpp>

namespace prove {

/// Lines about the error of a node that stands for s.reciprocal.term, where it is y = a + a e, rounded, and e is
/// c - a x, rounded; else none.
std::string newton_lines(const Statement& s, const Names& names, int node);
/// How large words of such a step are: y is near the reciprocal, and e is small. To say it where errors alone are
/// asked for would triple the time.
std::string newton_word_lines(const Statement& s, const Names& names, int node);
/// Lines about the polynomial.
std::string polynomial_lines(const Statement& s, const Names& names);

}  // namespace prove

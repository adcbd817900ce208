// A program and what it stands for, as a script of Gappa.
#pragma once

#include <host_sim/figures/prove/scales.hpp>

#include <optional>

namespace prove {

/// A real variable: off by at most `within` from a term of the formula or, where there is none, from an input.
struct RealVariable {
  std::string name;
  long double value = 0.0L;  ///< in the recorded run
  std::string near_input;
  int near_term = -1;
  double within = 0.0;
};

/// A result, the formula's term that it approximates, and the bound to prove of their difference.
struct Result {
  std::string name;
  int node = -1, term = -1;
  double bound = 0.0;
};

/// That results approximate 1 / x, by Newton's steps from a polynomial.
struct Reciprocal {
  int term = -1, of = -1;  ///< 1 / x, and x
  int polynomial = -1;     ///< near 1 / x
  int excess = -1;         ///< x times the polynomial, less 1, in a form that intervals bound well
};

/// What a script is made from.
struct Statement {
  Program program;
  Formula formula;
  Scales known;  ///< scales of inputs and results
  std::vector<RealVariable> variables;
  std::vector<Result> results;
  std::optional<Reciprocal> reciprocal;
  std::string split;             ///< input whose range Gappa cuts into pieces, if any
  long double likeness = 1e-5L;  ///< relative difference of a node and a term, in the run, that are one quantity
};

/// What a script demands: that errors stay within their bounds, that words hold what is put into them and choices by
/// masks always go the same way, or an answer how large the errors are.
enum class Goal { errors, words, ask };

std::string script_of(const Statement& statement, Goal goal);

}  // namespace prove

// What nodes and terms are called in a script, and what they are worth in the recorded run.
#pragma once

#include <host_sim/figures/prove/script.hpp>

namespace prove {

/// An integer times 2^-scale, a double to 17 digits, and a double exactly, as Gappa reads them.
///@{
std::string binary(Integer value, int scale);
std::string decimal(double x);
std::string exact(double x);
///@}

/// Names of a statement's nodes and terms; a node's name stands for its value times 2^-scale.
class Names {
 public:
  explicit Names(const Statement& s);  ///< refers to the statement

  [[nodiscard]] int scale(int node) const { return scales_.at(node); }
  [[nodiscard]] std::string of_node(int node) const;
  /// A node in the unit 2^-wanted of what it is an operand of.
  [[nodiscard]] std::string operand(int node, int wanted) const;
  [[nodiscard]] std::string of_term(int term) const;
  /// Whether a node and a term have one value in the run, but for roundings.
  [[nodiscard]] bool agree(int node, int term) const;

 private:
  const Statement& s_;
  std::vector<long double> values_;  ///< of the formula's terms
  Scales scales_;
};

}  // namespace prove

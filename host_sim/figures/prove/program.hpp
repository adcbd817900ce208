// A kernel's straight-line program: every operation on words that one run executes, as exact integers.
#pragma once

#include <string>
#include <vector>

namespace prove {

__extension__ using Integer = __int128;  ///< holds any sum of products of 32-bit words

/// What made a value.
enum class Kind { input, constant, add, subtract, multiply, times_power, floor_power, exclusive_or };

/// One value. `times_power` is left * 2^power, `floor_power` the largest integer up to left / 2^power.
struct Node {
  Kind kind = Kind::constant;
  int left = -1, right = -1;  ///< operands: indices into the program
  int power = 0;
  Integer value = 0;  ///< in the run that was recorded; of a constant in every run
  std::string name;   ///< of an input
};

/// A claim that the program depends on: a value fits its word, or a choice by masks always goes the same way.
struct Claim {
  int node = -1;
  Integer low = 0, high = 0;  ///< value of the node, both ends included
  bool chooses = false;       ///< whether a choice depends on it, so that it counts whatever becomes of the node
};

/// What a run did. Words are taken modulo 2^width until an operation asks for their value (a shift to the right, a
/// conversion, a product's upper word): only there is a claim made that the value fits. That sums may wrap in between
/// is how kernels are written.
class Program {
 public:
  std::vector<Node> nodes;
  std::vector<Claim> claims;
  int turns = 0;  ///< sine-cosine pairs so far

  /// A run-time input, its value in this run, and the range in which it stays; the one of that name if there is one.
  int input(const std::string& name, Integer value, Integer low, Integer high);
  /// Each use of a constant is a node of its own, for uses may differ in scale.
  int constant(Integer value);
  int combine(Kind kind, int left, int right);
  /// left * 2^power or, with Kind::floor_power, the floor of left / 2^power.
  int shift(Kind kind, int left, int power);
  /// The node as a word that holds `value` in this run: less what it has wrapped by.
  int settle(int node, Integer value, int width, bool is_signed);
  /// Claims that the node has the value of this run in every run.
  void pin(int node);
  void claim(int node, Integer low, Integer high, bool chooses = false);

  [[nodiscard]] const Node& at(int node) const { return nodes[static_cast<std::size_t>(node)]; }
  /// Values of all nodes for other values of the inputs, in the order in which these were made.
  [[nodiscard]] std::vector<Integer> evaluate(const std::vector<Integer>& inputs) const;
  /// Whether all claims hold for those values.
  [[nodiscard]] bool claims_hold(const std::vector<Integer>& values) const;
  [[nodiscard]] std::vector<int> inputs() const;

  /// The program that operations on recorded words are added to.
  static Program& active();
  static void activate(Program* program);

 private:
  int push(Node node);
  [[nodiscard]] bool same(int a, int b) const;
  [[nodiscard]] bool begins_with_constant(int node) const;
  int merged_floor(int left, int power);
  int less(int node, Integer amount);
};

Integer power_of_two(int exponent);
/// floor(value / 2^power).
Integer floor_of(Integer value, int power);
std::string text_of(Integer value);

}  // namespace prove

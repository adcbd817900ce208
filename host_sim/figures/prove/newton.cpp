#include <host_sim/figures/prove/newton.hpp>

namespace prove {
namespace {

/// The nodes of y = a + floor(product), product = a e, where e is the difference c - a x or its floor.
struct Step {
  int floor = -1, product = -1, e = -1, difference = -1, c = -1, a = -1, x = -1;
};

int without_floor(const Program& p, int node) { return p.at(node).kind == Kind::floor_power ? p.at(node).left : node; }

/// Whether a word is an input but for bits that a shift added or took.
bool is_input(const Program& p, int node) {
  const Kind kind = p.at(node).kind;
  return kind == Kind::input ||
         ((kind == Kind::floor_power || kind == Kind::times_power) && is_input(p, p.at(node).left));
}

/// Whether e is such a difference; says so in the step.
bool corrects(const Program& p, int e, Step& s) {
  s.e = e, s.difference = without_floor(p, e);
  const Node& n = p.at(s.difference);
  if (n.kind != Kind::subtract || p.at(n.left).kind != Kind::constant || p.at(n.right).kind != Kind::multiply)
    return false;
  const Node& product = p.at(n.right);
  const bool left = is_input(p, product.left);
  s.c = n.left, s.x = left ? product.left : product.right, s.a = left ? product.right : product.left;
  return is_input(p, s.x);
}

/// Whether a node is the result of a step, and of which.
bool is_step(const Program& p, int node, Step& s) {
  const Node& y = p.at(node);
  if (y.kind != Kind::add || p.at(y.right).kind != Kind::floor_power) return false;
  s.floor = y.right, s.product = p.at(s.floor).left;
  const Node& n = p.at(s.product);
  return n.kind == Kind::multiply && (corrects(p, n.left, s) || corrects(p, n.right, s));
}

/// What e lacks of 1 - a x: a rounding, what c has beyond 1, and what the word for x lacks.
std::string correction_lines(const Names& names, const Step& s, const std::string& x) {
  const std::string a = names.of_node(s.a), e = names.of_node(s.e), difference = names.of_node(s.difference);
  const std::string exact = "(1 - " + a + " * " + x + ")", word = names.of_node(s.x);
  const std::string lines = difference + " - " + exact + " -> (" + names.of_node(s.c) + " - 1)" +
                            (word == x ? "" : " + " + a + " * (" + x + " - " + word + ")") + ";\n";
  if (e == difference) return lines;
  return lines + e + " - " + exact + " -> (" + e + " - " + difference + ") + (" + difference + " - " + exact + ");\n";
}

/// What a step has left to it, where it starts from the polynomial's word.
std::string start_line(const Names& names, const Reciprocal& r, int a) {
  const std::string exact = names.of_term(r.term), near = names.of_term(r.polynomial), word = names.of_node(a);
  return word + " - " + exact + " -> (" + word + " - " + near + ") + (" + near + " - " + exact + ");\n";
}

}  // namespace

std::string newton_lines(const Statement& s, const Names& names, int node) {
  const Reciprocal& r = *s.reciprocal;
  const std::string exact = names.of_term(r.term), x = names.of_term(r.of);
  Step step, before;
  if (!is_step(s.program, node, step)) return {};
  const std::string a = names.of_node(step.a), error = "(" + a + " - " + exact + ")";
  const std::string lost = "(" + names.of_node(step.floor) + " - " + names.of_node(step.product) + ")";
  return names.of_node(node) + " - " + exact + " -> " + lost + " + " + a + " * (" + names.of_node(step.e) + " - (1 - " +
         a + " * " + x + ")) - " + error + " * " + error + " * " + x + " {" + x + " <> 0};\n" +
         (is_step(s.program, step.a, before) ? "" : start_line(names, r, step.a)) + correction_lines(names, step, x);
}

std::string newton_word_lines(const Statement& s, const Names& names, int node) {
  const Reciprocal& r = *s.reciprocal;
  const std::string exact = names.of_term(r.term), x = names.of_term(r.of), y = names.of_node(node);
  Step step;
  if (!is_step(s.program, node, step)) return {};
  const std::string a = names.of_node(step.a), difference = names.of_node(step.difference);
  return difference + " -> (" + difference + " - (1 - " + a + " * " + x + ")) - (" + a + " - " + exact + ") * " + x +
         " {" + x + " <> 0};\n" + y + " -> " + exact + " + (" + y + " - " + exact + ");\n";
}

std::string polynomial_lines(const Statement& s, const Names& names) {
  const Reciprocal& r = *s.reciprocal;
  const std::string exact = names.of_term(r.term), x = names.of_term(r.of), near = names.of_term(r.polynomial);
  const std::string excess = x + " * " + near + " - 1";
  return near + " - " + exact + " -> (" + excess + ") * " + exact + " {" + x + " <> 0};\n" + excess + " -> " +
         names.of_term(r.excess) + ";\n";
}

}  // namespace prove

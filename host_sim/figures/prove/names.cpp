#include <host_sim/figures/prove/names.hpp>

#include <cmath>
#include <cstdio>

namespace prove {
namespace {

std::vector<long double> term_values(const Statement& s) {
  return s.formula.evaluate([&](const std::string& variable) {
    for (const RealVariable& v : s.variables)
      if (v.name == variable) return v.value;
    for (const int i : s.program.inputs())
      if (s.program.at(i).name == variable) return real_value(s.program, i, s.known);
    return 0.0L;
  });
}

}  // namespace

std::string binary(Integer value, int scale) { return text_of(value) + "b" + std::to_string(-scale); }

std::string decimal(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

std::string exact(double x) {
  int exponent = 0;
  const double significand = std::frexp(x, &exponent);
  auto digits = static_cast<long long>(std::ldexp(significand, 53));
  exponent -= 53;
  for (; digits != 0 && digits % 2 == 0; digits /= 2)
    ++exponent;
  return std::to_string(digits) + "b" + std::to_string(digits == 0 ? 0 : exponent);
}

Names::Names(const Statement& s)
    : s_{s}, values_{term_values(s)}, scales_{scales_of(s.program, s.formula, values_, s.known)} {}

std::string Names::of_node(int node) const {
  const Node& n = s_.program.at(node);
  if (n.kind == Kind::input) return n.name;
  if (n.kind == Kind::constant) return binary(n.value, scale(node));
  return "p" + std::to_string(node);
}

std::string Names::operand(int node, int wanted) const {
  const int shift = scale(node) - wanted;
  return shift == 0 ? of_node(node) : "(" + of_node(node) + " * 1b" + std::to_string(shift) + ")";
}

std::string Names::of_term(int term) const {
  const Term& t = s_.formula.terms[static_cast<std::size_t>(term)];
  if (t.operation == Operation::variable) return t.name;
  if (t.operation == Operation::constant) return exact(t.constant);
  return "e" + std::to_string(term);
}

bool Names::agree(int node, int term) const {
  const long double value = values_[static_cast<std::size_t>(term)];
  return std::abs(value - real_value(s_.program, node, scales_)) <= s_.likeness * std::abs(value);
}

}  // namespace prove

#include <host_sim/figures/prove/scales.hpp>

#include <cmath>

namespace prove {
namespace {

/// Sets a scale that is not known yet.
bool learn(Scales& scales, int node, int scale) { return scales.emplace(node, scale).second; }

bool knows(const Scales& scales, int node) { return scales.count(node) != 0; }

/// What one node says about the scales of its operands and itself; whether that is news.
bool propagate(const Program& program, Scales& scales, int i) {
  const Node& n = program.at(i);
  if (n.kind == Kind::input || n.kind == Kind::constant) return false;
  const bool own = knows(scales, i), left = knows(scales, n.left), right = n.right >= 0 && knows(scales, n.right);
  if (n.kind == Kind::times_power || n.kind == Kind::floor_power) {
    const int gain = n.kind == Kind::times_power ? n.power : -n.power;
    if (left) return learn(scales, i, scales[n.left] + gain);
    return own && learn(scales, n.left, scales[i] - gain);
  }
  if (n.kind == Kind::multiply) {
    if (left && right) return learn(scales, i, scales[n.left] + scales[n.right]);
    if (own && left) return learn(scales, n.right, scales[i] - scales[n.left]);
    return own && right && learn(scales, n.left, scales[i] - scales[n.right]);
  }
  if (!own && !left && !right) return false;
  const int common = own ? scales[i] : left ? scales[n.left] : scales[n.right];
  const bool a = learn(scales, i, common), b = learn(scales, n.left, common), c = learn(scales, n.right, common);
  return a || b || c;
}

/// The scale at which the constant of a product is one of the formula's: there the product stands for the product that
/// it has in the formula. 0 where there is none.
int likely_scale(const Program& program, const Formula& formula, const std::vector<long double>& values, int product,
                 const Scales& scales) {
  const Node& n = program.at(product);
  const bool left = program.at(n.left).kind == Kind::constant;
  const Node& factor = program.at(left ? n.left : n.right);
  const long double other = real_value(program, left ? n.right : n.left, scales);
  for (std::size_t i = 0; i < formula.terms.size(); ++i) {
    const Term& t = formula.terms[i];
    if (t.operation != Operation::multiply) continue;
    const long double ratio = static_cast<long double>(factor.value) * other / values[i];
    if (!(ratio > 1e-30L && ratio < 1e30L)) continue;
    const auto scale = static_cast<int>(std::lround(std::log2(ratio)));
    const long double own = std::ldexp(static_cast<long double>(factor.value), -scale);
    for (const int k : {t.left, t.right}) {
      const Term& c = formula.terms[static_cast<std::size_t>(k)];
      if (c.operation == Operation::constant &&
          std::abs(own - values[static_cast<std::size_t>(k)]) <= 1e-5L * std::abs(own))
        return scale;
    }
  }
  return 0;
}

/// Gives a product's constant a scale; whether there was one to give.
bool guess(const Program& program, const Formula& formula, const std::vector<long double>& values, Scales& scales) {
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const Node& n = program.nodes[i];
    if (n.kind != Kind::multiply || knows(scales, n.left) == knows(scales, n.right)) continue;
    const int unknown = knows(scales, n.left) ? n.right : n.left;
    if (program.at(unknown).kind == Kind::constant)
      return learn(scales, unknown, likely_scale(program, formula, values, static_cast<int>(i), scales));
  }
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    if (program.nodes[i].kind == Kind::constant && learn(scales, static_cast<int>(i), 0)) return true;
  return false;
}

}  // namespace

long double real_value(const Program& program, int node, const Scales& scales) {
  return std::ldexp(static_cast<long double>(program.at(node).value), -scales.at(node));
}

Scales scales_of(const Program& program, const Formula& formula, const std::vector<long double>& values,
                 const Scales& known) {
  Scales scales = known;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < program.nodes.size(); ++i)
      more = propagate(program, scales, static_cast<int>(i)) || more;
    more = more || guess(program, formula, values, scales);
  }
  return scales;
}

}  // namespace prove

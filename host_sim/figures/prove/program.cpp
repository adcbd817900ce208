#include <host_sim/figures/prove/program.hpp>

#include <algorithm>
#include <stdexcept>

namespace prove {
namespace {

Program* active_program = nullptr;

Integer applied(const Node& node, Integer left, Integer right) {
  switch (node.kind) {
    case Kind::add:
      return left + right;
    case Kind::subtract:
      return left - right;
    case Kind::multiply:
      return left * right;
    case Kind::times_power:
      return left * power_of_two(node.power);
    case Kind::floor_power:
      return floor_of(left, node.power);
    case Kind::exclusive_or:
      return left ^ right;
    default:
      return node.value;
  }
}

}  // namespace

Integer power_of_two(int exponent) { return Integer{1} << exponent; }

Integer floor_of(Integer value, int power) { return power > 126 ? (value < 0 ? -1 : 0) : value >> power; }

std::string text_of(Integer value) {
  if (value < 0) return "-" + text_of(-value);
  std::string digits;
  for (; value > 9; value /= 10)
    digits += static_cast<char>('0' + static_cast<int>(value % 10));
  digits += static_cast<char>('0' + static_cast<int>(value));
  std::reverse(digits.begin(), digits.end());
  return digits;
}

Program& Program::active() {
  if (active_program == nullptr) throw std::logic_error("no program records this operation");
  return *active_program;
}
void Program::activate(Program* program) { active_program = program; }

bool Program::same(int a, int b) const {
  if (a == b || a < 0 || b < 0) return a == b;
  return at(a).kind == Kind::constant && at(b).kind == Kind::constant && at(a).value == at(b).value;
}

int Program::push(Node node) {
  for (std::size_t i = 0; node.kind != Kind::constant && node.kind != Kind::input && i < nodes.size(); ++i) {
    const Node& n = nodes[i];
    if (n.kind == node.kind && same(n.left, node.left) && same(n.right, node.right) && n.power == node.power)
      return static_cast<int>(i);
  }
  nodes.push_back(std::move(node));
  return static_cast<int>(nodes.size()) - 1;
}

int Program::input(const std::string& name, Integer value, Integer low, Integer high) {
  for (const int i : inputs())
    if (at(i).name == name) return i;
  const int node = push({Kind::input, -1, -1, 0, value, name});
  claim(node, low, high);
  return node;
}

int Program::constant(Integer value) { return push({Kind::constant, -1, -1, 0, value, {}}); }

int Program::combine(Kind kind, int left, int right) {
  if (kind == Kind::subtract && at(right).kind == Kind::constant && begins_with_constant(left))
    return less(left, at(right).value);
  Node node{kind, left, right, 0, 0, {}};
  node.value = applied(node, at(left).value, at(right).value);
  return push(node);
}

int Program::shift(Kind kind, int left, int power) {
  if (power == 0) return left;
  if (kind == Kind::times_power && begins_with_constant(left)) {
    const Node n = at(left);
    return combine(n.kind, constant(at(n.left).value * power_of_two(power)), shift(kind, n.right, power));
  }
  if (kind == Kind::floor_power) {
    const int merged = merged_floor(left, power);
    if (merged >= 0) return merged;
  }
  Node node{kind, left, -1, power, 0, {}};
  node.value = applied(node, at(left).value, 0);
  return push(node);
}

/// A floor of a floor is one floor, and what an integer adds between them can be added before both.
int Program::merged_floor(int left, int power) {
  const Node outer = at(left);
  if (outer.kind == Kind::floor_power) return shift(Kind::floor_power, outer.left, outer.power + power);
  if (outer.kind != Kind::add || at(outer.right).kind != Kind::constant) return -1;
  const Node inner = at(outer.left);
  if (inner.kind != Kind::floor_power) return -1;
  const int added = constant(at(outer.right).value * power_of_two(inner.power));
  return shift(Kind::floor_power, combine(Kind::add, inner.left, added), inner.power + power);
}

int Program::settle(int node, Integer value, int width, bool is_signed) {
  const Integer low = is_signed ? -power_of_two(width - 1) : Integer{0};
  const Integer wrapped = at(node).value - value;
  if (wrapped != 0) node = less(node, wrapped);
  claim(node, low, low + power_of_two(width) - 1);
  return node;
}

/// The node less a constant, which joins a constant that is there already.
int Program::less(int node, Integer amount) {
  if (!begins_with_constant(node)) return combine(Kind::subtract, node, constant(amount));
  const Node n = at(node);
  return combine(n.kind, constant(at(n.left).value - amount), n.right);
}

/// Whether the node is the sum of a constant and something else, or their difference.
bool Program::begins_with_constant(int node) const {
  const Node& n = at(node);
  return (n.kind == Kind::add || n.kind == Kind::subtract) && at(n.left).kind == Kind::constant;
}

void Program::pin(int node) { claim(node, at(node).value, at(node).value, true); }

void Program::claim(int node, Integer low, Integer high, bool chooses) {
  if (at(node).kind == Kind::constant) return;
  for (Claim& c : claims) {
    if (c.node != node) continue;
    c.low = std::max(c.low, low), c.high = std::min(c.high, high), c.chooses = c.chooses || chooses;
    return;
  }
  claims.push_back({node, low, high, chooses});
}

std::vector<int> Program::inputs() const {
  std::vector<int> all;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].kind == Kind::input) all.push_back(static_cast<int>(i));
  return all;
}

std::vector<Integer> Program::evaluate(const std::vector<Integer>& inputs) const {
  std::vector<Integer> values(nodes.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& n = nodes[i];
    const Integer left = n.left < 0 ? 0 : values[static_cast<std::size_t>(n.left)];
    const Integer right = n.right < 0 ? 0 : values[static_cast<std::size_t>(n.right)];
    values[i] = n.kind == Kind::input ? inputs.at(next++) : applied(n, left, right);
  }
  return values;
}

bool Program::claims_hold(const std::vector<Integer>& values) const {
  return std::all_of(claims.begin(), claims.end(), [&](const Claim& c) {
    const Integer value = values[static_cast<std::size_t>(c.node)];
    return value >= c.low && value <= c.high;
  });
}

}  // namespace prove

#include <host_sim/figures/prove/newton.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace prove {
namespace {

const char* sign_of(Operation operation) {
  if (operation == Operation::add) return " + ";
  if (operation == Operation::subtract) return " - ";
  return operation == Operation::multiply ? " * " : " / ";
}

class Writer {
 public:
  explicit Writer(const Statement& s) : s_{s}, names_{s} {}

  std::string text(Goal goal) {
    mark();
    match();
    if (s_.reciprocal) mark_term(s_.reciprocal->excess);  // agrees with no word
    define_formula();
    define_program();
    out_ << "\n{ ";
    hypotheses();
    out_ << "->\n  ";
    goals(goal);
    out_ << " }\n\n";
    write_hints(goal);
    for (const Result& r : s_.results)
      if (goal == Goal::errors && !s_.split.empty())
        out_ << name(r.node) << " - " << term_name(r.term) << " $ " << s_.split << ";\n";
    for (const Claim& c : s_.program.claims)
      if (goal == Goal::words && s_.reciprocal && !s_.split.empty() && c.chooses)
        out_ << name(c.node) << " $ " << s_.split << ";\n";
    return out_.str();
  }

 private:
  [[nodiscard]] int scale(int node) const { return names_.scale(node); }
  [[nodiscard]] std::string name(int node) const { return names_.of_node(node); }
  [[nodiscard]] std::string operand(int node, int wanted) const { return names_.operand(node, wanted); }
  [[nodiscard]] std::string term_name(int i) const { return names_.of_term(i); }

  void mark_node(int i) {
    if (i < 0 || !needed_.insert(i).second) return;
    mark_node(s_.program.at(i).left), mark_node(s_.program.at(i).right);
  }
  void mark_term(int i) {
    if (i < 0 || !meant_.insert(i).second) return;
    const Term& t = s_.formula.terms[static_cast<std::size_t>(i)];
    mark_term(t.left), mark_term(t.right);
    for (const RealVariable& v : s_.variables)
      if (t.operation == Operation::variable && v.name == t.name) mark_term(v.near_term);
  }
  void mark() {
    for (const Result& r : s_.results)
      mark_node(r.node), mark_term(r.term);
    for (const Claim& c : s_.program.claims)
      if (c.chooses) mark_node(c.node);
    if (s_.reciprocal) mark_term(s_.reciprocal->polynomial);
  }

  void define_formula() {
    for (const int i : meant_) {
      const Term& t = s_.formula.terms[static_cast<std::size_t>(i)];
      if (t.operation == Operation::variable || t.operation == Operation::constant) continue;
      const char* sign = sign_of(t.operation);
      out_ << term_name(i) << " = " << (is_zero_term(t.left) ? "" : term_name(t.left)) << sign << term_name(t.right)
           << ";\n";
    }
  }
  void define_program() {
    for (const int i : needed_) {
      const Node& n = s_.program.at(i);
      if (n.kind == Kind::input || n.kind == Kind::constant) continue;
      out_ << name(i) << " = " << expression(i, n) << ";\n";
    }
  }
  [[nodiscard]] std::string expression(int i, const Node& n) const {
    if (n.kind == Kind::times_power) return operand(n.left, scale(i) - n.power);
    if (n.kind == Kind::floor_power)
      return "fixed<" + std::to_string(-scale(i)) + ",dn>(" + operand(n.left, scale(i) + n.power) + ")";
    if (n.kind == Kind::multiply)
      return operand(n.left, scale(n.left)) + " * " + operand(n.right, scale(i) - scale(n.left));
    return (is_zero_node(n.left) ? "" : operand(n.left, scale(i))) + (n.kind == Kind::add ? " + " : " - ") +
           operand(n.right, scale(i));
  }

  [[nodiscard]] bool names_variable(const std::string& name) const {
    return std::any_of(meant_.begin(), meant_.end(), [&](int i) {
      const Term& t = s_.formula.terms[static_cast<std::size_t>(i)];
      return t.operation == Operation::variable && t.name == name;
    });
  }
  void hypotheses() {
    const char* join = "";
    for (const Claim& c : s_.program.claims) {
      if (s_.program.at(c.node).kind != Kind::input || needed_.count(c.node) == 0) continue;
      out_ << join << name(c.node) << " in [" << binary(c.low, scale(c.node)) << "," << binary(c.high, scale(c.node))
           << "] /\\ @FIX(" << name(c.node) << "," << -scale(c.node) << ") ";
      join = "/\\ ";
    }
    for (const RealVariable& v : s_.variables) {
      const std::string near = v.near_term < 0 ? v.near_input : term_name(v.near_term);
      out_ << join << v.name << " - " << near << " in [-" << decimal(v.within) << "," << decimal(v.within) << "] /\\ "
           << v.name << " in [-1,1] ";
      join = "/\\ ";
    }
  }
  void goals(Goal goal) {
    const char* join = "";
    for (const Result& r : s_.results) {
      if (goal == Goal::words) continue;
      out_ << join << name(r.node) << " - " << term_name(r.term) << " in ";
      if (goal == Goal::ask)
        out_ << "?";
      else
        out_ << "[-" << decimal(r.bound) << "," << decimal(r.bound) << "]";
      join = " /\\\n  ";
    }
    for (const Claim& c : s_.program.claims) {
      if (goal != Goal::words || s_.program.at(c.node).kind == Kind::input || needed_.count(c.node) == 0) continue;
      out_ << join << name(c.node) << " in [" << binary(c.low, scale(c.node)) << "," << binary(c.high, scale(c.node))
           << "]";
      join = " /\\\n  ";
    }
  }

  /// The terms that a node is equal to in the run but for roundings.
  void match() {
    for (const int i : needed_)
      for (const int t : meant_) {
        const bool constant = s_.formula.terms[static_cast<std::size_t>(t)].operation == Operation::constant;
        if (constant == (s_.program.at(i).kind == Kind::constant) && names_.agree(i, t)) like_[i].insert(t);
      }
  }
  [[nodiscard]] bool alike(int node, int term) const {
    const auto found = like_.find(node);
    return found != like_.end() && found->second.count(term) != 0;
  }

  /// The term that a real variable is near to, -1 where there is none.
  [[nodiscard]] int nearby(int term) const {
    const Term& t = s_.formula.terms[static_cast<std::size_t>(term)];
    for (const RealVariable& v : s_.variables)
      if (t.operation == Operation::variable && v.name == t.name) return v.near_term;
    return -1;
  }

  /// How an error is made of others. Gappa checks that each line is an identity.
  void write_hints(Goal goal) {
    if (s_.reciprocal) out_ << polynomial_lines(s_, names_);
    for (const auto& [node, terms] : like_) {
      const Node& n = s_.program.at(node);
      const std::string step = s_.reciprocal ? newton_lines(s_, names_, node) : "";
      out_ << step;
      if (s_.reciprocal && goal == Goal::words) out_ << newton_word_lines(s_, names_, node);
      for (const int t : terms) {
        if (!step.empty() || n.kind == Kind::constant || term_name(t) == name(node)) continue;
        if (const int near = nearby(t); near >= 0 && alike(node, near)) {
          out_ << name(node) << " - " << term_name(t) << " -> (" << name(node) << " - " << term_name(near) << ") - ("
               << term_name(t) << " - " << term_name(near) << ");\n";
        } else if (n.kind == Kind::floor_power) {
          if (alike(n.left, t) && name(n.left) != term_name(t))
            out_ << name(node) << " - " << term_name(t) << " -> (" << name(node) << " - " << name(n.left) << ") + ("
                 << name(n.left) << " - " << term_name(t) << ");\n";
        } else if (n.kind == Kind::add || n.kind == Kind::subtract) {
          write_sum(node, t);
        } else if (n.kind == Kind::multiply && is_crossed(n, t)) {
          write_crossed(node, t);
        } else if (!s_.reciprocal || s_.formula.terms[static_cast<std::size_t>(t)].operation == Operation::multiply) {
          out_ << name(node) << " ~ " << term_name(t) << ";\n";
        }
      }
    }
  }

  /// A product whose factors stand the other way round in the formula.
  [[nodiscard]] bool is_crossed(const Node& n, int term) const {
    const Term& t = s_.formula.terms[static_cast<std::size_t>(term)];
    return t.operation == Operation::multiply && !alike(n.left, t.left) && alike(n.left, t.right) &&
           alike(n.right, t.left);
  }
  void write_crossed(int node, int term) {
    const Node& n = s_.program.at(node);
    const Term& t = s_.formula.terms[static_cast<std::size_t>(term)];
    const std::string first = operand(n.left, scale(n.left)), x = term_name(t.right);
    const std::string second = operand(n.right, scale(node) - scale(n.left)), y = term_name(t.left);
    const std::string e = "(" + first + " - " + x + ")", f = "(" + second + " - " + y + ")";
    out_ << name(node) << " - " << term_name(term) << " -> " << e << " * " << y << " + " << x << " * " << f << " + "
         << e << " * " << f << ";\n";
  }

  struct Parts {
    int left = -1, right = -1;
    bool subtracts = false;
  };
  struct Signed {
    int index = -1;
    bool negative = false;
  };
  /// The first sum among the items, if there is one, gives way to its two parts.
  template <class At>
  static bool expand(std::vector<Signed>& items, At parts_of) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const Parts parts = parts_of(items[i].index);
      if (parts.right < 0) continue;
      const bool sign = items[i].negative;
      items[i] = {parts.right, sign != parts.subtracts};
      if (parts.left >= 0) items.insert(items.begin() + static_cast<std::ptrdiff_t>(i), {parts.left, sign});
      return true;
    }
    return false;
  }
  [[nodiscard]] bool is_zero_node(int i) const {
    return s_.program.at(i).kind == Kind::constant && s_.program.at(i).value == 0;
  }
  [[nodiscard]] bool is_zero_term(int i) const {
    const Term& t = s_.formula.terms[static_cast<std::size_t>(i)];
    return t.operation == Operation::constant && !(std::abs(t.constant) > 0.0);
  }
  [[nodiscard]] Parts parts_of_node(int i) const {
    const Node& n = s_.program.at(i);
    if (n.kind != Kind::add && n.kind != Kind::subtract) return {};
    return {is_zero_node(n.left) ? -1 : n.left, n.right, n.kind == Kind::subtract};
  }
  [[nodiscard]] Parts parts_of_term(int i) const {
    const Term& t = s_.formula.terms[static_cast<std::size_t>(i)];
    if (t.operation != Operation::add && t.operation != Operation::subtract) return {};
    return {is_zero_term(t.left) ? -1 : t.left, t.right, t.operation == Operation::subtract};
  }
  /// Takes what is alike out of both sums; appends the differences.
  void cancel(std::vector<Signed>& nodes, std::vector<Signed>& terms, std::string& text) const {
    for (std::size_t i = 0; i < nodes.size();) {
      std::size_t k = 0;
      while (k < terms.size() && (terms[k].negative != nodes[i].negative || !alike(nodes[i].index, terms[k].index)))
        ++k;
      if (k == terms.size()) {
        ++i;
        continue;
      }
      const std::string left = operand(nodes[i].index, unit_), right = term_name(terms[k].index);
      if (left != right) text += (nodes[i].negative ? " - (" : " + (") + left + " - " + right + ")";
      nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(i));
      terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
  /// The error of a sum from those of its parts, however they are associated.
  void write_sum(int node, int term) {
    unit_ = scale(node);
    std::vector<Signed> nodes{{node, false}}, terms{{term, false}};
    expand(nodes, [&](int i) { return parts_of_node(i); });
    std::string text;
    cancel(nodes, terms, text);
    while (!terms.empty() && (expand(terms, [&](int i) { return parts_of_term(i); }) ||
                              expand(nodes, [&](int i) { return parts_of_node(i); })))
      cancel(nodes, terms, text);
    for (const Signed& left : nodes)
      text += (left.negative ? " - " : " + ") + operand(left.index, unit_);
    for (const Signed& left : terms)
      text += (left.negative ? " + " : " - ") + term_name(left.index);
    if (terms.empty() && !text.empty())
      out_ << name(node) << " - " << term_name(term) << " -> " << text.substr(text[1] == '-' ? 1 : 3) << ";\n";
  }

  const Statement& s_;
  Names names_;
  std::set<int> needed_, meant_;
  std::map<int, std::set<int>> like_;
  int unit_ = 0;  ///< of the sum whose error is written
  std::ostringstream out_;
};

}  // namespace

std::string script_of(const Statement& statement, Goal goal) { return Writer(statement).text(goal); }

}  // namespace prove

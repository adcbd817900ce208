#include <host_sim/figures/prove/formula.hpp>

#include <stdexcept>

namespace prove {
namespace {
Formula* active_formula = nullptr;

bool same(const Term& a, const Term& b) {
  return a.operation == b.operation && a.left == b.left && a.right == b.right && a.name == b.name &&
         __builtin_bit_cast(unsigned long long, a.constant) == __builtin_bit_cast(unsigned long long, b.constant);
}
}  // namespace

int Formula::add(const Term& term) {
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (same(terms[i], term)) return static_cast<int>(i);
  terms.push_back(term);
  return static_cast<int>(terms.size()) - 1;
}

int Formula::negated(int term) {
  const int zero = add({Operation::constant, -1, -1, 0.0, {}});
  const Term& t = terms[static_cast<std::size_t>(term)];
  return t.operation == Operation::subtract && t.left == zero ? t.right
                                                              : add({Operation::subtract, zero, term, 0.0, {}});
}

Formula& Formula::active() {
  if (active_formula == nullptr) throw std::logic_error("no formula records this operation");
  return *active_formula;
}
void Formula::activate(Formula* formula) { active_formula = formula; }

}  // namespace prove

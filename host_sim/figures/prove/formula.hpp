// A kernel over the real numbers: what its operations on exact numbers amount to, as a formula.
#pragma once

#include <axial/links/links.hpp>

#include <string>
#include <vector>

namespace prove {

enum class Operation { variable, constant, add, subtract, multiply, divide };

/// One value of a formula.
struct Term {
  Operation operation = Operation::constant;
  int left = -1, right = -1;
  double constant = 0.0;
  std::string name;  ///< of a variable
};

/// What one run of a kernel over Real records.
class Formula {
 public:
  std::vector<Term> terms;
  int turns = 0;  ///< sine-cosine pairs so far

  int add(const Term& term);
  /// 0 less the term; of a term that is so itself what it was made from.
  int negated(int term);
  /// Values of all terms, given those of the variables.
  template <class ValueOf>
  [[nodiscard]] std::vector<long double> evaluate(ValueOf value_of) const {
    std::vector<long double> values;
    for (const Term& t : terms) {
      const long double left = t.left < 0 ? 0.0L : values[static_cast<std::size_t>(t.left)];
      const long double right = t.right < 0 ? 0.0L : values[static_cast<std::size_t>(t.right)];
      values.push_back(t.operation == Operation::variable   ? value_of(t.name)
                       : t.operation == Operation::constant ? static_cast<long double>(t.constant)
                       : t.operation == Operation::add      ? left + right
                       : t.operation == Operation::subtract ? left - right
                       : t.operation == Operation::multiply ? left * right
                                                            : left / right);
    }
    return values;
  }

  static Formula& active();
  static void activate(Formula* formula);
};

/// A number of kernels that stands for a real one.
class Real {
 public:
  constexpr Real() = default;
  constexpr static Real constant(double value) {
    Real x;
    x.value_ = value;
    return x;
  }
  static Real variable(const std::string& name) {
    return Real{Formula::active().add({Operation::variable, -1, -1, 0.0, name})};
  }
  [[nodiscard]] int term() const { return is_constant() ? term_of(value_) : term_; }

  friend constexpr Real operator+(const Real& a, const Real& b) {
    return both_constant(a, b) ? constant(a.value_ + b.value_) : combine(Operation::add, a, b);
  }
  friend constexpr Real operator-(const Real& a, const Real& b) {
    if (both_constant(a, b)) return constant(a.value_ - b.value_);
    if (b.is_multiple()) return a + b.opposite_multiple();  // as words do
    return b.is_zero() ? a : combine(Operation::subtract, a, b);
  }
  friend constexpr Real operator*(const Real& a, const Real& b) {
    return both_constant(a, b) ? constant(a.value_ * b.value_) : combine(Operation::multiply, a, b);
  }
  friend constexpr Real operator/(const Real& a, const Real& b) {
    return both_constant(a, b) ? constant(a.value_ / b.value_) : combine(Operation::divide, a, b);
  }
  constexpr Real operator-() const {
    return is_constant() ? constant(-value_) : Real{Formula::active().negated(term_)};
  }
  /// The pair of the next turn: the same names as those of the words (fixed_kernel.hpp).
  friend axial::SinCos<Real> sincos(const Real&) {
    const std::string number = std::to_string(++Formula::active().turns);
    return {variable("SIN" + number), variable("COS" + number)};
  }

 private:
  explicit Real(int term) : term_{term} {}
  static constexpr bool both_constant(const Real& a, const Real& b) { return a.is_constant() && b.is_constant(); }
  static Real combine(Operation operation, const Real& a, const Real& b) {
    const int left = a.term(), right = b.term();
    return Real{Formula::active().add({operation, left, right, 0.0, {}})};
  }
  /// A constant times something, and the same with the opposite constant.
  ///@{
  [[nodiscard]] bool is_multiple() const {
    if (is_constant()) return false;
    const Formula& f = Formula::active();
    const Term& t = f.terms[static_cast<std::size_t>(term_)];
    return t.operation == Operation::multiply &&
           f.terms[static_cast<std::size_t>(t.left)].operation == Operation::constant;
  }
  [[nodiscard]] Real opposite_multiple() const {
    const Formula& f = Formula::active();
    const Term t = f.terms[static_cast<std::size_t>(term_)];
    return constant(-f.terms[static_cast<std::size_t>(t.left)].constant) * Real{t.right};
  }
  ///@}
  static int term_of(double value) { return Formula::active().add({Operation::constant, -1, -1, value, {}}); }
  [[nodiscard]] constexpr bool is_zero() const { return is_constant() && !(value_ < 0.0) && !(value_ > 0.0); }
  [[nodiscard]] constexpr bool is_constant() const { return term_ < 0; }

  double value_ = 0.0;
  int term_ = -1;
};

}  // namespace prove

template <>
struct axial::NumberTraits<prove::Real> {
  static constexpr bool is_number = true;
  static constexpr prove::Real constant(double value) { return prove::Real::constant(value); }
};

/// The links that words have: without axial masses, of which they know none, so that both runs take the same steps.
template <class Scene, class Parameters, class Recursion>
struct axial::LinksOf<Scene, prove::Real, Parameters, Recursion> {
  static constexpr auto links() { return axial::StaticLinks<Scene, prove::Real, Parameters>{}; }
};

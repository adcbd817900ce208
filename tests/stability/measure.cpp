#include <algorithm>
#include <cmath>
#include <oracle/compare.hpp>
#include <oracle/convert.hpp>
#include <oracle/recursive.hpp>
#include <stability/measure.hpp>

namespace stability {
namespace {

using oracle::Chain;
using oracle::Matrix;
using oracle::Vector;

template <class T>
Chain<T> weightless(const Chain<double>& chain) {
  auto result = oracle::convert<T>(chain);
  result.gravity = {};
  return result;
}

/// M by its columns: the efforts of one unit acceleration each, without gravity.
template <class T>
Matrix<T> mass_matrix(const Chain<T>& chain, const Vector<T>& q) {
  const std::size_t n = q.size();
  const Vector<T> still(n, T(0));
  Matrix<T> M(chain.size(), chain.size());
  for (std::size_t j = 0; j < n; ++j) {
    Vector<T> unit = still;
    unit[j] = T(1);
    const auto column = oracle::recursive_inverse_dynamics(chain, q, still, unit);
    for (std::size_t i = 0; i < n; ++i)
      M(static_cast<int>(i), static_cast<int>(j)) = column[i];
  }
  return M;
}

template <class T>
T norm(const Vector<T>& v) {
  T largest(0), sum(0);
  for (const T& x : v)
    if (const T size = oracle::abs(x); size > largest) largest = size;
  if (!(largest > T(0))) return T(0);
  for (const T& x : v)
    sum += (x / largest) * (x / largest);
  return largest * T(std::sqrt(static_cast<double>(sum)));
}

/// Largest eigenvalue of a symmetric positive definite operator, by powers.
template <class T, class Apply>
T largest_eigenvalue(std::size_t n, Apply apply) {
  constexpr int most = 400;
  Vector<T> v(n);
  for (std::size_t i = 0; i < n; ++i)  // no eigenvector of anything regular is orthogonal to it
    v[i] = T(1.0 + 0.37 * std::sin(2.3 * static_cast<double>(i * i + 1)));
  T value(0);
  for (int k = 0; k < most; ++k) {
    const T length = norm(v);
    for (T& x : v)
      x /= length;
    v = apply(v);
    const T next = norm(v);
    if (oracle::abs(next - value) <= T(1e-7) * next) return next;
    value = next;
  }
  return value;
}

template <class T>
double condition_in(const Chain<double>& source, const Vector<double>& positions) {
  const auto chain = weightless<T>(source);
  const auto q = oracle::convert<T>(positions);
  const Vector<T> still(q.size(), T(0));
  const auto M = mass_matrix(chain, q);
  const T large = largest_eigenvalue<T>(q.size(), [&](const Vector<T>& v) { return M * v; });
  const T small = largest_eigenvalue<T>(
      q.size(), [&](const Vector<T>& v) { return oracle::recursive_forward_dynamics(chain, q, still, v); });
  return static_cast<double>(large * small);
}

double worst_of(const Vector<double>& values) {
  double worst = 0.0;
  for (const double x : values)
    if (!(x <= worst)) worst = std::isnan(x) ? HUGE_VAL : x;
  return worst;
}

}  // namespace

double condition(const Chain<double>& chain, const Vector<double>& q) {
  constexpr std::size_t small = 20;  // size ratios of 2^57 need quad; long chains are well without
  return q.size() <= small ? condition_in<quad>(chain, q) : condition_in<long double>(chain, q);
}

Reference reference_of(const Scenario& scenario, bool measures) {
  Reference result{{}, {}, {}, HUGE_VAL};
  if (!scenario.singular) result.qdd = cases::reference_acceleration(scenario);
  if (!measures) return result;
  const auto chain = oracle::convert<long double>(scenario.chain);
  const auto q = oracle::convert<long double>(scenario.q), qd = oracle::convert<long double>(scenario.qd);
  const Vector<long double> still(q.size(), 0.0L);
  const auto M = mass_matrix(weightless<long double>(scenario.chain), q);
  result.magnitudes = Matrix<double>(M.rows(), M.columns());
  for (int i = 0; i < M.rows(); ++i)
    for (int j = 0; j < M.columns(); ++j)
      result.magnitudes(i, j) = static_cast<double>(oracle::abs(M(i, j)));
  const auto h = oracle::recursive_inverse_dynamics(chain, q, qd, still);
  for (std::size_t i = 0; i < q.size(); ++i)
    result.forces.push_back(std::fabs(scenario.tau[i]) + std::fabs(static_cast<double>(h[i])));
  if (!scenario.singular) result.condition = condition(scenario.chain, scenario.q);
  return result;
}

double forward_error(const Scenario& scenario, const Reference& reference, const Vector<double>& qdd) {
  const double relative = oracle::relative_error(qdd, reference.qdd), scale = oracle::largest(reference.qdd);
  const bool absolute = scenario.measure == cases::Measure::absolute && scale > 0.0;
  return absolute ? relative * scale : relative;
}

double backward_error(const Scenario& scenario, const Reference& reference, const Vector<double>& qdd) {
  if (!std::all_of(qdd.begin(), qdd.end(), [](double x) { return std::isfinite(x); })) return HUGE_VAL;
  const auto quads = [](const Vector<double>& v) { return oracle::convert<quad>(v); };
  const auto tau = oracle::recursive_inverse_dynamics(oracle::convert<quad>(scenario.chain), quads(scenario.q),
                                                      quads(scenario.qd), quads(qdd));
  Vector<double> errors;
  for (int i = 0; i < scenario.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    double size = reference.forces[k];
    for (int j = 0; j < scenario.size(); ++j)
      size += reference.magnitudes(i, j) * std::fabs(qdd[static_cast<std::size_t>(j)]);
    const double residual = std::fabs(static_cast<double>(tau[k] - quad(scenario.tau[k])));
    errors.push_back(residual > 0.0 ? residual / size : 0.0);
  }
  return worst_of(errors);
}

}  // namespace stability

// Differences of vectors and matrices relative to the largest magnitude of the reference.
#pragma once

#include <oracle/algebra.hpp>

namespace oracle {

template <class T>
double largest(const Vector<T>& values) {
  double result = 0.0;
  for (const T& x : values)
    result = std::fmax(result, static_cast<double>(abs(x)));
  return result;
}

/// max |actual - reference| / max |reference|; absolute where the reference is zero; NaN counts as infinite.
template <class T, class R>
double relative_error(const Vector<T>& actual, const Vector<R>& reference) {
  if (actual.size() != reference.size()) return HUGE_VAL;
  const double scale = largest(reference);
  double worst = 0.0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const double error = static_cast<double>(abs(quad(actual[i]) - quad(reference[i])));
    if (!(error <= worst)) worst = error == error ? error : HUGE_VAL;
  }
  return scale > 0.0 ? worst / scale : worst;
}

/// The elements of a matrix, row by row.
template <class T>
Vector<T> elements(const Matrix<T>& A) {
  Vector<T> result;
  for (int i = 0; i < A.rows(); ++i)
    for (int j = 0; j < A.columns(); ++j)
      result.push_back(A(i, j));
  return result;
}

template <class T>
double relative_error(const Matrix<T>& actual, const Matrix<T>& reference) {
  return relative_error(elements(actual), elements(reference));
}

}  // namespace oracle

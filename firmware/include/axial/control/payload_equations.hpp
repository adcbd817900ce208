// Four normal equations and their solution, in any number.
#pragma once

#include <axial/scalar/rounding.hpp>
#include <axial/scalar/select.hpp>
#include <axial/scalar/traits.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

// L D L^T of a symmetric 4x4 and the solution of its equations; pivots too small for the type are reported.
template <class T>
class Equations {
 public:
  constexpr explicit Equations(const T (&a)[4][4]) {
    const T smallest = NumberTraits<T>::constant(16.0) * NumberTraits<T>::epsilon();
    for (int j = 0; j < 4; ++j) {
      T d = a[j][j];
      for (int k = 0; k < j; ++k)
        d -= l_[j][k] * l_[j][k] * d_[k];
      const bool good = d > smallest * a[j][j];
      regular_ = regular_ & good;
      d_[j] = d, inverse_[j] = select(good, reciprocal(select(good, d, T(One{}))), T(Zero{}));
      for (int i = j + 1; i < 4; ++i) {
        T x = a[i][j];
        for (int k = 0; k < j; ++k)
          x -= l_[i][k] * l_[j][k] * d_[k];
        l_[i][j] = x * inverse_[j];
      }
    }
  }
  constexpr bool regular() const { return regular_; }
  constexpr void solve(T (&x)[4]) const {
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < i; ++k)
        x[i] -= l_[i][k] * x[k];
    for (int i = 4; i-- > 0;) {
      x[i] *= inverse_[i];
      for (int k = i + 1; k < 4; ++k)
        x[i] -= l_[k][i] * x[k];
    }
  }

 private:
  T l_[4][4] = {}, d_[4] = {}, inverse_[4] = {};
  bool regular_ = true;
};

}  // namespace axial::detail

#include <axial/options/end.hpp>

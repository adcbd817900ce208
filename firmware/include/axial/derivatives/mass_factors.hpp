// Solves with M = L^T D L, for many right-hand sides whose zeros the compiler knows.
#pragma once

#include <axial/derivatives/derivative_results.hpp>
#include <axial/dynamics/composite_body.hpp>
#include <axial/recursion/walks.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// M = L^T D L as crba::solve() leaves it: gains below the diagonal, D on it; and 1/D, 0 of a joint that is held.
template <class Matrix, class T, int N>
struct Factors {
  Matrix m{};            ///< gains and D
  Row<T, N> inverses{};  ///< 1/D
};

/// Which rows of a right-hand side may be other than zero while it is solved for.
template <int N>
struct Filling {
  bool inwards[N][N] = {};   ///< [k][i]: row i, when joint k is taken inwards
  bool outwards[N][N] = {};  ///< [k][i]: row k, when what joint i does to it is subtracted
  bool solved[N] = {};       ///< rows of the result
};
/// How the rows that are given fill the others, by the structure of M.
template <int N>
constexpr Filling<N> filling(const crba::Structure<N>& m, const Row<bool, N>& given) {
  Filling<N> all;
  auto row = given;
  for (int k = N; k-- > 0;) {
    for (int i = 0; i < N; ++i)
      all.inwards[k][i] = row[i];
    for (int i = 0; i < k; ++i)
      row[i] = row[i] || (row[k] && m.present[k][i]);
  }
  for (int k = 0; k < N; ++k) {
    for (int i = k; i-- > 0;) {
      all.outwards[k][i] = row[k];
      row[k] = row[k] || (row[i] && m.present[k][i]);
    }
    all.solved[k] = row[k];
  }
  return all;
}

/// Rows that are filled, of a right-hand side `Given::rows` that the compiler knows.
template <class Links, class Given>
struct Known {
  static constexpr auto all = filling(crba::structure<Links>, Given::rows);  ///< the rows
  template <int K, int I>
  static constexpr std::bool_constant<all.inwards[K][I]> inwards(Index<K>, Index<I>) {
    return {};
  }  ///< whether row I is there when joint K is taken inwards
  template <int K, int I>
  static constexpr std::bool_constant<all.outwards[K][I]> outwards(Index<K>, Index<I>) {
    return {};
  }  ///< whether row K is there when joint I is subtracted
  template <int K>
  static constexpr std::bool_constant<all.solved[K]> solved(Index<K>) {
    return {};
  }  ///< whether the result has row K
};
/// Every row may be other than zero.
struct Any {
  template <class K, class I>
  static constexpr std::true_type inwards(K, I) {
    return {};
  }  ///< always
  template <class K, class I>
  static constexpr std::true_type outwards(K, I) {
    return {};
  }  ///< always
  template <class K>
  static constexpr std::true_type solved(K) {
    return {};
  }  ///< always
};

/// x - y, or -y where x is known to be zero.
template <class IsThere, class X>
AXIAL_INLINE constexpr X less(IsThere, const X& x, const X& y) {
  if constexpr (IsThere::value)
    return x - y;
  else
    return -y;
}
/// x[i] -= gain x[k] for what carries joint k, and x[k] / D.
template <class Rows, class Links, class F, class X, class K>
AXIAL_INLINE constexpr void take_inwards(Rows rows, const Links& links, const F& factors, X& x, K k) {
  if constexpr (decltype(rows.inwards(k, k))::value) {
    for_each_ancestor(links, k, [&](auto i) AXIAL_INLINE {
      if constexpr (!decltype(crba::is_absent<Links>(k, i))::value)
        x[i] = less(rows.inwards(k, i), x[i], factors.m(k, i) * x[k]);
    });
    x[k] = factors.inverses[k] * x[k];
  }
}
/// x[k] -= gain x[i] for what carries joint k.
template <class Rows, class Links, class F, class X, class K>
AXIAL_INLINE constexpr void take_outwards(Rows rows, const Links& links, const F& factors, X& x, K k) {
  for_each_ancestor(links, k, [&](auto i) AXIAL_INLINE {
    if constexpr (!decltype(crba::is_absent<Links>(k, i))::value && decltype(rows.solved(i))::value)
      x[k] = less(rows.outwards(k, i), x[k], factors.m(k, i) * x[i]);
  });
}
/// x = M^-1 x.
template <class Rows, class Links, class F, class X>
AXIAL_INLINE constexpr void substitute(Rows rows, const Links& links, const F& factors, X& x) {
  for_each_link_inwards(links, [&](auto k) AXIAL_INLINE { take_inwards(rows, links, factors, x, k); });
  for_each_link(links, [&](auto k) AXIAL_INLINE { take_outwards(rows, links, factors, x, k); });
}

/// What the rows of joints from k inwards leave of entry (i, j) of the inverse: sum less gain times entry (k, j).
template <class Links, class F, class Matrix, class I, class K, class J, class Sum>
AXIAL_INLINE constexpr auto less_inboard(const Links& links, const F& factors, const Matrix& inverse, I i, K k, J j,
                                         const Sum& sum) {
  if constexpr (!Links::unrolled) {
    auto rest = typename Links::Scalar(sum);
    for (int from = k; from >= 0; from = links.parent_index(from))
      rest = rest - factors.m(i, from) * inverse(from, j);
    return rest;
  } else if constexpr (K::value < 0) {
    return sum;
  } else {
    const Index<Links::template parent_of<K::value>> next;
    if constexpr (decltype(crba::is_absent<Links>(i, k))::value)
      return less_inboard(links, factors, inverse, i, next, j, sum);
    else
      return less_inboard(links, factors, inverse, i, next, j, sum - factors.m(i, k) * inverse(k, j));
  }
}
/// The link that carries link i.
template <class Links, class I>
AXIAL_INLINE constexpr auto parent_of(const Links& links, I i) {
  if constexpr (Links::unrolled)
    return Index<Links::template parent_of<I::value>>{};
  else
    return links.parent_index(i);
}
/// Calls f(Index<j>{}) for a sequence of links.
template <class F, int... J>
AXIAL_INLINE constexpr void for_each_of(const F& f, std::integer_sequence<int, J...>) {
  (f(Index<J>{}), ...);
}
/// Calls f(j) for links before link i.
template <class Links, class I, class Step>
AXIAL_INLINE constexpr void for_each_before(const Links&, I i, const Step& f) {
  if constexpr (Links::unrolled)
    for_each_of(f, std::make_integer_sequence<int, I::value>{});
  else
    for (int j = 0; j < i; ++j)
      f(j);
}
/// inverse = M^-1, row by row from the base: L M^-1 = D^-1 L^-T is zero below its diagonal and 1/D on it (Takahashi,
/// Fagan and Chin 1973), so that each entry follows from the rows of the joints that carry its own.
template <class Links, class F, class Matrix>
AXIAL_INLINE constexpr void invert(const Links& links, const F& factors, Matrix& inverse) {
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    auto parent = parent_of(links, i);
    for_each_before(links, i, [&](auto j) AXIAL_INLINE {
      inverse.set(i, j, less_inboard(links, factors, inverse, i, parent, j, Zero{}));
    });
    inverse(i, i) = less_inboard(links, factors, inverse, i, parent, i, factors.inverses[i]);
  });
}

/// A column of a matrix, as less_inboard() reads it.
template <class X>
struct OneColumn {
  const X& x;  ///< referred to
  /// Row k.
  template <class K, class J>
  AXIAL_INLINE constexpr const auto& operator()(K k, J) const {
    return x[k];
  }
};
/// invert() column by column in a loop, so that its code does not grow with the cube of the joints: of column j the
/// rows up to j are those of row j.
template <class Links, class F, class Matrix>
AXIAL_INLINE constexpr void invert_in_loop(const Links& links, const F& factors, Matrix& inverse) {
  using T = typename Links::Scalar;
  for (int j = 0; j < Links::capacity; ++j) {
    Row<T, Links::capacity> x;
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      if (i < j) {
        x[i] = inverse(j, i);
      } else {
        const OneColumn<Row<T, Links::capacity>> column{x};
        const auto inboard = less_inboard(links, factors, column, i, parent_of(links, i), j, Zero{});
        x[i] = i == j ? T(inboard + factors.inverses[i]) : T(inboard);
        inverse(i, j) = x[i];
      }
    });
  }
}

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>

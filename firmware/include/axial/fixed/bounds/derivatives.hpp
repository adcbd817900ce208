// Sizes, formats and errors of the derivatives of inverse dynamics: their own kernel, run on bounds.
#pragma once

#include <axial/dynamics/inverse_dynamics_derivatives.hpp>
#include <axial/fixed/bounds/flow.hpp>
#include <axial/fixed/bounds/newton_euler.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace bounds {

/// One bound per entry of a matrix.
template <int N>
struct EntryBounds {
  Ball of[N][N] = {};                                                        ///< row by row
  constexpr Ball& operator()(int i, int j) { return of[i][j]; }              ///< of entry (i, j)
  constexpr const Ball& operator()(int i, int j) const { return of[i][j]; }  ///< of entry (i, j)
};
/// The derivatives in bounds.
template <int N>
struct DerivativeBounds {
  EntryBounds<N> mass{}, position{}, velocity{};  ///< M, d tau / d q, d tau / d qd
};

/// Exponents of no result: where sizes alone are wanted.
struct NoExponents {
  /// one for all
  constexpr int mass(int, int) const { return 0; }
  constexpr int position(int, int) const { return 0; }  ///< one for all
  constexpr int velocity(int, int) const { return 0; }  ///< one for all
};

/// Where the kernel writes its entries: each is rounded into its exponent.
template <int N, class Exponents>
struct BoundedEntries {
  const WordRounding& rounding;  ///< of the arithmetic
  const Exponents& exponents;    ///< of results
  DerivativeBounds<N>& all;      ///< what is found

  /// Efforts are among the ranges of their links.
  static constexpr void effort(int, const Number&) {}
  /// M(i, j), either way round
  template <class X>
  constexpr void mass(int i, int j, const X& x) {
    all.mass(i, j) = all.mass(j, i) = rounded(x, exponents.mass(i, j));
  }
  /// d tau_i / d q_j
  template <class X>
  constexpr void position(int i, int j, const X& x) {
    all.position(i, j) = rounded(x, exponents.position(i, j));
  }
  /// d tau_i / d qd_j
  template <class X>
  constexpr void velocity(int i, int j, const X& x) {
    all.velocity(i, j) = rounded(x, exponents.velocity(i, j));
  }

 private:
  template <class X>
  constexpr Ball rounded(const X& x, int exponent) const {
    const NumberSum sum = term_of(x);
    return {sum.bound.size, sum.bound.error + sum.terms.rounding(exponent, rounding)};
  }
};

namespace detail {

template <int N, class Exponents>
constexpr DerivativeBounds<N> derive(Account<N>& account, const Exponents& exponents) {
  DerivativeBounds<N> all;
  BoundedEntries<N, Exponents> entries{account.rounding, exponents, all};
  with_loads(account.mechanism.loads, [&](auto scene) {
    const BoundedLinks<decltype(scene), N> links(account);
    const GivenLoads in = given_loads(account.mechanism.loads, account.rounding);
    const JointBounds<N> at(account.mechanism, account.rounding);
    derivatives::run(links, in, at.q, at.qd, at.qdd, entries);
  });
  return all;
}
template <int N>
constexpr DerivativeBounds<N> sizes(Account<N>& account) {
  note_description(account);
  const DerivativeBounds<N> all = derive(account, NoExponents{});
  account.choose_formats();
  return all;
}

}  // namespace detail

/// How large the entries can be.
template <int N>
constexpr DerivativeBounds<N> derivative_sizes(const Mechanism<N>& m, const WordRounding& r) {
  Account<N> account{m, r};
  return detail::sizes(account);
}
/// Errors of the entries in the formats that `ranges` say, each rounded into its exponent.
template <int N, class Exponents>
constexpr DerivativeBounds<N> derivative_errors(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges,
                                                const Exponents& exponents) {
  Account<N> account{m, r, false, false, ranges};
  return detail::derive(account, exponents);
}

}  // namespace bounds

/// Ranges, formats and errors of what the derivatives' recursion keeps.
template <int N>
constexpr Ranges<N> derivative_ranges(const Mechanism<N>& m, const WordRounding& r, Wanted wanted = Wanted::errors) {
  bounds::Account<N> account{m, r};
  bounds::detail::sizes(account);
  if (wanted == Wanted::errors) bounds::detail::derive(account, bounds::NoExponents{});
  return account.ranges;
}

}  // namespace axial

#include <axial/options/end.hpp>

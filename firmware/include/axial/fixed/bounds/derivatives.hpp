// Sizes, formats and errors of the derivatives of inverse dynamics: their own kernel, run on bounds.
#pragma once

#include <axial/derivatives/inverse_dynamics_derivatives.hpp>
#include <axial/fixed/bounds/dynamics.hpp>
#include <axial/fixed/bounds/flow.hpp>

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
/// How far an entry may be doubled from the format that all of its matrix share.
inline constexpr int most_doublings = 30;

/// The derivatives in bounds.
template <int N>
struct DerivativeBounds {
  EntryBounds<N> mass{}, position{}, velocity{};  ///< M, d tau / d q, d tau / d qd
};

/// Exponents of no result: where sizes alone are wanted.
struct NoExponents {
  static constexpr int mass(int, int) { return 0; }      ///< one for all
  static constexpr int position(int, int) { return 0; }  ///< one for all
  static constexpr int velocity(int, int) { return 0; }  ///< one for all
};
/// The least exponent of the entries of a matrix, at which all of them fit.
template <int N, class Exponent>
constexpr int least_exponent(const Exponent& exponent) {
  int least = exponent(0, 0);
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      least = axial::detail::smaller(least, exponent(i, j));
  return least;
}

/// Where the kernel writes its entries: each is rounded into its exponent, in the looped form into the least of the
/// matrix, from which it moves on without loss. An entry too small to say anything there is 0.
template <int N, class Exponents>
struct BoundedEntries {
  const WordRounding& rounding;                                 ///< of the arithmetic
  bool shared;                                                  ///< whether one step writes all entries
  const Exponents& exponents;                                   ///< of results
  DerivativeBounds<N>& all;                                     ///< what is found
  int least_mass = least_exponent<N>(Exponents::mass);          ///< of M
  int least_position = least_exponent<N>(Exponents::position);  ///< of d tau / d q
  int least_velocity = least_exponent<N>(Exponents::velocity);  ///< of d tau / d qd

  /// Efforts are among the ranges of their links.
  static constexpr void effort(int, const Number&) {}
  /// M(i, j), either way round
  template <class X>
  constexpr void mass(int i, int j, const X& x) {
    all.mass(i, j) = all.mass(j, i) = rounded(x, exponents.mass(i, j), least_mass);
  }
  /// d tau_i / d q_j
  template <class X>
  constexpr void position(int i, int j, const X& x) {
    all.position(i, j) = rounded(x, exponents.position(i, j), least_position);
  }
  /// d tau_i / d qd_j
  template <class X>
  constexpr void velocity(int i, int j, const X& x) {
    all.velocity(i, j) = rounded(x, exponents.velocity(i, j), least_velocity);
  }

 private:
  template <class X>
  constexpr Ball rounded(const X& x, int exponent, int least) const {
    const NumberSum sum = term_of(x);
    if (shared && exponent - least > most_doublings) return {sum.bound.size, sum.bound.size};
    return {sum.bound.size, sum.bound.error + sum.terms.rounding(shared ? least : exponent, rounding)};
  }
};

namespace detail {

template <int N, class Exponents>
constexpr DerivativeBounds<N> derive(Account<N>& account, const Exponents& exponents) {
  DerivativeBounds<N> all;
  BoundedEntries<N, Exponents> entries{account.rounding, account.mechanism.steps.shared, exponents, all};
  with_loads(account, [&entries](const auto& start) {
    derivatives::run(start.links, start.in, start.at.q, start.at.qd, start.at.qdd, entries);
  });
  return all;
}

}  // namespace detail

/// How large the entries can be.
template <int N>
constexpr DerivativeBounds<N> derivative_sizes(const Mechanism<N>& m, const WordRounding& r) {
  Account<N> account{m, r};
  detail::note_description(account);
  return detail::derive(account, NoExponents{});
}
/// What is derived in the formats of `ranges`: errors of the entries, and of all that the recursion keeps.
template <int N>
struct Derived {
  DerivativeBounds<N> entries{};  ///< each rounded into its exponent
  Ranges<N> ranges{};             ///< as given, with errors
};
/// Errors in the formats that `ranges` say.
template <int N, class Exponents>
constexpr Derived<N> derived(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges,
                             const Exponents& exponents) {
  auto account = account_in_formats(m, r, ranges);
  const DerivativeBounds<N> entries = detail::derive(account, exponents);
  return {entries, account.ranges};
}

}  // namespace bounds

/// Ranges, formats and errors of what the derivatives' recursion keeps.
template <int N>
constexpr Ranges<N> derivative_ranges(const Mechanism<N>& m, const WordRounding& r, Wanted wanted = Wanted::errors) {
  return bounds::detail::ranges_by(
      m, r, wanted, [](bounds::Account<N>& account) { bounds::detail::derive(account, bounds::NoExponents{}); });
}

}  // namespace axial

#include <axial/options/end.hpp>

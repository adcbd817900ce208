// Sizes, formats and errors of the mass matrix: composite bodies and their kernel, run on bounds.
#pragma once

#include <axial/dynamics/mass_matrix.hpp>
#include <axial/fixed/bounds/links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace bounds {

/// Rows of a mass matrix in bounds: the largest error of the entries up to the diagonal, each in its exponent.
template <int N, class Exponent>
struct MatrixRows {
  const WordRounding& rounding;  ///< of the arithmetic
  const Exponent& exponent;      ///< of entry (i, j)
  double error[N] = {};          ///< of row i

  /// Sets an entry, as the kernel does.
  constexpr void set(int i, int j, const Number& value) {
    const double own = value.bound.error + rounding.move(value.exponent, exponent(i, j));
    if (own > error[i]) error[i] = own;
  }
};

namespace detail {

template <int N, class Rows>
constexpr void set_rows(Account<N>& account, Rows& rows) {
  with_loads(account, [&rows](const auto& start) { crba::entries(start.links, start.in, start.screws(), rows); });
}

// The looped form keeps a joint's unit force, a column of its composite body, in the formats of forces, and adds masses
// that are words.
template <int N>
constexpr void note_unit_forces(Account<N>& account) {
  const auto widen = [](double& widest, double size) { widest = size > widest ? size : widest; };
  const Mechanism<N>& m = account.mechanism;
  double carried[N] = {};
  for (int i = N; i-- > 0;) {
    carried[i] += magnitude(m.links[i].mass) + (i + 1 == N ? m.loads.payload_mass : 0.0);
    if (m.parent(i) >= 0) carried[m.parent(i)] += carried[i];
    const LinkRange& own = account.ranges.range[i];
    const bool slides = m.links[i].prismatic;
    LinkSizes& widest = account.widest[i];
    widen(widest.of(quantity::Moment{}), (slides ? own.first_moment : own.rotational_inertia).size);
    widen(widest.of(quantity::Force{}), slides ? carried[i] : own.first_moment.size);
    widen(widest.of(quantity::JointInertia{}), slides ? carried[i] : 0.0);
    if (account.rounding.tabled) widen(widest.of(quantity::Mass{}), carried[i]);
  }
}

template <int N>
constexpr void run_bodies(Account<N>& account) {
  const auto none = [](int, int) { return 0; };
  MatrixRows<N, decltype(none)> ignored{account.rounding, none};
  set_rows(account, ignored);
  if (account.sizing) note_unit_forces(account);
}

}  // namespace detail

/// Errors of the rows of the matrix whose entries have the exponents `exponent(i, j)`, in the formats of `ranges`.
template <int N, class Exponent>
constexpr Row<double, N> mass_matrix_errors(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges,
                                            const Exponent& exponent) {
  auto account = account_in_formats(m, r, ranges);
  MatrixRows<N, Exponent> all{r, exponent};
  detail::set_rows(account, all);
  Row<double, N> errors;
  for (int i = 0; i < N; ++i)
    errors[i] = all.error[i];
  return errors;
}

}  // namespace bounds

/// Ranges and formats of the mass matrix by composite bodies: joint_inertia of joint i is the diagonal's.
template <int N>
constexpr Ranges<N> composite_body_ranges(const Mechanism<N>& m, const WordRounding& r,
                                          Wanted wanted = Wanted::errors) {
  return bounds::detail::ranges_by(m, r, wanted, bounds::detail::run_bodies<N>);
}

}  // namespace axial

#include <axial/options/end.hpp>

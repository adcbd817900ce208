// What derivatives of forward dynamics are asked for, and how both Jacobians of inverse dynamics become them: column by
// column, without columns of zeros.
#pragma once

#include <axial/derivatives/inverse_dynamics_derivatives.hpp>
#include <axial/derivatives/mass_factors.hpp>
#include <axial/recursion/forward_result.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// The rows of column J of a Jacobian.
template <class Links, class By, int J>
struct JacobianColumn {
  static constexpr auto rows = [] {
    Row<bool, Links::capacity> rows;
    for (int i = 0; i < Links::capacity; ++i)
      rows[i] = jacobian_structure<Links>.of(By{})[i][J];
    return rows;
  }();  ///< those that are not zero
};

/// Columns from the first to the last that is not zero.
struct ColumnRange {
  int first = 0;  ///< none where it is behind the last
  int last = -1;  ///< inclusive
};
/// Columns of a Jacobian from the first to the last that is not zero.
template <class Links, class By>
constexpr ColumnRange columns_with_entries() {
  const auto& present = jacobian_structure<Links>.of(By{});
  ColumnRange range{Links::capacity, -1};
  for (int j = 0; j < Links::capacity; ++j)
    for (int i = 0; i < Links::capacity; ++i)
      if (present[i][j]) range = {j < range.first ? j : range.first, j};
  return range;
}
/// Columns of a Jacobian that are not zero where the compiler knows them, else all.
template <class By, class Links>
AXIAL_INLINE constexpr ColumnRange columns_of(const Links& links) {
  if constexpr (Links::unrolled) {
    constexpr ColumnRange range = columns_with_entries<Links, By>();
    return range;
  } else {
    return {0, links.size() - 1};
  }
}

/// Whether each column has code of its own, which has no zeros: of arms whose loop would not be shorter.
template <class Links>
inline constexpr bool has_few_columns = Links::unrolled&& Links::capacity <= 4;

/// matrix = M^-1 matrix, for few joints.
template <class Links, class F, class S, class T, class By>
AXIAL_INLINE constexpr void solve_few(const Links& links, const F& factors, JointMatrix<S, T, By>& matrix) {
  for_each_link(links, [&](auto j) AXIAL_INLINE {
    const Known<Links, JacobianColumn<Links, By, decltype(j)::value>> rows;
    Row<T, Links::capacity> x{};
    for_each_link(links, [&](auto i) AXIAL_INLINE { x[i] = matrix(i, j); });
    substitute(rows, links, factors, x);
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      if constexpr (decltype(rows.solved(i))::value) matrix(i, j) = x[i];
    });
  });
}
/// A matrix' entries, row by row, and which of its columns have any.
template <class T>
struct Block {
  T* entries = nullptr;   ///< referred to
  ColumnRange columns{};  ///< inclusive
};
/// block = M^-1 block: a loop, for its code would be the longest of all.
template <int N, class Links, class F, class T>
AXIAL_INLINE constexpr void solve_block(const Links& links, const F& factors, const Block<T>& block) {
  for (int j = block.columns.first; j <= block.columns.last; ++j) {
    Row<T, Links::capacity> x{};
    for_each_link(links, [&](auto i) AXIAL_INLINE { x[i] = block.entries[i * N + j]; });
    substitute(Any{}, links, factors, x);
    for_each_link(links, [&](auto i) AXIAL_INLINE { block.entries[i * N + j] = x[i]; });
  }
}
/// matrix = M^-1 matrix for every matrix, all columns in one loop.
template <class Links, class F, class S, class T, class... By>
AXIAL_INLINE constexpr void solve_columns(const Links& links, const F& factors, JointMatrix<S, T, By>&... matrices) {
  if constexpr (has_few_columns<Links>) {
    (solve_few(links, factors, matrices), ...);
  } else {
    const Block<T> blocks[] = {{matrices.values, columns_of<By>(links)}...};
    for (const auto& block : blocks)
      solve_block<JointMatrix<S, T, by::Position>::size>(links, factors, block);
  }
}

}  // namespace derivatives

/// Matrices of forward_dynamics_derivatives() over numbers T; a number system with formats has its own.
template <class S, class T>
struct AccelerationMatrices {
  using ByEffort = MassMatrixOf<S, T>;                   ///< M^-1
  using ByPosition = JointMatrixOf<S, T, by::Position>;  ///< d qdd / d q
  using ByVelocity = JointMatrixOf<S, T, by::Velocity>;  ///< d qdd / d qd
};

/// What forward_dynamics_derivatives() may be asked for besides the accelerations.
///@{
struct with_inverse_mass_matrix {
  /// Member that this tag adds to the results.
  template <class S, class T>
  struct Result {
    typename AccelerationMatrices<S, T>::ByEffort M_inverse;  ///< d qdd / d tau, symmetric: 1/(kg m^2), 1/(kg m), 1/kg
  };
};
struct with_acceleration_by_position {
  /// Member that this tag adds to the results.
  template <class S, class T>
  struct Result {
    typename AccelerationMatrices<S, T>::ByPosition dqdd_dq;  ///< (i, j) = d qdd_i / d q_j, at given efforts
  };
};
struct with_acceleration_by_velocity {
  /// Member that this tag adds to the results.
  template <class S, class T>
  struct Result {
    typename AccelerationMatrices<S, T>::ByVelocity dqdd_dqd;  ///< (i, j) = d qdd_i / d qd_j, at given efforts
  };
};
///@}

/// Accelerations, their derivatives that are wanted, and a status: all of them unless some are named.
template <class S, class T, class... Wanted>
struct ForwardDynamicsDerivatives : WantedResults<S, T, Wanted...> {
  ForwardDynamicsOf<S, T> qdd{};  ///< rad/s^2 or m/s^2; its status is that of all
};
/// Accelerations, all of their derivatives, and a status.
template <class S, class T>
struct ForwardDynamicsDerivatives<S, T>
    : ForwardDynamicsDerivatives<S, T, with_inverse_mass_matrix, with_acceleration_by_position,
                                 with_acceleration_by_velocity> {};

namespace derivatives {

/// Takes the Jacobians' entries, where those of forward dynamics are wanted instead.
template <class Result>
struct SlopeEntries {
  Result& result;  ///< referred to

  /// Efforts and entries of M are not taken.
  ///@{
  template <class I, class X>
  AXIAL_INLINE constexpr void effort(I, const X&) {}
  template <class I, class J, class X>
  AXIAL_INLINE constexpr void mass(I, J, const X&) {}
  ///@}
  /// d tau_i / d q_j
  template <class I, class J, class X>
  AXIAL_INLINE constexpr void position(I i, J j, const X& x) {
    if constexpr (Result::template has<with_acceleration_by_position>) write_entry(result.dqdd_dq, i, j, x);
  }
  /// d tau_i / d qd_j
  template <class I, class J, class X>
  AXIAL_INLINE constexpr void velocity(I i, J j, const X& x) {
    if constexpr (Result::template has<with_acceleration_by_velocity>) write_entry(result.dqdd_dqd, i, j, x);
  }
};

/// Whether an arm that the compiler knows is so long that its flash counts: little is kept from step to step then, and
/// M^-1 comes out of a loop. Four joints and less have neither loops nor anything to spare.
template <class Links>
inline constexpr bool is_long = Links::unrolled && !has_few_columns<Links>;
/// How the second pass of a long arm goes.
template <class Links>
struct LittleKept {
  static constexpr bool forces_ahead = true;  ///< links' own forces first
  /// Where the outer half begins, of a chain of seven joints and more: its columns go through the inner half in a loop.
  /// That saves a tenth of the flash and costs few instructions; of six joints it would save little.
  static constexpr int looped_from = Links::capacity > 6 && rests_at_link_1<Links>() ? (Links::capacity + 1) / 2 : 0;
};

/// Jacobians of inverse dynamics become those of forward dynamics: -M^-1 times them.
template <class Links, class F, class Result>
AXIAL_INLINE constexpr void solve_slopes(const Links& links, F factors, Result& result) {
  constexpr bool position = Result::template has<with_acceleration_by_position>;
  constexpr bool velocity = Result::template has<with_acceleration_by_velocity>;
  for_each_link(links, [&](auto i) AXIAL_INLINE { factors.inverses[i] = -factors.inverses[i]; });
  if constexpr (position && velocity)
    solve_columns(links, factors, result.dqdd_dq, result.dqdd_dqd);
  else if constexpr (position)
    solve_columns(links, factors, result.dqdd_dq);
  else if constexpr (velocity)
    solve_columns(links, factors, result.dqdd_dqd);
}
/// M^-1 and the slopes of a long arm, whose state stands in variables of its own: a store to a result may change the
/// caller's for all that the compiler knows, and all that follows from it would be computed twice.
template <class Links, class Input, class Q, class Screws, class V, class A, class F, class Result>
AXIAL_INLINE constexpr void long_slopes(const Links& links, const Input& in, const Q& q, const Screws& screws,
                                        const V& qd, const A& qdd, const F& factors, Result& result) {
  if constexpr (Result::template has<with_inverse_mass_matrix>) invert_in_loop(links, factors, result.M_inverse);
  SlopeEntries<Result> slopes{result};
  entries<LittleKept<Links>>(links, in, q, screws, qd, qdd, slopes);
  write_between_branches(links, slopes);
  solve_slopes(links, factors, result);
}

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>

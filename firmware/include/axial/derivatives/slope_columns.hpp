// Columns of both Jacobians of inverse dynamics, solved for those of forward dynamics: without columns of zeros.
#pragma once

#include <axial/derivatives/inverse_dynamics_derivatives.hpp>
#include <axial/derivatives/mass_factors.hpp>

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
}  // namespace axial

#include <axial/options/end.hpp>

// Squares of numbers in vector registers: rows become columns.
#pragma once
#include <axial/scalar/language.hpp>

#include <utility>

#include <axial/scalar/lanes.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Exchanges what two rows hold beyond the diagonal of each square of 2 Block numbers.
template <int Block, class Vector, int... Lane>
AXIAL_INLINE constexpr void exchange(Vector& upper, Vector& lower, std::integer_sequence<int, Lane...>) {
  constexpr int n = sizeof...(Lane);
  const Vector first = __builtin_shufflevector(upper, lower, ((Lane & Block) != 0 ? n + Lane - Block : Lane)...);
  lower = __builtin_shufflevector(upper, lower, ((Lane & Block) != 0 ? n + Lane : Lane + Block)...);
  upper = first;
}
template <int Block, int Row, class Vector, int N>
AXIAL_INLINE constexpr void exchange_row(Vector (&rows)[N]) {
  if constexpr ((Row & Block) == 0) exchange<Block>(rows[Row], rows[Row + Block], std::make_integer_sequence<int, N>{});
}
/// rows[i][k] becomes rows[k][i]: N log2(N) shuffles.
template <int Block, class Vector, int N, int... Row>
AXIAL_INLINE constexpr void transpose(Vector (&rows)[N], std::integer_sequence<int, Row...> all) {
  if constexpr (Block > 0) {
    (exchange_row<Block, Row>(rows), ...);
    transpose<Block / 2>(rows, all);
  }
}
template <class Vector, int N>
AXIAL_INLINE constexpr void transpose(Vector (&rows)[N]) {
  transpose<N / 2>(rows, std::make_integer_sequence<int, N>{});
}

/// The vector register that holds lane First and those behind it.
template <int First, class L>
AXIAL_INLINE constexpr auto& vector_from(L& lanes) {
  if constexpr (L::is_vector)
    return lanes.values;
  else if constexpr (First < L::size / 2)
    return vector_from<First>(lanes.low);
  else
    return vector_from<First - L::size / 2>(lanes.high);
}
/// Number of lanes of L that stand in one register.
template <class L>
constexpr int lanes_of_vector() {
  if constexpr (L::is_vector)
    return L::size;
  else
    return lanes_of_vector<typename L::Half>();
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

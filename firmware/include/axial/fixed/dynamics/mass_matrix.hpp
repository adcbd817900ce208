// The mass matrix in fixed point: an exponent per entry.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/mass_matrix.hpp>
#include <axial/fixed/links/fixed_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
/// Exponents of the entries: |M_ij| <= sqrt(M_ii M_jj), whatever the configuration.
template <class S, class Word>
inline constexpr auto mass_matrix_format = entry_exponents<joint_count<S>>([](int i, int j) {
  using Sizes = SizesOf<S, Word>;
  return joint_rounding<Word>.exponent(square_root(Sizes::inertia(i) * Sizes::inertia(j)));
});

/// The least exponent of the entries.
template <class S, class Word>
inline constexpr int least_entry = bounds::least_exponent<joint_count<S>>([](int i, int j) {
  return mass_matrix_format<S, Word>.of[i][j];
});

/// How far entries, each in its format, are from exponent E: in either direction.
template <class S, class Word, int E>
struct MatrixShifts {
  static constexpr int size = joint_count<S>;
  unsigned char down[size * (size + 1) / 2] = {}, up[size * (size + 1) / 2] = {};

  static constexpr MatrixShifts chosen() {
    MatrixShifts shifts;
    for (int i = 0; i < size; ++i)
      for (int j = 0; j <= i; ++j) {
        const int shift = mass_matrix_format<S, Word>.of[i][j] - E, at = i * (i + 1) / 2 + j;
        shifts.down[at] = static_cast<unsigned char>(shift < 0 ? smaller(-shift, 31) : 0);
        shifts.up[at] = static_cast<unsigned char>(shift > 0 ? shift : 0);
      }
    return shifts;
  }
};
template <class S, class Word, int E>
inline constexpr auto matrix_shifts = MatrixShifts<S, Word, E>::chosen();
}  // namespace detail

/// Mass matrix in fixed point: M(i, j) = raw 2^-exponent(i, j).
template <class S, class Word>
struct MassMatrix<S, Stored<Word>> {
  static constexpr int size = joint_count<S>;  ///< number of joints
  Stored<Word> values[size * (size + 1) / 2];  ///< lower triangle, row by row

  /// Exponent of entry (i, j).
  [[nodiscard]] static constexpr int exponent(int i, int j) { return detail::mass_matrix_format<S, Word>.of[i][j]; }
  /// Entry (i, j), either way round.
  AXIAL_INLINE constexpr Stored<Word>& operator()(int i, int j) { return values[at(i, j)]; }
  /// Entry (i, j), either way round.
  AXIAL_INLINE constexpr const Stored<Word>& operator()(int i, int j) const { return values[at(i, j)]; }
  /// Rounds into the format of entry (I, J).
  template <int I, int J, class V>
  AXIAL_INLINE constexpr void set(Index<I>, Index<J>, const V& value) {
    if constexpr (!is_zero_v<V>) values[at(I, J)] = {round_to<exponent(I, J)>(value).raw};
  }
  /// Sets an entry from a format that all links share.
  template <int E, class A>
  AXIAL_INLINE constexpr void set(int i, int j, const Fx<E, A>& value) {
    constexpr const auto& shifts = detail::matrix_shifts<S, Word, E>;
    values[at(i, j)] = {detail::moved_either_way<A>(value.raw, shifts.down[at(i, j)], shifts.up[at(i, j)])};
  }
  /// Sets an entry from a sum that nobody has rounded: in the least exponent of the entries.
  template <class A, class B>
  AXIAL_INLINE constexpr void set(int i, int j, const Sum<A, B>& value) {
    set(i, j, round_to<detail::least_entry<S, Word>>(value));
  }
  AXIAL_INLINE constexpr void set(int, int, Zero) {}  ///< what is zero by type is zero already

 private:
  AXIAL_INLINE static constexpr int at(int i, int j) { return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i; }
};

}  // namespace axial

#include <axial/options/end.hpp>

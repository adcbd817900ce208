// Derivatives of inverse dynamics in fixed point: an exponent per entry.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/derivatives/inverse_dynamics_derivatives.hpp>
#include <axial/fixed/dynamics/mass_matrix.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
/// How large the entries can be, whatever the scene's arithmetic.
template <class S, class Word>
constexpr auto found_derivative_sizes();
template <class S, class Word>
inline constexpr auto derivative_sizes_of = found_derivative_sizes<S, Word>();

/// Jacobians of drives that joints share, from those of the joints: sums of bounds.
template <class S, class Word>
struct DrivenSlopeSizes {
  using Sizes = DriveSizes<S, Word>;
  using Links = decltype(links_of<S, Stored<Word>, BaseParameters, recursion::Derivatives>());
  static constexpr int size = joint_count<S>;

  /// Calls f(k, l, i, j, factor) for what entry (i, j) of the joints' adds to entry (k, l) of the drives'.
  template <class By, class F>
  static constexpr void each_share(By, const F& f) {
    for (int k = 0; k < size; ++k)
      for (int l = 0; l < size; ++l)
        for (int i = 0; i < Sizes::joints; ++i)
          for (int j = 0; j < Sizes::joints; ++j) {
            const double factor = Sizes::g.ratio[i][k] * Sizes::g.ratio[j][l];
            if (factor != 0.0 && driven::SlopeShares<Links, By>::is_present(i, j)) f(k, l, i, j, factor);
          }
  }
  template <class By>
  static constexpr bounds::EntryBounds<size> of(By by, const bounds::EntryBounds<Sizes::joints>& joints) {
    bounds::EntryBounds<size> all;
    each_share(by, [&](int k, int l, int i, int j, double factor) {
      all(k, l) = all(k, l) + magnitude(factor) * joints(i, j);
    });
    for (int k = 0; k < size && std::is_same_v<By, by::Velocity>; ++k)
      all(k, k).size += Sizes::viscous(k);
    return all;
  }
};
template <class S, class Word>
constexpr auto found_derivative_sizes() {
  if constexpr (shares_drives_in<typename scene_of<S>::Robot>) {
    using Driven = DrivenSlopeSizes<S, Word>;
    const auto& joints = derivative_sizes_of<typename Driven::Sizes::Joint, Word>;
    bounds::DerivativeBounds<joint_count<S>> all;
    all.position = Driven::of(by::Position{}, joints.position);
    all.velocity = Driven::of(by::Velocity{}, joints.velocity);
    return all;
  } else {
    return bounds::derivative_sizes(mechanism_of<scene_of<S>, FullParameters>, joint_rounding<Word>);
  }
}

/// Sizes of the entries of one matrix.
///@{
template <class S, class Word>
constexpr const auto& entries_of(by::Position) {
  return derivative_sizes_of<S, Word>.position;
}
template <class S, class Word>
constexpr const auto& entries_of(by::Velocity) {
  return derivative_sizes_of<S, Word>.velocity;
}
///@}

/// Exponents of the entries by their sizes.
template <class S, class Word, class By>
inline constexpr auto joint_matrix_format = entry_exponents<joint_count<S>>([](int i, int j) {
  return joint_rounding<Word>.exponent(entries_of<S, Word>(By{})(i, j).size);
});

/// The format that one step writes all entries in, and doublings of each from there into its own. An entry beyond
/// `most_doublings` is less than that format's unit: it is 0.
template <class S, class Word, class By>
struct EntryDoublings {
  static constexpr int size = joint_count<S>;
  int exponent = 0;
  unsigned char of[size * size] = {};

  static constexpr EntryDoublings chosen() {
    constexpr auto own = [](int i, int j) { return joint_matrix_format<S, Word, By>.of[i][j]; };
    EntryDoublings doublings;
    doublings.exponent = bounds::least_exponent<size>(own);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        doublings.of[i * size + j] =
            static_cast<unsigned char>(smaller(own(i, j) - doublings.exponent, bounds::most_doublings + 1));
    return doublings;
  }
};
template <class S, class Word, class By>
inline constexpr auto entry_doublings = EntryDoublings<S, Word, By>::chosen();

/// x 2^doublings, held within a word: what is exact fits, so that a word that would not is no farther off when held. 0
/// for more doublings than 30.
template <class S>
AXIAL_INLINE constexpr typename S::Word doubled_word(typename S::Word x, unsigned char doublings) {
  const auto factor = static_cast<std::int32_t>((std::uint32_t{2} << doublings) >> 1);
  bool held = false;
  return held_in_word<S>(held, integer::multiply(x, factor));
}
}  // namespace detail

/// Words of a matrix of N joints.
template <int N, class T>
struct SquareWords {
  static constexpr int size = N;  ///< number of joints
  T values[N * N];                ///< row by row; zero where the matrix is initialised by {}

  AXIAL_INLINE constexpr T& operator()(int i, int j) { return values[i * N + j]; }              ///< entry (i, j)
  AXIAL_INLINE constexpr const T& operator()(int i, int j) const { return values[i * N + j]; }  ///< entry (i, j)
};

/// Matrix of joints in fixed point: entry (i, j) = raw 2^-exponent(i, j).
template <class S, class Word, class By>
struct JointMatrix<S, Stored<Word>, By> : SquareWords<joint_count<S>, Stored<Word>> {
  /// Exponent of entry (i, j).
  [[nodiscard]] static constexpr int exponent(int i, int j) {
    return detail::joint_matrix_format<S, Word, By>.of[i][j];
  }
  /// Rounds into the format of entry (I, J).
  template <int I, int J, class V>
  AXIAL_INLINE constexpr void set(Index<I>, Index<J>, const V& value) {
    if constexpr (!is_zero_v<V>) (*this)(I, J) = {round_to<exponent(I, J)>(value).raw};
  }
  /// Rounds into a format that all entries share, and moves on into that of entry (i, j).
  template <class V>
  AXIAL_INLINE constexpr void set(int i, int j, const V& value) {
    const auto shared = round_to<detail::entry_doublings<S, Word, By>.exponent>(value);
    const unsigned char doublings = detail::entry_doublings<S, Word, By>.of[i * joint_count<S> + j];
    (*this)(i, j) = {detail::doubled_word<typename V::Arithmetic>(shared.raw, doublings)};
  }
};

}  // namespace axial

#include <axial/options/end.hpp>

// What fixed point computes with: stored words, how products and sums are held, which exponent a value takes.
#pragma once

#include <axial/scalar/inline.hpp>
#include <axial/scalar/traits.hpp>

#include <cstdint>
#include <type_traits>

#include <axial/options/begin.hpp>

namespace axial {

/// A stored fixed-point number: the bits alone. Its exponent is known from where it stands (Positions, Efforts, ...).
/// As the T of an algorithm it chooses the word of the arithmetic.
template <class WordType>
struct Stored {
  using Word = WordType;  ///< integer that holds it
  Word raw{};             ///< value 2^exponent
  /// Equality of the bits: of values only where both have one exponent.
  ///@{
  friend constexpr bool operator==(Stored a, Stored b) { return a.raw == b.raw; }
  friend constexpr bool operator!=(Stored a, Stored b) { return a.raw != b.raw; }
  ///@}
};

/// True for a stored fixed-point number.
template <class T>
inline constexpr bool is_stored_v = false;
/// True for a stored fixed-point number.
template <class Word>
inline constexpr bool is_stored_v<Stored<Word>> = true;

/// Fixed point is always a number.
template <class Word>
[[nodiscard]] constexpr bool is_finite(const Stored<Word>&) {
  return true;
}

namespace detail {
// Double words for sums of products, and words for sums of their upper words; wider where nothing may wrap unseen.
template <class Type, class Bits, class Upper>
struct WiderWords {
  using type = Type;
  using bits = Bits;
  using upper = Upper;
};
template <class Word, bool checked>
struct Widened;
template <>
struct Widened<std::int32_t, false> : WiderWords<std::int64_t, std::uint64_t, std::uint32_t> {};
template <>
struct Widened<std::int16_t, false> : WiderWords<std::int32_t, std::uint32_t, std::uint16_t> {};
template <>
struct Widened<std::int16_t, true> : WiderWords<std::int64_t, std::uint64_t, std::uint64_t> {};
#ifdef __SIZEOF_INT128__
template <>
struct Widened<std::int32_t, true> {
  __extension__ using type = __int128;
  __extension__ using bits = unsigned __int128;
  using upper = std::uint64_t;
};
#endif
}  // namespace detail

/// Results that did not fit their format, counted by arithmetics that check. For tests on a host.
inline std::uint64_t range_overflows = 0;

/// How fixed point computes: the word; results rounded to nearest or down; products exact in a double word, or only
/// their upper word; with `is_checked` sums that do not wrap, and a count of results that do not fit.
template <class WordType, bool to_nearest, bool upper_word, bool is_checked = false>
struct Arithmetic {
  using Word = WordType;  ///< of results
  /// Word of products: twice the word, wider where sums are checked
  using Wide = typename detail::Widened<Word, is_checked>::type;
  using Bits = typename detail::Widened<Word, is_checked>::bits;    ///< sums wrap: only what is stored has to fit
  using Upper = typename detail::Widened<Word, is_checked>::upper;  ///< of sums of upper words
  /// What the template's arguments say: rounding, products, counted overflows
  static constexpr bool nearest = to_nearest, high_word = upper_word, checked = is_checked;
  static constexpr int bits = 8 * static_cast<int>(sizeof(Word));  ///< of the word
  static constexpr int unit = bits - 2;                            ///< exponent of sines and cosines
  static constexpr double capacity = static_cast<double>((Wide{1} << (bits - 1)) - 1);  ///< largest raw value of a word
};

namespace detail {

constexpr int smaller(int a, int b) { return a < b ? a : b; }

/// What a number of a kernel is stored as.
template <class Scalar>
struct StoredAs {
  using type = Scalar;
};
template <class Word, bool nearest, bool high, bool checked>
struct StoredAs<Arithmetic<Word, nearest, high, checked>> {
  using type = Stored<Word>;
};

/// 2^e of a normal number: e from -1022 to 1023, held there.
constexpr double power_of_two(int e) {
  const int held = e < -1022 ? -1022 : e > 1023 ? 1023 : e;
  return __builtin_bit_cast(double, static_cast<std::uint64_t>(held + 1023) << 52);
}
/// The e of 2^e <= x < 2^(e + 1), x > 0 and normal.
constexpr int binary_exponent(double x) {
  return static_cast<int>(__builtin_bit_cast(std::uint64_t, x) >> 52 & 0x7ff) - 1023;
}
/// The word of a result that fits by proof.
template <class S, class X>
AXIAL_INLINE constexpr typename S::Word narrowed(X bits) {
  if constexpr (S::checked) {
    using Signed = std::conditional_t<(sizeof(X) > 8), typename S::Wide, std::int64_t>;
    const auto value = static_cast<Signed>(bits);
    if (value != static_cast<Signed>(static_cast<typename S::Word>(value))) ++range_overflows;
  }
  return static_cast<typename S::Word>(bits);
}
constexpr std::int64_t nearest_integer(double x) { return static_cast<std::int64_t>(x < 0.0 ? x - 0.5 : x + 0.5); }

/// The largest exponent at which |value| still fits a word of `capacity`; for 0 a large one.
constexpr int fitting_exponent(double value, double capacity) {
  const double size = value < 0.0 ? -value : value;
  constexpr int most = 200;
  if (!(size > power_of_two(-most))) return most;
  const int e = binary_exponent(capacity) - binary_exponent(size);
  return smaller(size * power_of_two(e) + 0.5 <= capacity ? e : e - 1, most);
}

}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>

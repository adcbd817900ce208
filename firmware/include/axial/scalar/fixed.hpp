// Fixed point: integers with a binary exponent in their type. Products and sums stay exact, and lazy, until something
// names the format that they are rounded to.
#pragma once

#include <axial/scalar/rounding.hpp>
#include <axial/scalar/select.hpp>

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
using Fixed32 = Stored<std::int32_t>;  ///< fixed point in 32 bits
using Fixed16 = Stored<std::int16_t>;  ///< fixed point in 16 bits

/// True for a stored fixed-point number.
template <class T>
inline constexpr bool is_stored_v = false;
/// True for a stored fixed-point number.
template <class Word>
inline constexpr bool is_stored_v<Stored<Word>> = true;

namespace detail {
// Double words for sums of products, and words for sums of their upper words; wider where nothing may wrap unseen.
template <class Word, bool checked>
struct Widened;
template <>
struct Widened<std::int32_t, false> {
  using type = std::int64_t;
  using bits = std::uint64_t;
  using upper = std::uint32_t;
};
template <>
struct Widened<std::int16_t, false> {
  using type = std::int32_t;
  using bits = std::uint32_t;
  using upper = std::uint16_t;
};
#ifdef __SIZEOF_INT128__
template <>
struct Widened<std::int32_t, true> {
  __extension__ using type = __int128;
  __extension__ using bits = unsigned __int128;
  using upper = std::uint64_t;
};
#endif
template <>
struct Widened<std::int16_t, true> {
  using type = std::int64_t;
  using bits = std::uint64_t;
  using upper = std::uint64_t;
};
}  // namespace detail

/// Results that did not fit their format, counted by arithmetics that check. For tests on a host.
inline std::uint64_t range_overflows = 0;

/// How fixed point computes: the word; results rounded to nearest or down; products exact in a double word, or only
/// their upper word; with `is_checked` sums that do not wrap, and a count of results that do not fit.
template <class WordType, bool to_nearest, bool upper_word, bool is_checked = false>
struct Arithmetic {
  using Word = WordType;  ///< of results
  /// of products: twice the word, wider where sums are checked
  using Wide = typename detail::Widened<Word, is_checked>::type;
  using Bits = typename detail::Widened<Word, is_checked>::bits;    ///< sums wrap: only what is stored has to fit
  using Upper = typename detail::Widened<Word, is_checked>::upper;  ///< of sums of upper words
  /// as the template's arguments say: rounding, products, counted overflows
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

/// 2^e.
constexpr double power_of_two(int e) {
  double p = 1.0;
  for (; e > 0; --e)
    p *= 2.0;
  for (; e < 0; ++e)
    p *= 0.5;
  return p;
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
  if (!(size > 0.0)) return 200;
  int e = 0;
  double scaled = size;
  while (scaled * 2.0 + 0.5 <= capacity && e < 200)
    scaled *= 2.0, ++e;
  while (scaled + 0.5 > capacity)
    scaled *= 0.5, --e;
  return e;
}

}  // namespace detail

/// A number raw * 2^-E in arithmetic S. Nothing mixes exponents or widens by itself.
template <int E, class S>
struct Fx {
  static constexpr int exponent = E;  ///< of its unit, 2^-E
  using Arithmetic = S;               ///< that computes with it
  typename S::Word raw{};             ///< value 2^E
};

/// A constant of the model, by the bits of its double; it takes the exponent that suits where it is used.
template <std::uint64_t Bits, class S>
struct Literal {
  using Arithmetic = S;                                              ///< that computes with it
  static constexpr double value = __builtin_bit_cast(double, Bits);  ///< as the model states it
};

/// An exact product that nobody has rounded yet; of two variables, or of a literal (the first) and a variable.
template <class A, class B, bool negative = false>
struct Product {
  using Arithmetic = typename B::Arithmetic;  ///< of its factors
  /// factor
  ///@{
  A a{};
  B b{};
  ///@}
};
/// An exact sum that nobody has rounded yet.
template <class A, class B>
struct Sum {
  using Arithmetic = typename A::Arithmetic;  ///< of its terms
  /// term
  ///@{
  A a{};
  B b{};
  ///@}
};

/// An angle: the whole range of the integer is one turn, so that it wraps exactly.
template <class S>
struct Bam {
  std::int32_t raw{};  ///< angle 2^32 / (2 pi rad), modulo a turn
};
/// Sum of angles, modulo a turn.
template <class S>
AXIAL_INLINE constexpr Bam<S> operator+(Bam<S> a, Bam<S> b) {
  return {static_cast<std::int32_t>(static_cast<std::uint32_t>(a.raw) + static_cast<std::uint32_t>(b.raw))};
}

namespace detail {

template <class X>
struct FixedKind : std::false_type {};
template <int E, class S>
struct FixedKind<Fx<E, S>> : std::true_type {};
template <std::uint64_t Bits, class S>
struct FixedKind<Literal<Bits, S>> : std::true_type {};
template <class A, class B, bool n>
struct FixedKind<Product<A, B, n>> : std::true_type {};
template <class A, class B>
struct FixedKind<Sum<A, B>> : std::true_type {};

template <class X>
struct IsFx : std::false_type {};
template <int E, class S>
struct IsFx<Fx<E, S>> : std::true_type {};

template <class X>
using if_fixed = std::enable_if_t<FixedKind<X>::value, int>;

template <class X>
inline constexpr bool is_literal_v = false;
template <std::uint64_t Bits, class S>
inline constexpr bool is_literal_v<Literal<Bits, S>> = true;

constexpr std::uint64_t bits_of(double value) { return __builtin_bit_cast(std::uint64_t, value); }

}  // namespace detail

template <class X>
struct NumberTraits<X, std::enable_if_t<detail::FixedKind<X>::value>> {
  static constexpr bool is_number = true;
  /// In the format of X.
  static constexpr X constant(double value) {
    static_assert(!std::is_empty_v<X>, "a literal has no format");
    return {
        static_cast<typename X::Arithmetic::Word>(detail::nearest_integer(value * detail::power_of_two(X::exponent)))};
  }
};

namespace detail {
template <class X>
struct Constants<X, std::enable_if_t<FixedKind<X>::value && !IsFx<X>::value>> {
  template <int N>
  AXIAL_INLINE static constexpr auto integer(Int<N>) {
    return Literal<bits_of(static_cast<double>(N)), typename X::Arithmetic>{};
  }
};
/// Beside a stored number an integer has its format, if it fits.
template <int E, class S>
struct Constants<Fx<E, S>> {
  template <int N>
  AXIAL_INLINE static constexpr auto integer(Int<N>) {
    if constexpr (fitting_exponent(N, S::capacity) >= E)
      return NumberTraits<Fx<E, S>>::constant(N);
    else
      return Literal<bits_of(static_cast<double>(N)), S>{};
  }
};
/// Constants of a model are literals until they meet a format.
template <class Word, bool nearest, bool high, bool checked>
struct Constants<Arithmetic<Word, nearest, high, checked>> {
  template <class Get>
  AXIAL_INLINE static constexpr auto constant(Get get) {
    constexpr double value = get();
    return Literal<bits_of(value), Arithmetic<Word, nearest, high, checked>>{};
  }
};
}  // namespace detail

/// The opposite number, of a lazy expression as lazy: no rounding.
///@{
template <int E, class S>
AXIAL_INLINE constexpr Fx<E, S> operator-(Fx<E, S> x) {
  return {detail::narrowed<S>(-typename S::Wide{x.raw})};
}
template <std::uint64_t B, class S>
AXIAL_INLINE constexpr auto operator-(Literal<B, S>) {
  return Literal<detail::bits_of(-Literal<B, S>::value), S>{};
}
template <class A, class B, bool n>
AXIAL_INLINE constexpr auto operator-(const Product<A, B, n>& x) {
  if constexpr (detail::is_literal_v<A>)
    return Product<decltype(-x.a), B>{-x.a, x.b};
  else
    return Product<A, B, !n>{x.a, x.b};
}
template <class A, class B>
AXIAL_INLINE constexpr auto operator-(const Sum<A, B>& x) {
  return Sum<decltype(-x.a), decltype(-x.b)>{-x.a, -x.b};
}
///@}

/// An exact product; of two literals a literal.
///@{
template <int E, int F, class S>
AXIAL_INLINE constexpr auto operator*(Fx<E, S> a, Fx<F, S> b) {
  return Product<Fx<E, S>, Fx<F, S>>{a, b};
}
template <std::uint64_t B, int F, class S>
AXIAL_INLINE constexpr auto operator*(Literal<B, S> a, Fx<F, S> b) {
  return Product<Literal<B, S>, Fx<F, S>>{a, b};
}
template <int E, std::uint64_t B, class S>
AXIAL_INLINE constexpr auto operator*(Fx<E, S> a, Literal<B, S> b) {
  return b * a;
}
template <std::uint64_t A, std::uint64_t B, class S>
AXIAL_INLINE constexpr auto operator*(Literal<A, S>, Literal<B, S>) {
  return Literal<detail::bits_of(Literal<A, S>::value * Literal<B, S>::value), S>{};
}
///@}

/// An exact sum: of one format at once, of literals by the compiler, of anything else lazy.
///@{
template <int E, class S>
AXIAL_INLINE constexpr Fx<E, S> operator+(Fx<E, S> a, Fx<E, S> b) {
  return {detail::narrowed<S>(typename S::Bits(a.raw) + typename S::Bits(b.raw))};
}
template <int E, class S>
AXIAL_INLINE constexpr Fx<E, S> operator-(Fx<E, S> a, Fx<E, S> b) {
  return {detail::narrowed<S>(typename S::Bits(a.raw) - typename S::Bits(b.raw))};
}
template <std::uint64_t A, std::uint64_t B, class S>
AXIAL_INLINE constexpr auto operator+(Literal<A, S>, Literal<B, S>) {
  return Literal<detail::bits_of(Literal<A, S>::value + Literal<B, S>::value), S>{};
}
template <class A, class B, detail::if_fixed<A> = 0, detail::if_fixed<B> = 0>
AXIAL_INLINE constexpr auto operator+(const A& a, const B& b) {
  return Sum<A, B>{a, b};
}
template <class A, class B, detail::if_fixed<A> = 0, detail::if_fixed<B> = 0>
AXIAL_INLINE constexpr auto operator-(const A& a, const B& b) {
  return a + (-b);
}
///@}

/// 2 x, exactly: the same bits.
template <int E, class S>
AXIAL_INLINE constexpr Fx<E - 1, S> twice(const Fx<E, S>& x) {
  return {x.raw};
}

/// x / 2, exactly.
template <int E, class S>
AXIAL_INLINE constexpr Fx<E + 1, S> half(const Fx<E, S>& x) {
  return {x.raw};
}

// Comparisons by the sign of a difference: a processor without conditional instructions would branch otherwise.
namespace detail {
AXIAL_INLINE constexpr bool is_less(std::int64_t a, std::int64_t b) {  // where a - b fits
  return (static_cast<std::uint64_t>(a - b) >> 63) != 0;
}

/// x where it fits a word, else the largest or smallest number; sets `lost` there. |x| < 2^(31 + the word's bits).
template <class S>
AXIAL_INLINE constexpr typename S::Word held_in_word(bool& lost, std::int64_t x) {
  const auto sign = static_cast<std::int32_t>(x >> 63);
  const auto spill = static_cast<std::uint32_t>(static_cast<std::int32_t>(x >> (S::bits - 1)) ^ sign);
  const auto beyond = static_cast<std::int32_t>((spill | (0U - spill)) >> 31);
  lost = lost | (beyond != 0);
  constexpr auto most = static_cast<std::int32_t>(S::capacity);
  const std::int32_t limit = (most ^ sign) - sign, held = static_cast<std::int32_t>(x);
  return static_cast<typename S::Word>((held & (beyond - 1)) | (limit & -beyond));
}
}  // namespace detail
/// Comparison of numbers of one format, without a branch.
///@{
template <int E, class S>
AXIAL_INLINE constexpr bool operator<(Fx<E, S> a, Fx<E, S> b) {
  return detail::is_less(a.raw, b.raw);
}
template <int E, class S>
AXIAL_INLINE constexpr bool operator>(Fx<E, S> a, Fx<E, S> b) {
  return b < a;
}
///@}

/// |x| of a constant, by the compiler.
template <std::uint64_t B, class S>
AXIAL_INLINE constexpr auto magnitude(Literal<B, S>) {
  constexpr double value = Literal<B, S>::value;
  return Literal<detail::bits_of(value < 0.0 ? -value : value), S>{};
}

/// yes or no by a mask.
template <int E, class S>
AXIAL_INLINE constexpr Fx<E, S> select(bool condition, const Fx<E, S>& yes, const Fx<E, S>& no) {
  const typename S::Word mask = static_cast<typename S::Word>(-static_cast<int>(condition));
  return {static_cast<typename S::Word>((yes.raw & mask) | (no.raw & static_cast<typename S::Word>(~mask)))};
}

}  // namespace axial

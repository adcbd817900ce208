// Lanes of vector registers, as many as are needed: what batches are made of. The vector extension of GCC and Clang.
#pragma once
#include <axial/scalar/language.hpp>

#include <utility>

#include <axial/scalar/select.hpp>
#include <axial/scalar/sincos.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Bytes of the widest vector register. Nothing wider is passed around: compilers lower that badly, or warn.
#if defined(__AVX512F__)
inline constexpr int vector_bytes = 64;
#elif defined(__AVX__)
inline constexpr int vector_bytes = 32;
#else
inline constexpr int vector_bytes = 16;
#endif

/// The signed integer as wide as a number T.
template <class T>
using WordOf = std::make_signed_t<typename BitsOf<T>::type>;

/// N numbers E in one vector register.
template <class E, int N, int Bytes, bool fits = (N * static_cast<int>(sizeof(E)) <= Bytes)>
struct Lanes {
  typedef E Values __attribute__((vector_size(N * sizeof(E))));
  static constexpr int size = N;
  static constexpr bool is_vector = true;
  Values values;
};
/// N numbers E in two halves, where one register is too narrow.
template <class E, int N, int Bytes>
struct Lanes<E, N, Bytes, false> {
  using Half = Lanes<E, N / 2, Bytes>;
  static constexpr int size = N;
  static constexpr bool is_vector = false;
  Half low, high;
};

/// R of f(a, b, ...), vector by vector.
template <class R, class F, class A, class... B>
AXIAL_INLINE constexpr R lanewise(const F& f, const A& a, const B&... b) {
  if constexpr (R::is_vector)
    return R{__builtin_bit_cast(typename R::Values, f(a.values, b.values...))};
  else
    return R{lanewise<typename R::Half>(f, a.low, b.low...), lanewise<typename R::Half>(f, a.high, b.high...)};
}

/// f(First), f(First + 1), ... in the lanes.
template <class L, int First, class F, int... Lane>
AXIAL_INLINE constexpr L generated_vector(const F& f, std::integer_sequence<int, Lane...>) {
  return {typename L::Values{f(First + Lane)...}};
}
template <class L, int First = 0, class F>
AXIAL_INLINE constexpr L generated(const F& f) {
  if constexpr (L::is_vector)
    return generated_vector<L, First>(f, std::make_integer_sequence<int, L::size>{});
  else
    return {generated<typename L::Half, First>(f), generated<typename L::Half, First + L::size / 2>(f)};
}
/// x in all lanes.
template <class L, class E>
AXIAL_INLINE constexpr L broadcast(E x) {
  return generated<L>([x](int) AXIAL_INLINE { return x; });
}

/// a + b, a - b or a * b. GCC fuses a product with a sum wherever the processor can; Clang within an expression only,
/// and here each operator is a function.
template <char operation, class Vector>
AXIAL_INLINE constexpr Vector arithmetic(const Vector& a, const Vector& b) {
#ifdef __clang__
#pragma clang fp contract(fast)
#endif
  if constexpr (operation == '+')
    return a + b;
  else if constexpr (operation == '-')
    return a - b;
  else
    return a * b;
}

/// yes where the mask is all ones, no where it is zero.
template <class M, class L>
AXIAL_INLINE constexpr L chosen(const M& mask, const L& yes, const L& no) {
  return lanewise<L>([](auto m, auto y, auto n) AXIAL_INLINE { return m ? y : n; }, mask, yes, no);
}

/// The numbers of a vector without their sign bits.
template <class Vector>
AXIAL_INLINE constexpr Vector without_sign(const Vector& x) {
  using Bits = typename TrigonometricConstants<Vector>::Bits;
  return __builtin_bit_cast(Vector, __builtin_bit_cast(Bits, x) << 1 >> 1);
}

/// All ones where a vector holds a number, zero for NaN and infinities.
template <class Vector>
AXIAL_INLINE constexpr auto are_finite(const Vector& x) {
  using Number = ElementOf<Vector>;
  using Bits = typename TrigonometricConstants<Vector>::Bits;
  constexpr auto infinite = __builtin_bit_cast(typename BitsOf<Number>::type, std::numeric_limits<Number>::infinity());
  return (__builtin_bit_cast(Bits, x) & infinite) != infinite;
}

/// What one lane holds.
template <class L>
AXIAL_INLINE constexpr auto element(const L& lanes, int lane) {
  if constexpr (L::is_vector)
    return lanes.values[lane];
  else
    return lane < L::size / 2 ? element(lanes.low, lane) : element(lanes.high, lane - L::size / 2);
}

/// Makes the function that it is inlined into align its stack to vectors. Clang decides that by variables, before it
/// knows which registers do not suffice: what these hold would lie across lines of the cache, in some runs more than in
/// others. No instruction of its own.
template <class Vector>
AXIAL_INLINE inline void align_stack() {
#if defined(__clang__) && defined(__x86_64__)
  if constexpr (sizeof(Vector) > 16) {
    Vector slot;
    asm volatile("" : "=m"(slot));
  }
#endif
}

/// Sines and cosines, in vectors.
template <class L>
AXIAL_INLINE constexpr SinCos<L> sincos_of_lanes(const L& x) {
  if constexpr (L::is_vector) {
    if (!__builtin_is_constant_evaluated()) align_stack<typename L::Values>();
    auto pair = sincos_of(x.values);
    return {L{pair.sin}, L{pair.cos}};
  } else {
    auto low = sincos_of_lanes(x.low), high = sincos_of_lanes(x.high);
    return {L{low.sin, high.sin}, L{low.cos, high.cos}};
  }
}

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

// Sine-cosine pairs: constexpr, without tables, without branches on data.
#pragma once

#include <axial/scalar/structural.hpp>
#include <utility>

#include <axial/options/begin.hpp>

namespace axial {

/// sin and cos of one angle.
template <class T>
struct SinCos {
  T sin, cos;  ///< one of the pair, of one angle
};

namespace detail {

// The numbers of one floating-point format: pi/2 in pieces short enough that a multiple of each is exact (Cody and
// Waite 1980), the constant whose addition rounds to an integer, and minimax polynomials in t = r^2 on [0, (pi/4)^2]
// (weighted least squares, reweighted to the minimax error given with each; 40-digit arithmetic).
template <class T, class = void>
struct TrigonometricConstants;

template <>
struct TrigonometricConstants<float> {
  using Number = float;
  using Bits = std::uint32_t;
  static constexpr bool is_short = true;
  static constexpr float two_over_pi = 0.63661977F;
  static constexpr float pieces[3] = {0x1.92p+0F, 0x1.fb4p-12F, 0x1.4442d2p-24F};
  static constexpr float rounder = 0x1.8p+23F;
  static constexpr float sine[] = {-0.166666548733002685F, 0.00833217353549626166F,
                                   -0.000195166550433800746F};  // 3.6e-9
  static constexpr float cosine[] = {0.0416666467473967017F, -0.00138873614349370836F,
                                     0.0000244377286253442746F};  // 1e-10
};

template <>
struct TrigonometricConstants<double> {
  using Number = double;
  using Bits = std::uint64_t;
  static constexpr bool is_short = false;
  static constexpr double two_over_pi = 0.63661977236758134308;
  static constexpr double pieces[3] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
  static constexpr double rounder = 0x1.8p+52;
  static constexpr double sine[] = {-0.166666666666666316,    0.00833333333332231317,
                                    -0.000198412698297235503, 2.75573136615068856e-6,
                                    -2.50507531838161692e-8,  1.58965005931046379e-10};  // 3.5e-18
  static constexpr double cosine[] = {0.0416666666666665987,    -0.00138888888888739883,
                                      0.0000248015872893938844, -2.75573143258295247e-7,
                                      2.08757195410711982e-9,   -1.13594481519286497e-11};  // 5e-20
};

template <class Vector>
using ElementOf = std::decay_t<decltype(std::declval<const Vector&>()[0])>;

// A vector of several numbers (the compilers' vector_size) has the constants of one.
template <class Vector>
struct TrigonometricConstants<Vector, std::enable_if_t<sizeof(ElementOf<Vector>) != 0>>
    : TrigonometricConstants<ElementOf<Vector>> {
  typedef typename TrigonometricConstants<ElementOf<Vector>>::Bits Bits __attribute__((vector_size(sizeof(Vector))));
};

// From here on T is a number or a vector of several, whose constants are numbers.

template <class Number, std::size_t N, class T>
AXIAL_INLINE constexpr T horner(const Number (&coefficients)[N], T t) {
  T sum = T{} + coefficients[N - 1];
  for (std::size_t i = N - 1; i-- > 0;)
    sum = sum * t + coefficients[i];
  return sum;
}

// x = quadrant pi/2 + r + low, |r| <= pi/4. What float would gain from `low` is less than half of its last place, so
// there it is zero by type.
template <class T, class Low>
struct Reduced {
  T r;
  Low low;
  typename TrigonometricConstants<T>::Bits quadrant;
};

template <class T>
AXIAL_INLINE constexpr auto reduce(T x) {
  using C = TrigonometricConstants<T>;
  const T shifted = x * C::two_over_pi + C::rounder;
  const T k = shifted - C::rounder;
  const auto quadrant = __builtin_bit_cast(typename C::Bits, shifted);
  const T first = x - k * C::pieces[0];
  const T second = first - k * C::pieces[1];
  if constexpr (C::is_short) {
    return Reduced<T, Zero>{second - k * C::pieces[2], {}, quadrant};
  } else {
    const T low = ((first - second) - k * C::pieces[1]) - k * C::pieces[2];
    const T r = second + low;
    return Reduced<T, T>{r, (second - r) + low, quadrant};
  }
}

// cos(r + low). In double the rounding of 1 - t/2 is put back, which keeps it within 1 ulp; float saves the operations.
template <class T, class Low>
AXIAL_INLINE constexpr T cosine_near_zero(T r, T t, Low low) {
  using C = TrigonometricConstants<T>;
  using Number = typename C::Number;
  const T tail = t * horner(C::cosine, t);
  if constexpr (C::is_short) {
    return Number(1) + t * (Number(-0.5) + tail);
  } else {
    const T half = Number(0.5) * t, leading = Number(1) - half;
    return leading + (((Number(1) - leading) - half) + (t * tail - r * low));
  }
}

// Exchanges the pair in odd quadrants and sets the signs, with integer masks instead of branches.
template <class T, class Bits>
AXIAL_INLINE constexpr SinCos<T> into_quadrant(T sine, T cosine, Bits quadrant) {
  constexpr int sign = static_cast<int>(sizeof(typename TrigonometricConstants<T>::Number)) * 8 - 1;
  const Bits odd = Bits{} - (quadrant & 1u), half = quadrant >> 1;
  const Bits s = __builtin_bit_cast(Bits, sine), c = __builtin_bit_cast(Bits, cosine);
  const Bits exchange = (s ^ c) & odd;
  const Bits sine_bits = (s ^ exchange) ^ (half << sign);
  const Bits cosine_bits = (c ^ exchange) ^ ((half ^ quadrant) << sign);
  return {__builtin_bit_cast(T, sine_bits), __builtin_bit_cast(T, cosine_bits)};
}

template <class T>
AXIAL_INLINE constexpr T and_low(T x, T low) {
  return x + low;
}
template <class T>
AXIAL_INLINE constexpr T and_low(T x, Zero) {
  return x;
}

template <class T>
AXIAL_INLINE constexpr SinCos<T> sincos_of(T x) {
  auto reduced = reduce(x);
  const T r = reduced.r, t = r * r;
  const T sine = r + and_low(r * t * horner(TrigonometricConstants<T>::sine, t), reduced.low);
  const T cosine = cosine_near_zero(r, t, reduced.low);
  return into_quadrant(sine, cosine, reduced.quadrant);
}

}  // namespace detail

/// Sine and cosine of an angle in radians, without branches: the same instructions for every x. NaN and infinities
/// give NaN.
/// double: within 1 ulp for |x| <= 10^6. float: within 1.5 * 2^-24 (absolute) for |x| <= 10^4.
/// Beyond that the reduction loses digits gradually.
template <class T, std::enable_if_t<std::is_floating_point_v<T>, int> = 0>
[[nodiscard]] AXIAL_INLINE constexpr SinCos<T> sincos(T x) {
  return detail::sincos_of(x);
}

namespace detail {

// Several angles at once, where the processor has vector units: on a host a third of the work of a six-joint arm's
// torque is its sines. The same operations in the same order as of one, so the same bits.
#if defined(__SSE2__) || (defined(__aarch64__) && defined(__ARM_NEON))
inline constexpr bool has_vector_units = true;
#else
inline constexpr bool has_vector_units = false;
#endif
#if defined(__AVX2__)
inline constexpr int double_lanes = 4;
#else
inline constexpr int double_lanes = 2;
#endif

template <class T>
struct Packed {
  static constexpr int lanes = std::is_same_v<T, double> ? double_lanes : 4;
  typedef T Values __attribute__((vector_size(lanes * sizeof(T))));
};

/// x as it is, in a register of its own where `apart`, so that angles are not loaded as one wide vector: a processor
/// does not forward narrow stores to a wide load, which would wait until the cache has angles that were just computed.
template <bool apart, class T>
AXIAL_INLINE inline T loaded(T x) {
#ifdef __SSE2__
  if constexpr (apart) asm("" : "+x"(x));
#endif
  return x;
}

/// Angles first, first + 1, ...; lanes beyond the last angle repeat it.
template <int First, class T, int N, int... Lane>
AXIAL_INLINE constexpr void sincos_group(const T (&x)[N], SinCos<T> (&pairs)[N], std::integer_sequence<int, Lane...>) {
  typename Packed<T>::Values values = {loaded<Lane % 2 == 0>(x[First + Lane < N ? First + Lane : N - 1])...};
  auto group = sincos_of(values);
  ((pairs[First + Lane < N ? First + Lane : N - 1] = {group.sin[Lane], group.cos[Lane]}), ...);
}

template <int First, class T, int N>
AXIAL_INLINE constexpr void sincos_groups(const T (&x)[N], SinCos<T> (&pairs)[N]) {
  if constexpr (First < N) {
    sincos_group<First>(x, pairs, std::make_integer_sequence<int, Packed<T>::lanes>{});
    sincos_groups<First + Packed<T>::lanes>(x, pairs);
  }
}

}  // namespace detail

/// Whether packing so many angles of this type is quicker than one after the other: the first joint's pair is often not
/// needed at all, so that two or three are not worth it.
template <class T>
constexpr bool packing_pays(int angles) {
  return detail::has_vector_units && std::is_floating_point_v<T> && angles > 3;
}

/// pairs[i] = sincos(x[i]), in vectors. For processors with vector units only: see packing_pays.
template <class T, int N>
AXIAL_INLINE constexpr void sincos(const T (&x)[N], SinCos<T> (&pairs)[N]) {
  if (__builtin_is_constant_evaluated()) {
    for (int i = 0; i < N; ++i)
      pairs[i] = sincos(x[i]);
  } else {
    detail::sincos_groups<0>(x, pairs);
  }
}

}  // namespace axial

#include <axial/options/end.hpp>

// Sine-cosine pairs of several angles at once, where the processor has vector units: on a host a third of the work of a
// six-joint arm's torque is its sines. The same operations in the same order as sincos.hpp, so the same bits.
#pragma once

#include <axial/scalar/sincos.hpp>

#include <utility>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

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
struct Packed;
template <>
struct Packed<float> {
  static constexpr int lanes = 4;
  typedef float Values __attribute__((vector_size(16)));
};
template <>
struct Packed<double> {
  static constexpr int lanes = double_lanes;
  typedef double Values __attribute__((vector_size(8 * double_lanes)));
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

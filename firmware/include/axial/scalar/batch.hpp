// Several states at once: a number that holds one of each, in the processor's vector units.
#pragma once
#include <axial/scalar/language.hpp>

#include <utility>

#include <axial/scalar/lanes.hpp>
#include <axial/scalar/rounding.hpp>
#include <axial/scalar/sincos.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Lanes of a vector register that holds numbers T.
template <class T>
inline constexpr int native_lanes = detail::vector_bytes / static_cast<int>(sizeof(T));

template <class T, int N, int Bytes = detail::vector_bytes>
class BatchOrdinal;

/// N truths, one per lane: what comparisons of batches say, and what select() takes.
template <class T, int N, int Bytes = detail::vector_bytes>
class BatchMask {
  using Ordinal = BatchOrdinal<T, N, Bytes>;

 public:
  using Lanes = detail::Lanes<detail::WordOf<T>, N, Bytes>;  ///< how they are kept
  constexpr BatchMask() = default;
  /// One decision for all lanes.
  AXIAL_INLINE constexpr BatchMask(bool all)  // NOLINT(google-explicit-constructor): a decision for all is one for each
      : lanes(detail::broadcast<Lanes>(-static_cast<detail::WordOf<T>>(all))) {}
  /// All ones where true, else zero.
  AXIAL_INLINE constexpr explicit BatchMask(const Lanes& words) : lanes(words) {}

  /// Decision of one lane; the index is not checked.
  AXIAL_INLINE constexpr bool operator[](int lane) const { return detail::element(lanes, lane) != 0; }
  /// Lane by lane, as for bool.
  ///@{
  AXIAL_INLINE friend constexpr BatchMask operator&(const BatchMask& a, const BatchMask& b) {
    return BatchMask(detail::lanewise<Lanes>([](auto x, auto y) AXIAL_INLINE { return x & y; }, a.lanes, b.lanes));
  }
  AXIAL_INLINE friend constexpr BatchMask operator|(const BatchMask& a, const BatchMask& b) {
    return BatchMask(detail::lanewise<Lanes>([](auto x, auto y) AXIAL_INLINE { return x | y; }, a.lanes, b.lanes));
  }
  AXIAL_INLINE constexpr BatchMask operator!() const {
    return BatchMask(detail::lanewise<Lanes>([](auto x) AXIAL_INLINE { return ~x; }, lanes));
  }
  ///@}
  /// yes where the condition holds, else no; of integers, of which kernels have constants.
  AXIAL_INLINE friend constexpr Ordinal select(const BatchMask& condition, const Ordinal& yes, const Ordinal& no) {
    return Ordinal(detail::chosen(condition.lanes, yes.lanes, no.lanes));
  }

  Lanes lanes;  ///< all ones where true, else zero
};

/// N integers as wide as T: indices and codes, one per lane.
template <class T, int N, int Bytes>
class BatchOrdinal {
  using Lanes = detail::Lanes<detail::WordOf<T>, N, Bytes>;
  using Mask = BatchMask<T, N, Bytes>;

 public:
  constexpr BatchOrdinal() = default;
  /// One number in all lanes.
  AXIAL_INLINE constexpr BatchOrdinal(int all)  // NOLINT(google-explicit-constructor): kernels count with int
      : lanes(detail::broadcast<Lanes>(static_cast<detail::WordOf<T>>(all))) {}
  AXIAL_INLINE constexpr explicit BatchOrdinal(const Lanes& words) : lanes(words) {}  ///< one per lane

  /// Number of one lane; the index is not checked.
  AXIAL_INLINE constexpr int operator[](int lane) const { return static_cast<int>(detail::element(lanes, lane)); }
  /// Lane by lane.
  AXIAL_INLINE friend constexpr Mask operator!=(const BatchOrdinal& a, const BatchOrdinal& b) {
    return Mask(detail::lanewise<Lanes>([](auto x, auto y) AXIAL_INLINE { return x != y; }, a.lanes, b.lanes));
  }
  /// x < 0.
  AXIAL_INLINE friend constexpr Mask is_negative(const BatchOrdinal& x) {
    return Mask(detail::lanewise<Lanes>([](auto v) AXIAL_INLINE { return v < 0; }, x.lanes));
  }
  /// What has been found (an index, -1 for nothing), or `index` where it is found now.
  AXIAL_INLINE friend constexpr BatchOrdinal first_found(const BatchOrdinal& found, const Mask& now, int index) {
    return select(is_negative(found) & now, BatchOrdinal(index), found);
  }

  Lanes lanes;  ///< one per lane
};

/// N floats or doubles, one per lane; a number of the whole library: what takes `Joints<Robot, double>` takes
/// `Joints<Robot, Batch<double>>` and answers N states at once. Each lane has what one state has, to rounding (the same
/// bits where the compiler fuses no multiply-add), and nothing that one lane holds, NaN included, reaches another.
/// N is a power of two; more than a register holds become several registers, fewer than none does. A program is
/// compiled for one processor: `Bytes` makes batches of different vector units different types, which do not link.
template <class T, int N = native_lanes<T>, int Bytes = detail::vector_bytes>
class Batch {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "axial: a batch holds floats or doubles");
  static_assert(N >= 2 && (N & (N - 1)) == 0, "axial: a batch has 2, 4, 8, ... lanes");
  using Mask = BatchMask<T, N, Bytes>;

 public:
  using Lanes = detail::Lanes<T, N, Bytes>;  ///< how they are kept
  static constexpr int size = N;             ///< number of lanes
  constexpr Batch() = default;
  AXIAL_INLINE constexpr explicit Batch(T all) : lanes(detail::broadcast<Lanes>(all)) {}  ///< one value in all lanes
  AXIAL_INLINE constexpr explicit Batch(const Lanes& values) : lanes(values) {}           ///< one per lane

  /// f(k) in lane k: `Batch<double, 4>::of([&](int k) { return x[k]; })`.
  template <class F>
  [[nodiscard]] AXIAL_INLINE static constexpr Batch of(const F& f) {
    return Batch(detail::generated<Lanes>([&](int lane) AXIAL_INLINE { return static_cast<T>(f(lane)); }));
  }
  AXIAL_INLINE constexpr T operator[](int lane) const { return detail::element(lanes, lane); }  ///< of one lane

  /// Lane by lane.
  ///@{
  AXIAL_INLINE friend constexpr Batch operator+(const Batch& a, const Batch& b) {
    return Batch(detail::lanewise<Lanes>([](auto x, auto y) AXIAL_INLINE { return detail::arithmetic<'+'>(x, y); },
                                         a.lanes, b.lanes));
  }
  AXIAL_INLINE friend constexpr Batch operator-(const Batch& a, const Batch& b) {
    return Batch(detail::lanewise<Lanes>([](auto x, auto y) AXIAL_INLINE { return detail::arithmetic<'-'>(x, y); },
                                         a.lanes, b.lanes));
  }
  AXIAL_INLINE friend constexpr Batch operator*(const Batch& a, const Batch& b) {
    return Batch(detail::lanewise<Lanes>([](auto x, auto y) AXIAL_INLINE { return detail::arithmetic<'*'>(x, y); },
                                         a.lanes, b.lanes));
  }
  AXIAL_INLINE friend constexpr Batch operator/(const Batch& a, const Batch& b) {
    return Batch(detail::lanewise<Lanes>([](auto x, auto y) AXIAL_INLINE { return x / y; }, a.lanes, b.lanes));
  }
  AXIAL_INLINE constexpr Batch operator-() const {
    return Batch(detail::lanewise<Lanes>([](auto x) AXIAL_INLINE { return -x; }, lanes));
  }
  AXIAL_INLINE friend constexpr Mask operator<(const Batch& a, const Batch& b) {
    using Words = typename Mask::Lanes;
    return Mask(detail::lanewise<Words>([](auto x, auto y) AXIAL_INLINE { return x < y; }, a.lanes, b.lanes));
  }
  AXIAL_INLINE friend constexpr Mask operator>(const Batch& a, const Batch& b) { return b < a; }
  ///@}

  /// yes where the condition holds, else no.
  AXIAL_INLINE friend constexpr Batch select(const Mask& condition, const Batch& yes, const Batch& no) {
    return Batch(detail::chosen(condition.lanes, yes.lanes, no.lanes));
  }
  /// x without its sign bit.
  AXIAL_INLINE friend constexpr Batch absolute_of(const Batch& x) {
    return Batch(detail::lanewise<Lanes>([](auto v) AXIAL_INLINE { return detail::without_sign(v); }, x.lanes));
  }

  Lanes lanes;  ///< one per lane
};

/// True in lanes that hold numbers, false for NaN and infinities; looks at the bits, as for one number.
template <class T, int N, int Bytes>
[[nodiscard]] AXIAL_INLINE constexpr BatchMask<T, N, Bytes> is_finite(const Batch<T, N, Bytes>& x) {
  using Mask = BatchMask<T, N, Bytes>;
  return Mask(
      detail::lanewise<typename Mask::Lanes>([](auto v) AXIAL_INLINE { return detail::are_finite(v); }, x.lanes));
}
/// Sines and cosines of the angles in all lanes, in vectors: as of one, with its errors.
template <class T, int N, int Bytes>
[[nodiscard]] AXIAL_INLINE constexpr SinCos<Batch<T, N, Bytes>> sincos(const Batch<T, N, Bytes>& x) {
  auto pair = detail::sincos_of_lanes(x.lanes);
  return {Batch<T, N, Bytes>(pair.sin), Batch<T, N, Bytes>(pair.cos)};
}

/// A batch as a number of kernels.
template <class T, int N, int Bytes>
struct NumberTraits<Batch<T, N, Bytes>> {
  using Number = Batch<T, N, Bytes>;       ///< what kernels compute with
  static constexpr bool is_number = true;  ///< it is a number
  /// the nearest T, in all lanes
  AXIAL_INLINE static constexpr Number constant(double value) { return Number(static_cast<T>(value)); }
  /// distance from 1 to the next T
  AXIAL_INLINE static constexpr Number epsilon() { return Number(std::numeric_limits<T>::epsilon()); }
};
/// What one lane holds.
template <class T, int N, int Bytes>
struct LaneOf<Batch<T, N, Bytes>> {
  using type = T;  ///< one of the numbers
};

}  // namespace axial

#include <axial/options/end.hpp>

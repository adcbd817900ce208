// Whether what went into a kernel and what came out of it are numbers, in each lane of a batch.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/batch/batch_status.hpp>
#include <axial/links/soundness.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Whether |x| > most or x is NaN, lane by lane.
template <class T, int N, int Bytes>
AXIAL_INLINE constexpr BatchMask<T, N, Bytes> is_larger(const Batch<T, N, Bytes>& x, const Batch<T, N, Bytes>& most) {
  return (!is_finite(x)) | (absolute_of(x) > most);
}
/// Whether x < 0, lane by lane.
template <class T, int N, int Bytes>
AXIAL_INLINE constexpr BatchMask<T, N, Bytes> is_below_zero(const Batch<T, N, Bytes>& x) {
  return x < Batch<T, N, Bytes>(T(0));
}

/// soundness_of() per lane: ok, angle_range or not_finite, from the sum of |angles| and of what is 0 or NaN.
template <class T, int N, int Bytes>
AXIAL_INLINE constexpr BatchStatus<T, N, Bytes> soundness_of(const Batch<T, N, Bytes>& all) {
  using Ordinal = BatchOrdinal<T, N, Bytes>;
  const Ordinal broken = static_cast<int>(Status::Code::not_finite),
                large = static_cast<int>(Status::Code::angle_range);
  const auto finite = is_finite(all), exact = !(all > Batch<T, N, Bytes>(largest_angles<T>));
  return {select(finite, select(exact, Ordinal(0), large), broken), -1};
}

}  // namespace axial

#include <axial/options/end.hpp>

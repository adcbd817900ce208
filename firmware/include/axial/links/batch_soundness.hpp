// Whether what went into a kernel and what came out of it are numbers, in each lane of a batch.
#pragma once

#include <axial/links/soundness.hpp>
#include <axial/scene/batch_status.hpp>

#include <axial/options/begin.hpp>

namespace axial {

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

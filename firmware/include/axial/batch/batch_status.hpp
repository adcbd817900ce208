// What an algorithm says of each state of a batch; whether what went in and what came out are numbers, lane by lane.
#pragma once

#include <axial/links/soundness.hpp>
#include <axial/scalar/batch.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// N statuses, one per lane.
template <class T, int N, int Bytes = detail::vector_bytes>
struct BatchStatus {
  BatchOrdinal<T, N, Bytes> code = static_cast<int>(Status::Code::ok);  ///< a Status::Code per lane, as a number
  BatchOrdinal<T, N, Bytes> joint = -1;                                 ///< counted from 0 at the base; -1 for none

  /// Status of one lane; the index is not checked.
  [[nodiscard]] AXIAL_INLINE constexpr Status operator[](int lane) const {
    return status_from(code[lane], joint[lane]);
  }
  /// True where nothing was found in any lane.
  [[nodiscard]] constexpr bool ok() const {
    bool all = true;
    for (int lane = 0; lane < N; ++lane)
      all = all & (code[lane] == static_cast<int>(Status::Code::ok));
    return all;
  }
};
/// One of each per lane.
template <class T, int N, int Bytes>
struct Decisions<Batch<T, N, Bytes>> {
  using Truth = BatchMask<T, N, Bytes>;       ///< what a comparison says
  using Ordinal = BatchOrdinal<T, N, Bytes>;  ///< an index or a code
  using Answer = BatchStatus<T, N, Bytes>;    ///< what an algorithm says besides its numbers
};

/// Statuses of codes and joints.
template <class T, int N, int Bytes>
AXIAL_INLINE constexpr BatchStatus<T, N, Bytes> status_from(const BatchOrdinal<T, N, Bytes>& code,
                                                            const BatchOrdinal<T, N, Bytes>& joint) {
  return {code, joint};
}
/// `found` in lanes where it reports something, about no joint; else `otherwise`.
template <class T, int N, int Bytes>
AXIAL_INLINE constexpr BatchStatus<T, N, Bytes> first_trouble(const BatchStatus<T, N, Bytes>& found,
                                                              const BatchStatus<T, N, Bytes>& otherwise) {
  const auto unsound = found.code != BatchOrdinal<T, N, Bytes>(0);
  return {select(unsound, found.code, otherwise.code), select(unsound, found.joint, otherwise.joint)};
}
/// Replaces the codes where `condition` holds.
template <class T, int N, int Bytes>
AXIAL_INLINE constexpr void put_where(BatchStatus<T, N, Bytes>& status, const BatchMask<T, N, Bytes>& condition,
                                      Status::Code code) {
  status.code = select(condition, BatchOrdinal<T, N, Bytes>(static_cast<int>(code)), status.code);
}

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

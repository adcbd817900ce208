// What an algorithm says of each state of a batch; whether what went in and what came out are numbers, and checks of
// requests and answers, lane by lane.
#pragma once

#include <axial/batch/batch_joints.hpp>
#include <axial/control/limits.hpp>
#include <axial/dynamics/check_finite.hpp>
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

/// check_finite() per lane: ok, or not_finite and the first joint (from the base) of which one of the values is NaN or
/// infinite.
template <class S, class T, int N, int Bytes, class... Values>
[[nodiscard]] constexpr BatchStatus<T, N, Bytes> check_finite(const Joints<S, Batch<T, N, Bytes>>& first,
                                                              const Values&... others) {
  using Ordinal = BatchOrdinal<T, N, Bytes>;
  Ordinal joint = -1;
  for (int i = 0; i < first.size; ++i)
    joint = first_found(joint, !(is_finite(first[i]) & ... & is_finite(others[i])), i);
  const Ordinal broken = static_cast<int>(Status::Code::not_finite);
  return {select(is_negative(joint), Ordinal(0), broken), joint};
}

namespace detail {
// check(k) of every lane.
template <class T, int N, int Bytes, class Check>
constexpr BatchStatus<T, N, Bytes> checked_lanes(const Check& check) {
  const auto part = [&](auto get) {
    using Ordinal = BatchOrdinal<T, N, Bytes>;
    return Ordinal(generated<decltype(Ordinal::lanes)>([&](int k) { return static_cast<WordOf<T>>(get(check(k))); }));
  };
  return {part([](const Status& s) { return static_cast<int>(s.code); }),
          part([](const Status& s) { return s.joint; })};
}
}  // namespace detail

/// check_request() per lane: the first joint with which something is wrong, and what.
template <class S, class T, int N, int Bytes>
[[nodiscard]] constexpr BatchStatus<T, N, Bytes> check_request(
    const Positions<robot_of<S>, Batch<T, N, Bytes>>& q, const Velocities<robot_of<S>, Batch<T, N, Bytes>>& qd,
    const Accelerations<robot_of<S>, Batch<T, N, Bytes>>& qdd) {
  return detail::checked_lanes<T, N, Bytes>(
      [&](int k) { return check_request<S, T>(lane(q, k), lane(qd, k), lane(qdd, k)); });
}
/// check_position() per lane: positions alone.
template <class S, class T, int N, int Bytes>
[[nodiscard]] constexpr BatchStatus<T, N, Bytes> check_position(const Positions<robot_of<S>, Batch<T, N, Bytes>>& q) {
  return detail::checked_lanes<T, N, Bytes>([&](int k) { return check_position<S, T>(lane(q, k)); });
}

}  // namespace axial

#include <axial/options/end.hpp>

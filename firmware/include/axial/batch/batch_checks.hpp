// Checks of requests and answers, one status per lane of a batch.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/batch/batch_joints.hpp>
#include <axial/batch/batch_status.hpp>
#include <axial/control/limits.hpp>
#include <axial/dynamics/check_finite.hpp>

#include <axial/options/begin.hpp>

namespace axial {

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

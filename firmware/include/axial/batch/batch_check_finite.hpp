// Whether the values of each lane of a batch are numbers.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/batch/batch_status.hpp>
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

}  // namespace axial

#include <axial/options/end.hpp>

// What kernels decide about numbers, and the status that it makes: one, or one per lane of a batch.
#pragma once

#include <axial/scene/status.hpp>
#include <type_traits>

#include <axial/options/begin.hpp>

namespace axial {

/// How decisions about numbers T are kept. A batch (batch.hpp) has each of them once per lane.
template <class T>
struct Decisions {
  using Truth = bool;     ///< what a comparison says
  using Ordinal = int;    ///< an index or a code
  using Answer = Status;  ///< what an algorithm says besides its numbers
};
/// Kinds of decisions about numbers T: bool, int and Status for all but batches.
///@{
template <class T>
using Truth = typename Decisions<T>::Truth;
template <class T>
using Ordinal = typename Decisions<T>::Ordinal;
template <class T>
using StatusOf = typename Decisions<T>::Answer;
///@}

namespace detail {
/// What a decision is kept as: bool, though a type may say it, or one per lane.
template <class B>
using Decided = std::conditional_t<std::is_convertible_v<B, bool>, bool, B>;
}  // namespace detail

/// A status of a code and a joint, as numbers.
AXIAL_INLINE constexpr Status status_from(int code, int joint) { return {static_cast<Status::Code>(code), joint}; }
/// A code about the first joint that was found, or ok where none was (-1); without a branch.
AXIAL_INLINE constexpr Status status_of_first(Status::Code code, int joint) {
  return status_from(static_cast<int>(code) & ~(joint >> 31), joint);
}
/// `found` where it reports something, about no joint; else `otherwise`.
AXIAL_INLINE constexpr Status first_trouble(const Status& found, const Status& otherwise) {
  const int unsound = -static_cast<int>(!found.ok());  // all ones: about no joint, and no other code
  const int code = static_cast<int>(found.code) | (static_cast<int>(otherwise.code) & ~unsound);
  return {static_cast<Status::Code>(code), otherwise.joint | unsound};
}
/// Replaces the code where `condition` holds.
AXIAL_INLINE constexpr void put_where(Status& status, bool condition, Status::Code code) {
  const int mask = -static_cast<int>(condition), own = static_cast<int>(status.code);
  status.code = static_cast<Status::Code>((static_cast<int>(code) & mask) | (own & ~mask));
}

}  // namespace axial

#include <axial/options/end.hpp>

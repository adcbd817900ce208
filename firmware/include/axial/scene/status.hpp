// What an algorithm says besides its numbers: a status, or one per lane of a batch; what kernels decide about numbers.
#pragma once

#include <axial/scalar/inline.hpp>

#include <type_traits>

#include <axial/options/begin.hpp>

namespace axial {

/// Result of a check. `joint` names the joint that it is about, -1 for none.
struct Status {
  /// What was found.
  enum class Code : unsigned char {
    ok = 0,                  ///< nothing to report
    near_singular = 1,       ///< forward dynamics: the joint's inertia is lost in rounding
    not_finite = 2,          ///< an input or a result is NaN or infinite
    position_limit = 3,      ///< outside the declared limits
    speed_limit = 4,         ///< outside the declared limits
    acceleration_limit = 5,  ///< outside the declared limits; of fixed-point answers: too far outside to be exact
    effort_limit = 6,        ///< the result was clamped to the declared effort
    payload_limit = 7,       ///< the run-time payload is beyond the declared maximum, or not a number; about no joint
    saturated = 9,           ///< fixed-point forward dynamics: efforts drive this joint beyond the range of its formats
    rescaled = 10,           ///< fixed-point forward dynamics: efforts beyond the declared ones; right, but less exact
    not_ready = 8,           ///< asked before the first good refresh(); about no joint
    input_limit = 11,        ///< a run-time input, a gain or a tool that is none, or beyond what is declared
    angle_range = 12,  ///< sines not exact: in sum beyond 8192 rad in float, 524288 in double; or a pair that is none
    inaccurate = 13,   ///< forward dynamics by elimination: the matrix is too ill-conditioned for the documented error
    effort_rate = 14,  ///< the change of this joint's effort was limited to the declared step
    command_limit =
        15,  ///< the position told to this joint's drive was limited to its range, or its offset to the largest
    current_limit = 16,  ///< this joint's effort was limited to the current that the heat of its winding allows
  };
  Code code = Code::ok;  ///< what was found
  int joint = -1;        ///< counted from 0 at the base; -1 for none

  [[nodiscard]] AXIAL_INLINE constexpr bool ok() const { return code == Code::ok; }  ///< true where nothing was found
  /// True where the answer is that of the request, though its efforts may have been limited.
  [[nodiscard]] AXIAL_INLINE constexpr bool met() const {
    return code == Code::ok || code == Code::effort_limit || code == Code::effort_rate || code == Code::command_limit ||
           code == Code::current_limit;
  }
};

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

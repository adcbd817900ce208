// What the codes of a status mean, as text.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What a code means, in one English sentence without a full stop; never a null pointer, nothing allocated. A number
/// that is no code has a text too. Links only where it is called.
[[nodiscard]] constexpr const char* status_text(Status::Code code) {
  using Code = Status::Code;
  switch (code) {
    case Code::ok:
      return "ok";
    case Code::near_singular:
      return "near singular: the joint's inertia is lost in rounding";
    case Code::not_finite:
      return "an input or a result is NaN or infinite";
    case Code::position_limit:
      return "position outside the declared limits";
    case Code::speed_limit:
      return "speed outside the declared limit";
    case Code::acceleration_limit:
      return "acceleration outside the declared limit";
    case Code::effort_limit:
      return "effort clamped to the declared limit";
    case Code::payload_limit:
      return "payload beyond the declared maximum";
    case Code::not_ready:
      return "asked before the first good refresh";
    case Code::saturated:
      return "efforts drive the joint beyond the range of its formats";
    case Code::rescaled:
      return "efforts beyond the declared ones: right, but less exact";
    case Code::input_limit:
      return "a run-time input is beyond the declared limit";
    case Code::angle_range:
      return "an angle of so many turns that its sine is not exact";
    case Code::inaccurate:
      return "the inertia matrix is too ill-conditioned for the documented error";
    case Code::effort_rate:
      return "change of effort limited to the declared step";
    case Code::command_limit:
      return "position command limited to the joint's range or to the largest offset";
    case Code::current_limit:
      return "effort limited to the current that the winding's heat allows";
  }
  return "unknown status code";
}
/// What the status' code means; the joint is the caller's to print.
[[nodiscard]] constexpr const char* status_text(const Status& status) { return status_text(status.code); }

}  // namespace axial

#include <axial/options/end.hpp>

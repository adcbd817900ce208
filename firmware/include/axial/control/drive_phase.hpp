// When drives may exert a torque, and which part of it: the times of a fall-back, apart from any robot.
#pragma once
#include <axial/scalar/language.hpp>

#include <cstdint>

#include <axial/scalar/inline.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What the drives are doing.
enum class DrivePhase : unsigned char {
  idle = 0,      ///< disabled; the first good request enables them
  running = 1,   ///< they follow requests
  fading = 2,    ///< requests stopped: acceleration and speed leave the torque along a ramp
  holding = 3,   ///< what holds the arm at the last position
  disabled = 4,  ///< nobody came back: disabled until rearm()
};

/// How long a fall-back waits, fades and holds, in control ticks; each at least 1.
struct FallBackTimes {
  std::uint16_t patience = 20;  ///< ticks without a good request that running tolerates
  std::uint16_t ramp = 50;      ///< ticks in which the motion's share of the torque goes from all to none
  std::uint16_t hold = 1000;    ///< ticks that the arm is held before its drives are disabled
};

/// The phases and their clock. Requests and ticks are events; every transition stands in one of the members.
class DrivePhases {
 public:
  [[nodiscard]] AXIAL_INLINE constexpr DrivePhase phase() const { return phase_; }  ///< the present one
  [[nodiscard]] constexpr std::uint32_t age() const {
    return ticks_;
  }  ///< ticks in this phase; running: since the last good request
  /// Whether the drives are to be enabled.
  [[nodiscard]] AXIAL_INLINE constexpr bool enabled() const {
    return phase_ != DrivePhase::idle && phase_ != DrivePhase::disabled;
  }

  /// A good request: the drives follow it, from whatever phase but `disabled`; false there.
  [[nodiscard]] constexpr bool follow() {
    if (phase_ == DrivePhase::disabled) return false;
    enter(DrivePhase::running, 0);
    return true;
  }

  /// Something to hold at before any good request: from idle the drives hold, and the time to hold begins. Nothing
  /// happens in other phases; false there.
  [[nodiscard]] constexpr bool hold() {
    if (phase_ != DrivePhase::idle) return false;
    enter(DrivePhase::holding, 0);
    return true;
  }

  /// `ticks` control ticks have passed; what is late is caught up, whatever the number.
  constexpr void advance(const FallBackTimes& times, std::uint32_t ticks) {
    constexpr std::uint32_t most = 0xFFFFFFFFu;
    ticks_ = ticks > most - ticks_ ? most : ticks_ + ticks;
    leave(DrivePhase::running, times.patience, DrivePhase::fading);
    leave(DrivePhase::fading, times.ramp, DrivePhase::holding);
    leave(DrivePhase::holding, times.hold, DrivePhase::disabled);
  }

  /// A controlled stop came to rest: from fading the drives hold, and the time to hold begins.
  constexpr void rest() {
    if (phase_ == DrivePhase::fading) enter(DrivePhase::holding, 0);
  }

  /// Somebody asks for the drives again: from disabled to idle. An arm that is held stays held.
  constexpr void rearm() {
    if (phase_ == DrivePhase::disabled) enter(DrivePhase::idle, 0);
  }

  /// The motion's share of the torque in 2^-16: all (65536) while running, falling in equal steps along the ramp, none
  /// after it.
  [[nodiscard]] constexpr std::uint32_t share(const FallBackTimes& times) const {
    constexpr std::uint32_t all = 1u << 16;
    if (phase_ == DrivePhase::running) return all;
    if (phase_ != DrivePhase::fading || ticks_ >= times.ramp) return 0;
    return (times.ramp - ticks_) * all / times.ramp;
  }

 private:
  constexpr void enter(DrivePhase phase, std::uint32_t ticks) {
    phase_ = phase;
    ticks_ = ticks;
  }
  constexpr void leave(DrivePhase from, std::uint32_t after, DrivePhase to) {
    if (phase_ == from && ticks_ >= after) enter(to, ticks_ - after);
  }

  DrivePhase phase_ = DrivePhase::idle;
  std::uint32_t ticks_ = 0;
};

}  // namespace axial

#include <axial/options/end.hpp>

// Phases and their clock, tick by tick: proofs by the compiler.
#include <axial/control/drive_phase.hpp>

namespace axial {
namespace {

using Phase = DrivePhase;
constexpr FallBackTimes times{3, 4, 5};

/// Phases after a good request and `ticks` ticks, one at a time or at once.
constexpr DrivePhases after(std::uint32_t ticks, bool at_once = false) {
  DrivePhases phases;
  if (!phases.follow()) return {};
  if (at_once) phases.advance(times, ticks);
  for (std::uint32_t i = 0; !at_once && i < ticks; ++i)
    phases.advance(times, 1);
  return phases;
}
constexpr Phase phase_after(std::uint32_t ticks) { return after(ticks).phase(); }

// Each threshold, on both sides: 3 ticks of patience, 4 of ramp, 5 of hold.
static_assert(phase_after(0) == Phase::running && phase_after(2) == Phase::running);
static_assert(phase_after(3) == Phase::fading && phase_after(6) == Phase::fading);
static_assert(phase_after(7) == Phase::holding && phase_after(11) == Phase::holding);
static_assert(phase_after(12) == Phase::disabled && phase_after(1000) == Phase::disabled);

constexpr bool late_ticks_are_caught_up() {
  for (std::uint32_t ticks = 0; ticks < 20; ++ticks) {
    const DrivePhases late = after(ticks, true), punctual = after(ticks);
    if (late.phase() != punctual.phase() || late.age() != punctual.age()) return false;
  }
  return after(0xFFFFFFFF, true).phase() == Phase::disabled;
}
static_assert(late_ticks_are_caught_up());

// The clock never wraps back into an earlier phase.
constexpr bool the_clock_stays_at_its_end() {
  DrivePhases phases;
  if (!phases.follow()) return false;
  constexpr FallBackTimes patient{65535, 1, 1};
  phases.advance(patient, 65534);
  phases.advance(patient, 0xFFFFFFFF);
  return phases.phase() == Phase::disabled;
}
static_assert(the_clock_stays_at_its_end());

constexpr bool share_is(std::uint32_t ticks, std::uint32_t share) { return after(ticks).share(times) == share; }
static_assert(share_is(0, 65536) && share_is(2, 65536), "all while running");
static_assert(share_is(3, 65536) && share_is(4, 49152) && share_is(5, 32768) && share_is(6, 16384), "equal steps");
static_assert(share_is(7, 0) && share_is(12, 0), "none once it is held");

constexpr bool longest_ramp_does_not_overflow() {
  constexpr FallBackTimes slow{1, 65535, 1};
  DrivePhases phases;
  if (!phases.follow()) return false;
  phases.advance(slow, 1);
  std::uint32_t last = phases.share(slow);
  if (last != 65536) return false;
  for (int i = 0; i < 1000; ++i) {
    phases.advance(slow, 65);
    const std::uint32_t now = phases.share(slow);
    if (now >= last || last - now > 66) return false;
    last = now;
  }
  return true;
}
static_assert(longest_ramp_does_not_overflow());

// Times may change while it fades: what is past the new ramp is past.
constexpr bool a_shorter_ramp_is_over() {
  const FallBackTimes shorter{3, 2, 5};
  return after(4).share(shorter) == 32768 && after(5).share(shorter) == 0 && after(6).share(shorter) == 0;
}
static_assert(a_shorter_ramp_is_over());

constexpr bool enabled_in(Phase phase) {
  DrivePhases phases;
  if (phase != Phase::idle && !phases.follow()) return false;
  for (int i = 0; phases.phase() != phase && i < 100; ++i)
    phases.advance(times, 1);
  return phases.phase() == phase && phases.enabled();
}
static_assert(!enabled_in(Phase::idle) && !enabled_in(Phase::disabled));
static_assert(enabled_in(Phase::running) && enabled_in(Phase::fading) && enabled_in(Phase::holding));

// A good request: from every phase but disabled, and its clock starts anew.
constexpr bool follows_after(std::uint32_t ticks) {
  DrivePhases phases = after(ticks);
  return phases.follow() && phases.phase() == Phase::running && phases.age() == 0;
}
static_assert(follows_after(2) && follows_after(4) && follows_after(8));
static_assert(!follows_after(12));
constexpr bool disabled_stays_disabled() {
  DrivePhases phases = after(12);
  if (phases.follow() || phases.hold()) return false;
  phases.advance(times, 100);
  return phases.phase() == Phase::disabled;
}
static_assert(disabled_stays_disabled());

constexpr bool rearmed_is(std::uint32_t ticks, Phase phase, bool follows) {
  DrivePhases phases = after(ticks);
  phases.rearm();
  return phases.phase() == phase && phases.follow() == follows;
}
static_assert(rearmed_is(12, Phase::idle, true), "rearm() is the way out of disabled");
static_assert(rearmed_is(0, Phase::running, true) && rearmed_is(4, Phase::fading, true), "what is held stays held");
static_assert(rearmed_is(8, Phase::holding, true));

// Holding without a good request: from idle alone, for the whole time to hold; idle itself waits for ever.
constexpr Phase held_for(std::uint32_t ticks) {
  DrivePhases phases;
  phases.advance(times, 1000);
  if (phases.phase() != Phase::idle || !phases.hold()) return Phase::disabled;
  phases.advance(times, ticks);
  return phases.phase();
}
static_assert(held_for(0) == Phase::holding && held_for(4) == Phase::holding && held_for(5) == Phase::disabled);
constexpr bool holds_after(std::uint32_t ticks) {
  DrivePhases phases = after(ticks);
  const Phase before = phases.phase();
  return phases.hold() || phases.phase() != before;
}
static_assert(!holds_after(0) && !holds_after(4) && !holds_after(8) && !holds_after(12));

}  // namespace
}  // namespace axial

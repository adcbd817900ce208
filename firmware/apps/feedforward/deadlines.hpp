#pragma once
/// Times of the main job, in ticks of the board, and what a tick may cost.

#include <cstdint>

#include <axial/control/drive_phase.hpp>

#include <hal/clock.hpp>
#include <hal/counter.hpp>
#include <hal/link/messages.hpp>

namespace axial::apps {

/// Ticks without a good set-point after which a free-running image falls back. Reports come at this distance.
constexpr std::uint16_t watchdog_ticks = 20;
static_assert(hal::link::sequence_window <= watchdog_ticks,
              "A wrong number that was believed blocks no set-points for longer than the fall-back waits.");
/// A loop that does not feed the watchdog of the hardware for so long restarts the board.
constexpr std::uint32_t hardware_watchdog_ms = 100;
/// After a missed deadline so many ticks must be met before the watchdog is fed again: a loop that is late again and
/// again starves it.
constexpr std::uint32_t recovery_ticks = 4;
/// In lock-step the host's own time counts too: a simulation may take its time over a step.
constexpr std::uint32_t lock_step_patience_ms = 1000;
constexpr std::uint32_t ramp_ms = 100, hold_ms = 2000;

constexpr std::uint16_t ticks_of(std::uint32_t ms, std::uint32_t tick_Hz) {
  return static_cast<std::uint16_t>((ms * tick_Hz + 999) / 1000);
}

/// Of a board whose tick comes at `tick_Hz`.
constexpr FallBackTimes fall_back_times(hal::link::Mode mode, std::uint32_t tick_Hz) {
  const bool free = mode == hal::link::Mode::free_running;
  return {free ? watchdog_ticks : ticks_of(lock_step_patience_ms, tick_Hz), ticks_of(ramp_ms, tick_Hz),
          ticks_of(hold_ms, tick_Hz)};
}

/// What code may count, at most, to end within a tick: `Board::count` masks the tick's interrupt, so a tick that it
/// hides is seen here. No limit where nothing counts.
template <class Board>
std::uint32_t counts_a_tick() {
  switch (Board::counter_scale().kind) {
    case hal::CounterKind::cycles:
      return Board::clock().core_Hz / Board::tick_Hz;
    case hal::CounterKind::instructions:
      return Board::Counter::per_second / Board::tick_Hz;
    default:
      return 0xFFFFFFFF;
  }
}

}  // namespace axial::apps

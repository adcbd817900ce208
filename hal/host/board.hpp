#pragma once
/// A board inside a host program: two byte queues for the serial port, a tick that the test advances, no counter.
/// All state is static, as a board's is; `fresh()` gives a new one. What leads to a restart returns here: the test sees
/// it in `state.restarts` and decides what comes next.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include <hal/clock.hpp>
#include <hal/counter.hpp>
#include <hal/failure.hpp>
#include <hal/fault_report.hpp>

namespace axial::hal {

/// A change of the drives' pin.
struct DriveChange {
  std::uint32_t tick;
  bool on;
};

struct HostBoardState {
  std::deque<std::uint8_t> to_board, from_board;
  std::uint32_t ticks = 0, overruns = 0, tick_rate_Hz = 0, entropy = 0;
  std::uint32_t count = 0;  ///< what measured code costs
  CounterKind counter = CounterKind::none;
  std::string printed;
  bool exited = false;
  bool asleep = false;  ///< a board would sleep until more comes
  int exit_code = 0;
  ClockReport clock{ClockSource::internal, 0, 0};

  bool drives = false;
  std::vector<DriveChange> drive_changes;
  std::uint32_t watchdog_ms = 0;  ///< 0: not started
  std::uint32_t feeds = 0;        ///< times that the watchdog was fed
  std::uint32_t fed_tick = 0;     ///< tick of the last time, or of its start
  ResetCause cause = ResetCause::power_on;
  FaultReport report{};  ///< what a failure leaves for the next start
  bool guarded = false, intact = true;
  std::uint32_t stack_bytes = 0;  ///< what `measure_stack` finds
  int stack_looks = 0;            ///< calls of it before it does
  unsigned restarts = 0;
};

struct HostBoard {
  static constexpr const char* name = "host";
  static constexpr std::uint32_t baud = 2'000'000, tick_Hz = 1000;

  inline static HostBoardState state{};

  static void fresh() { state = {}; }
  /// Power-on state but for what a reset keeps: the report and the count of restarts.
  static void boot() {
    HostBoardState next{};
    next.report = state.report;
    next.restarts = state.restarts;
    state = std::move(next);
  }

  static void start() {
    enable_drives(false);
    state.cause = take_cause(state.report, state.cause);
  }
  static const ClockReport& clock() { return state.clock; }
  static std::uint32_t baud_running() { return baud; }

  static bool read(std::uint8_t& byte) {
    if (state.to_board.empty()) return false;
    byte = state.to_board.front();
    state.to_board.pop_front();
    return true;
  }
  static bool write(const std::uint8_t* bytes, std::size_t count) {
    state.from_board.insert(state.from_board.end(), bytes, bytes + count);
    return true;
  }
  static bool serial_idle() { return state.to_board.empty(); }
  static std::uint32_t overruns() { return state.overruns; }

  static void start_tick(std::uint32_t rate_Hz) { state.tick_rate_Hz = rate_Hz; }
  static void stop_tick() { state.tick_rate_Hz = 0; }
  static std::uint32_t ticks() { return state.ticks; }
  static std::uint32_t entropy() { return ++state.entropy; }

  /// A host test never sleeps: its step returns and the test decides what comes next.
  template <class Predicate>
  static void sleep_unless(Predicate busy) {
    state.asleep = !busy();
  }

  struct Counter {
    static constexpr std::uint32_t per_second = 1'000'000'000u / 64;
    static std::uint32_t count(Measured code, void* argument) {
      code(argument);
      return state.count;
    }
  };
  static CounterScale counter_scale() { return {state.counter, 1, 1}; }
  static std::uint32_t empty_bracket() { return 0; }
  template <class Code>
  static std::uint32_t count(Code& code) {
    code();
    return state.count;
  }

  static void enable_drives(bool on) {
    if (state.drives != on) state.drive_changes.push_back({state.ticks, on});
    state.drives = on;
  }
  static bool drives_enabled() { return state.drives; }
  static bool drive_pin() { return state.drives; }

  static void start_watchdog(std::uint32_t ms) {
    state.watchdog_ms = ms;
    state.fed_tick = state.ticks;
  }
  static void feed_watchdog() {
    ++state.feeds;
    state.fed_tick = state.ticks;
  }
  /// Whether a watchdog of hardware would have restarted the board by now.
  static bool watchdog_expired() {
    return state.watchdog_ms != 0 &&
           std::uint64_t{state.ticks - state.fed_tick} * 1000 >= std::uint64_t{state.watchdog_ms} * tick_Hz;
  }

  static ResetCause reset_cause() { return state.cause; }
  static const FaultReport& last_fault() { return state.report; }
  static bool guard_stack() {
    state.guarded = true;
    return true;
  }
  static bool guarded() { return state.guarded; }
  static bool stack_intact() { return state.intact; }

  static void fail(ResetCause cause) {
    FaultReport report{};
    report.cause = cause;
    give_up<HostBoard>(report, state.report);
  }
  static void reset() { fail(ResetCause::software); }
  static void describe(const FaultReport&) {}
  static void restart() { ++state.restarts; }

  static bool measure_stack(std::uint32_t& bytes) {
    bytes = state.stack_bytes;
    if (state.stack_looks == 0) return true;
    --state.stack_looks;
    return false;
  }
  static void print(const char* text) { state.printed += text; }
  static void exit(int code) {
    state.exited = true;
    state.exit_code = code;
  }
};

}  // namespace axial::hal

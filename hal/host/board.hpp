#pragma once
/// A board inside a host program: two byte queues for the serial port, a tick that the test advances, no counter.
/// All state is static, as a board's is; `reset()` gives a fresh one.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include <hal/clock.hpp>
#include <hal/counter.hpp>

namespace axial::hal {

struct HostBoardState {
  std::deque<std::uint8_t> to_board, from_board;
  std::uint32_t ticks = 0, overruns = 0, tick_rate_Hz = 0;
  std::string printed;
  bool exited = false;
  int exit_code = 0;
  ClockReport clock{ClockSource::internal, 0, 0};
};

struct HostBoard {
  static constexpr const char* name = "host";
  static constexpr std::uint32_t baud = 2'000'000, tick_Hz = 1000;

  inline static HostBoardState state{};

  static void reset() { state = {}; }

  static void start() {}
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

  /// A host test never sleeps: its step returns and the test decides what comes next.
  template <class Predicate>
  static void sleep_unless(Predicate) {}

  static CounterScale counter_scale() { return {CounterKind::none, 0, 0}; }
  static std::uint32_t empty_bracket() { return 0; }
  template <class Code>
  static std::uint32_t count(Code& code) {
    code();
    return 0;
  }

  static std::uint32_t stack_used_bytes() { return 0; }
  static void print(const char* text) { state.printed += text; }
  static void exit(int code) {
    state.exited = true;
    state.exit_code = code;
  }
};

}  // namespace axial::hal

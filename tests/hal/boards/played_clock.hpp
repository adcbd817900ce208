#pragma once
/// A clock controller that plays a sound board, a broken crystal, a broken PLL or an emulator.

#include <cstdint>
#include <functional>

#include <gtest/gtest.h>

#include <hal/clock.hpp>

namespace axial::hal {

/// A register whose reads answer from what was written.
struct Played {
  using Answer = std::function<std::uint32_t(std::uint32_t)>;
  std::uint32_t written = 0;
  Answer answer;
  void operator=(std::uint32_t value) { written = value; }
  operator std::uint32_t() const { return answer ? answer(written) : written; }
};

struct Rcc {
  Played control, pll, configuration;
};
struct Flash {
  Played access_control;
};

constexpr std::uint32_t internal_ready = 1u << 1, crystal_on = 1u << 16, pll_on = 1u << 24, switch_mask = 3u;

/// Both families place these bits alike: a ready flag follows its on bit, the status of the switch the switch.
inline Rcc board(bool crystal_works, bool pll_works) {
  Rcc rcc;
  rcc.control.answer = [crystal_works, pll_works](std::uint32_t value) {
    value |= internal_ready;
    if (crystal_works && (value & crystal_on) != 0) value |= crystal_on << 1;
    if (pll_works && (value & pll_on) != 0) value |= pll_on << 1;
    return value;
  };
  rcc.configuration.answer = [](std::uint32_t value) { return value | (value & switch_mask) << 2; };
  return rcc;
}

/// QEMU: every register reads 0.
inline Rcc emulator() {
  Rcc rcc;
  rcc.control.answer = rcc.configuration.answer = [](std::uint32_t) { return 0u; };
  return rcc;
}

inline void expect_clock(const ClockReport& report, ClockSource source, std::uint32_t core_Hz, std::uint32_t uart_Hz) {
  EXPECT_EQ(report.source, source);
  EXPECT_EQ(report.core_Hz, core_Hz);
  EXPECT_EQ(report.uart_Hz, uart_Hz);
}

}  // namespace axial::hal

#include <hal/fault_report.hpp>

#include <cstring>
#include <utility>

#include <gtest/gtest.h>

namespace axial::hal {
namespace {

FaultReport example(std::uint32_t mark) {
  FaultReport report{0, ResetCause::stack_overflow, 3, 0x08001234, 0x08000FFF, 0x20000040, 0x82, 0x40000000, 0x20000010,
                     0};
  seal(report, mark);
  return report;
}

TEST(FaultReport, IsSoundOnceSealed) {
  EXPECT_TRUE(sound(example(FaultReport::fresh)));
  EXPECT_TRUE(sound(example(FaultReport::told)));
  EXPECT_FALSE(sound(example(0))) << "a mark that nobody writes";
  EXPECT_FALSE(sound(FaultReport{})) << "memory of zeros";
}

TEST(FaultReport, NoBitChangesUnseen) {
  constexpr std::size_t words = sizeof(FaultReport) / sizeof(std::uint32_t);
  for (std::size_t bit = 0; bit < 32 * words; ++bit) {
    FaultReport report = example(FaultReport::fresh);
    std::uint32_t raw[words];
    std::memcpy(raw, &report, sizeof report);
    raw[bit / 32] ^= 1u << (bit % 32);
    std::memcpy(&report, raw, sizeof report);
    EXPECT_FALSE(sound(report)) << "bit " << bit % 32 << " of word " << bit / 32;
  }
}

TEST(FaultReport, NoTwoWordsChangePlacesUnseen) {
  constexpr std::size_t words = sizeof(FaultReport) / sizeof(std::uint32_t);
  for (std::size_t first = 0; first < words; ++first)
    for (std::size_t second = first + 1; second < words; ++second) {
      FaultReport report = example(FaultReport::fresh);
      std::uint32_t raw[words];
      std::memcpy(raw, &report, sizeof report);
      if (raw[first] == raw[second]) continue;
      std::swap(raw[first], raw[second]);
      std::memcpy(&report, raw, sizeof report);
      EXPECT_FALSE(sound(report)) << "words " << first << " and " << second;
    }
}

TEST(FaultReport, IsToldOnce) {
  FaultReport kept = example(FaultReport::fresh);
  EXPECT_EQ(take_cause(kept, ResetCause::software), ResetCause::stack_overflow);
  EXPECT_TRUE(sound(kept)) << "what it says can still be read";
  EXPECT_EQ(kept.program_counter, 0x08001234u);
  EXPECT_EQ(take_cause(kept, ResetCause::watchdog), ResetCause::watchdog) << "the next reset has another reason";
}

TEST(FaultReport, OneThatDoesNotMatchItsCheckWordIsNotBelieved) {
  FaultReport kept = example(FaultReport::fresh);
  kept.cause = ResetCause::watchdog;
  EXPECT_EQ(take_cause(kept, ResetCause::software), ResetCause::unknown);
  EXPECT_FALSE(sound(kept));
  EXPECT_EQ(take_cause(kept, ResetCause::software), ResetCause::software);
}

TEST(FaultReport, MemoryAfterPowerOnIsNoReport) {
  FaultReport kept{};
  EXPECT_EQ(take_cause(kept, ResetCause::power_on), ResetCause::power_on);
}

}  // namespace
}  // namespace axial::hal

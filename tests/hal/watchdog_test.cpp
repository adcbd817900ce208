#include <hal/cmsdk/watchdog.hpp>
#include <hal/nrf51/watchdog.hpp>
#include <hal/stm32/watchdog.hpp>

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace axial::hal {
namespace {

/// Every store to a watchdog's registers, in order.
struct Log {
  using Store = std::pair<const char*, std::uint32_t>;
  inline static std::vector<Store> stores;
};

struct Played {
  const char* name;
  std::uint32_t reads = 0;
  void operator=(std::uint32_t value) { Log::stores.push_back({name, value}); }
  operator std::uint32_t() const { return reads; }
};

template <class Registers>
struct Port {
  static constexpr std::uint32_t clock_Hz = 32'000;
  inline static Registers played{};
  static Registers& registers() { return played; }
};

struct Independent {
  Played key{"key"}, prescaler{"prescaler"}, reload{"reload"};
  struct {
    unsigned busy = 3, looks = 0;
    operator std::uint32_t() { return ++looks > busy ? 0u : 3u; }
  } status;
};

/// RM0090, the chapter on the independent watchdog: start, unlock, prescaler, reload, wait, feed.
TEST(Stm32Watchdog, StartsAsTheManualSays) {
  Log::stores.clear();
  stm32::Watchdog<Port<Independent>>::start(100);
  const std::vector<Log::Store> expected{
      {"key", 0xCCCC}, {"key", 0x5555}, {"prescaler", 0}, {"reload", 799}, {"key", 0xAAAA}};
  EXPECT_EQ(Log::stores, expected);
  EXPECT_EQ(Port<Independent>::played.status.looks, 4u) << "waits while the registers are taken over";
  Log::stores.clear();
  stm32::Watchdog<Port<Independent>>::feed();
  EXPECT_EQ(Log::stores, (std::vector<Log::Store>{{"key", 0xAAAA}}));
}

/// (reload + 1) * 4 * 2^prescaler clocks are the time or at most one count more; no coarser prescaler than needed.
TEST(Stm32Watchdog, TimeIsNeverTooShort) {
  for (const std::uint32_t clock_Hz : {32'000u, 40'000u}) {
    for (std::uint32_t ms = 1; ms <= 20'000; ms += ms / 100 + 1) {
      const stm32::WatchdogTime time = stm32::watchdog_time(clock_Hz, ms);
      const std::uint32_t count = 4u << time.prescaler, clocks = (time.reload + 1) * count;
      EXPECT_GE(clocks, clock_Hz / 1000 * ms) << ms;
      EXPECT_LT(clocks, clock_Hz / 1000 * ms + count) << ms;
      EXPECT_LE(time.reload, 0xFFFu);
      if (time.prescaler > 0) {
        EXPECT_GT(clock_Hz / 1000 * ms, 4096 * (count / 2)) << ms;
      }
    }
  }
  EXPECT_EQ(stm32::watchdog_time(32'000, 60'000).reload, 0xFFFu) << "the longest there is";
  EXPECT_EQ(stm32::watchdog_time(32'000, 60'000).prescaler, 6u);
}

TEST(Stm32ResetFlags, NameTheReason) {
  constexpr std::uint32_t pin = 1u << 26;  // accompanies every other
  EXPECT_EQ(stm32::reset_cause(pin), ResetCause::power_on);
  EXPECT_EQ(stm32::reset_cause(pin | 1u << 27), ResetCause::power_on);
  EXPECT_EQ(stm32::reset_cause(pin | 1u << 28), ResetCause::software);
  EXPECT_EQ(stm32::reset_cause(pin | 1u << 29), ResetCause::watchdog);
  EXPECT_EQ(stm32::reset_cause(pin | 1u << 30), ResetCause::watchdog);
  EXPECT_EQ(stm32::reset_cause(pin | 1u << 31), ResetCause::unknown);
}

TEST(Stm32ResetFlags, AreClearedForTheNextReset) {
  std::uint32_t status = 1u << 29 | 1u << 26 | 3u;
  EXPECT_EQ(stm32::take_reset_flags(status), ResetCause::watchdog);
  EXPECT_NE(status & 1u << 24, 0u);
}

struct Nordic {
  Played reload{"reload"}, requests_enabled{"requests"}, configuration{"configuration"}, start{"start"};
  Played request[1]{{"feed"}};
};

/// nRF51 reference manual, the chapter on the watchdog: nothing can be changed once it runs.
TEST(Nrf51Watchdog, StartsLast) {
  Log::stores.clear();
  nrf51::Watchdog<Port<Nordic>>::start(1000);
  nrf51::Watchdog<Port<Nordic>>::feed();
  const std::vector<Log::Store> expected{
      {"reload", 32767}, {"requests", 1}, {"configuration", 1}, {"start", 1}, {"feed", 0x6E524635}};
  EXPECT_EQ(Log::stores, expected);
}

TEST(Nrf51Watchdog, TimeIsNeverTooShort) {
  EXPECT_EQ(nrf51::watchdog_reload(0), 15u) << "the least that the part takes";
  for (std::uint32_t ms = 1; ms <= 100'000; ms += ms / 100 + 1)
    EXPECT_GE((nrf51::watchdog_reload(ms) + 1.0) / 32.768, ms);
}

TEST(Nrf51ResetFlags, NameTheReasonAndAreCleared) {
  EXPECT_EQ(nrf51::reset_cause(0), ResetCause::power_on);
  EXPECT_EQ(nrf51::reset_cause(1u << 0), ResetCause::power_on);
  EXPECT_EQ(nrf51::reset_cause(1u << 2), ResetCause::software);
  EXPECT_EQ(nrf51::reset_cause(1u << 3), ResetCause::fault);
  EXPECT_EQ(nrf51::reset_cause(1u << 16), ResetCause::unknown);
  Played reasons{"reasons", 1u << 1 | 1u << 2};
  Log::stores.clear();
  EXPECT_EQ(nrf51::take_reset_flags(reasons), ResetCause::watchdog) << "before what came with it";
  EXPECT_EQ(Log::stores, (std::vector<Log::Store>{{"reasons", 6}})) << "written ones clear";
}

struct Cmsdk {
  Played load{"load"}, control{"control"}, clear{"clear"}, lock{"lock"};
};

TEST(CmsdkWatchdog, IsLockedWhenNobodyFeedsIt) {
  Log::stores.clear();
  cmsdk::Watchdog<Port<Cmsdk>>::start(500);
  cmsdk::Watchdog<Port<Cmsdk>>::feed();
  const std::vector<Log::Store> expected{{"lock", 0x1ACCE551}, {"load", 16'000}, {"control", 3}, {"lock", 1},
                                         {"lock", 0x1ACCE551}, {"clear", 1},     {"lock", 1}};
  EXPECT_EQ(Log::stores, expected);
}

}  // namespace
}  // namespace axial::hal

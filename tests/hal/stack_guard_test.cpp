#include <hal/cortex_m/faults.hpp>
#include <hal/cortex_m/stack_guard.hpp>
#include <hal/riscv/stack_guard.hpp>
#include <hal/riscv/trap.hpp>

#include <gtest/gtest.h>

namespace axial::hal {
namespace {

using namespace cortex_m;

/// DDI 0403E, B3.5.9: never execute, read-only for all, size 2^(4 + 1), enabled.
TEST(StackGuard, RegionOfArmv7) {
  const RegionWords words = read_only_v7(0x20000000, 32);
  EXPECT_EQ(words.base, 0x20000000u);
  EXPECT_EQ(words.attributes & 1u, 1u) << "enabled";
  EXPECT_EQ(words.attributes >> 1 & 0x1Fu, 4u) << "32 bytes";
  EXPECT_EQ(words.attributes >> 8 & 0xFFu, 0u) << "no part left out";
  EXPECT_EQ(words.attributes >> 24 & 7u, 6u) << "nobody writes";
  EXPECT_EQ(words.attributes >> 28 & 1u, 1u) << "nobody executes";
  EXPECT_EQ(read_only_v7(0, 1024).attributes >> 1 & 0x1Fu, 9u);
}

/// DDI 0419, B3.5: a region of 2^(7 + 1) bytes, whose bits 8 to 15 leave out an eighth each; C alone is normal memory.
TEST(StackGuard, RegionOfArmv6) {
  const RegionWords first = read_only_v6(0x20000000, 32), last = read_only_v6(0x200001E0, 32);
  EXPECT_EQ(first.base, 0x20000000u);
  EXPECT_EQ(first.attributes, 1u << 28 | 6u << 24 | 1u << 17 | 0xFEu << 8 | 7u << 1 | 1u);
  EXPECT_EQ(last.base, 0x20000100u);
  EXPECT_EQ(last.attributes >> 8 & 0xFFu, 0x7Fu);
  EXPECT_EQ(read_only_v6(0x20000040, 64).attributes >> 8 & 0xFFu, 0xF3u);
}

/// DDI 0553, MPU_RBAR and MPU_RLAR: privileged read-only, never execute; the limit is the last block of 32 bytes.
TEST(StackGuard, RegionOfArmv8) {
  const RegionWords words = read_only_v8(0x38000000, 32);
  EXPECT_EQ(words.base, 0x38000000u | 2u << 1 | 1u);
  EXPECT_EQ(words.attributes, 0x38000000u | 1u);
  EXPECT_EQ(read_only_v8(0x38000000, 128).attributes, 0x38000060u | 1u);
}

struct Played {
  std::uint32_t type, control, region, base, attributes;
};

TEST(StackGuard, LeavesTheDefaultMapEverywhereElse) {
  Played unit{8u << 8, 0, 9, 0, 0};
  EXPECT_TRUE(guard(unit, {0x20000000, 0x123}));
  EXPECT_EQ(unit.control, 5u) << "enabled, default map for privileged code, at rest while a fault is served";
  EXPECT_EQ(unit.region, 0u);
  EXPECT_EQ(unit.base, 0x20000000u);
  EXPECT_EQ(unit.attributes, 0x123u);
}

TEST(StackGuard, SaysWhereThereIsNoUnit) {
  Played unit{0, 0, 9, 0, 0};
  EXPECT_FALSE(guard(unit, {0x20000000, 0x123}));
  EXPECT_EQ(unit.control, 0u);
  EXPECT_EQ(unit.region, 9u) << "nothing is written";
}

/// Privileged Architecture, 3.7.1: of 2^k bytes, k - 3 low bits of the address are ones.
TEST(StackGuard, EntryOfRiscV) {
  EXPECT_EQ(riscv::power_of_two_region(0x80040000, 32), 0x80040000u >> 2 | 3u);
  EXPECT_EQ(riscv::power_of_two_region(0x80000000, 256 * 1024), 0x80000000u >> 2 | 0x7FFFu);
}

constexpr StackBounds stack{0x20000000, 0x20000020, 0x20001000};

TEST(Overflow, IsToldFromOtherFaults) {
  EXPECT_FALSE(overflowed(stack, 0x20000400, 0, 0)) << "an undefined instruction";
  EXPECT_FALSE(overflowed(stack, 0x20000400, 0x82, 0x20000020)) << "the first word above the guard";
  EXPECT_FALSE(overflowed(stack, 0x20000400, 0x82, 0x1FFFFFFF)) << "a stray pointer below RAM";
  EXPECT_TRUE(overflowed(stack, 0x20000400, 0x82, 0x20000000)) << "a store to the guard";
  EXPECT_TRUE(overflowed(stack, 0x20000400, 0x82, 0x2000001C)) << "a store to its last word";
  EXPECT_TRUE(overflowed(stack, 0x2000001C, 0, 0)) << "a frame in the guard";
  EXPECT_FALSE(overflowed(stack, 0x20000020, 0, 0)) << "a frame just above it";
  EXPECT_TRUE(overflowed(stack, 0x1FFFFFE0, 0, 0)) << "a frame below RAM";
  for (const unsigned bit : {4u, 12u, 20u})
    EXPECT_TRUE(overflowed(stack, 0x20000400, 1u << bit, 0)) << "a frame that did not fit, bit " << bit;
}

TEST(Overflow, FramesAreReadInsideTheStackOnly) {
  EXPECT_TRUE(stack.holds_frame(0x20000000));
  EXPECT_TRUE(stack.holds_frame(0x20001000 - 32));
  EXPECT_FALSE(stack.holds_frame(0x1FFFFFFC));
  EXPECT_FALSE(stack.holds_frame(0x20001000 - 28));
  EXPECT_FALSE(stack.holds_frame(0x20000402)) << "not at a word";
}

TEST(Overflow, AnAddressIsReportedWhereItIsValid) {
  EXPECT_EQ(refused_address(1u << 7, 0x11, 0x22), 0x11u);
  EXPECT_EQ(refused_address(1u << 15, 0x11, 0x22), 0x22u);
  EXPECT_EQ(refused_address(0, 0x11, 0x22), 0u);
}

TEST(Overflow, OfRiscVKeepsRoomForInterrupts) {
  constexpr std::uintptr_t bottom = 0x80040000;
  EXPECT_FALSE(riscv::overflowed(bottom, bottom + 32, 0, 0));
  EXPECT_TRUE(riscv::overflowed(bottom, bottom + 28, 0, 0));
  EXPECT_TRUE(riscv::overflowed(bottom, bottom + 32, 192, 0)) << "an interrupt needs more";
  EXPECT_TRUE(riscv::overflowed(bottom, bottom + 400, 0, bottom + 28)) << "a store to the guard";
  EXPECT_FALSE(riscv::overflowed(bottom, bottom + 400, 0, bottom + 32));
  EXPECT_FALSE(riscv::overflowed(bottom, bottom + 400, 0, bottom - 4));
}

}  // namespace
}  // namespace axial::hal

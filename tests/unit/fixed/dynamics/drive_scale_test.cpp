// Efforts beyond the formats, and bits that efforts leave unused: powers of two, by hand.
#include <gtest/gtest.h>
#include <axial/fixed/dynamics/drive_scale.hpp>
#include <functional>

using namespace axial;

namespace {

using S = Arithmetic<std::int32_t, true, false>;
using X = Fx<20, S>;
using V = Vec3<X, X, X>;

/// Magnification after one word was seen as one component.
int magnification(std::int32_t word) {
  Headroom room(0);
  room(V{X{word}, X{0}, X{0}});
  return room.magnification();
}

template <std::int64_t limit>
int halvings(std::int64_t x) {
  return detail::halvings<limit>(x, std::make_integer_sequence<int, detail::most_halvings>{});
}

}  // namespace

// The sign, a component from a norm (below 2), a sum on the way (below 2), rounding: a word below 2^28 is safe.
TEST(Headroom, LeavesThreeBitsBesideTheSignAndNoMore) {
  for (int k = 0; k < 31; ++k)
    for (const std::int64_t word : {std::int64_t{1} << k, (std::int64_t{2} << k) - 1}) {
      const int m = magnification(static_cast<std::int32_t>(word));
      EXPECT_GE(m, 0);
      EXPECT_LE(m, Headroom::most);
      EXPECT_EQ(magnification(static_cast<std::int32_t>(-word - 1)), m) << "of either sign";
      if (m > 0) {
        EXPECT_LT(word << m, std::int64_t{1} << 28) << word;
      }
      if (m < Headroom::most) {
        EXPECT_GE((std::int64_t{2} << k) << (m + 1), std::int64_t{1} << 29) << "a bit is left unused by " << word;
      }
    }
  EXPECT_EQ(magnification(0), Headroom::most);
  EXPECT_EQ(magnification(std::numeric_limits<std::int32_t>::min()), 0);
}

TEST(Headroom, SeesEveryComponent) {
  const X large{1 << 27}, small{1};
  for (int k = 0; k < 6; ++k) {
    const auto at = [&](int i) { return i == k ? large : small; };
    Headroom force(0), motion(0), among(3);
    force(ForceVector{V{at(0), at(1), at(2)}, V{at(3), at(4), at(5)}});
    motion(MotionVector{V{at(0), at(1), at(2)}, V{at(3), at(4), at(5)}});
    among(V{small, small, small}, V{at(0), at(1), at(2)}, V{at(3), at(4), at(5)});
    EXPECT_EQ(force.magnification(), 0) << k;
    EXPECT_EQ(motion.magnification(), 0) << k;
    EXPECT_EQ(among.magnification(), 0) << k;
    EXPECT_EQ(among.magnified(), 3);
  }
}

TEST(Halvings, BringAnEffortWithinItsLimitToTwoUnits) {
  constexpr std::int64_t limit = 1000;
  for (const int sign : {1, -1}) {
    EXPECT_EQ(halvings<limit>(sign * 998), 0);
    for (int k = 0; k < detail::most_halvings; ++k) {
      EXPECT_EQ(halvings<limit>(sign * ((limit << k) + 3)), k + 1) << "just beyond " << k;
      EXPECT_EQ(halvings<limit>(sign * ((limit << k) - 3)), k) << "just within " << k;
    }
    EXPECT_EQ(halvings<limit>(sign * 0xFFFFFFFFLL), detail::most_halvings);
  }
}

TEST(Halvings, OfALimitBeyondWordsAreNone) { EXPECT_EQ(halvings<std::int64_t{1} << 34>(0xFFFFFFFFLL), 0); }

TEST(Divided, MovesBetweenExponentsAndHalves) {
  EXPECT_EQ((detail::divided<20, 20, S>(1024, 0).raw), 1024);
  EXPECT_EQ((detail::divided<20, 20, S>(1024, 3).raw), 128);
  EXPECT_EQ((detail::divided<20, 20, S>(1024, -3).raw), 8192);
  EXPECT_EQ((detail::divided<18, 20, S>(1024, 0).raw), 256);
  EXPECT_EQ((detail::divided<22, 20, S>(-1024, 1).raw), -2048);
}

TEST(RescaledWord, DoublesAndHalves) {
  EXPECT_EQ((detail::rescaled_word<S, true>(-3, 4)), -48);
  EXPECT_EQ((detail::rescaled_word<S, false>(-3, 4)), -48);
  EXPECT_EQ((detail::rescaled_word<S, false>(48, -4)), 3);
  EXPECT_EQ((detail::rescaled_word<S, false>(7, 0)), 7);
}

TEST(Difference, OfTheLargestWordsDoesNotWrap) {
  const X most{std::numeric_limits<std::int32_t>::max()}, least{std::numeric_limits<std::int32_t>::min()};
  EXPECT_EQ(detail::difference(most, least), 0xFFFFFFFFLL);
  EXPECT_EQ(detail::difference(least, most), -0xFFFFFFFFLL);
}

// A bias may be finer than the effort that it is taken from: exact in its units, to one unit in those of the effort.
TEST(Difference, TakesAFinerBias) {
  const Fx<20, S> tau{INT32_MAX};
  const Fx<24, S> bias{INT32_MIN};
  EXPECT_EQ(detail::exact_difference(tau, bias), (std::int64_t{INT32_MAX} << 4) - INT32_MIN);
  EXPECT_EQ(detail::difference(tau, bias), std::int64_t{INT32_MAX} - (INT32_MIN >> 4));
}

TEST(Divided, LeavesRoomForADifferenceOfFinerWords) {
  constexpr int finer = 24, doublings = 30;
  constexpr int most = detail::magnification_limit<doublings>(10, finer);
  static_assert(most == 16, "bits behind 33 and the finer ones, and those on the way down");
  constexpr std::int64_t small = 0x12345, large = std::int64_t{1} << (16 + finer);
  EXPECT_EQ((detail::divided<14, 24, S, finer, doublings>(small, -most).raw), small << (most - 10));
  EXPECT_EQ((detail::divided<14, 24, S, finer, doublings>(-large, 0).raw), -(large >> 10));
}

TEST(Headroom, IsKeptWhileABitIsSpared) {
  for (const std::int32_t word : {(1 << 30) - 1, -(1 << 30)}) {
    Headroom room(0);
    room(X{word});
    EXPECT_TRUE(room.kept()) << word;
  }
  for (const std::int32_t word : {1 << 30, -(1 << 30) - 1}) {
    Headroom room(0);
    room(X{word});
    EXPECT_FALSE(room.kept()) << word;
  }
}

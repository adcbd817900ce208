#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <cmath>
#include <random>
#include <robots/robots.hpp>

using namespace axial;

namespace {

using R = robots::Scara;
using Code = Status::Code;
using Q = Positions<R, Fixed32>;
using Qd = Velocities<R, Fixed32>;
using Tau = EffortsOf<R, Fixed32>;
constexpr std::int32_t largest = std::numeric_limits<std::int32_t>::max(), smallest = -largest - 1;
const long double turn = 2.0L * std::acos(-1.0L);

struct Drive {
  static constexpr double effort_a_count = 0.043;  // N m
  static constexpr std::int32_t most_counts = 1023;
  static constexpr int direction = 1;
};
struct Backwards : Drive {
  static constexpr int direction = -1;
};

template <std::uint32_t counts, std::int32_t zero, int direction>
double largest_angle_error() {  // in units
  std::mt19937 random(20240928);
  long double largest_error = 0.0L;
  for (int k = 0; k < 100000; ++k) {
    const auto n = static_cast<std::int32_t>(random()) >> (k % 8);
    const std::int64_t from_zero = direction * (std::int64_t{n} - zero);
    if (from_zero > largest || from_zero < smallest) continue;
    const std::int64_t within = from_zero % counts;
    const long double exact = std::ldexp(static_cast<long double>(within) / counts, 32);
    const long double raw = RotaryEncoder<counts, zero, direction>::position(n).raw;
    largest_error = std::max(largest_error, std::abs(std::remainder(raw - exact, std::ldexp(1.0L, 32))));
  }
  return static_cast<double>(largest_error);
}

}  // namespace

TEST(Encoder, PowersOfTwoAreExact) {
  static_assert(RotaryEncoder<4096>::position(1024).raw == 1 << 30);
  static_assert(RotaryEncoder<4096>::position(4096 + 1).raw == 1 << 20);
  static_assert(RotaryEncoder<4096, 100, -1>::position(99).raw == 1 << 20);
  static_assert(RotaryEncoder<(1u << 31)>::position(1).raw == 2);
  EXPECT_EQ((largest_angle_error<65536, 0, 1>()), 0.0);
  EXPECT_EQ((largest_angle_error<4096, 1234, -1>()), 0.0);
}

TEST(Encoder, PowersOfTwoLetTheCounterWrap) {
  using E = RotaryEncoder<8192, -5>;
  const auto before = static_cast<std::uint32_t>(E::position(largest).raw);
  EXPECT_EQ(static_cast<std::uint32_t>(E::position(smallest).raw) - before, 1U << 19);
}

TEST(Encoder, OthersAreWithinThreeQuartersOfAUnit) {
  const double errors[] = {largest_angle_error<1000, 0, 1>(), largest_angle_error<3, 7, 1>(),
                           largest_angle_error<4096 * 101, -5, -1>(), largest_angle_error<0xFFFFFFFB, 0, 1>()};
  for (const double error : errors) {
    EXPECT_LE(error, 0.75);
    EXPECT_GT(error, 0.25);
  }
}

TEST(Encoder, VelocityIsNearestAndSaturates) {
  using E = RotaryEncoder<10000, 0, -1>;
  std::mt19937 random(20240929);
  for (int k = 0; k < 20000; ++k) {
    const auto rate = static_cast<std::int32_t>(random() % 12000) - 6000;  // 3.8 rad/s
    const auto v = E::velocity<Qd, 0>(rate);
    EXPECT_TRUE(v.status.ok());
    const double exact = static_cast<double>(-rate * turn / 10000 * std::ldexp(1.0L, Qd::exponent(0)));
    EXPECT_NEAR(v.value.raw, exact, 0.5 + std::ldexp(std::abs(exact), -31));
  }
  const auto& limits = fixed_limits_of<R, std::int32_t>.joints;
  for (const std::int32_t rate : {7000, largest}) {
    EXPECT_EQ((E::velocity<Qd, 0>(rate).value.raw), -limits[0].speed.raw);
    EXPECT_EQ((E::velocity<Qd, 0>(-rate).value.raw), limits[0].speed.raw);
    EXPECT_EQ((E::velocity<Qd, 0>(-rate).status.code), Code::speed_limit);
    EXPECT_EQ((E::velocity<Qd, 0>(-rate).status.joint), 0);
  }
}

TEST(Encoder, ASlideCountsMetres) {
  using E = LinearEncoder<1000000, 250>;
  for (std::int32_t reading = 250; reading <= 250250; reading += 997) {
    const auto q = E::position<Q, 2>(reading);
    EXPECT_TRUE(q.status.ok());
    const double exact = (reading - 250) * 1e-6 * std::ldexp(1.0, Q::exponent(2));
    EXPECT_NEAR(q.value.raw, exact, 0.5 + std::ldexp(exact, -31));
  }
  EXPECT_EQ((E::position<Q, 2>(100000000).status.code), Code::position_limit);
  EXPECT_EQ((E::position<Q, 2>(100000000).value.raw), largest);
  EXPECT_EQ((E::position<Q, 2>(-100000000).value.raw), -largest);
  EXPECT_EQ((E::velocity<Qd, 2>(2000000).status.code), Code::speed_limit);
  EXPECT_NEAR(to_real<double>(Qd{{{}, {}, E::velocity<Qd, 2>(500000).value}})[2], 0.5, 1e-9);
}

TEST(CurrentCommand, IsNearestAndSaturates) {
  std::mt19937 random(20240930);
  for (int k = 0; k < 20000; ++k) {
    const Tau tau{{{static_cast<std::int32_t>(random()) >> (k % 31)}, {}, {}}};
    const double exact = to_real<double>(tau)[0] / Drive::effort_a_count;
    const auto command = current_command<Drive, Tau, 0>(tau[0]);
    const double within = std::min(std::max(exact, -1023.0), 1023.0);
    EXPECT_NEAR(command.value, within, 0.5 + 1e-6);
    EXPECT_EQ(command.status.ok(), std::lround(std::abs(exact)) <= 1023) << exact;
    EXPECT_EQ((current_command<Backwards, Tau, 0>(tau[0]).value), -command.value);
  }
  constexpr auto full = current_command<Drive, Tau, 0>({largest});
  EXPECT_EQ(full.value, 1023);
  EXPECT_EQ(full.status.code, Code::effort_limit);
  EXPECT_EQ(full.status.joint, 0);
}

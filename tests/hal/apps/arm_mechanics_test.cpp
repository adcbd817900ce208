// What an arm that a board stands in for does besides moving as rigid bodies: what its robot's Mechanics name.

#include <algorithm>
#include <cmath>

#include "arm_fixture.hpp"

namespace axial::apps {
namespace {

/// Two joints and a slide with all that there is.
struct Worn : robots::Scara {
  static constexpr const char* name = "worn";
  static constexpr auto chain = axial::chain(axial::gravity(0.0, 0.0, -9.8125),
                                             axial::revolute()
                                                 .mass(4.0)
                                                 .com(0.1875, 0.0, 0.0)
                                                 .inertia_com(0.0, 0.05, 0.05)
                                                 .position_limits(-2.5, 2.5)
                                                 .speed_limit(4.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(80.0)
                                                 .coulomb(2.0)
                                                 .viscous(0.1),
                                             axial::revolute()
                                                 .a(0.375)
                                                 .mass(2.5)
                                                 .com(0.15, 0.0, 0.0)
                                                 .inertia_com(0.0, 0.02, 0.02)
                                                 .position_limits(-2.6, 2.6)
                                                 .speed_limit(5.0)
                                                 .acceleration_limit(30.0)
                                                 .effort_limit(25.0)
                                                 .coulomb(1.0),
                                             axial::prismatic()
                                                 .a(0.3125)
                                                 .alpha_deg(180)
                                                 .mass(1.25)
                                                 .position_limits(0.0, 0.25)
                                                 .speed_limit(1.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(30.0)
                                                 .coulomb(15.0));
  struct Mechanics {
    static constexpr bool friction = true;
    static constexpr EndStops stops{1e5, 30.0};
    static constexpr int encoder_bits = 14;
    static constexpr double backlash[] = {0.02, 0.0, 0.001};
  };
};
template <class Number>
class WornArm : public ArmApp<Worn, Number> {};
TYPED_TEST_SUITE(WornArm, Numbers);
constexpr std::uint32_t count = 1U << 18;  // of 14 bits a turn
constexpr std::int32_t slide_step = 610;   // 10^7 / 2^14

TYPED_TEST(WornArm, StandsStillAgainstItsWeight) {
  this->open(link::Mode::lock_step);
  const auto first = this->tell(link::ArmAction::place, pose);
  link::Encoders last{};
  for (std::uint32_t k = 1; k <= 3000; ++k)
    last = this->ask({1.9F, -0.9F, 0.0F}, k);  // gravity's 12.3 N are less than the slide's 15
  EXPECT_EQ(last.position, first.position);
  EXPECT_EQ(last.speed, first.speed);
}

TYPED_TEST(WornArm, CountsAsCoarselyAsItsEncoders) {
  this->open(link::Mode::lock_step);
  auto found = this->tell(link::ArmAction::place, pose);
  EXPECT_NEAR(found.position[0], static_cast<double>(pose[0]) * counts_a_rad, count / 2 + 1);
  for (std::uint32_t k = 1; k <= 50; ++k) {
    found = this->ask({9.0F, -5.0F, 29.0F}, k);
    EXPECT_EQ(static_cast<std::uint32_t>(found.position[0]) % count, 0U);
    EXPECT_EQ(static_cast<std::uint32_t>(found.position[1]) % count, 0U);
    EXPECT_EQ(found.position[2] % slide_step, 0);
  }
}

TYPED_TEST(WornArm, HasPlayBetweenMotorAndJoint) {
  this->open(link::Mode::lock_step);
  const auto first = this->tell(link::ArmAction::place, {0.0F, 0.0F, 0.1F});
  std::uint32_t k = 0;
  link::Encoders found{};
  double way = 0.0;
  do
    found = this->ask({9.0F, 0.0F, 0.0F}, ++k), way += 1e-3 * static_cast<double>(found.speed[0]);
  while (found.position[0] == first.position[0] && k < 1000);
  EXPECT_NEAR(way, 0.01 + 0.5 * count / counts_a_rad, 2e-3) << "half of its play, and half a count";
  while (way < 0.1)
    found = this->ask({9.0F, 0.0F, 0.0F}, ++k), way += 1e-3 * static_cast<double>(found.speed[0]);
  EXPECT_NEAR(found.position[0] / counts_a_rad, way - 0.01, count / counts_a_rad);
}

TYPED_TEST(WornArm, StaysBetweenItsStops) {
  this->open(link::Mode::lock_step);
  this->tell(link::ArmAction::place, {2.0F, 0.0F, 0.1F});
  double most = 0.0;
  for (std::uint32_t k = 1; k <= 2000; ++k) {
    const auto found = this->ask({5.0F, 0.0F, 0.0F}, k);
    most = std::max(most, found.position[0] / counts_a_rad);
    EXPECT_LT(std::fabs(found.speed[0]), 10.0F);
  }
  EXPECT_GT(most, 2.49);
  EXPECT_LT(most, (std::is_same_v<TypeParam, float> ? 2.53 : 2.5 + count / counts_a_rad))
      << "in words it does not yield";
}

}  // namespace
}  // namespace axial::apps

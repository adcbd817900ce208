#include <gtest/gtest.h>
#include <axial/control/collision.hpp>
#include <axial/robot/chain.hpp>
#include <cmath>

using namespace axial;

namespace {

struct Arm {  // the second joint declares no effort limit
  static constexpr auto chain = axial::chain(
      revolute().mass(1).com(1, 0, 0).position_limits(-2, 2).speed_limit(2).acceleration_limit(5).effort_limit(20),
      revolute().a(1).mass(1).com(1, 0, 0).position_limits(-2, 2).speed_limit(2).acceleration_limit(5));
};
struct Tuning {
  static constexpr double period = 1e-3, gain = 100.0, fraction = 0.1, uncertainty = 1.0, release = 0.5;
  static constexpr int confirm = 3, calm = 2;
};
using Effort = Residuals<Arm, double, Tuning>;

constexpr double enter = 0.1 * 20 + 1.0, leave = 0.5 * enter;

class Detector : public testing::Test {
 protected:
  Collision see(double first, double second = 0.0) {
    Effort r{};
    r[0] = first, r[1] = second;
    return detect(state_, r);
  }
  bool any(std::initializer_list<double> efforts) {
    bool detected = false;
    for (const double x : efforts)
      detected = see(x).detected;
    return detected;
  }
  CollisionState state_{};
};

}  // namespace

TEST_F(Detector, ThresholdsFollowTheDeclaredEffort) {
  constexpr auto& threshold = collision_thresholds_of<Arm, double, Tuning>;
  EXPECT_DOUBLE_EQ(threshold.enter[0], 3.0);
  EXPECT_DOUBLE_EQ(threshold.leave[0], 1.5);
  EXPECT_DOUBLE_EQ(threshold.enter[1], 1.0) << "no declared effort: the uncertainty alone";
  EXPECT_DOUBLE_EQ(threshold.leave[1], 0.5);
}

TEST_F(Detector, AThresholdItselfIsNotBeyondIt) {
  EXPECT_FALSE(any({enter, -enter, enter, -enter}));
  EXPECT_EQ(see(enter).joint, -1);
  EXPECT_EQ(see(std::nextafter(enter, 9.0)).joint, 0);
  EXPECT_EQ(see(-std::nextafter(enter, 9.0)).joint, 0);
}

TEST_F(Detector, LeavesOutWhatIsNoNumberAndSaysSo) {
  EXPECT_FALSE(any({4, 4, NAN, INFINITY}));
  EXPECT_EQ(see(0.0, NAN).status.code, Status::Code::not_finite);
  EXPECT_EQ(see(4.0, -INFINITY).joint, -1);
  EXPECT_TRUE(any({4})) << "the third in a row of those that count";
  EXPECT_TRUE(see(4).status.ok());
  EXPECT_TRUE(any({0, NAN}));
  EXPECT_FALSE(any({NAN, 0})) << "the second calm one";
}

TEST_F(Detector, NamesTheOutermostJoint) {
  EXPECT_EQ(see(4.0, 2.0).joint, 1);
  EXPECT_EQ(see(4.0, 0.0).joint, 0);
  EXPECT_EQ(see(0.0, -2.0).joint, 1);
  EXPECT_EQ(see(0.0, 0.0).joint, -1);
}

TEST_F(Detector, ConfirmsAfterSoManyInARow) {
  EXPECT_FALSE(any({4, 4}));
  EXPECT_TRUE(see(4).detected);
}

TEST_F(Detector, CountsFromTheStartAfterOneThatIsNot) { EXPECT_FALSE(any({4, 4, 2, 4, 4})); }

TEST_F(Detector, EndsAfterSoManyCalmOnesInARow) {
  ASSERT_TRUE(any({4, 4, 4}));
  EXPECT_TRUE(any({0}));
  EXPECT_FALSE(any({0}));
}

TEST_F(Detector, BetweenTheThresholdsNothingBeginsAndNothingEnds) {
  EXPECT_FALSE(any({2, 2, 2, 2, 2}));
  ASSERT_TRUE(any({4, 4, 4}));
  EXPECT_TRUE(any({2, 2, 2, 2, 0, 2, 0, 2}));
  EXPECT_TRUE(any({leave, 2}));
  EXPECT_FALSE(any({leave, -leave})) << "the lower threshold itself is calm";
}

TEST_F(Detector, LastsAsLongAsItIsLoud) {
  ASSERT_TRUE(any({4, 4, 4}));
  for (int i = 0; i < 1000; ++i)
    ASSERT_TRUE(see(0.0, i % 2 ? 4.0 : -4.0).detected) << i;
  EXPECT_LE(state_.above, Tuning::confirm) << "counts stay where they end";
}

TEST_F(Detector, BeginsAnewAfterItEnded) {
  ASSERT_TRUE(any({4, 4, 4}));
  ASSERT_FALSE(any({0, 0}));
  EXPECT_FALSE(any({4, 4}));
  EXPECT_TRUE(any({4}));
}

// Joint values that say what they are, and those that say nothing: zero unless initialised, taken where they belong.
// What does not compile is in tests/compile_fail.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

using namespace axial;

namespace {

using R = robots::Scara;

constexpr bool uninitialised_are_zero() {
  Joints<R, float> plain;
  Positions<R, Fixed32> words;
  JointPositions<R> q;
  JointVelocities<R, Fixed32> qd;
  bool zero = true;
  for (int i = 0; i < 3; ++i)
    zero =
        zero && !(plain[i] < 0) && !(plain[i] > 0) && words[i].raw == 0 && !(q[i] < 0) && !(q[i] > 0) && qd[i].raw == 0;
  return zero;
}
static_assert(uninitialised_are_zero());

}  // namespace

TEST(JointRoles, AreTakenWhereTheyBelongAndGiveTheSame) {
  const Joints<R, float> a{0.3F, -0.5F, 0.1F}, b{1.0F, 2.0F, -0.5F}, c{3.0F, -4.0F, 1.0F};
  const JointPositions<R> q{0.3F, -0.5F, 0.1F};
  const JointVelocities<R> qd{1.0F, 2.0F, -0.5F};
  const JointAccelerations<R> qdd{3.0F, -4.0F, 1.0F};
  const auto plain = inverse_dynamics<R>(a, b, c), said = inverse_dynamics<R>(q, qd, qdd);
  const auto mixed = inverse_dynamics<R>(q, b, qdd);
  FeedforwardState<R, float> state;
  const auto safe = feedforward<R>(state, q, qd, qdd);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(plain[i], said[i]);
    EXPECT_EQ(plain[i], mixed[i]);
    EXPECT_EQ(plain[i], safe.tau[i]);
  }
  EXPECT_TRUE((forward_dynamics<R>(q, qd, plain).status.ok()));
  EXPECT_EQ((jacobian<R, 1>(q)[0].angular.z), 1.0F);
}

TEST(JointRoles, InDoubleAndInWords) {
  const JointPositions<R, double> q{0.3, -0.5, 0.1};
  EXPECT_TRUE(forward_kinematics<R>(q).status.ok());
  JointPositions<R, Fixed32> words;
  JointVelocities<R, Fixed32> speeds;
  JointAccelerations<R, Fixed32> still;
  words[0].raw = 1 << 20;
  EXPECT_EQ((inverse_dynamics<R>(words, speeds, still)[2].raw),
            (inverse_dynamics<R>(Positions<R, Fixed32>{words}, Velocities<R, Fixed32>{}, Accelerations<R, Fixed32>{})[2]
                 .raw));
}

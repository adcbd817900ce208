// What is not finite, or an angle too large for its sine, is said; and nothing else is.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

using namespace axial;
using Code = Status::Code;

namespace {

template <class T>
class SoundnessOf : public testing::Test {
 protected:
  static constexpr T largest = std::numeric_limits<T>::max(), infinity = std::numeric_limits<T>::infinity();
  static constexpr T nan = std::numeric_limits<T>::quiet_NaN();

  static Code of(T angle, T number) {
    Soundness<T> all;
    all.angle(T(0.25)), all.angle(angle), all.number(T(-0.5)), all.number(number);
    return all.status().code;
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(SoundnessOf, Reals);

}  // namespace

TYPED_TEST(SoundnessOf, NumbersAreSound) {
  using T = TypeParam;
  for (T x : {T(0), T(-0.0), T(1), std::numeric_limits<T>::denorm_min(), this->largest / 2, -this->largest / 2})
    EXPECT_EQ(this->of(T(1), x), Code::ok) << x;
}
TYPED_TEST(SoundnessOf, WhatIsNotFiniteIsSaidWhereverItStands) {
  using T = TypeParam;
  for (T x : {this->nan, -this->nan, this->infinity, -this->infinity}) {
    EXPECT_EQ(this->of(x, T(1)), Code::not_finite) << x;
    EXPECT_EQ(this->of(T(1), x), Code::not_finite) << x;
    EXPECT_EQ(this->of(this->largest, x), Code::not_finite) << x << " beside an angle out of range";
  }
  Soundness<T> both;
  both.number(this->infinity), both.number(-this->infinity);
  EXPECT_EQ(both.status().code, Code::not_finite) << "infinities of either sign do not cancel";
}
TYPED_TEST(SoundnessOf, AnglesEndWhereSinesLoseDigits) {
  using T = TypeParam;
  const T most = largest_angles<T>;
  EXPECT_EQ(this->of(most - T(1), T(0)), Code::ok);
  EXPECT_EQ(this->of(T(1) - most, T(0)), Code::ok);
  EXPECT_EQ(this->of(most + T(1), T(0)), Code::angle_range);
  EXPECT_EQ(this->of(-most - T(1), T(0)), Code::angle_range);
  EXPECT_EQ(this->of(this->largest, T(0)), Code::angle_range);
}
TYPED_TEST(SoundnessOf, SinesAreExactUpToThere) {
  using T = TypeParam;
  const double scale = std::is_same_v<T, float> ? 0x1.8p-24 : 0x1p-53;  // what sincos.hpp says
  for (int i = 0; i < 2000; ++i) {
    const T x = largest_angles<T> - T(i) / T(7);
    const auto pair = sincos(x);
    EXPECT_NEAR(static_cast<double>(pair.sin), static_cast<double>(std::sin(static_cast<long double>(x))),
                1.01 * scale);
    EXPECT_NEAR(static_cast<double>(pair.cos), static_cast<double>(std::cos(static_cast<long double>(x))),
                1.01 * scale);
  }
}

namespace {

using Everything =
    Scene<robots::Puma560, RuntimeGravity, RotorInertia, Friction, Payload, TipWrench, ExternalWrenches, BaseMotion>;

template <class S, class Spoil>
Status spoilt(const Spoil& spoil) {
  Joints<robot_of<S>, float> q{}, qd{}, tau{};
  Inputs<S, float> in{};
  for (int i = 0; i < q.size; ++i)
    q[i] = 0.1F * static_cast<float>(i), qd[i] = 0.2F, tau[i] = 1.0F;
  spoil(q, qd, tau, in);
  return forward_dynamics<S>(q, qd, tau, in).status;
}

template <class S>
void expect_every_joint_value_seen() {
  const auto nothing = [](auto&, auto&, auto&, auto&) {};
  ASSERT_TRUE(spoilt<S>(nothing).ok());
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()})
    for (int i = 0; i < joint_count<S>; ++i) {
      EXPECT_EQ(spoilt<S>([&](auto& q, auto&, auto&, auto&) { q[i] = bad; }).code, Code::not_finite) << i;
      EXPECT_EQ(spoilt<S>([&](auto&, auto& qd, auto&, auto&) { qd[i] = bad; }).code, Code::not_finite) << i;
      EXPECT_EQ(spoilt<S>([&](auto&, auto&, auto& tau, auto&) { tau[i] = bad; }).code, Code::not_finite) << i;
    }
}

}  // namespace

TEST(ForwardSoundness, SeesEveryJointByEveryRoute) {
  using R = robots::Scara;
  expect_every_joint_value_seen<R>();
  expect_every_joint_value_seen<Scene<R, Gravity, RotorInertia, ArticulatedBody>>();
  expect_every_joint_value_seen<Scene<R, Gravity, RotorInertia, SplitArticulatedBody>>();
  expect_every_joint_value_seen<Scene<R, Gravity, RotorInertia, CompositeBody>>();
  expect_every_joint_value_seen<Scene<R, Gravity, RotorInertia, Looped>>();
}

TEST(ForwardSoundness, SeesWhatOverflows) {
  using R = robots::Scara;
  EXPECT_EQ(spoilt<R>([](auto&, auto& qd, auto&, auto&) { qd[0] = 1e25F; }).code, Code::not_finite);
  EXPECT_EQ(spoilt<R>([](auto&, auto&, auto& tau, auto&) { tau[1] = 3e38F; }).code, Code::not_finite);
  EXPECT_EQ(spoilt<R>([](auto& q, auto&, auto&, auto&) { q[0] = 1e6F; }).code, Code::angle_range);
  EXPECT_EQ(spoilt<R>([](auto& q, auto&, auto&, auto&) { q[1] = -1e6F; }).joint, -1);
}

TEST(ForwardSoundness, SeesEveryInput) {
  const float bad = std::numeric_limits<float>::quiet_NaN();
  ASSERT_TRUE(spoilt<Everything>([](auto&, auto&, auto&, auto&) {}).ok());
  const auto expect_seen = [&](auto pick, const char* what) {
    const auto spoil = [&](auto&, auto&, auto&, auto& in) { pick(in) = bad; };
    EXPECT_EQ(spoilt<Everything>(spoil).code, Code::not_finite) << what;
  };
  expect_seen([](auto& in) -> float& { return in.gravity.x; }, "gravity.x");
  expect_seen([](auto& in) -> float& { return in.gravity.z; }, "gravity.z");
  expect_seen([](auto& in) -> float& { return in.base_motion.angular_velocity.x; }, "angular_velocity");
  expect_seen([](auto& in) -> float& { return in.base_motion.angular_acceleration.y; }, "angular_acceleration");
  expect_seen([](auto& in) -> float& { return in.base_motion.linear_acceleration.z; }, "linear_acceleration");
  expect_seen([](auto& in) -> float& { return in.payload.mass; }, "payload.mass");
  expect_seen([](auto& in) -> float& { return in.payload.com.y; }, "payload.com");
  expect_seen([](auto& in) -> float& { return in.payload.inertia_com.xz; }, "payload.inertia_com");
  expect_seen([](auto& in) -> float& { return in.tip_wrench.moment.x; }, "tip_wrench.moment");
  expect_seen([](auto& in) -> float& { return in.tip_wrench.force.z; }, "tip_wrench.force");
  expect_seen([](auto& in) -> float& { return in.wrenches[0].force.x; }, "wrenches[0]");
}

TEST(ForwardSoundness, SeesTurnsThatNobodyGave) {
  using S = Scene<robots::Scara, Gravity, RotorInertia, SineCosines>;
  EXPECT_EQ(spoilt<S>([](auto&, auto&, auto&, auto&) {}).code, Code::not_finite);
  const auto given = [](auto& q, auto&, auto&, auto& in) { in.turns = sine_cosines<S>(q); };
  EXPECT_TRUE(spoilt<S>(given).ok());
}

TEST(ForwardSoundness, KeepsWhatTheSolverSaysOfASoundAnswer) {
  using M = Model<2, Gravity, ArticulatedBody>;
  M model;
  ASSERT_TRUE(model.add(revolute()));
  ASSERT_TRUE(model.add(revolute().mass(1.0).inertia_com(0.1, 0.1, 0.1)));
  Joints<M, float> q{}, qd{}, tau{1.0F, 2.0F};
  EXPECT_EQ(forward_dynamics(model, q, qd, tau).status.code, Code::near_singular);
  tau[1] = std::numeric_limits<float>::infinity();
  const auto broken = forward_dynamics(model, q, qd, tau);
  EXPECT_EQ(broken.status.code, Code::not_finite);
  EXPECT_EQ(broken.status.joint, -1);
}

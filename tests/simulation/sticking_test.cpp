// Dry friction that sticks: closed forms of one joint, an arm that holds a pose to the last bit, a joint that is locked
// by its friction.
#include <axial/axial.hpp>
#include <axial/simulation/sticking.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <robots/puma560.hpp>

namespace {

using namespace axial;

/// A block on a track: 5 N when it slides, 8 N break it away.
struct Block {
  static constexpr auto chain =
      axial::chain(gravity(0.0, 0.0, 0.0), prismatic().mass(2.0).coulomb(5.0, -4.0).stribeck(8.0, 0.01).viscous(0.5));
};
using OnTrack = Scene<Block, Friction>;
/// The same without a static effort and without a damper.
struct DryBlock {
  static constexpr auto chain = axial::chain(gravity(0.0, 0.0, 0.0), prismatic().mass(2.0).coulomb(5.0, -4.0));
};

template <class T>
class Sticking : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(Sticking, Numbers);

template <class S, class T, class X>
bool move(X& x, const Held<S, T>& held, double h, int steps) {
  bool ok = true;
  for (int k = 0; k < steps; ++k)
    ok = advance<StickingEuler>(x, static_cast<T>(h), held).ok() && ok;
  return ok;
}

}  // namespace

TYPED_TEST(Sticking, HoldsABlockForAMinuteToTheLastBit) {
  using T = TypeParam;
  Motion<OnTrack, T> x;
  x.q[0] = T(0.123456789);
  const T before = x.q[0];
  ASSERT_TRUE(move(x, Held<OnTrack, T>{{T(7.9)}, {}}, 1e-3, 60'000));
  EXPECT_EQ(x.q[0], before);
  EXPECT_EQ(x.qd[0], T(0));
  ASSERT_TRUE(move(x, Held<OnTrack, T>{{T(-7.9)}, {}}, 1e-3, 1000));
  EXPECT_EQ(x.q[0], before);
  ASSERT_TRUE(move(x, Held<OnTrack, T>{{T(-8.1)}, {}}, 1e-3, 1000));
  EXPECT_LT(x.q[0], before - T(0.1));
}

// Pulled by more than what breaks it away, the block soon slides under Coulomb's effort and a damper.
TYPED_TEST(Sticking, LetsABlockSlide) {
  using T = TypeParam;
  Motion<OnTrack, T> x;
  ASSERT_TRUE(move(x, Held<OnTrack, T>{{T(10.0)}, {}}, 1e-4, 30'000));
  const double damped = (10.0 - 5.0) / 0.5, rate = 0.5 / 2.0, t = 3.0;
  EXPECT_NEAR(static_cast<double>(x.qd[0]), damped * (1.0 - std::exp(-rate * t)), 0.02);
}

// A block that was thrown is slowed by a = 2 C / m and stops where v^2 / 2 a says, for good.
TYPED_TEST(Sticking, StopsABlockThatWasThrown) {
  using T = TypeParam;
  using S = Scene<DryBlock, Friction>;
  for (const double speed : {1.0, -0.7}) {
    Motion<S, T> x;
    x.qd[0] = static_cast<T>(speed);
    ASSERT_TRUE(move(x, Held<S, T>{}, 1e-3, 2000));
    const double slows = speed > 0.0 ? 2.5 : -2.0;
    EXPECT_EQ(x.qd[0], T(0));
    EXPECT_NEAR(static_cast<double>(x.q[0]), speed * speed / (2.0 * slows), 1e-3 * std::fabs(speed)) << speed;
    const T there = x.q[0];
    ASSERT_TRUE(move(x, Held<S, T>{}, 1e-3, 1000));
    EXPECT_EQ(x.q[0], there);
  }
}

// Beside the torques that hold its weight an arm is pulled by nine tenths of what its joints' friction is.
TYPED_TEST(Sticking, HoldsAnArmForAMinuteToTheLastBit) {
  using T = TypeParam;
  using S = Scene<robots::Puma560, Gravity, RotorInertia, Friction>;
  Motion<S, T> x;
  x.q = {T(0.3), T(-0.7), T(1.9), T(0.2), T(0.4), T(-0.5)};
  const auto before = x.q;
  Held<S, T> held;
  held.tau = gravity_torque<S>(x.q);
  for (int i = 0; i < 6; ++i) {
    const auto& link = robots::Puma560::chain.links[i];
    held.tau[i] += static_cast<T>(0.9 * (i % 2 == 0 ? link.coulomb_forward : link.coulomb_backward));
  }
  ASSERT_TRUE(move(x, held, 1e-3, 60'000));
  for (int i = 0; i < 6; ++i)
    EXPECT_TRUE(x.q[i] == before[i] && x.qd[i] == T(0)) << i;
  // A third more and the elbow gives way, forwards; what it does to the shoulder moves that, but not the base.
  held.tau[2] += static_cast<T>(0.3 * robots::Puma560::chain.links[2].coulomb_forward);
  ASSERT_TRUE(move(x, held, 1e-3, 20));
  EXPECT_GT(x.qd[2], T(0));
  EXPECT_EQ(x.q[0], before[0]);
}

namespace {

constexpr double rod = 0.4, bob = 1.5;
/// A pendulum on the end of an arm whose joint is stiff with rust, and the pendulum alone.
struct Rusty {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -9.81, 0.0), revolute().mass(3.0).com(0.3, 0, 0).coulomb(200.0),
                   revolute().a(0.6).mass(bob).com(rod, 0, 0).coulomb(0.02));
};
struct Alone {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -9.81, 0.0), revolute().mass(bob).com(rod, 0, 0).coulomb(0.02));
};

}  // namespace

TYPED_TEST(Sticking, LocksAJointForTheOthers) {
  using T = TypeParam;
  Motion<Scene<Rusty, Gravity, Friction>, T> x;
  Motion<Scene<Alone, Gravity, Friction>, T> y;
  x.q[1] = y.q[0] = T(-0.8);
  for (int k = 0; k < 2000; ++k) {
    ASSERT_TRUE(advance<StickingEuler>(x, T(1e-3), Held<Scene<Rusty, Gravity, Friction>, T>{}).ok());
    ASSERT_TRUE(advance<StickingEuler>(y, T(1e-3), Held<Scene<Alone, Gravity, Friction>, T>{}).ok());
  }
  EXPECT_EQ(x.q[0], T(0));
  EXPECT_NEAR(static_cast<double>(x.q[1]), static_cast<double>(y.q[0]), sizeof(T) == 4 ? 1e-2 : 1e-6);
  EXPECT_GT(std::fabs(static_cast<double>(x.q[1]) + 0.8), 0.01);
}

// It comes to rest, and stays.
TYPED_TEST(Sticking, EndsASwing) {
  using T = TypeParam;
  Motion<Scene<Alone, Gravity, Friction>, T> x;
  ASSERT_TRUE(move(x, Held<Scene<Alone, Gravity, Friction>, T>{}, 1e-3, 200'000));
  EXPECT_EQ(x.qd[0], T(0));
  EXPECT_LE(std::fabs(bob * 9.81 * rod * std::cos(static_cast<double>(x.q[0]))), 0.021) << "within the dead band";
}

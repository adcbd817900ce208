// What is stiff: a joint of 1e5 N m/rad behind 1e-3 kg m^2, end stops that are hit at 3 rad/s, friction that sticks for
// a minute. No blow-up, no creep; where a method cannot, the step limit says so before it does.
#include <axial/axial.hpp>
#include <axial/simulation/end_stops.hpp>
#include <axial/simulation/energy.hpp>
#include <axial/simulation/step_limit.hpp>
#include <axial/simulation/sticking.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <robots/puma560.hpp>

namespace {

using namespace axial;

constexpr double inertia = 1e-3, stiffness = 1e5, h = 1e-3, turn = 6.283185307179586;

/// A wheel between two stops.
struct Wheel {
  static constexpr auto chain = axial::chain(gravity(0.0, 0.0, 0.0), revolute()
                                                                         .mass(1.0)
                                                                         .inertia_com(inertia, inertia, inertia)
                                                                         .position_limits(-0.5, 0.5)
                                                                         .speed_limit(5.0)
                                                                         .acceleration_limit(100.0)
                                                                         .effort_limit(10.0)
                                                                         .coulomb(0.2));
};
/// The same behind a spring.
struct SprungWheel {
  static constexpr auto chain = axial::chain(
      gravity(0.0, 0.0, 0.0), revolute().mass(1.0).inertia_com(inertia, inertia, inertia).spring(stiffness, 0.25));
};
using Free = Scene<Wheel>;
using Rubbing = Scene<Wheel, Friction>;
using Sprung = Scene<SprungWheel, JointSprings>;

template <class T>
class EndStop : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(EndStop, Numbers);

/// A step of the wheel by an effort, between stops of that damping.
template <class Method, class S, class T>
Status stopped_step(Motion<S, T>& x, double tau, double damping, double step = h) {
  const Held<S, T> held{{static_cast<T>(tau)}, {}};
  return advance<Method>(x, static_cast<T>(step), WithEndStops<S, T, Held<S, T>>(held, {stiffness, damping}));
}

}  // namespace

TYPED_TEST(EndStop, IsLeftNoFasterThanItWasHit) {
  using T = TypeParam;
  for (const double damping : {0.0, 1.0, 30.0})
    for (int start = 0; start < 16; ++start) {  // sixteenths of a step before the stop
      Motion<Free, T> x;
      x.q[0] = static_cast<T>(0.49 - 3.0 * h * start / 16.0), x.qd[0] = T(3);
      T most = T(0);
      for (int k = 0; k < 2000; ++k) {
        ASSERT_TRUE((stopped_step<LinearlyImplicitEuler>(x, 0.0, damping).ok()));
        ASSERT_LE(std::fabs(x.qd[0]), T(3.00001));
        most = std::max(most, std::fabs(x.q[0]));
      }
      EXPECT_GT(most, T(0.5)) << "it was hit";
      EXPECT_LT(most, T(0.5 + 3.01 * h)) << "and entered by a step at most";
    }
}

// By the closed form of the header, of the step in which a joint is in its stop.
TYPED_TEST(EndStop, StopsAJointAsItsFormulaSays) {
  using T = TypeParam;
  const double k = h * h * stiffness / inertia, d = h * 30.0 / inertia, inside = 0.25;
  Motion<Free, T> x;
  x.q[0] = static_cast<T>(0.5 + inside * h * 3.0), x.qd[0] = T(3);
  ASSERT_TRUE((stopped_step<LinearlyImplicitEuler>(x, 0.0, 30.0).ok()));
  EXPECT_NEAR(static_cast<double>(x.qd[0]), 3.0 * (1.0 - k * inside) / (1.0 + k + d), 3e-3);
}

// A spring carries what a weight asks of it: tau = K x.
TYPED_TEST(EndStop, CarriesAnEffortWhereItsSpringDoes) {
  using T = TypeParam;
  for (const double side : {1.0, -1.0}) {
    Motion<Free, T> x;
    for (int k = 0; k < 3000; ++k)
      ASSERT_TRUE((stopped_step<LinearlyImplicitEuler>(x, 10.0 * side, 30.0).ok()));
    EXPECT_NEAR(static_cast<double>(x.q[0]), side * (0.5 + 10.0 / stiffness), 1e-6);
    EXPECT_NEAR(static_cast<double>(x.qd[0]), 0.0, 1e-4);
  }
}

// A damper in the stop does not hold back what leaves it.
TYPED_TEST(EndStop, NeverPulls) {
  using T = TypeParam;
  Motion<Free, T> x;
  x.q[0] = T(0.5001), x.qd[0] = T(-3);
  ASSERT_TRUE((stopped_step<LinearlyImplicitEuler>(x, 0.0, 1e3).ok()));
  EXPECT_EQ(x.qd[0], T(-3));
}

TYPED_TEST(EndStop, HoldsAJointThatSticks) {
  using T = TypeParam;
  Motion<Rubbing, T> x;
  x.q[0] = T(0.49), x.qd[0] = T(3);
  for (int k = 0; k < 2000; ++k) {
    ASSERT_TRUE((stopped_step<StickingEuler>(x, 0.0, 30.0).ok()));
    ASSERT_LE(std::fabs(x.qd[0]), T(3));
    ASSERT_LT(std::fabs(x.q[0]), T(0.5 + 3.01 * h));
  }
  EXPECT_EQ(x.qd[0], T(0));
  const T there = x.q[0];
  for (int k = 0; k < 60'000; ++k)
    ASSERT_TRUE((stopped_step<StickingEuler>(x, 0.19, 30.0).ok()));
  EXPECT_EQ(x.q[0], there) << "for a minute, pushed by less than breaks it away";
}

// The drive's effort and its own stiffness go on to a drive inside, and on.
TYPED_TEST(EndStop, LeavesADriveItsOwnStiffness) {
  using T = TypeParam;
  const auto servo = [](const Instant<Free, T>& at, EffortsOf<Free, T>& tau, Inputs<Free, T>&,
                        DriveStiffness<Free, T>& told) {
    tau[0] = T(stiffness) * (T(0.25) - at.q[0]), told.stiffness[0] = T(stiffness);
  };
  const WithEndStops<Free, T, decltype(servo)> drive(servo, {stiffness, 0.0});
  Motion<Free, T> x;
  for (int k = 0; k < 200; ++k)
    ASSERT_TRUE((advance<LinearlyImplicitEuler>(x, static_cast<T>(h), drive).ok()));
  EXPECT_NEAR(static_cast<double>(x.q[0]), 0.25, 1e-6);
}

TYPED_TEST(EndStop, MethodsThatCannotAreToldBeforeTheyDo) {
  using T = TypeParam;
  DriveStiffness<Free, T> told{};
  told.stiffness[0] = T(stiffness);
  const Positions<Wheel, T> q{};
  const Inputs<Free, T> in{};
  using Code = Status::Code;
  const auto explicit_limit = step_limit<SemiImplicitEuler, Free>(q, in, told);
  EXPECT_EQ(explicit_limit.judge(T(h)).code, Code::input_limit);
  EXPECT_EQ((step_limit<RungeKutta4, Free>(q, in, told).judge(T(h)).code), Code::input_limit);
  EXPECT_TRUE((step_limit<LinearlyImplicitEuler, Free>(q, in, told).judge(T(h)).ok()));
  EXPECT_TRUE((step_limit<StickingEuler, Free>(q, in, told).judge(T(h)).ok()));
  // What was told is so: 2 / w is the limit, and a step beyond it blows up.
  EXPECT_NEAR(static_cast<double>(explicit_limit.seconds), 2.0 / std::sqrt(stiffness / inertia), 1e-6);
  Motion<Free, T> x;
  x.q[0] = T(0.4999), x.qd[0] = T(3);
  double most = 0.0;
  for (int k = 0; k < 200; ++k)
    if (stopped_step<SemiImplicitEuler>(x, 10.0, 0.0).ok())
      most = std::max(most, std::fabs(static_cast<double>(x.qd[0])));
  EXPECT_GT(most, 30.0);
}

// A joint of 1e5 N m/rad behind 1e-3 kg m^2, for a minute: it comes to rest where its spring does, whatever it was
// given.
TYPED_TEST(EndStop, AStiffJointComesToRest) {
  using T = TypeParam;
  Motion<Sprung, T> x;
  x.q[0] = T(0.26), x.qd[0] = T(3);
  for (int k = 0; k < 60'000; ++k) {
    ASSERT_TRUE((advance<LinearlyImplicitEuler>(x, static_cast<T>(h), Held<Sprung, T>{{T(10)}, {}}).ok()));
    ASSERT_LE(std::fabs(x.q[0] - T(0.25)), T(0.0131));
  }
  const double count = turn / (1 << 20);
  EXPECT_NEAR(static_cast<double>(x.q[0]), 0.25 + 10.0 / stiffness, count);
  EXPECT_NEAR(static_cast<double>(x.qd[0]), 0.0, 1e-4);
}

// An arm that hits two stops at once under its motors' torque, in float as a board has it: kinetic energy never exceeds
// what it came with and what its motors spend.
TEST(EndStops, OfAPumaTakeNoMoreThanTheyAreGiven) {
  using R = robots::Puma560;
  using S = Scene<R, Gravity, RotorInertia>;
  Motion<S, float> x;
  const Held<S, float> held{{30.0F, 0.0F, 40.0F, 2.0F, 0.0F, 0.0F}, {}};
  const WithEndStops<S, float, Held<S, float>> drive(held, {1e5, 50.0});
  const auto total = [&] {
    Positions<R, double> q{};
    Velocities<R, double> qd{};
    for (int i = 0; i < 6; ++i)
      q[i] = static_cast<double>(x.q[i]), qd[i] = static_cast<double>(x.qd[i]);
    return energy<S>(q, qd).total();
  };
  double spent = total();
  for (int k = 0; k < 5000; ++k) {
    const auto before = x.q;
    ASSERT_TRUE(advance<LinearlyImplicitEuler>(x, 1e-3F, drive).ok());
    for (int i = 0; i < 6; ++i)
      spent += static_cast<double>(held.tau[i]) * static_cast<double>(x.q[i] - before[i]);
    ASSERT_LT(total(), spent + 0.5 + 0.02 * std::fabs(spent)) << k;
    for (int i = 0; i < 6; ++i)
      ASSERT_LT(static_cast<double>(std::fabs(x.q[i])), 4.8) << "joint " << i << ", step " << k;
  }
}

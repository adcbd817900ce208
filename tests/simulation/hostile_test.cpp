// Bad numbers in steps and step limits: a status, and the state stays the last good one.
#include <gtest/gtest.h>
#include <axial/dynamics/check_finite.hpp>
#include <axial/links/model.hpp>
#include <axial/robot/chain.hpp>
#include <axial/simulation/step_limit.hpp>

#include <cmath>
#include <cstring>
#include <limits>

namespace {

using namespace axial;
using Code = Status::Code;

struct Arm {
  static constexpr auto chain = axial::chain(
      gravity(0.0, -9.81, 0.0),
      revolute().mass(2.0).com(0.3, 0.0, 0.0).inertia_com(0.01, 0.02, 0.02).spring(40.0).viscous(0.2),
      revolute().a(0.5).alpha_deg(30).mass(1.0).com(0.2, 0.0, 0.0).inertia_com(0.01, 0.02, 0.02).spring(10.0, 0.1),
      prismatic().a(0.4).alpha_deg(90).mass(0.5).inertia_com(0.001, 0.001, 0.001).spring(300.0));
};
using S = Scene<Arm, Gravity, JointSprings, Friction>;
using RunTime = Model<4, Gravity, JointSprings, Friction>;

template <class T>
constexpr T hostile[] = {std::numeric_limits<T>::quiet_NaN(),   std::numeric_limits<T>::infinity(),
                         -std::numeric_limits<T>::infinity(),   std::numeric_limits<T>::max(),
                         sizeof(T) == 4 ? T(-1e25) : T(-1e170), T(1e12),
                         std::numeric_limits<T>::denorm_min()};

template <class X>
X moving() {
  X x;
  for (int i = 0; i < 3; ++i)
    x.q[i] = typename X::Scalar(0.3) * typename X::Scalar(i + 1), x.qd[i] = typename X::Scalar(0.1);
  return x;
}
template <class Values>
bool same(const Values& a, const Values& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
template <class S, class T>
bool same(const Motion<S, T>& a, const Motion<S, T>& b) {
  return same(a.q, b.q) && same(a.qd, b.qd) && a.steps == b.steps;
}
template <class S, class T>
bool same(const CompensatedMotion<S, T>& a, const CompensatedMotion<S, T>& b) {
  const Motion<S, T>&x = a, &y = b;
  return same(x, y) && same(a.q_rest, b.q_rest) && same(a.qd_rest, b.qd_rest);
}

// Each number that a step takes (q, qd, tau, h), by each hostile one.
template <class X, class Advance>
void expect_state_kept(const Advance& advance) {
  using T = typename X::Scalar;
  for (const T bad : hostile<T>)
    for (int number = 0; number < 10; ++number) {
      SCOPED_TRACE(testing::Message() << "number " << number << " is " << bad);
      X x = moving<X>();
      Held<typename X::Subject, T> held{};
      T h = T(1e-3);
      for (int k = 0; k < 3; ++k)
        ASSERT_TRUE(advance(x, h, held).ok());
      const X good = x;
      (number < 3 ? x.q[number] : number < 6 ? x.qd[number - 3] : number < 9 ? held.tau[number - 6] : h) = bad;
      const X before = x;
      const Status status = advance(x, h, held);
      if (status.code == Code::not_finite) {
        EXPECT_TRUE(same(x, before));
      } else {
        EXPECT_TRUE(check_finite(x.q, x.qd).ok());
        EXPECT_EQ(x.steps, before.steps + 1);
      }
      if (!std::isfinite(bad)) {
        EXPECT_EQ(status.code, Code::not_finite);
      }
      // The caller mends what was bad, and goes on from where the robot was.
      if (number >= 6 && status.code == Code::not_finite) {
        EXPECT_TRUE(same(x, good));
        EXPECT_TRUE(advance(x, T(1e-3), Held<typename X::Subject, T>{}).ok());
      }
    }
}

template <class T>
class Steps : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(Steps, Numbers);

RunTime model() {
  RunTime all;
  for (const auto& link : Arm::chain.links)
    EXPECT_TRUE(all.add(link));
  all.set_gravity(0.0, -9.81, 0.0);
  return all;
}

}  // namespace

TYPED_TEST(Steps, KeepTheLastGoodState) {
  using T = TypeParam;
  expect_state_kept<Motion<S, T>>(
      [](auto& x, T h, const auto& held) { return advance<SemiImplicitEuler>(x, h, held); });
  expect_state_kept<CompensatedMotion<S, T>>(
      [](auto& x, T h, const auto& held) { return advance<RungeKutta4>(x, h, held); });
  expect_state_kept<Motion<S, T>>(
      [](auto& x, T h, const auto& held) { return advance<LinearlyImplicitEuler>(x, h, held); });
}
TYPED_TEST(Steps, OfRunTimeModelsKeepIt) {
  using T = TypeParam;
  const auto robot = model();
  expect_state_kept<Motion<RunTime, T>>(
      [&](auto& x, T h, const auto& held) { return advance<RungeKutta4>(robot, x, h, held); });
}

// A step that overflows though all that it takes is finite.
TYPED_TEST(Steps, ThatOverflowAreNotMade) {
  using T = TypeParam;
  Motion<S, T> x = moving<Motion<S, T>>();
  x.qd[0] = std::numeric_limits<T>::max() / T(4);
  const auto before = x;
  EXPECT_EQ(advance<SemiImplicitEuler>(x, T(100), Held<S, T>{}).code, Code::not_finite);
  EXPECT_TRUE(same(x, before));
  EXPECT_EQ(x.steps, 0u);
}

// Whatever comes before it, what is not finite is what a step of several evaluations says.
TEST(StepStatus, NotFiniteComesFirst) {
  using Sums = detail::Summation<S, double>;
  const Status singular{Code::near_singular, 2}, broken{Code::not_finite, -1}, ok{};
  EXPECT_EQ(detail::first_of<Sums>(singular, broken).code, Code::not_finite);
  EXPECT_EQ(detail::first_of<Sums>(broken, singular).code, Code::not_finite);
  EXPECT_EQ(detail::first_of<Sums>(ok, singular).joint, 2);
  EXPECT_EQ(detail::first_of<Sums>(singular, ok).joint, 2);
}

TYPED_TEST(Steps, HaveNoLimitWhereNumbersAreNone) {
  using T = TypeParam;
  const auto q = moving<Motion<S, T>>().q;
  const auto right = step_limit<SemiImplicitEuler, S>(q);
  ASSERT_TRUE(right.status.ok());
  ASSERT_GT(right.seconds, T(0));
  EXPECT_EQ(static_cast<T>(right), right.seconds);
  for (const T bad : {hostile<T>[0], hostile<T>[1], hostile<T>[2]})
    for (int i = 0; i < 3; ++i) {
      auto bent = q;
      bent[i] = bad;
      DriveStiffness<S, T> drive{};
      (i == 0 ? drive.damping : drive.stiffness)[i] = bad;
      for (const auto& limit :
           {step_limit<SemiImplicitEuler, S>(bent), step_limit<RungeKutta4, S>(bent),
            step_limit<LinearlyImplicitEuler, S>(bent), step_limit<SemiImplicitEuler, S>(q, {}, drive)}) {
        EXPECT_EQ(limit.status.code, Code::not_finite);
        EXPECT_EQ(limit.seconds, T(0));
      }
    }
  auto far = q;
  far[0] = T(1e9);
  EXPECT_EQ((step_limit<SemiImplicitEuler, S>(far).status.code), Code::angle_range);
}

// Stiffnesses of any size that a number holds: squares neither overflow nor vanish. h is as 1/sqrt(k), 1/d.
TYPED_TEST(Steps, AreLimitedWhateverTheSizeOfTheSprings) {
  using T = TypeParam;
  using Bare = Scene<Arm, Gravity>;
  const auto q = moving<Motion<Bare, T>>().q;
  const auto limit = [&](T stiffness, T damping) {
    DriveStiffness<Bare, T> drive{};
    for (int i = 0; i < 3; ++i)
      drive.stiffness[i] = stiffness, drive.damping[i] = damping;
    const auto found = step_limit<SemiImplicitEuler, Bare>(q, {}, drive);
    EXPECT_TRUE(found.status.ok()) << stiffness << ' ' << damping;
    return static_cast<double>(found.seconds);
  };
  const double spring = limit(T(1), T(0)), damper = limit(T(0), T(1)), huge = sizeof(T) == 4 ? 1e28 : 1e200,
               tolerance = sizeof(T) == 4 ? 1e-4 : 1e-12;
  for (const double size : {1.0 / huge, 1e-9, 1e9, huge}) {
    EXPECT_NEAR(limit(T(size), T(0)) * std::sqrt(size) / spring, 1.0, tolerance) << size;
    EXPECT_NEAR(limit(T(0), T(size)) * size / damper, 1.0, tolerance) << size;
  }
}

// Of angles of very many turns sines are not exact: the state moves on, and the status says so, whatever the method.
TYPED_TEST(Steps, OfVeryManyTurnsSaySo) {
  using T = TypeParam;
  const auto status = [](auto method) {
    auto x = moving<Motion<S, T>>();
    x.q[1] = T(1.5) * largest_angles<T>;
    const Status found = advance<decltype(method)>(x, T(1e-6), Held<S, T>{});
    EXPECT_EQ(x.steps, 1u);
    return found.code;
  };
  EXPECT_EQ(status(SemiImplicitEuler{}), Code::angle_range);
  EXPECT_EQ(status(RungeKutta4{}), Code::angle_range);
  EXPECT_EQ(status(LinearlyImplicitEuler{}), Code::angle_range);
}

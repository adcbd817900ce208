// Motions in fixed point: what their sums keep, which states are not kept, and that the compiler computes the same
// bits.
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/step_limit.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace axial;

/// A wheel and a carriage that nothing moves: their motions are known.
struct Free {
  static constexpr auto chain = axial::chain(
      gravity(0.0, 0.0, 0.0), payload_limit(1.0, 0.1, 0.1),
      revolute()
          .mass(1.0)
          .inertia_com(0.25, 0.25, 0.5)
          .position_limits(-1.0, 1.0)
          .speed_limit(3.0)
          .acceleration_limit(8.0)
          .effort_limit(4.0),
      prismatic().mass(2.0).position_limits(-0.5, 0.5).speed_limit(1.0).acceleration_limit(4.0).effort_limit(8.0));
};
using S = Scene<Free, Gravity>;

template <class X>
double angle_of(const X& x) {
  return (x.q[0].raw + std::ldexp(x.q_rest[0], -32)) / detail::bam_per_radian;
}
template <class Values>
double real(const Values& values, const std::int32_t* rests, int i) {
  return std::ldexp(values[i].raw + std::ldexp(rests[i], -32), -Values::exponent(i));
}
Motion<S, Fixed32> moving(double turn, double slide) {
  Motion<S, Fixed32> x;
  x.qd = to_fixed<Velocities<Free, Fixed32>>(Joints<Free, double>{turn, slide}).values;
  return x;
}
Held<S, Fixed32> pulled(double turn, double slide) {
  return {to_fixed<EffortsOf<S, Fixed32>>(Joints<Free, double>{turn, slide}).values, {}};
}

template <class Method>
class Words : public testing::Test {};
using Methods = testing::Types<SemiImplicitEuler, RungeKutta4>;
TYPED_TEST_SUITE(Words, Methods);

}  // namespace

// A hundredth of a unit per step, twenty thousand times: words alone would stand still.
TYPED_TEST(Words, LoseNothingOfSmallSteps) {
  constexpr int steps = 20'000;
  constexpr double h = 0x1p-20, turn_rate = 0x1p-19, slide_rate = 0x1p-14;
  auto x = moving(turn_rate, slide_rate);
  const double unit = std::ldexp(1.0, -Positions<Free, Fixed32>::exponent(1));
  ASSERT_LT(h * turn_rate * detail::bam_per_radian, 0.01) << "of a unit";
  for (int k = 0; k < steps; ++k)
    ASSERT_TRUE(advance<TypeParam>(x, h, Held<S, Fixed32>{}).ok());
  const double tolerance = 2.0 * 0x1p-29;  // of what was travelled, for h and h / 2 pi; and 2^-33 of a unit per step
  EXPECT_NEAR(angle_of(x), turn_rate * steps * h,
              turn_rate * steps * h * tolerance + steps * 0x1p-33 / detail::bam_per_radian);
  EXPECT_NEAR(real(x.q, x.q_rest, 1), slide_rate * steps * h,
              slide_rate * steps * h * tolerance + steps * 0x1p-33 * unit);
  EXPECT_EQ(x.steps, static_cast<std::uint64_t>(steps));
  EXPECT_EQ(x.time(h, 1), 2U * steps + 1U) << "half steps";
}

// Speeds of constant accelerations, and the positions of Runge and Kutta, are exact but for words.
TYPED_TEST(Words, SumAccelerations) {
  constexpr double h = 1e-3;
  constexpr int steps = 500;
  auto x = moving(0.0, 0.0);
  const auto held = pulled(1.5, 0.5);  // 3 rad/s^2, 0.25 m/s^2
  for (int k = 0; k < steps; ++k)
    ASSERT_TRUE(advance<TypeParam>(x, h, held).ok());
  const double t = h * steps;
  EXPECT_NEAR(real(x.qd, x.qd_rest, 0), 3.0 * t, 1e-6);
  EXPECT_NEAR(real(x.qd, x.qd_rest, 1), 0.25 * t, 1e-6);
  const double first_order = TypeParam::order == 1 ? 0.5 * h * t : 0.0;
  EXPECT_NEAR(angle_of(x), 3.0 * (0.5 * t * t + first_order), 1e-6);
  EXPECT_NEAR(real(x.q, x.q_rest, 1), 0.25 * (0.5 * t * t + first_order), 1e-6);
}

TYPED_TEST(Words, TurnForEver) {
  auto x = moving(3.0, 0.0);
  double turns = 0.0;
  for (int k = 0; k < 10'000; ++k) {
    const std::int32_t before = x.q[0].raw;
    const auto status = advance<TypeParam>(x, 1e-3, Held<S, Fixed32>{});
    ASSERT_TRUE(status.ok() || status.code == Status::Code::position_limit) << "an angle beyond its limits is told";
    turns += static_cast<std::int32_t>(static_cast<std::uint32_t>(x.q[0].raw) - static_cast<std::uint32_t>(before)) *
             0x1p-32;
  }
  EXPECT_NEAR(turns * 6.283185307179586, 30.0, 1e-6);
}

namespace {

template <class Method>
void expect_left_alone(const Motion<S, Fixed32>& start, const FixedStep& h, const Held<S, Fixed32>& held,
                       Status::Code code, int joint) {
  auto x = start;
  x.steps = 7, x.q_rest[1] = 5, x.qd_rest[0] = -6;
  const Status status = advance<Method>(x, h, held);
  EXPECT_EQ(status.code, code);
  EXPECT_EQ(status.joint, joint);
  EXPECT_TRUE(x.q[0] == start.q[0] && x.q[1] == start.q[1] && x.qd[0] == start.qd[0] && x.qd[1] == start.qd[1]);
  EXPECT_TRUE(x.steps == 7 && x.q_rest[1] == 5 && x.qd_rest[0] == -6);
}

}  // namespace

TYPED_TEST(Words, LeaveAStateAloneThatWouldBeBeyondItsLimits) {
  using Code = Status::Code;
  constexpr auto alone = [](auto... given) { expect_left_alone<TypeParam>(given...); };
  const auto still = moving(0.0, 0.0), fast = moving(2.9999, 0.0);
  auto at_the_end = moving(0.0, 0.5);
  at_the_end.q[1].raw = static_cast<std::int32_t>(0.4999 * std::ldexp(1.0, Positions<Free, Fixed32>::exponent(1)));
  auto beyond = at_the_end;
  beyond.qd[0].raw = (std::numeric_limits<std::int32_t>::min)();
  alone(fast, 1e-3, pulled(4.0, 0.0), Code::speed_limit, 0);
  alone(still, 1.0, pulled(0.0, 8.0), Code::speed_limit, 1);  // 4 m/s: far beyond the word
  alone(still, 1.0, pulled(4.0, -8.0), Code::speed_limit, 0);
  alone(at_the_end, 1e-3, pulled(0.0, 0.0), Code::position_limit, 1);
  alone(beyond, 1e-3, pulled(0.0, 0.0), Code::speed_limit, 0);
  alone(still, 0.0, pulled(1.0, 0.0), Code::input_limit, -1);
  alone(still, std::nan(""), pulled(1.0, 0.0), Code::input_limit, -1);
}

// The angle of joint 0 is beyond its limits, which comes first and is no harm; what the slide does is.
TYPED_TEST(Words, SayWhatIsLostBeforeWhatIsTold) {
  auto x = moving(0.5, 0.0);
  x.q[0].raw = detail::raw_angle(1.5);
  EXPECT_EQ(advance<TypeParam>(x, 1e-3, Held<S, Fixed32>{}).code, Status::Code::position_limit);
  EXPECT_EQ(x.steps, 1U) << "an angle has no end";
  x.qd[1].raw = (std::numeric_limits<std::int32_t>::max)();
  const Status status = advance<TypeParam>(x, 1e-3, Held<S, Fixed32>{});
  EXPECT_EQ(status.code, Status::Code::speed_limit);
  EXPECT_EQ(status.joint, 1);
  EXPECT_EQ(x.steps, 1U);
  // Beyond its end the slide has no acceleration, though it would be back after the step.
  x.qd[1].raw = -(1 << 28), x.q[1].raw = fixed_limits_of<S, std::int32_t>.joints[1].max + 1;
  const Status slid = advance<TypeParam>(x, 1e-3, Held<S, Fixed32>{});
  EXPECT_EQ(slid.code, Status::Code::position_limit);
  EXPECT_EQ(slid.joint, 1);
  EXPECT_EQ(x.steps, 1U);
}

TYPED_TEST(Words, RefuseInputsBeyondWhatIsDeclared) {
  using Loaded = Scene<Free, Gravity, Payload>;
  Motion<Loaded, Fixed32> x;
  Held<Loaded, Fixed32> held;
  held.in.payload.mass.raw = (std::numeric_limits<std::int32_t>::max)();
  const Status status = advance<TypeParam>(x, 1e-3, held);
  EXPECT_EQ(status.code, Status::Code::payload_limit);
  EXPECT_EQ(x.steps, 0U);
}

namespace {

/// A wheel in thick grease: 4000 1/s.
struct Greased {
  static constexpr auto chain = axial::chain(
      gravity(0.0, 0.0, 0.0),
      revolute().mass(1.0).inertia_com(0.25, 0.25, 0.5).viscous(2000.0).speed_limit(3.0).acceleration_limit(16000.0));
};
using Grease = Scene<Greased, Friction>;

/// Status of the first step that is not made, of many from full speed; what is left of the speed.
template <class Method>
Status stopped(double h, double& speed) {
  Motion<Grease, Fixed32> x;
  x.qd = to_fixed<Velocities<Greased, Fixed32>>(Joints<Greased, double>{1.0}).values;
  Status status;
  for (int k = 0; k < 200 && status.ok(); ++k)
    status = advance<Method>(x, h, Held<Grease, Fixed32>{});
  speed = std::fabs(to_real<double>(x.qd)[0]);
  return status;
}

}  // namespace

// The limit in float is theirs; beyond it they say so before a word wraps.
TYPED_TEST(Words, BlowUpIntoAStatus) {
  const auto limit = step_limit<TypeParam, Grease>(Joints<Greased, float>{});
  const double inside = 0.9 * static_cast<double>(limit), beyond = 1.2 * static_cast<double>(limit);
  double speed = 0.0;
  EXPECT_TRUE(limit.judge(static_cast<float>(inside)).ok());
  EXPECT_FALSE(limit.judge(static_cast<float>(beyond)).ok());
  EXPECT_TRUE(stopped<TypeParam>(inside, speed).ok());
  EXPECT_LE(speed, 1e-6);
  const Status status = stopped<TypeParam>(beyond, speed);
  EXPECT_EQ(status.code, Status::Code::speed_limit);
  EXPECT_EQ(status.joint, 0);
  EXPECT_LE(speed, 3.0);
}

namespace {

template <class Method>
constexpr Motion<S, Fixed32> computed() {
  Motion<S, Fixed32> x;
  x.qd[0].raw = 123456789, x.qd[1].raw = -98765432;
  Held<S, Fixed32> held;
  held.tau[0].raw = 7654321, held.tau[1].raw = -1234567;
  for (int k = 0; k < 5; ++k)
    (void)advance<Method>(x, 1.0 / 3000.0, held);
  return x;
}

}  // namespace

// A constant expression has no compiler's options and no processor: what runs must be those bits.
TYPED_TEST(Words, AreTheBitsOfAConstantExpression) {
  constexpr auto by_compiler = computed<TypeParam>();
  const auto run = computed<TypeParam>();
  EXPECT_EQ(by_compiler.steps, 5U);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(run.q[i] == by_compiler.q[i] && run.qd[i] == by_compiler.qd[i]) << i;
    EXPECT_TRUE(run.q_rest[i] == by_compiler.q_rest[i] && run.qd_rest[i] == by_compiler.qd_rest[i]) << i;
  }
  EXPECT_EQ(sizeof(run), (2 + 2 + 2 + 2) * sizeof(std::int32_t) + sizeof(std::uint64_t));
}

// Gravity compensation for hand guiding: what carries the arm, checked, clamped, no faster than declared.
#include "arms.hpp"
#include "safe_loop.hpp"

using namespace axial;
using safe_loop::Case;
using safe_loop::Code;
using safe_loop::expect_status;

namespace {

using Cases = control_tests::MoreArms<Case>;

template <class C>
class GravityCompensation : public testing::Test {
 protected:
  static constexpr int n = C::n;
  using S = typename C::S;
  using T = typename C::T;
  using Real = typename C::Real;
  static Real weight(const Real& q) { return gravity_torque<S, double>(q); }

  SafeLoopState<S, T> state_{};
};
TYPED_TEST_SUITE(GravityCompensation, Cases);

}  // namespace

TYPED_TEST(GravityCompensation, CarriesTheArmWhereItIs) {
  for (const double share : {0.25, 0.5, 0.75}) {
    const auto q = TypeParam::position(share);
    const auto answer = compensate_gravity<typename TypeParam::S>(this->state_, TypeParam::place(q));
    EXPECT_TRUE(answer.status.ok());
    TypeParam::expect_near(TypeParam::real(answer.tau), this->weight(q), "weight");
    TypeParam::expect_near(TypeParam::real(this->state_.output.last), this->weight(q), "remembered");
  }
}

TYPED_TEST(GravityCompensation, KeepsWhatCarriedTheArmWhereThePositionIsBad) {
  using S = typename TypeParam::S;
  const auto good = TypeParam::position(0.4);
  const auto carried = compensate_gravity<S>(this->state_, TypeParam::place(good)).tau;
  for (int i = 0; i < this->n; ++i) {
    if constexpr (is_stored_v<typename TypeParam::T>)
      if (fixed_limits_of<S, std::int32_t>.joints[i].span == std::numeric_limits<std::uint32_t>::max())
        continue;  // a joint that may turn for ever
    for (const double bad : TypeParam::bad_positions(i)) {
      auto q = TypeParam::position(0.6);
      q[i] = bad;
      auto place = TypeParam::place(q);
      if constexpr (is_stored_v<typename TypeParam::T>)
        place[i].raw = fixed_limits_of<S, std::int32_t>.joints[i].max + 1;  // the conversion would bring it inside
      const auto answer = compensate_gravity<S>(this->state_, place);
      expect_status(answer.status, std::isfinite(bad) ? Code::position_limit : Code::not_finite, i);
      EXPECT_FALSE(answer.status.met());
      TypeParam::expect_near(TypeParam::real(answer.tau), TypeParam::real(carried), "kept");
    }
  }
}

TYPED_TEST(GravityCompensation, StartsWithNoEffort) {
  auto q = TypeParam::place(TypeParam::position(0.4));
  if constexpr (is_stored_v<typename TypeParam::T>)
    q[0].raw = fixed_limits_of<typename TypeParam::S, std::int32_t>.joints[0].max + 1;
  else
    q[0] = NAN;
  const auto answer = compensate_gravity<typename TypeParam::S>(this->state_, q);
  EXPECT_FALSE(answer.status.met());
  TypeParam::expect_near(TypeParam::real(answer.tau), {}, "nothing");
}

TYPED_TEST(GravityCompensation, ChangesNoFasterThanDeclared) {
  using S = typename TypeParam::S;
  const auto step = TypeParam::efforts(0.01);
  this->state_.output.step = TypeParam::effort(step);
  auto last = TypeParam::real(this->state_.output.last);
  bool slowed = false;
  for (int k = 0; k < 200; ++k) {
    const bool jump = k >= 100;  // the position jumps, as a slipping encoder's would
    const auto q = TypeParam::position(jump ? 0.85 : 0.3);
    const auto answer = compensate_gravity<S>(this->state_, TypeParam::place(q));
    const auto now = TypeParam::real(answer.tau);
    bool limited = false;
    for (int i = 0; i < this->n; ++i) {
      EXPECT_LE(std::fabs(now[i] - last[i]), step[i] + TypeParam::tolerance(i)) << k << ", joint " << i;
      limited = limited || std::fabs(now[i] - this->weight(q)[i]) > TypeParam::tolerance(i);
    }
    EXPECT_EQ(answer.status.code == Code::effort_rate, limited) << k;
    EXPECT_TRUE(answer.status.met());
    slowed = slowed || limited;
    last = now;
  }
  EXPECT_TRUE(slowed);
  TypeParam::expect_near(last, this->weight(TypeParam::position(0.85)), "arrived");
}

TYPED_TEST(GravityCompensation, IsSlowWhereItIsBadToo) {
  using S = typename TypeParam::S;
  const auto q = TypeParam::position(0.4);
  (void)compensate_gravity<S>(this->state_, TypeParam::place(q));
  this->state_.output.last = TypeParam::effort({});  // drives that something else had switched off
  this->state_.output.step = TypeParam::effort(TypeParam::efforts(0.001));
  auto bad = TypeParam::place(q);
  if constexpr (is_stored_v<typename TypeParam::T>)
    bad[0].raw = fixed_limits_of<S, std::int32_t>.joints[0].max + 1;
  else
    bad[0] = NAN;
  const auto answer = compensate_gravity<S>(this->state_, bad);
  EXPECT_FALSE(answer.status.met());
  for (int i = 0; i < this->n; ++i)
    EXPECT_LE(std::fabs(TypeParam::real(answer.tau)[i]),
              0.001 * TypeParam::link(i).effort_limit + TypeParam::tolerance(i));
}

namespace {

struct Heavy {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -10.0, 0.0), payload_limit(2.0, 0.5, 0.1),
                   revolute().mass(4).com(0.5, 0, 0).inertia_com(0, 0.1, 0.1).effort_limit(15),
                   revolute().a(1.0).mass(1).com(0.5, 0, 0).inertia_com(0, 0.1, 0.1).effort_limit(30).spring(8, 0.25));
};

}  // namespace

// The first joint would need 35 N m, the second needs 5 N m.
TEST(GravityCompensationOf, ClampsToTheDeclaredEffortsAndSaysSo) {
  SafeLoopState<Heavy, double> state;
  const auto answer = compensate_gravity<Heavy>(state, Joints<Heavy, double>{0.0, 0.0});
  expect_status(answer.status, Code::effort_limit, 0);
  EXPECT_TRUE(answer.status.met());
  EXPECT_EQ(answer.tau[0], 15.0);
  EXPECT_NEAR(answer.tau[1], 5.0, 1e-12);
}

// 2 kg at 0.25 m beyond the second joint: 5 N m more at it, 25 N m at the first.
TEST(GravityCompensationOf, CarriesThePayload) {
  using S = Scene<Heavy, Gravity, Payload>;
  SafeLoopState<S, double> state;
  Inputs<S, double> in{};
  in.payload.mass = 2.0, in.payload.com = {0.25, 0.0, 0.0};
  const auto answer = compensate_gravity<S>(state, Joints<Heavy, double>{1.5707963267948966, 0.0}, in);
  EXPECT_TRUE(answer.status.ok());
  EXPECT_NEAR(answer.tau[1], 0.0, 1e-12);
  const auto flat = compensate_gravity<S>(state, Joints<Heavy, double>{0.0, 0.0}, in);
  EXPECT_NEAR(flat.tau[1], 10.0, 1e-12);
  in.payload.mass = 2.5;
  const auto refused = compensate_gravity<S>(state, Joints<Heavy, double>{1.5, 0.0}, in);
  expect_status(refused.status, Code::payload_limit, -1);
  EXPECT_NEAR(refused.tau[1], 10.0, 1e-12) << "what carried the arm before";
}

TEST(GravityCompensationOf, HoldsAgainstTheSprings) {
  using S = Scene<Heavy, Gravity, JointSprings>;
  SafeLoopState<S, double> state;
  const auto answer = compensate_gravity<S>(state, Joints<Heavy, double>{1.5707963267948966, 0.5});
  EXPECT_NEAR(answer.tau[1], 10.0 * 0.5 * std::cos(1.5707963267948966 + 0.5) + 8.0 * 0.25, 1e-12);
}

TEST(GravityCompensationOf, AnInputThatOverflowsKeepsTheLastGoodEffort) {
  using S = Scene<Heavy, RuntimeGravity>;
  SafeLoopState<S, float> state;
  Inputs<S, float> in{};
  const Joints<Heavy, float> q{1.0F, 0.5F};
  const auto carried = compensate_gravity<S>(state, q, in);
  for (const float g : {NAN, INFINITY, -3e38F}) {
    in.gravity = {0.0F, g, g};
    const auto answer = compensate_gravity<S>(state, q, in);
    expect_status(answer.status, Code::not_finite, -1);
    for (int i = 0; i < 2; ++i)
      EXPECT_EQ(answer.tau[i], carried.tau[i]) << g;
  }
}

/// Finite in all that it says, and too stiff for a float at 2 rad.
struct Stiff {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -10.0, 0.0), revolute().mass(1.0).position_limits(-3.0, 3.0).spring(3e38, 0.0));
};

TEST(GravityCompensationOf, AnInputThatOverflowsASpringKeepsTheLastGoodEffort) {
  using S = Scene<Stiff, Gravity, JointSprings>;
  SafeLoopState<S, float> state;
  const auto carried = compensate_gravity<S>(state, Joints<Stiff, float>{0.0F});
  const auto answer = compensate_gravity<S>(state, Joints<Stiff, float>{2.0F});
  expect_status(answer.status, Code::not_finite, -1);
  EXPECT_EQ(answer.tau[0], carried.tau[0]);
}

TEST(EffortRamp, AStepThatIsNoNumberOrNegativeAllowsNoChange) {
  EffortRamp<Heavy, float> ramp;
  for (const float step : {NAN, -1.0F}) {
    ramp.step = {step, step};
    Efforts<Heavy, float> tau{3.0F, -3.0F};
    expect_status(ramp.limit(tau), Code::effort_rate, 0);
    EXPECT_EQ(tau[0], 0.0F);
    EXPECT_EQ(tau[1], 0.0F);
  }
}

TEST(EffortRamp, NamesTheFirstJointThatItSlows) {
  EffortRamp<Heavy, float> ramp;
  ramp.step = {1.0F, 2.0F};
  Efforts<Heavy, float> tau{1.0F, -3.0F};
  expect_status(ramp.limit(tau), Code::effort_rate, 1);
  EXPECT_EQ(tau[0], 1.0F);
  EXPECT_EQ(tau[1], -2.0F);
  tau = {2.0F, -3.5F};
  EXPECT_TRUE(ramp.limit(tau).ok());
  EXPECT_EQ(ramp.last[1], -3.5F);
}

TEST(EffortRamp, OfWordsGoesFromEndToEndWhereNothingLimitsIt) {
  using S = robots::Scara;
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  EffortRamp<S, Fixed32> ramp;
  for (const std::int32_t end : {most, -most - 1, most}) {
    EffortsOf<S, Fixed32> tau{};
    for (int i = 0; i < 3; ++i)
      tau[i].raw = end;
    EXPECT_TRUE(ramp.limit(tau).ok());
    EXPECT_EQ(tau[2].raw, end);
  }
  ramp.step[1].raw = 7;
  EffortsOf<S, Fixed32> down{};
  for (int i = 0; i < 3; ++i)
    down[i].raw = -most - 1;
  expect_status(ramp.limit(down), Code::effort_rate, 1);
  EXPECT_EQ(down[0].raw, -most - 1);
  EXPECT_EQ(down[1].raw, most - 7);
}

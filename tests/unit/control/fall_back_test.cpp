// Torques of the fall-back, in float, double and fixed point: what is exerted in each phase, and in what steps.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <cmath>

#include "arms.hpp"

using namespace axial;

namespace {

constexpr FallBackTimes times{3, 8, 5};
constexpr double resolution = 1.0 / 65536.0;  // of the share

template <class R_, class T_>
struct Case {
  using R = R_;
  using T = T_;
  using Real = Joints<R, double>;

  /// A motion inside the limits whose torque is not what holds the arm.
  static Real position(double of_range = 0.4) {
    Real q{};
    for (int i = 0; i < Real::size; ++i) {
      const auto& l = R::chain.links[i];
      q[i] = l.position_min + of_range * (l.position_max - l.position_min);
    }
    return q;
  }
  static Real speed() {
    Real qd{};
    for (int i = 0; i < Real::size; ++i)
      qd[i] = 0.5 * R::chain.links[i].speed_limit;
    return qd;
  }
  static Real acceleration() {
    Real qdd{};
    for (int i = 0; i < Real::size; ++i)
      qdd[i] = (i % 2 == 0 ? 0.25 : -0.25) * R::chain.links[i].acceleration_limit;
    return qdd;
  }
  static auto request(const Real& q, const Real& qd = {}, const Real& qdd = {}) {
    if constexpr (is_stored_v<T>) {
      return to_fixed_request<R, typename T::Word>(q, qd, qdd);
    } else {
      Request<R, T> r;
      for (int i = 0; i < Real::size; ++i)
        r.q[i] = static_cast<T>(q[i]), r.qd[i] = static_cast<T>(qd[i]), r.qdd[i] = static_cast<T>(qdd[i]);
      return r;
    }
  }
  static Real real(const EffortsOf<R, T>& tau) {
    if constexpr (is_stored_v<T>) return to_real<double>(tau);
    Real out{};
    if constexpr (!is_stored_v<T>)
      for (int i = 0; i < Real::size; ++i)
        out[i] = static_cast<double>(tau[i]);
    return out;
  }
  static EffortsOf<R, T> torque_of(const Request<R, T>& r) {
    FeedforwardState<R, T> state;
    const auto result = feedforward<R>(state, r.q, r.qd, r.qdd);
    EXPECT_TRUE(result.status.ok());
    return result.tau;
  }
  /// Roundings of a torque: some of T's, or of its format.
  static double tolerance(int i) {
    const double effort = R::chain.links[i].effort_limit;
    return effort * (std::is_same_v<T, float> ? 1e-6 : std::is_same_v<T, double> ? 1e-14 : 1e-7);
  }
};

using Cases = control_tests::Arms<Case>;

template <class C>
class FallBackOf : public testing::Test {
 protected:
  using R = typename C::R;
  using T = typename C::T;
  using Real = typename C::Real;

  void move() {
    const auto r = C::request(C::position(), C::speed(), C::acceleration());
    moving_ = C::torque_of(r);
    ASSERT_TRUE(fall_back_.follow(r.q, moving_));
  }
  void wait(int ticks) {
    for (int i = 0; i < ticks; ++i)
      fall_back_.advance(1);
  }
  Real exerted() const { return C::real(fall_back_.torque()); }
  static Real weight(const Real& q) { return C::real(gravity_torque<R>(C::request(q).q)); }
  static void expect_near(const Real& found, const Real& wanted, const char* what) {
    for (int i = 0; i < Real::size; ++i)
      EXPECT_NEAR(found[i], wanted[i], C::tolerance(i)) << what << ", joint " << i;
  }

  FallBack<R, T> fall_back_{times};
  EffortsOf<R, T> moving_{};
};
TYPED_TEST_SUITE(FallBackOf, Cases);

}  // namespace

TYPED_TEST(FallBackOf, ExertsTheLastGoodTorqueWhileItIsYoung) {
  this->move();
  this->expect_near(this->exerted(), TypeParam::real(this->moving_), "at once");
  this->wait(times.patience - 1);
  EXPECT_EQ(this->fall_back_.phase(), DrivePhase::running);
  this->expect_near(this->exerted(), TypeParam::real(this->moving_), "to the end of patience");
}

TYPED_TEST(FallBackOf, TheRampIsAStraightLineToWhatHoldsTheArm) {
  using Real = typename TypeParam::Real;
  this->move();
  this->wait(times.patience);
  const Real from = TypeParam::real(this->moving_), to = this->weight(TypeParam::position());
  Real last = from;
  for (int k = 0; k <= times.ramp; ++k) {
    const Real now = this->exerted();
    for (int i = 0; i < Real::size; ++i) {
      const double share = 1.0 - static_cast<double>(k) / times.ramp, apart = std::fabs(from[i] - to[i]);
      EXPECT_NEAR(now[i], to[i] + share * (from[i] - to[i]), TypeParam::tolerance(i) + resolution * apart);
      EXPECT_LE(std::fabs(now[i] - last[i]), apart / times.ramp + 2 * TypeParam::tolerance(i) + resolution * apart);
      EXPECT_LE((now[i] - last[i]) * (from[i] - to[i]), TypeParam::tolerance(i) * apart) << "monotone";
    }
    last = now;
    if (k < times.ramp) this->wait(1);
  }
  EXPECT_EQ(this->fall_back_.phase(), DrivePhase::holding);
  this->expect_near(last, to, "held");
}

TYPED_TEST(FallBackOf, TheRampIsTheInverseDynamicsOfASlowerMotion) {
  this->move();
  this->wait(times.patience + times.ramp / 2);
  auto qd = TypeParam::speed(), qdd = TypeParam::acceleration();
  for (int i = 0; i < TypeParam::Real::size; ++i)
    qd[i] *= std::sqrt(0.5), qdd[i] *= 0.5;
  const auto slower = TypeParam::torque_of(TypeParam::request(TypeParam::position(), qd, qdd));
  this->expect_near(this->exerted(), TypeParam::real(slower), "half of the ramp");
}

TYPED_TEST(FallBackOf, HoldsForItsTimeThenExertsNothing) {
  this->move();
  this->wait(times.patience + times.ramp);
  this->expect_near(this->exerted(), this->weight(TypeParam::position()), "held");
  this->wait(times.hold - 1);
  EXPECT_TRUE(this->fall_back_.enabled());
  this->expect_near(this->exerted(), this->weight(TypeParam::position()), "to the end");
  this->wait(1);
  EXPECT_EQ(this->fall_back_.phase(), DrivePhase::disabled);
  EXPECT_FALSE(this->fall_back_.enabled());
  this->expect_near(this->exerted(), {}, "disabled");
}

TYPED_TEST(FallBackOf, FindsTheHoldWhateverTheTicksThatWereLate) {
  for (const int late : {times.patience + times.ramp / 2, times.patience + times.ramp}) {
    SCOPED_TRACE(late);
    this->fall_back_ = FallBack<typename TestFixture::R, typename TestFixture::T>(times);
    this->move();
    this->fall_back_.advance(static_cast<std::uint32_t>(late));
    this->wait(times.patience + times.ramp - late);
    this->expect_near(this->exerted(), this->weight(TypeParam::position()), "held");
  }
}

TYPED_TEST(FallBackOf, AGoodRequestEndsItAndOneIsNotEnoughOnceDisabled) {
  this->move();
  this->wait(times.patience + 2);
  this->move();
  EXPECT_EQ(this->fall_back_.phase(), DrivePhase::running);
  this->expect_near(this->exerted(), TypeParam::real(this->moving_), "running again");
  this->wait(1000);
  const auto r = TypeParam::request(TypeParam::position());
  EXPECT_FALSE(this->fall_back_.follow(r.q, this->moving_));
  EXPECT_FALSE(this->fall_back_.hold_at(r.q));
  this->expect_near(this->exerted(), {}, "disabled");
  this->fall_back_.rearm();
  EXPECT_EQ(this->fall_back_.phase(), DrivePhase::idle);
  EXPECT_TRUE(this->fall_back_.follow(r.q, this->moving_));
  EXPECT_TRUE(this->fall_back_.enabled());
}

TYPED_TEST(FallBackOf, HoldsAtAKnownPositionBeforeAnyGoodRequest) {
  this->expect_near(this->exerted(), {}, "idle");
  const auto q = TypeParam::position(0.7);
  EXPECT_TRUE(this->fall_back_.hold_at(TypeParam::request(q).q));
  EXPECT_TRUE(this->fall_back_.enabled());
  this->expect_near(this->exerted(), this->weight(q), "held");
  EXPECT_FALSE(this->fall_back_.hold_at(TypeParam::request(TypeParam::position(0.1)).q)) << "it is held already";
  this->expect_near(this->exerted(), this->weight(q), "held where it was");
  this->wait(times.hold);
  EXPECT_FALSE(this->fall_back_.enabled());
}

TYPED_TEST(FallBackOf, AfterAGoodRequestARefusedOneChangesNothing) {
  this->move();
  EXPECT_FALSE(this->fall_back_.hold_at(TypeParam::request(TypeParam::position(0.7)).q));
  this->expect_near(this->exerted(), TypeParam::real(this->moving_), "running");
  this->wait(times.patience + times.ramp);
  this->expect_near(this->exerted(), this->weight(TypeParam::position()), "where the good one was");
}

TEST(FallBack, WhatIsNoPositionHoldsNothing) {
  using R = robots::Puma560;
  FallBack<R, float> fall_back(times);
  for (const float bad : {NAN, INFINITY, -INFINITY, 100.0F, -100.0F})
    for (int i = 0; i < 6; ++i) {
      Joints<R, float> q{0.1F, -0.5F, 0.3F, 0.2F, -0.4F, 0.5F};
      EXPECT_EQ(fall_back.phase(), DrivePhase::idle);
      q[i] = bad;
      EXPECT_FALSE(fall_back.hold_at(q)) << bad << ", joint " << i;
    }
  EXPECT_FALSE(fall_back.enabled());
}

namespace {

struct Heavy {
  static constexpr auto chain = axial::chain(
      gravity(0.0, -10.0, 0.0), revolute().mass(4).com(0.5, 0, 0).inertia_com(0, 0.1, 0.1).effort_limit(15),
      revolute().a(1.0).mass(1).com(0.5, 0, 0).inertia_com(0, 0.1, 0.1).effort_limit(30));
};

}  // namespace

// The first joint would need 35 N m, the second needs 5 N m.
TEST(FallBack, WhatHoldsTheArmIsKeptInsideTheEffortLimits) {
  FallBack<Heavy, double> fall_back(times);
  EXPECT_TRUE(fall_back.hold_at({0.0, 0.0}));
  EXPECT_EQ(fall_back.torque()[0], 15.0);
  EXPECT_NEAR(fall_back.torque()[1], 5.0, 1e-12);
}

namespace {

// A slide whose weight about the joint before it is no number of float where it is far out.
struct Overflowing {
  static constexpr auto chain =
      axial::chain(gravity(-10.0, 0, 0), revolute().effort_limit(15),
                   prismatic().alpha_deg(90).mass(1e35).position_limits(-1e4, 1e4).accept(as_published));
};

}  // namespace

TEST(FallBack, WhatNeedsATorqueThatIsNoNumberIsNotHeld) {
  FallBack<Overflowing, float> fall_back(times);
  EXPECT_TRUE(fall_back.hold_at({0.0F, 1.0F}));
  fall_back = FallBack<Overflowing, float>(times);
  EXPECT_FALSE(fall_back.hold_at({0.0F, 9e3F}));
  EXPECT_FALSE(fall_back.enabled());
}

// Gravity is a run-time input here; it fails before the arm is held.
TEST(FallBack, WhereNothingIsKnownToHoldTheArmTheTorqueLeavesAlongTheRamp) {
  using S = Scene<Heavy, RuntimeGravity>;
  Inputs<S, double> in{};
  in.gravity = {0.0, NAN, 0.0};
  FallBack<S, double> fall_back(times);
  EXPECT_FALSE(fall_back.hold_at({0.0, 0.0}, in));
  EXPECT_FALSE(fall_back.enabled());
  ASSERT_TRUE(fall_back.follow({0.0, 0.0}, {8.0, 4.0}, in));
  fall_back.advance(times.patience + times.ramp / 4);
  EXPECT_EQ(fall_back.torque()[0], 6.0);
  EXPECT_EQ(fall_back.torque()[1], 3.0);
  fall_back.advance(times.ramp);
  EXPECT_EQ(fall_back.torque()[0], 0.0);
}

namespace {

// 1.51214 kg at 0.5 m: 9.81 (1.51214 0.5) = 7.417 N m; a kilogram at 0.58807 m: 5.769 N m more.
struct Loaded {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -9.81, 0.0), payload_limit(2.0, 1.0, 0.1), tip_wrench_limit(50.0, 20.0),
                   revolute()
                       .mass(1.51214)
                       .com(-0.5, 0, 0)
                       .inertia_com(0, 0.05, 0.05)
                       .position_limits(-2, 2)
                       .speed_limit(2)
                       .acceleration_limit(10)
                       .effort_limit(60));
};
constexpr PayloadBody<double> kilogram{1.0, {-0.58807, 0.0, 0.0}, {}};

template <class T>
struct LoadedCase {
  using S = Scene<Loaded, Gravity, RotorInertia, Payload, TipWrench>;
  static Inputs<S, T> with(const PayloadBody<double>& load, double push = 0.0) {
    Inputs<S, T> in;
    if constexpr (is_stored_v<T>) {
      in.payload = to_fixed_payload<S, std::int32_t>(load).load;
      using F = InputFormats<Loaded, T>;
      in.tip_wrench.moment.z.raw = static_cast<std::int32_t>(push * std::ldexp(1.0, F::tip_moment));
    } else {
      in.payload.mass = static_cast<T>(load.mass), in.payload.com.x = static_cast<T>(load.com.x);
      in.tip_wrench.moment.z = static_cast<T>(push);
    }
    return in;
  }
  static Positions<Loaded, T> level() { return {}; }
  static double exerted(const FallBack<S, T>& fall_back) {
    if constexpr (is_stored_v<T>)
      return to_real<double>(fall_back.torque())[0];
    else
      return static_cast<double>(fall_back.torque()[0]);
  }
};

template <class T>
class FallBackWithALoad : public testing::Test {};
using Numbers = testing::Types<float, double, Fixed32>;
TYPED_TEST_SUITE(FallBackWithALoad, Numbers);

}  // namespace

TYPED_TEST(FallBackWithALoad, HoldsTheLoadOfTheLastGoodRequest) {
  using Case = LoadedCase<TypeParam>;
  FallBack<typename Case::S, TypeParam> fall_back(times);
  ASSERT_TRUE(fall_back.follow(Case::level(), {}, Case::with({})));
  fall_back.advance(times.patience + times.ramp);
  EXPECT_NEAR(Case::exerted(fall_back), -7.417, 5e-4) << "no load";
  ASSERT_TRUE(fall_back.follow(Case::level(), {}, Case::with(kilogram)));
  for (int k = 0; k < times.patience + times.ramp; ++k)
    fall_back.advance(1);
  EXPECT_EQ(fall_back.phase(), DrivePhase::holding);
  EXPECT_NEAR(Case::exerted(fall_back), -13.186, 5e-4);
}

TYPED_TEST(FallBackWithALoad, HoldsItBeforeAnyGoodRequest) {
  using Case = LoadedCase<TypeParam>;
  FallBack<typename Case::S, TypeParam> fall_back(times);
  EXPECT_TRUE(fall_back.hold_at(Case::level(), Case::with(kilogram)));
  EXPECT_NEAR(Case::exerted(fall_back), -13.186, 5e-4);
}

// A push of 5 N m is of its moment: an arm that leaned on it would fall when it ends.
TYPED_TEST(FallBackWithALoad, LeansOnNoPush) {
  using Case = LoadedCase<TypeParam>;
  FallBack<typename Case::S, TypeParam> fall_back(times);
  ASSERT_TRUE(fall_back.follow(Case::level(), {}, Case::with(kilogram, 5.0)));
  fall_back.advance(times.patience + times.ramp);
  EXPECT_NEAR(Case::exerted(fall_back), -13.186, 5e-4);
}

TYPED_TEST(FallBackWithALoad, TakesALoadThatChangesAfterTheLastRequestButNoneThatIsBad) {
  using Case = LoadedCase<TypeParam>;
  FallBack<typename Case::S, TypeParam> fall_back(times);
  ASSERT_TRUE(fall_back.follow(Case::level(), {}, Case::with(kilogram)));
  auto bad = Case::with(kilogram);
  if constexpr (is_stored_v<TypeParam>)
    bad.payload.mass.raw = -bad.payload.mass.raw;
  else
    bad.payload.mass = -bad.payload.mass;
  fall_back.advance(1, bad);
  fall_back.advance(times.patience + times.ramp, bad);
  EXPECT_NEAR(Case::exerted(fall_back), -13.186, 5e-4);
  ASSERT_TRUE(fall_back.follow(Case::level(), {}, Case::with(kilogram)));
  fall_back.advance(times.patience + times.ramp, Case::with({}));
  EXPECT_NEAR(Case::exerted(fall_back), -7.417, 5e-4);
}

// The pairs are those of the position that the arm is held at, and a scene without inputs pays for none.
TEST(FallBack, KeepsThePairsOfItsPosition) {
  using S = Scene<Loaded, Gravity, SineCosines>;
  FallBack<S, double> fall_back(times);
  Inputs<S, double> in;
  in.turns[0] = {std::sin(1.0), std::cos(1.0)};
  ASSERT_TRUE(fall_back.follow({1.0}, {}, in));
  in.turns[0] = {0.0, 1.0};
  fall_back.advance(times.patience + times.ramp, in);
  EXPECT_NEAR(fall_back.torque()[0], -7.41705 * std::cos(1.0), 1e-4);
  in.turns[0] = {0.0, 0.0};
  FallBack<S, double> broken(times);
  EXPECT_FALSE(broken.hold_at({1.0}, in));
  EXPECT_LT(sizeof(FallBack<Loaded, double>), sizeof(FallBack<S, double>));
}

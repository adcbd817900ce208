// The main jobs' controllers with real robots, in float and fixed point: what a refused, an unmeasured, a late request
// leaves the drives with.
#include <firmware/apps/tracking/controller.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <robots/puma560.hpp>
#include <robots/scara.hpp>

namespace axial::apps {
namespace {

namespace link = hal::link;

constexpr float weight = -1.25F * 9.8125F;  // of the SCARA's slide, whose axis points down
constexpr FallBackTimes times{3, 8, 5};
const float nan = std::numeric_limits<float>::quiet_NaN();

template <class Robot>
link::SetPoint at(const std::array<float, link::max_joints>& q) {
  link::SetPoint wanted{};
  wanted.joints = Robot::chain.size;
  wanted.q = q;
  return wanted;
}
const link::SetPoint rest = at<robots::Scara>({0.1F, 0.2F, 0.1F});

/// Encoders of turning joints at `angles`, then of a slide 0.1 m out.
link::Measurement measured(std::initializer_list<double> angles) {
  link::Measurement m{};
  for (const double angle : angles)
    m.position[m.joints++] =
        static_cast<std::int32_t>(std::llround(std::remainder(angle / 6.283185307179586, 1.0) * 4294967296.0));
  m.position[m.joints++] = 1'000'000;
  m.feeds_forward = 1;
  return m;
}

template <class Controller>
link::Torque answer(Controller& controller, const link::SetPoint& wanted) {
  link::Torque torque{};
  controller.load(wanted);
  controller.compute();
  controller.settle(wanted);
  controller.store(torque);
  return torque;
}
template <class Controller>
link::Torque exerted(const Controller& controller) {
  link::Torque torque{};
  controller.store_exerted(torque);
  return torque;
}

template <class T>
class Jobs : public testing::Test {
 protected:
  Jobs() {
    plain_.set_times(times);
    tracking_.set_times(times);
  }
  static void expect(const link::Torque& torque, link::TorqueStatus status, DrivePhase phase) {
    EXPECT_EQ(torque.status, static_cast<std::uint8_t>(status));
    EXPECT_EQ(torque.phase, static_cast<std::uint8_t>(phase));
  }
  static void expect_held(const link::Torque& torque) {
    EXPECT_NEAR(torque.tau[0], 0.0F, 1e-5F);
    EXPECT_NEAR(torque.tau[1], 0.0F, 1e-5F);
    EXPECT_NEAR(torque.tau[2], weight, 1e-5F);
  }

  Controller<robots::Scara, T> plain_;
  TrackingController<robots::Scara, T> tracking_;
};
using Numbers = testing::Types<float, Fixed32>;
TYPED_TEST_SUITE(Jobs, Numbers);

}  // namespace

TYPED_TEST(Jobs, ARefusedRequestHoldsAtItsOwnPositionOnlyWhereThatIsGood) {
  for (std::size_t i = 0; i < 3; ++i)
    for (const float bad : {nan, 100.0F, -100.0F}) {
      link::SetPoint nowhere = rest;
      nowhere.q[i] = bad;
      const auto torque = answer(this->plain_, nowhere);
      this->expect(torque, std::isnan(bad) ? link::TorqueStatus::not_finite : link::TorqueStatus::outside_limits,
                   DrivePhase::idle);
      EXPECT_EQ(torque.joint, i);
      EXPECT_EQ(torque.tau[2], 0.0F);
    }
  // The first thing that is wrong is a speed; the position of a joint after it is wrong too.
  link::SetPoint twice = rest;
  twice.qd[0] = nan;
  twice.q[2] = 9.0F;
  this->expect(answer(this->plain_, twice), link::TorqueStatus::not_finite, DrivePhase::idle);
  link::SetPoint known = rest;
  known.qdd[1] = nan;
  const auto held = answer(this->plain_, known);
  this->expect(held, link::TorqueStatus::not_finite, DrivePhase::holding);
  this->expect_held(held);
}

TYPED_TEST(Jobs, AfterDisablingOnlyARestartHelps) {
  EXPECT_EQ(answer(this->plain_, rest).phase, static_cast<std::uint8_t>(DrivePhase::running));
  this->plain_.advance(1000);
  const auto refused = answer(this->plain_, rest);
  this->expect(refused, link::TorqueStatus::disabled, DrivePhase::disabled);
  EXPECT_EQ(refused.tau[2], 0.0F);
  this->plain_.restart();
  this->expect(answer(this->plain_, rest), link::TorqueStatus::ok, DrivePhase::running);
}

TYPED_TEST(Jobs, EachSetPointTakesAMeasurementOfItsOwn) {
  auto& job = this->tracking_;
  const auto before = answer(job, rest);
  this->expect(before, link::TorqueStatus::not_measured, DrivePhase::holding);
  this->expect_held(before);
  job.measure(measured({0.0, 0.2}));
  const auto good = answer(job, rest);
  this->expect(good, link::TorqueStatus::ok, DrivePhase::running);
  EXPECT_GT(good.tau[0], 1.0F) << "feedback of 0.1 rad";
  const auto without = answer(job, rest);
  this->expect(without, link::TorqueStatus::not_measured, DrivePhase::running);
  EXPECT_EQ(without.tau, good.tau) << "held";
  EXPECT_EQ(without.joint, link::no_joint);
}

TYPED_TEST(Jobs, FeedbackFadesWithTheMotion) {
  auto& job = this->tracking_;
  job.measure(measured({0.0, 0.2}));
  const float first = answer(job, rest).tau[0];
  job.advance(times.patience + times.ramp / 2);
  EXPECT_NEAR(exerted(job).tau[0], 0.5F * first, 1e-4F * first);
  job.advance(times.ramp / 2);
  this->expect_held(exerted(job));
}

/// The derivative is over a tick; over a pause it would be as many times too large.
TYPED_TEST(Jobs, FeedbackBeginsWithoutADerivativeAfterAPause) {
  auto& job = this->tracking_;
  job.measure(measured({0.06, 0.2}));
  const float first = answer(job, rest).tau[0];
  job.advance(times.patience);
  job.measure(measured({0.08, 0.2}));
  EXPECT_NEAR(answer(job, rest).tau[0], 0.5F * first, 1e-3F * first);
  job.measure(measured({0.0799, 0.2}));
  EXPECT_GT(answer(job, rest).tau[0], 0.5F * first) << "the next one has a derivative";
  (void)answer(job, rest);  // not measured
  job.measure(measured({0.08, 0.2}));
  EXPECT_NEAR(answer(job, rest).tau[0], 0.5F * first, 1e-3F * first);
}

// 0.2 rad to 0 between two measurements; the arm of the fall-back is that of the last good request.
TYPED_TEST(Jobs, AnEncoderThatJumpsIsNotBelievedUntilASessionBegins) {
  auto& job = this->tracking_;
  job.measure(measured({0.1, 0.2}));
  const auto before = answer(job, rest);
  this->expect(before, link::TorqueStatus::ok, DrivePhase::running);
  for (const double reads : {0.0, 0.0, 0.1, 0.2, 0.2}) {
    job.measure(measured({0.1, reads}));
    const auto told = answer(job, rest);
    this->expect(told, link::TorqueStatus::not_measured, DrivePhase::running);
    EXPECT_EQ(told.tau, before.tau) << reads;
  }
  job.advance(10'000);
  EXPECT_EQ(job.phase(), DrivePhase::disabled);
  job.restart();
  job.measure(measured({0.1, 0.2}));
  this->expect(answer(job, rest), link::TorqueStatus::ok, DrivePhase::running);
}

// The wanted motion leaves, what the encoder reads stays.
TYPED_TEST(Jobs, AnEncoderThatStandsStillIsNotBelievedForLong) {
  auto& job = this->tracking_;
  link::SetPoint wanted = rest;
  int refused = 0;
  for (int k = 0; k < 500 && refused == 0; ++k) {
    wanted.q[1] = 0.2F + 0.002F * static_cast<float>(k);
    job.measure(measured({0.1, 0.2}));
    refused = answer(job, wanted).status == static_cast<std::uint8_t>(link::TorqueStatus::not_measured) ? k : 0;
  }
  EXPECT_GT(refused, 50);
  EXPECT_LT(refused, 250);  // at 0.39 rad, where feedback asks for twice the effort
}

TYPED_TEST(Jobs, WhereTheRequestIsNowhereTheArmIsHeldWhereEncodersSeeIt) {
  auto& job = this->tracking_;
  link::SetPoint nowhere = rest;
  nowhere.q[1] = nan;
  this->expect(answer(job, nowhere), link::TorqueStatus::not_finite, DrivePhase::idle);
  job.measure(measured({0.3, 3.0}));
  this->expect(answer(job, nowhere), link::TorqueStatus::not_finite, DrivePhase::idle);  // 3 rad is outside
  job.measure(measured({0.3, -2.5}));
  job.restart();
  this->expect(answer(job, nowhere), link::TorqueStatus::not_finite, DrivePhase::idle);  // of the session before
  job.measure(measured({0.3, -2.5}));
  const auto held = answer(job, nowhere);
  this->expect(held, link::TorqueStatus::not_finite, DrivePhase::holding);
  this->expect_held(held);
}

namespace {

/// A joint that turns from 1 to 6 rad: half of that is beyond half a turn, where binary angles wrap.
struct Wide {
  static constexpr const char* name = "wide";
  static constexpr auto chain = axial::chain(gravity(0.0, -10.0, 0.0), revolute()
                                                                           .mass(1)
                                                                           .com(0.5, 0, 0)
                                                                           .inertia_com(0, 0.1, 0.1)
                                                                           .position_limits(1.0, 6.0)
                                                                           .speed_limit(5)
                                                                           .acceleration_limit(50)
                                                                           .effort_limit(50));
};

template <class T>
float held_when_seen_at(double angle) {
  TrackingController<Wide, T> job;
  link::Measurement m{};
  m.joints = 1;
  m.position[0] =
      static_cast<std::int32_t>(std::llround(std::remainder(angle / 6.283185307179586, 1.0) * 4294967296.0));
  job.measure(m);
  return answer(job, at<Wide>({nan})).tau[0];
}

}  // namespace

TYPED_TEST(Jobs, EncodersSeeAnAngleWithinTheJointsTurn) {
  for (const double angle : {1.1, 3.0, 3.3, 4.0, 5.9})
    EXPECT_NEAR(held_when_seen_at<TypeParam>(angle), 5.0 * std::cos(angle), 1e-4) << angle;
  for (const double angle : {0.9, 0.0, 6.2})
    EXPECT_EQ(held_when_seen_at<TypeParam>(angle), 0.0F) << angle;
}

}  // namespace axial::apps

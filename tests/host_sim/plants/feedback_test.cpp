// The feedback of the tracking controller as numbers: gains, signs, wrapping angles, limits; statuses on the wire.
#include <firmware/apps/elastic/controller.hpp>
#include <firmware/apps/tracking/controller.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <robots/scara.hpp>
#include <robots/scara_quill.hpp>

namespace axial::apps {
namespace {

namespace link = hal::link;
using robots::Scara;

constexpr double w = 2.0 * 3.14159265358979323846 * bandwidth_Hz, turn = 6.283185307179586;

/// M_ii in the middle of the joints' travel.
double inertia(int i) {
  Joints<Scara, double> middle{};
  for (int k = 0; k < 3; ++k)
    middle[k] = 0.5 * (Scara::chain.links[k].position_min + Scara::chain.links[k].position_max);
  return mass_matrix<Scara>(middle)(i, i);
}

/// One tick of a controller, in the loop's order.
template <class Controller>
link::Torque tick(Controller& controller, const link::Measurement& measured, const link::SetPoint& wanted) {
  link::Torque torque{};
  controller.measure(measured);
  controller.load(wanted);
  controller.compute();
  controller.settle(wanted);
  controller.store(torque);
  return torque;
}

template <class T>
class Feedback : public testing::Test {
 protected:
  /// The torque at rest where the wanted joints are q and the encoders say `seen` (rad, m).
  link::Torque answer(std::array<float, 3> q, std::array<double, 3> seen, bool feeds_forward = false) {
    link::SetPoint wanted{};
    link::Measurement measured{};
    wanted.joints = measured.joints = 3;
    for (std::size_t i = 0; i < 3; ++i)
      wanted.q[i] = q[i];
    for (std::size_t i = 0; i < 2; ++i)
      measured.position[i] =
          static_cast<std::int32_t>(std::llround(std::remainder(seen[i] / turn, 1.0) * 4294967296.0));
    measured.position[2] = static_cast<std::int32_t>(std::llround(seen[2] * slide_counts));
    measured.feeds_forward = feeds_forward ? 1 : 0;
    return tick(controller_, measured, wanted);
  }
  TrackingController<Scara, T> controller_;
};
using Numbers = testing::Types<float, Fixed32>;
TYPED_TEST_SUITE(Feedback, Numbers);

constexpr std::array<float, 3> here{0.25F, -0.5F, 0.125F};

}  // namespace

TYPED_TEST(Feedback, IsAStiffnessOfTheErrorAtFirst) {
  const double error[] = {0.01, -0.02, 0.005};
  const auto torque = this->answer(here, {0.25 - error[0], -0.5 - error[1], 0.125 - error[2]});
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(torque.tau[static_cast<std::size_t>(i)], w * w * inertia(i) * error[i], 2e-4) << i;
}

// The nut's drive is told apart from one that stands whole turns away; gains are by M of the drives.
TYPED_TEST(Feedback, OfADriveThatJointsShareCountsItsTurns) {
  using robots::ScaraQuill;
  const auto M = mass_matrix<ScaraQuill>(Joints<ScaraQuill, double>{});
  const double u[] = {0.0, 0.0, 40.0, 0.5};
  const auto torque = [&](std::size_t drive, double error) {
    TrackingController<ScaraQuill, TypeParam> controller;
    link::SetPoint wanted{};
    link::Measurement measured{};
    wanted.joints = measured.joints = 4;
    for (std::size_t k = 0; k < 4; ++k) {
      wanted.q[k] = static_cast<float>(u[k]);
      measured.position[k] =
          static_cast<std::int32_t>(std::llround((u[k] - (k == drive ? error : 0.0)) * slide_counts));
    }
    return tick(controller, measured, wanted).tau[drive];
  };
  for (const double error : {0.001, -0.002, 0.1, turn})
    EXPECT_NEAR(torque(2, error), std::fmin(w * w * M(2, 2) * error, 1.1), 1e-5) << error;
  for (const double error : {0.001, -0.002, 0.1})
    EXPECT_NEAR(torque(3, error), std::fmin(w * w * M(3, 3) * error, 2.0), 1e-5) << error;
}

TYPED_TEST(Feedback, ThenAlsoADampingOfItsChange) {
  (void)this->answer(here, {0.25, -0.5, 0.125});
  const double error[] = {1e-4, -2e-4, 1e-4};
  const auto torque = this->answer(here, {0.25 - error[0], -0.5 - error[1], 0.125 - error[2]});
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(torque.tau[static_cast<std::size_t>(i)], (w * w + 2.0 * w * control_Hz) * inertia(i) * error[i], 2e-3)
        << i;
}

TYPED_TEST(Feedback, AddsToTheFeedForwardWhereThatIsWanted) {
  const auto without = this->answer(here, {0.25, -0.5, 0.125}), with = this->answer(here, {0.25, -0.5, 0.125}, true);
  EXPECT_NEAR(without.tau[2], 0.0, 1e-4);
  EXPECT_NEAR(with.tau[2], -1.25 * 9.8125, 1e-4) << "the slide's weight";
}

// The encoder says -2.4 rad where the joint wants 2.4: over half a turn it is 1.48 rad away, the other way.
TYPED_TEST(Feedback, GoesTheShortWayRound) {
  for (const double sign : {1.0, -1.0}) {
    this->controller_ = {};
    const auto torque = this->answer({static_cast<float>(sign * 2.4), -0.5F, 0.125F}, {sign * -2.4, -0.5, 0.125});
    EXPECT_NEAR(torque.tau[0], -sign * 80.0, 1e-3) << "all that is declared";
  }
}

TYPED_TEST(Feedback, EndsAtTheDeclaredEfforts) {
  const auto forward = this->answer(here, {-0.75, -1.5, 0.0});
  this->controller_ = {};  // no arm gets from one to the other in a tick
  const auto backward = this->answer(here, {1.25, 0.5, 0.25});
  for (std::size_t i = 0; i < 3; ++i) {
    const double most = Scara::chain.links[i].effort_limit;
    EXPECT_NEAR(forward.tau[i], most, 1e-5 * most) << i;
    EXPECT_NEAR(backward.tau[i], -most, 1e-5 * most) << i;
  }
}

// A SCARA behind harmonic drives of 12 Hz: at rest its slide hangs on a spring of w^2 m, so the motor stands m g / K
// above where a rigid one would.
class ElasticFeedback : public testing::Test {
 protected:
  static constexpr double weight = 1.25 * 9.8125, spring_rate = 2.0 * 3.14159265358979323846 * 12.0;
  static constexpr double deflection = 9.8125 / (spring_rate * spring_rate);
  static constexpr double count = 1.0 / slide_counts;
  // w^2 of the feedback, of links and motors that are as heavy.
  static constexpr double stiffness = 16.0 * 3.14159265358979323846 * 16.0 * 3.14159265358979323846 * 0.25 * 2.5;

  /// The slide's answer at rest at 0.125 m, its motor seen at 0.125 m and what is added.
  link::Torque answer(double seen, link::FeedForward feed = link::FeedForward::full, bool derivatives = true) {
    link::SetPoint wanted{};
    link::Measurement measured{};
    wanted.joints = measured.joints = derivatives_.joints = 3;
    wanted.q[2] = 0.125F;
    measured.position[2] = static_cast<std::int32_t>(std::llround((0.125 + seen) * slide_counts));
    measured.feeds_forward = static_cast<std::uint8_t>(feed);
    if (derivatives) controller_.take(derivatives_);
    return tick(controller_, measured, wanted);
  }
  link::Derivatives derivatives_{};
  ElasticController<Elastic<Scara, 12>> controller_;
};

TEST_F(ElasticFeedback, IsOfTheMotorThatItsSpringDeflects) {
  EXPECT_NEAR(answer(-deflection).tau[2], -weight, stiffness * count) << "the motor is where its load pulls it";
  controller_ = {};
  EXPECT_NEAR(answer(0.0).tau[2], -weight - stiffness * deflection, stiffness * count) << "as if the joint were rigid";
}
TEST_F(ElasticFeedback, IsOfTheLinkWhereJointsAreTakenAsRigid) {
  EXPECT_NEAR(answer(0.0, link::FeedForward::rigid).tau[2], -weight, stiffness * count);
}
TEST_F(ElasticFeedback, NeedsItsDerivativesAtEverySetPoint) {
  const auto status = [&](bool derivatives) {
    return static_cast<link::TorqueStatus>(answer(-deflection, link::FeedForward::full, derivatives).status);
  };
  EXPECT_EQ(status(true), link::TorqueStatus::ok);
  EXPECT_EQ(status(false), link::TorqueStatus::not_measured);
  EXPECT_EQ(status(true), link::TorqueStatus::ok);
  EXPECT_EQ(status(false), link::TorqueStatus::not_measured) << "those of the set-point before are old";
  derivatives_.q4[2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(status(true), link::TorqueStatus::not_finite);
}

TEST(LinkStatus, SaysWhatTheHostCanDoAbout) {
  using Code = Status::Code;
  EXPECT_EQ(link_status(Code::ok), link::TorqueStatus::ok);
  EXPECT_EQ(link_status(Code::effort_limit), link::TorqueStatus::effort_limited);
  EXPECT_EQ(link_status(Code::not_finite), link::TorqueStatus::not_finite);
  for (const Code code : {Code::position_limit, Code::speed_limit, Code::acceleration_limit, Code::payload_limit})
    EXPECT_EQ(link_status(code), link::TorqueStatus::outside_limits);
}

}  // namespace axial::apps

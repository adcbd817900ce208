// The closed loop on the host: what feeding forward is worth, and what takes it away. The image is held to the same
// source, bit by bit, by `loop --check` (host_sim.Loop.*).
#include <host_sim/plants/loop/elastic.hpp>
#include <host_sim/plants/loop/loop.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

using namespace host_sim::loop;

namespace {

constexpr double seconds = 4.0;

Tracking tracked(Case situation, const std::string& number = "float") {
  situation.seconds = seconds;
  const auto controller = on_host(situation.robot, number);
  return follow(situation, *controller);
}

Case of(const std::string& robot, bool feeds_forward, double parameter_error = 0.0) {
  Case c;
  c.robot = robot, c.feeds_forward = feeds_forward, c.parameter_error = parameter_error, c.seed = 3;
  return c;
}

}  // namespace

TEST(Loop, FeedForwardCutsTheErrorTwentyfold) {
  for (const std::string& robot : robots())
    for (const char* number : {"float", "fixed32"}) {
      const Tracking fed = tracked(of(robot, true), number), alone = tracked(of(robot, false), number);
      std::printf("%s, %s: tool error RMS %.3g m, alone %.3g m\n", robot.c_str(), number, fed.tool_rms, alone.tool_rms);
      EXPECT_EQ(fed.refused, 0);
      EXPECT_EQ(fed.ticks, 4000);
      EXPECT_GE(alone.tool_rms, 20.0 * fed.tool_rms) << robot;
      for (std::size_t i = 0; i < fed.rms.size(); ++i)
        EXPECT_GE(alone.rms[i], 20.0 * fed.rms[i]) << robot << ", joint " << i + 1;
    }
}

TEST(Loop, FixedPointTracksAsFloatDoes) {
  for (const std::string& robot : robots()) {
    const Tracking a = tracked(of(robot, true)), b = tracked(of(robot, true), "fixed32");
    EXPECT_NEAR(a.tool_rms / b.tool_rms, 1.0, 0.01) << robot;
  }
}

// What is fed forward is off by the model's error, so the tracking error grows with it, about in proportion.
TEST(Loop, WrongParametersCostInProportion) {
  for (const std::string& robot : robots()) {
    const double one = tracked(of(robot, true, 0.01)).tool_rms, five = tracked(of(robot, true, 0.05)).tool_rms,
                 ten = tracked(of(robot, true, 0.1)).tool_rms, alone = tracked(of(robot, false, 0.1)).tool_rms;
    EXPECT_GT(one, tracked(of(robot, true)).tool_rms) << robot;
    EXPECT_NEAR(five / one, 5.0, 1.5) << robot;
    EXPECT_NEAR(ten / five, 2.0, 0.4) << robot;
    EXPECT_GT(alone, 3.0 * ten) << robot;
  }
}

TEST(Loop, LateTorquesAndCoarseEncodersCost) {
  const double exact = tracked(of("scara", true)).tool_rms;
  Case late = of("scara", true), coarse = late;
  late.delay = 2, coarse.encoder_bits = 12;
  EXPECT_GT(tracked(late).tool_rms, 2.0 * exact);
  EXPECT_GT(tracked(coarse).tool_rms, 2.0 * exact);
}

TEST(Loop, ARefusedSetPointIsAnsweredByTheLastSafeTorque) {
  const auto controller = on_host("scara", "float");
  link::Measurement still{};
  still.joints = 3, still.feeds_forward = 1;
  link::SetPoint good{}, bad{};
  good.joints = bad.joints = 3;
  good.q = bad.q = {0.0F, 0.0F, 0.05F};
  still.position = {0, 0, 500'000};
  bad.q[1] = std::numeric_limits<float>::quiet_NaN();
  const auto first = controller->answer(still, good), second = controller->answer(still, bad);
  EXPECT_EQ(first.status, static_cast<std::uint8_t>(link::TorqueStatus::ok));
  EXPECT_EQ(second.status, static_cast<std::uint8_t>(link::TorqueStatus::not_finite));
  EXPECT_NEAR(first.tau[2], second.tau[2], 1e-5F);
}

TEST(LastPlaces, AreCountedAcrossZero) {
  const float least = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(last_places(1.0F, 1.0F), 0u);
  EXPECT_EQ(last_places(0.0F, -0.0F), 0u);
  EXPECT_EQ(last_places(least, -least), 2u);
  EXPECT_EQ(last_places(1.0F, std::nextafter(1.0F, 2.0F)), 1u);
  EXPECT_EQ(last_places(std::nextafter(-1.0F, 0.0F), -1.0F), 1u);
  EXPECT_GT(last_places(1.0F, std::numeric_limits<float>::quiet_NaN()), 1u << 31);
}

TEST(Loop, SaysWhatItDoesNotKnow) {
  EXPECT_THROW(on_host("panda", "float"), std::runtime_error);
  EXPECT_THROW(on_host("scara", "double"), std::runtime_error);
  const auto controller = on_host("gripper", "float");
  Case elastic = of("gripper", true);
  elastic.resonance = 12;
  EXPECT_THROW(follow(elastic, *controller), std::runtime_error);
}

// Springs of harmonic drives, 12 Hz with a locked motor, encoders on the motors, the same gains.
TEST(Loop, MotorsThatLeadTheirLinksAreTenTimesAsExact) {
  for (const std::string robot : {"scara", "puma560"}) {
    Case c;
    c.robot = robot, c.resonance = 12, c.seconds = 2.0;
    const auto by = [&](bool as_rigid) {
      c.as_rigid = as_rigid;
      const auto controller = elastic_on_host(robot, 12);
      return follow(c, *controller);
    };
    const Tracking elastic = by(false), rigid = by(true);
    std::printf("%s: tool error RMS %.3g m, as rigid %.3g m\n", robot.c_str(), elastic.tool_rms, rigid.tool_rms);
    EXPECT_EQ(elastic.refused, 0);
    EXPECT_GE(rigid.tool_rms, 10.0 * elastic.tool_rms) << robot;
    EXPECT_LT(elastic.tool_rms, 30e-6) << robot;  // a torque held for a millisecond
  }
}

// Of what is wrong with the springs the firmware knows nothing. A damper of the ratio zeta lets a link run ahead of its
// spring by zeta / (pi f) of the rate at which its torque changes: in proportion.
TEST(Loop, SpringsThatAreSofterAndDampersAreFelt) {
  const auto tool_error = [](double stiffness_error, double damping_ratio) {
    Case c;
    c.robot = "puma560", c.resonance = 12, c.seconds = 2.0;
    c.stiffness_error = stiffness_error, c.damping_ratio = damping_ratio;
    const auto controller = elastic_on_host(c.robot, c.resonance);
    return follow(c, *controller).tool_rms;
  };
  const double exact = tool_error(0.0, 0.0), half = tool_error(0.0, 0.5), whole = tool_error(0.0, 1.0);
  EXPECT_GT(tool_error(-0.1, 0.0), 20.0 * exact);
  EXPECT_GT(half, 3.0 * exact);
  EXPECT_NEAR(whole / half, 2.0, 0.3);
}

TEST(Loop, ASetPointWithoutItsDerivativesIsRefused) {
  const auto controller = elastic_on_host("scara", 12);
  link::SetPoint still{};
  link::Measurement seen{};
  link::Derivatives more{};
  still.joints = seen.joints = more.joints = 3, seen.feeds_forward = 1;
  still.q[2] = 0.05F, seen.position[2] = 500'000;
  controller->take(more);
  EXPECT_EQ(controller->answer(seen, still).status, static_cast<std::uint8_t>(link::TorqueStatus::ok));
  EXPECT_EQ(controller->answer(seen, still).status, static_cast<std::uint8_t>(link::TorqueStatus::not_measured));
  more.q4[0] = std::numeric_limits<float>::quiet_NaN();
  controller->take(more);
  EXPECT_EQ(controller->answer(seen, still).status, static_cast<std::uint8_t>(link::TorqueStatus::not_finite));
}

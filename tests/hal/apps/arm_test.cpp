// A board that stands in for an arm, on the host's board: how it moves, and what its drives do when efforts are late,
// absent or wrong (firmware/apps/plant/README.md). On boards in their emulators: tests/target/arm_test.py.

#include <firmware/apps/plant/arm.hpp>

#include <cmath>
#include <limits>

#include <robots/scara.hpp>

#include "app_fixture.hpp"

namespace axial::apps {
namespace {

using link::noise::Bytes;
constexpr float nan_of = std::numeric_limits<float>::quiet_NaN();
constexpr double counts_a_rad = 4294967296.0 / 6.283185307179586;

link::Torque efforts(const std::array<float, link::max_joints>& tau, DrivePhase phase = DrivePhase::running) {
  link::Torque out{};
  out.joints = 3, out.tau = tau, out.phase = byte_of(phase);
  return out;
}
link::ArmCommand command(link::ArmAction action, const std::array<float, link::max_joints>& values = {}) {
  return {3, values, static_cast<std::uint8_t>(action)};
}

template <class R, class Number>
class ArmApp : public App<plant::Arm<R, Number>> {
 protected:
  link::Encoders ask(const std::array<float, link::max_joints>& tau, std::uint32_t number,
                     DrivePhase phase = DrivePhase::running) {
    this->send(this->framed(efforts(tau, phase), number));
    return this->template answer<link::Encoders>().value();
  }
  link::Encoders tell(link::ArmAction action, const std::array<float, link::max_joints>& values = {}) {
    this->send(this->framed(command(action, values), 0));
    return this->template answer<link::Encoders>().value();
  }
  std::uint32_t refused(link::Fault fault) { return this->faults(fault); }
};

using FloatArm = ArmApp<robots::Scara, float>;
using FixedArm = ArmApp<robots::Scara, Fixed32>;

constexpr std::array<float, link::max_joints> pose = {0.3F, -0.4F, 0.1F}, tau = {2.0F, -1.0F, 3.0F};

// The same motion in double by a hundred steps a tick.
Motion<Scene<robots::Scara, Gravity, RotorInertia>, double> reference(int ticks) {
  using S = Scene<robots::Scara, Gravity, RotorInertia>;
  Motion<S, double> x;
  Held<S, double> held{};
  for (int i = 0; i < 3; ++i) {
    x.q[i] = static_cast<double>(pose[static_cast<std::size_t>(i)]);
    held.tau[i] = static_cast<double>(tau[static_cast<std::size_t>(i)]);
  }
  for (int k = 0; k < 100 * ticks; ++k)
    EXPECT_TRUE(advance<RungeKutta4>(x, 1e-5, held).ok());
  return x;
}
void expect_reference(const link::Encoders& found, int ticks, double counts) {
  const auto x = reference(ticks);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(found.position[k], x.q[i] * (i == 2 ? slide_counts : counts_a_rad), i == 2 ? 1.0 : counts) << i;
    EXPECT_NEAR(static_cast<double>(found.speed[k]), x.qd[i], 1e-5) << i;
  }
}

TEST_F(FloatArm, MovesByEfforts) {
  open(link::Mode::lock_step);
  EXPECT_EQ(tell(link::ArmAction::place, pose).position[2], 1'000'000);
  link::Encoders last{};
  for (std::uint32_t k = 1; k <= 50; ++k)
    last = ask(tau, k);
  EXPECT_EQ(last.status, byte_of(link::TorqueStatus::ok));
  EXPECT_EQ(sequence_, 50U);
  expect_reference(last, 50, 100.0);  // 1.5e-7 rad
  expect_reference(last, 50, 100.0);
  EXPECT_TRUE(board().drives);
}

TEST_F(FixedArm, MovesByEfforts) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  link::Encoders last{};
  for (std::uint32_t k = 1; k <= 50; ++k)
    last = ask(tau, k);
  expect_reference(last, 50, 200.0);
}

TEST_F(FloatArm, ANumberLeftOutIsATickUnderTheEffortsBefore) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  for (std::uint32_t k = 1; k <= 9; ++k)
    ask(tau, k);
  const auto left_out = ask({5.0F}, 20);  // 11 ticks; the last of them by other efforts
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  for (std::uint32_t k = 1; k <= 19; ++k)
    ask(tau, k);
  const auto whole = ask({5.0F}, 20);
  EXPECT_EQ(left_out.position, whole.position);
  EXPECT_EQ(left_out.speed, whole.speed);
}

TEST_F(FloatArm, EffortsThatAreNoNumbersAreSilence) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  std::uint32_t number = 0;
  link::Encoders found = ask(tau, ++number);
  const auto until = [&](DrivePhase phase, std::uint32_t most) {
    std::uint32_t ticks = 0;
    while (found.phase != byte_of(phase) && ticks <= most) {
      found = ask({0.0F, nan_of, 0.0F}, ++number), ++ticks;
      EXPECT_EQ(found.status, byte_of(link::TorqueStatus::not_finite));
      EXPECT_EQ(found.joint, 1);
    }
    return ticks;
  };
  EXPECT_EQ(until(DrivePhase::fading, 100), watchdog_ticks);
  const float before = found.speed[2];
  EXPECT_EQ(until(DrivePhase::disabled, 1000), ramp_ms + 1);
  // The slide weighs 1.25 kg and was pushed by 3 N, of which the ramp leaves 99 % to 1 %, then nothing, twice.
  EXPECT_NEAR(found.speed[2] - before, 1e-3F * (101.0F * 9.8125F + 49.5F * 3.0F / 1.25F), 1e-3F);
  EXPECT_FALSE(board().drives);
  found = ask(tau, ++number);
  EXPECT_EQ(found.status, byte_of(link::TorqueStatus::disabled));
  const float coasting = found.speed[2];
  found = ask(tau, ++number);
  EXPECT_NEAR(found.speed[2] - coasting, 9.8125e-3F, 1e-4F) << "the slide falls freely";
  open(link::Mode::lock_step);
  found = ask(tau, 1);
  EXPECT_EQ(found.status, byte_of(link::TorqueStatus::ok));
  EXPECT_EQ(found.phase, byte_of(DrivePhase::running));
}

TEST_F(FloatArm, EffortsBeyondTheirLimitAreCut) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  const auto cut = ask({200.0F, 0.0F, -31.0F}, 1);
  EXPECT_EQ(cut.status, byte_of(link::TorqueStatus::effort_limited));
  EXPECT_EQ(cut.joint, 0);
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  const auto whole = ask({80.0F, 0.0F, -30.0F}, 1);
  EXPECT_EQ(whole.status, byte_of(link::TorqueStatus::ok));
  EXPECT_EQ(cut.position, whole.position);
}

TEST_F(FloatArm, DrivesOfAControllerThatAreOffExertNothing) {
  open(link::Mode::lock_step);
  for (const DrivePhase phase : {DrivePhase::idle, DrivePhase::disabled}) {
    tell(link::ArmAction::place, pose);
    const auto found = ask(tau, phase == DrivePhase::idle ? 1 : 2, phase);
    EXPECT_NEAR(found.speed[2], 9.8125e-3F, 1e-6F);
    EXPECT_EQ(found.speed[0], 0.0F);
  }
}

TEST_F(FloatArm, WhatIsOldTwiceOrFarAheadMovesNothing) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  const auto before = ask(tau, 5);
  for (const std::uint32_t number : {5U, 3U, 26U}) {
    send(framed(efforts(tau), number));
    EXPECT_FALSE(answer<link::Encoders>());
  }
  EXPECT_EQ(refused(link::Fault::out_of_order), 2U);
  EXPECT_EQ(refused(link::Fault::far_ahead), 1U);
  EXPECT_EQ(tell(link::ArmAction::go).position, before.position);
}

TEST_F(FloatArm, ASilentLineIsNoTimeInLockStep) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  const auto before = ask(tau, 1);
  tick(5000);
  EXPECT_FALSE(answer<link::Encoders>());
  const auto after = tell(link::ArmAction::go);
  EXPECT_EQ(after.position, before.position);
  EXPECT_EQ(after.phase, byte_of(DrivePhase::running));
}

TEST_F(FloatArm, ASilentLineFadesAndDisablesInFreeRunning) {
  open(link::Mode::free_running);
  tell(link::ArmAction::place, pose);
  send(framed(efforts(tau), 1));
  tick();
  const auto first = answer<link::Encoders>().value();
  EXPECT_EQ(first.status, byte_of(link::TorqueStatus::ok));
  tick(watchdog_ticks - 1);
  EXPECT_FALSE(answer<link::Encoders>());
  tick();
  const auto fading = answer<link::Encoders>().value();
  EXPECT_EQ(fading.status, byte_of(link::TorqueStatus::watchdog));
  EXPECT_EQ(fading.phase, byte_of(DrivePhase::fading));
  EXPECT_GT(fading.position[0], first.position[0]) << "by the timer";
  EXPECT_TRUE(board().drives);
  tick(ramp_ms + 1);
  EXPECT_EQ(answer<link::Encoders>()->phase, byte_of(DrivePhase::disabled));
  EXPECT_FALSE(board().drives);
  send(framed(efforts(tau), 2));
  tick();
  EXPECT_EQ(answer<link::Encoders>()->status, byte_of(link::TorqueStatus::disabled)) << "until a session begins";
}

TEST_F(FloatArm, FreeRunningMovesATickATick) {
  open(link::Mode::free_running);
  tell(link::ArmAction::place, pose);
  send(framed(efforts(tau, DrivePhase::running), 1));
  tick();  // without efforts, which are taken at its end
  open(link::Mode::lock_step);
  const auto fallen = tell(link::ArmAction::go);
  EXPECT_NEAR(fallen.speed[2], 9.8125e-3F, 1e-6F);
  EXPECT_EQ(fallen.speed[0], 0.0F);
}

TEST_F(FloatArm, DoesWhatItIsTold) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  tell(link::ArmAction::push, {1.5F});
  const float pushed = ask({}, 1).speed[0];
  EXPECT_GT(pushed, 1e-4F);
  tell(link::ArmAction::stop);
  EXPECT_EQ(ask({}, 2).speed[0], pushed);
  tell(link::ArmAction::go);
  EXPECT_GT(ask({}, 3).speed[0], pushed);
  const auto seen = ask({}, 4);
  const auto blind = tell(link::ArmAction::blind, {0.0F, 1.0F});
  EXPECT_EQ(blind.position[0], seen.position[0]);
  EXPECT_EQ(blind.position[1], 0);
  EXPECT_NE(tell(link::ArmAction::blind).position[1], 0);
}

TEST_F(FloatArm, RefusesCommandsThatAreNone) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  send(framed(command(link::ArmAction::place, {nan_of}), 0));
  send(framed(command(link::ArmAction::push, {nan_of}), 0));
  send(framed(command(static_cast<link::ArmAction>(5)), 0));
  EXPECT_FALSE(answer<link::Encoders>());
  EXPECT_EQ(refused(link::Fault::bad_payload), 3U);
  send(link::noise::wire(command(link::ArmAction::place), 0));
  EXPECT_EQ(refused(link::Fault::no_session), 1U);
  send(framed(set_point(1.0F), 1));
  EXPECT_EQ(refused(link::Fault::unknown_type), 1U) << "it is no controller";
  EXPECT_EQ(tell(link::ArmAction::go).position[2], 1'000'000);
}

TEST_F(FixedArm, IsNotPlacedBeyondItsLimits) {
  open(link::Mode::lock_step);
  send(framed(command(link::ArmAction::place, {0.0F, 0.0F, 0.3F}), 0));
  EXPECT_EQ(refused(link::Fault::bad_payload), 1U);
}

// Faster than it declares: words hold no such state, so the arm stays, and says why.
TEST_F(FixedArm, SaysWhatItsWordsDoNotHold) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  link::Encoders found{};
  for (std::uint32_t k = 1; k <= 100 && found.status == byte_of(link::TorqueStatus::ok); ++k)
    found = ask({}, k);  // the slide falls: 1 m/s after 102 ms
  for (std::uint32_t k = 101; k <= 104; ++k)
    found = ask({}, k);
  EXPECT_EQ(found.status, byte_of(link::TorqueStatus::outside_limits));
  EXPECT_EQ(found.joint, 2);
  EXPECT_LE(found.speed[2], 1.0F);
}

// --- what an arm does besides

/// Two joints and a slide with all that there is.
struct Worn : robots::Scara {
  static constexpr const char* name = "worn";
  static constexpr auto chain = axial::chain(axial::gravity(0.0, 0.0, -9.8125),
                                             axial::revolute()
                                                 .mass(4.0)
                                                 .com(0.1875, 0.0, 0.0)
                                                 .inertia_com(0.0, 0.05, 0.05)
                                                 .position_limits(-2.5, 2.5)
                                                 .speed_limit(4.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(80.0)
                                                 .coulomb(2.0)
                                                 .viscous(0.1),
                                             axial::revolute()
                                                 .a(0.375)
                                                 .mass(2.5)
                                                 .com(0.15, 0.0, 0.0)
                                                 .inertia_com(0.0, 0.02, 0.02)
                                                 .position_limits(-2.6, 2.6)
                                                 .speed_limit(5.0)
                                                 .acceleration_limit(30.0)
                                                 .effort_limit(25.0)
                                                 .coulomb(1.0),
                                             axial::prismatic()
                                                 .a(0.3125)
                                                 .alpha_deg(180)
                                                 .mass(1.25)
                                                 .position_limits(0.0, 0.25)
                                                 .speed_limit(1.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(30.0)
                                                 .coulomb(15.0));
  struct Mechanics {
    static constexpr bool friction = true;
    static constexpr EndStops stops{1e5, 30.0};
    static constexpr int encoder_bits = 14;
    static constexpr double backlash[] = {0.02, 0.0, 0.001};
  };
};
using WornArm = ArmApp<Worn, float>;
constexpr std::uint32_t count = 1U << 18;  // of 14 bits a turn
constexpr std::int32_t slide_step = 610;   // 10^7 / 2^14

TEST_F(WornArm, StandsStillAgainstItsWeight) {
  open(link::Mode::lock_step);
  const auto first = tell(link::ArmAction::place, pose);
  link::Encoders last{};
  for (std::uint32_t k = 1; k <= 3000; ++k)
    last = ask({1.9F, -0.9F, 0.0F}, k);  // gravity's 12.3 N are less than the slide's 15
  EXPECT_EQ(last.position, first.position);
  EXPECT_EQ(last.speed, first.speed);
}

TEST_F(WornArm, CountsAsCoarselyAsItsEncoders) {
  open(link::Mode::lock_step);
  auto found = tell(link::ArmAction::place, pose);
  EXPECT_NEAR(found.position[0], static_cast<double>(pose[0]) * counts_a_rad, count / 2 + 1);
  for (std::uint32_t k = 1; k <= 50; ++k) {
    found = ask({9.0F, -5.0F, 29.0F}, k);
    EXPECT_EQ(static_cast<std::uint32_t>(found.position[0]) % count, 0U);
    EXPECT_EQ(static_cast<std::uint32_t>(found.position[1]) % count, 0U);
    EXPECT_EQ(found.position[2] % slide_step, 0);
  }
}

TEST_F(WornArm, HasPlayBetweenMotorAndJoint) {
  open(link::Mode::lock_step);
  const auto first = tell(link::ArmAction::place, {0.0F, 0.0F, 0.1F});
  std::uint32_t k = 0;
  link::Encoders found{};
  double way = 0.0;
  do
    found = ask({9.0F, 0.0F, 0.0F}, ++k), way += 1e-3 * static_cast<double>(found.speed[0]);
  while (found.position[0] == first.position[0] && k < 1000);
  EXPECT_NEAR(way, 0.01 + 0.5 * count / counts_a_rad, 2e-3) << "half of its play, and half a count";
  while (way < 0.1)
    found = ask({9.0F, 0.0F, 0.0F}, ++k), way += 1e-3 * static_cast<double>(found.speed[0]);
  EXPECT_NEAR(found.position[0] / counts_a_rad, way - 0.01, count / counts_a_rad);
}

TEST_F(WornArm, StaysBetweenItsStops) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, {2.0F, 0.0F, 0.1F});
  double most = 0.0;
  for (std::uint32_t k = 1; k <= 2000; ++k) {
    const auto found = ask({20.0F, 0.0F, 0.0F}, k);
    most = std::max(most, found.position[0] / counts_a_rad);
    EXPECT_LT(std::fabs(found.speed[0]), 10.0F);
  }
  EXPECT_GT(most, 2.49);
  EXPECT_LT(most, 2.53);
}

}  // namespace
}  // namespace axial::apps

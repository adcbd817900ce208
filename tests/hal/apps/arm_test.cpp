// A board that stands in for an arm, on the host's board: how it moves, and what its drives do when efforts are late,
// absent or wrong (firmware/apps/plant/README.md). On boards in their emulators: tests/target/arm_test.py.

#include <cmath>

#include "arm_fixture.hpp"

namespace axial::apps {
namespace {

using FloatArm = ArmApp<robots::Scara, float>;
using FixedArm = ArmApp<robots::Scara, Fixed32>;

constexpr JointValues tau = {2.0F, -1.0F, 3.0F};

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

// In free-running steps are made before efforts are taken: what became of them is not forgotten by that.
TEST_F(FixedArm, SaysInFreeRunningToo) {
  open(link::Mode::free_running);
  tell(link::ArmAction::place, pose);
  link::Encoders found{};
  for (std::uint32_t k = 1; k <= 200 && found.status == byte_of(link::TorqueStatus::ok); ++k) {
    send(framed(efforts({}), k));
    tick();
    found = answer<link::Encoders>().value();
  }
  EXPECT_EQ(found.status, byte_of(link::TorqueStatus::outside_limits));
  EXPECT_EQ(found.joint, 2);
}

TEST_F(FloatArm, KnowsNoLoadsWhereItsRobotNamesNone) {
  open(link::Mode::lock_step);
  send(framed(link::ArmLoad{1.0F, {}, {}}, 0));
  EXPECT_EQ(refused(link::Fault::unknown_type), 1U);
}

}  // namespace
}  // namespace axial::apps

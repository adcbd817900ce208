// What the main job does with the drives when the line, the host or the program fails: on the host board, whose pin,
// watchdog and restarts are plain to see. In QEMU: tests/target/safety_test.py.

#include <limits>

#include "app_fixture.hpp"

namespace axial::apps {
namespace {

using link::noise::Bytes;
using link::noise::wire;

constexpr std::uint32_t patience = watchdog_ticks, ramp = ramp_ms, hold = hold_ms;  // a tick is a millisecond here
constexpr std::uint32_t lock_step_patience = lock_step_patience_ms;

class SafetyApp : public App<SumController> {
 protected:
  /// The torque of the motion is 3.5 times what holds the arm.
  void move(std::uint32_t number) {
    link::SetPoint moving = set_point(4.0f);
    moving.qd = {1.0f, 1.0f, 1.0f};
    moving.qdd = {2.0f, 2.0f, 2.0f};
    send(framed(moving, number));
  }
  static constexpr float moving = 14.0f, held = 4.0f;

  void expect_drives(bool on) { EXPECT_EQ(hal::HostBoard::drives_enabled(), on); }
  link::SetPoint bad() {
    link::SetPoint out = set_point(3.0f);
    out.qdd[1] = std::numeric_limits<float>::quiet_NaN();
    return out;
  }
};

TEST_F(SafetyApp, NothingIsDoneBeforeASessionIsOpen) {
  expect_drives(false);
  EXPECT_TRUE(board().guarded);
  ask(1.0f, 1);
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::no_session));
  send(wire(set_point(1.0f), 2));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::no_session));
  expect_drives(false);
  open(link::Mode::lock_step);
  send(wire(set_point(1.0f), 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::no_session)) << "a frame of no session";
  expect_drives(false);
  ask(1.0f, 1);
  EXPECT_TRUE(answer<link::Torque>());
  expect_drives(true);
}

TEST_F(SafetyApp, ASilentLineFadesHoldsAndDisablesInFreeRunning) {
  open(link::Mode::free_running);
  move(1);
  tick();
  EXPECT_EQ(answer<link::Torque>()->tau[0], moving);
  expect_drives(true);
  tick(patience - 1);
  EXPECT_FALSE(answer<link::Torque>());
  tick();
  const auto first = answer<link::Torque>();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->status, byte_of(link::TorqueStatus::watchdog));
  EXPECT_EQ(first->phase, byte_of(DrivePhase::fading));
  EXPECT_EQ(first->tau[1], moving);
  EXPECT_EQ(first->joint, link::no_joint);
  EXPECT_EQ(sequence_, 1u);
  tick(ramp / 2);
  EXPECT_NEAR(answer<link::Torque>()->tau[2], held + (moving - held) * 0.6f, 1e-3f)
      << "reported 40 ticks into the ramp";
  tick(ramp / 2);
  const auto holding = answer<link::Torque>();
  EXPECT_EQ(holding->phase, byte_of(DrivePhase::holding));
  EXPECT_EQ(holding->tau[0], held);
  tick(hold - 1);
  expect_drives(true);
  answers_ = 0;
  tick();
  const auto last = answer<link::Torque>();
  ASSERT_TRUE(last);
  EXPECT_EQ(last->phase, byte_of(DrivePhase::disabled));
  EXPECT_EQ(last->tau[0], 0.0f);
  ASSERT_EQ(board().drive_changes.size(), 2u);
  EXPECT_EQ(board().drive_changes[1].tick - board().drive_changes[0].tick, patience + ramp + hold);
  tick(1000);
  EXPECT_FALSE(answer<link::Torque>()) << "nothing more to report";
  EXPECT_EQ(stats().watchdog_holds, ramp + hold);
}

TEST_F(SafetyApp, TicksThatComeLateAgeTheLastSetPointAllTheSame) {
  open(link::Mode::free_running);
  move(1);
  tick();
  board().ticks += patience + ramp;
  app_.step();
  EXPECT_EQ(answer<link::Torque>()->phase, byte_of(DrivePhase::holding));
  board().ticks += hold;
  app_.step();
  expect_drives(false);
}

TEST_F(SafetyApp, ASilentLineFadesHoldsAndDisablesInLockStep) {
  open(link::Mode::lock_step);
  EXPECT_EQ(board().tick_rate_Hz, 1000u) << "the timer runs in lock-step too";
  move(1);
  tick(lock_step_patience - 1);
  EXPECT_EQ(answer<link::Torque>()->phase, byte_of(DrivePhase::running));
  tick();
  EXPECT_EQ(answer<link::Torque>()->phase, byte_of(DrivePhase::fading));
  tick(ramp + hold - 1);
  expect_drives(true);
  tick();
  ASSERT_EQ(board().drive_changes.size(), 2u);
  EXPECT_EQ(board().drive_changes[1].tick, lock_step_patience + ramp + hold);
}

TEST_F(SafetyApp, TicksBeforeASetPointAreNoneOfItsOwn) {
  open(link::Mode::lock_step);
  const Bytes frame = framed(set_point(4.0f), 1);
  send({frame.begin(), frame.end() - 1});
  board().ticks += 3;  // the loop has not come round since
  send({frame.end() - 1, frame.end()});
  tick(lock_step_patience + ramp + hold - 1);
  expect_drives(true);
  tick();
  ASSERT_EQ(board().drive_changes.size(), 2u);
  EXPECT_EQ(board().drive_changes[1].tick - board().drive_changes[0].tick, lock_step_patience + ramp + hold);
}

TEST_F(SafetyApp, AStepGivesOneAnswerSoThatTheTickIsNotKeptWaiting) {
  Bytes burst = wire(link::StatsRequest{}, 0);
  for (const std::uint8_t byte : start_frame(link::Mode::lock_step, hello_.session + 1, 7))
    burst.push_back(byte);
  for (const std::uint8_t byte : wire(set_point(1.0f), 1))
    burst.push_back(byte);
  board().to_board.insert(board().to_board.end(), burst.begin(), burst.end());
  std::vector<std::size_t> told;
  for (bool busy = true; busy; busy = !board().asleep) {
    app_.step();
    if (!board().from_board.empty()) told.push_back(board().from_board.size());
    board().from_board.clear();
  }
  EXPECT_EQ(told.size(), 3u) << "hello, statistics, error";
  for (const std::size_t bytes : told)
    EXPECT_LE(bytes, link::max_wire_size);
}

TEST_F(SafetyApp, TheStackIsMeasuredAPartAStepSoThatTheTickIsNotKeptWaiting) {
  board().stack_looks = 5;
  board().stack_bytes = 1236;
  const Bytes request = wire(link::StatsRequest{}, 0);
  board().to_board.insert(board().to_board.end(), request.begin(), request.end());
  for (int looks = 0; looks < 5; ++looks) {
    app_.step();
    EXPECT_FALSE(board().asleep);
    EXPECT_TRUE(board().from_board.empty());
  }
  app_.step();
  EXPECT_EQ(answer<link::Stats>().value().stack_bytes, 1236u);
  EXPECT_TRUE(board().asleep);
}

TEST_F(SafetyApp, AGoodSetPointEndsTheFallBackUntilTheDrivesAreDisabled) {
  open(link::Mode::free_running);
  move(1);
  tick(1 + patience + ramp / 2);
  ask(5.0f, 2);
  tick();
  EXPECT_EQ(answer<link::Torque>()->tau[0], 5.0f);
  tick(patience + ramp + hold);
  expect_drives(false);
  ask(6.0f, 3);
  tick();
  const auto refused = answer<link::Torque>();
  EXPECT_EQ(refused->status, byte_of(link::TorqueStatus::disabled));
  EXPECT_EQ(refused->tau[0], 0.0f);
  expect_drives(false);
  open(link::Mode::free_running);
  expect_drives(false);
  ask(6.0f, 1);
  tick();
  EXPECT_EQ(answer<link::Torque>()->tau[0], 6.0f);
  expect_drives(true);
}

TEST_F(SafetyApp, RefusedSetPointsDoNotKeepAMotionAlive) {
  open(link::Mode::free_running);
  move(1);
  tick();
  std::uint32_t number = 1;
  for (std::uint32_t i = 0; i < patience + ramp; ++i) {
    send(framed(bad(), ++number));
    tick();
  }
  const auto answered = answer<link::Torque>();
  EXPECT_EQ(answered->tau[0], held);
  expect_drives(true);
  for (std::uint32_t i = 0; i < hold; ++i) {
    send(framed(bad(), ++number));
    tick();
  }
  expect_drives(false);
}

TEST_F(SafetyApp, TheFirstRefusedRequestHoldsWhereThePositionIsKnown) {
  for (const link::Mode mode : {link::Mode::lock_step, link::Mode::free_running}) {
    hal::HostBoard::fresh();
    app_ = {};
    app_.start();
    hello_ = answer<link::Hello>().value();
    open(mode);
    link::SetPoint nowhere = set_point(3.0f);
    nowhere.q[2] = std::numeric_limits<float>::infinity();
    send(framed(nowhere, 1));
    tick();
    const auto idle = answer<link::Torque>();
    EXPECT_EQ(idle->phase, byte_of(DrivePhase::idle));
    EXPECT_EQ(idle->tau[0], 0.0f);
    expect_drives(false);
    send(framed(bad(), 2));
    if (mode == link::Mode::free_running) tick();
    const auto holding = answer<link::Torque>();
    EXPECT_EQ(holding->phase, byte_of(DrivePhase::holding));
    EXPECT_EQ(holding->tau[0], 3.0f);
    expect_drives(true);
    tick(hold);
    expect_drives(false);
  }
}

TEST_F(SafetyApp, AStartLetsNoArmFall) {
  open(link::Mode::free_running);
  move(1);
  tick(1 + patience + ramp);
  open(link::Mode::free_running);
  expect_drives(true);
  tick();
  expect_drives(true);
  EXPECT_EQ(board().drive_changes.size(), 1u);
}

TEST_F(SafetyApp, AnOldStartIsAnsweredByAHelloAndDoesNothing) {
  open(link::Mode::lock_step);
  const Bytes old = open(link::Mode::free_running, 100);
  const std::uint32_t session = hello_.session;
  ask(1.0f, 101);
  send(old);
  const auto hello = answer<link::Hello>();
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->session, session);
  ask(2.0f, 102);
  tick();
  EXPECT_EQ(answer<link::Torque>()->tau[0], 2.0f) << "the session goes on";
}

/// Everything that a host ever sent, played again: later in the session, in the next one, after a reset.
TEST_F(SafetyApp, WhatWasRecordedIsNeverDoneAgain) {
  const std::uint32_t at_boot = hello_.session;
  Bytes recorded = open(link::Mode::lock_step);
  for (std::uint32_t i = 1; i < 10; ++i) {
    const Bytes frame = framed(set_point(100.0f), i);
    recorded.insert(recorded.end(), frame.begin(), frame.end());
    send(frame);
  }
  ask(1.0f, 10);
  answer<link::Torque>();
  send(recorded);
  EXPECT_FALSE(answer<link::Torque>()) << "in the same session";
  EXPECT_EQ(faults(link::Fault::out_of_order), 9u);
  open(link::Mode::lock_step);
  send(recorded);
  EXPECT_FALSE(answer<link::Torque>()) << "in the next session";
  EXPECT_EQ(faults(link::Fault::bad_crc), 9u);
  ask(2.0f, 1);
  EXPECT_EQ(answer<link::Torque>()->tau[0], 2.0f);
  for (const std::uint32_t known_at_boot : {1000u, 0u}) {
    hal::HostBoard::boot();
    board().entropy = known_at_boot;
    app_ = {};
    app_.start();
    hello_ = answer<link::Hello>().value();
    EXPECT_EQ(hello_.session == at_boot, known_at_boot == 0) << "a board may know nothing but what it knew then";
    board().entropy += 17;  // bytes come at other times
    const std::size_t changes = board().drive_changes.size();
    send(recorded);
    EXPECT_FALSE(answer<link::Torque>()) << "after a reset";
    expect_drives(false);
    EXPECT_EQ(board().drive_changes.size(), changes);
    open(link::Mode::lock_step);
    EXPECT_EQ(stats().set_points, 0u);
  }
}

TEST_F(SafetyApp, AFloodOfBytesKeepsNoTickWaiting) {
  open(link::Mode::free_running);
  move(1);
  tick();
  board().to_board.assign(1000000, 0x11);
  for (std::uint32_t i = 0; i < patience + ramp + hold - 1; ++i)
    tick();
  expect_drives(true);
  tick();
  expect_drives(false);
  EXPECT_FALSE(board().to_board.empty()) << "the flood outlasts it";
  EXPECT_EQ(board().restarts, 0u);
}

TEST_F(SafetyApp, TheWatchdogIsFedOnceATickByALoopInTime) {
  EXPECT_EQ(board().watchdog_ms, hardware_watchdog_ms);
  open(link::Mode::free_running);
  const std::uint32_t before = board().feeds;
  app_.step();
  EXPECT_EQ(board().feeds, before) << "no tick, no food";
  tick(5);
  EXPECT_EQ(board().feeds, before + 5);
  EXPECT_FALSE(hal::HostBoard::watchdog_expired());
  board().ticks += hardware_watchdog_ms;
  EXPECT_TRUE(hal::HostBoard::watchdog_expired()) << "a loop that hangs";
}

TEST_F(SafetyApp, AMissedDeadlineIsCountedToldAndFeedsNothing) {
  open(link::Mode::free_running);
  tick();
  const std::uint32_t before = board().feeds;
  board().ticks += 2;
  app_.step();
  EXPECT_EQ(board().feeds, before);
  tick(recovery_ticks);
  EXPECT_EQ(board().feeds, before) << "once is not enough";
  tick();
  EXPECT_EQ(board().feeds, before + 1);
  ask(1.0f, 1);
  tick();
  EXPECT_EQ(answer<link::Torque>()->overruns, 1u);
  EXPECT_EQ(stats().deadline_overruns, 1u);
}

/// Every second tick in time is no loop in time.
TEST_F(SafetyApp, ALoopThatIsLateAgainAndAgainStarvesTheWatchdog) {
  open(link::Mode::free_running);
  tick();
  const std::uint32_t before = board().feeds;
  for (std::uint32_t i = 0; i < hardware_watchdog_ms / (2 + recovery_ticks) + 1; ++i) {
    board().ticks += 2;
    app_.step();
    tick(recovery_ticks);
  }
  EXPECT_EQ(board().feeds, before);
  EXPECT_TRUE(hal::HostBoard::watchdog_expired());
}

TEST_F(SafetyApp, InLockStepTheDeadlineIsThatOfTheFallBack) {
  open(link::Mode::lock_step);
  tick();
  const std::uint32_t before = board().feeds;
  board().ticks += watchdog_ticks;
  app_.step();
  EXPECT_EQ(board().feeds, before + 1);
  board().ticks += watchdog_ticks + 1;
  app_.step();
  EXPECT_EQ(board().feeds, before + 1);
  EXPECT_EQ(stats().deadline_overruns, 1u);
}

/// The tick's interrupt is masked while the torque is counted: what it hides is seen by the count.
TEST_F(SafetyApp, ATorqueThatTakesLongerThanATickMissesItsDeadline) {
  const std::uint32_t instructions_a_tick = 1'000'000'000u / 64 / 1000;
  board().counter = hal::CounterKind::instructions;
  for (const link::Mode mode : {link::Mode::free_running, link::Mode::lock_step}) {
    open(mode);
    board().count = instructions_a_tick;
    const std::uint32_t punctual = stats().deadline_overruns;
    ask(1.0f, 1);
    tick();
    const std::uint32_t before = stats().deadline_overruns, fed = board().feeds;
    EXPECT_EQ(before, punctual) << "it just meets its tick";
    board().count = instructions_a_tick + 1;
    ask(1.0f, 2);
    tick();
    const bool late = mode == link::Mode::free_running;
    EXPECT_EQ(stats().deadline_overruns, before + (late ? 1 : 0));
    EXPECT_EQ(board().feeds, fed + (late ? 0 : 1));
    tick(recovery_ticks + 1);
  }
  board().counter = hal::CounterKind::cycles;
  board().clock.core_Hz = 168'000'000;
  open(link::Mode::free_running);
  board().count = 168'000;
  ask(1.0f, 1);
  tick();
  const std::uint32_t before = stats().deadline_overruns;
  board().count = 168'001;
  ask(1.0f, 2);
  tick();
  EXPECT_EQ(stats().deadline_overruns, before + 1);
}

TEST_F(SafetyApp, APinThatDisagreesFeedsNothing) {
  open(link::Mode::free_running);
  ask(1.0f, 1);
  tick();
  const std::uint32_t before = board().feeds;
  board().drives = false;
  tick(3);
  EXPECT_EQ(board().feeds, before);
}

TEST_F(SafetyApp, ATouchedStackGuardDisablesAndRestartsWithinATick) {
  open(link::Mode::free_running);
  ask(1.0f, 1);
  tick();
  board().intact = false;
  const std::uint32_t fed = board().feeds;
  tick();
  EXPECT_EQ(board().restarts, 1u);
  expect_drives(false);
  EXPECT_EQ(board().feeds, fed);
  hal::HostBoard::boot();
  app_ = {};
  app_.start();
  const auto hello = answer<link::Hello>();
  EXPECT_EQ(hello->reset_cause, static_cast<std::uint8_t>(hal::ResetCause::stack_overflow));
}

TEST_F(SafetyApp, TheNextHelloTellsWhyAndWhere) {
  hal::FaultReport report{};
  report.cause = hal::ResetCause::fault;
  report.program_counter = 0x08001234;
  hal::seal(report, hal::FaultReport::fresh);
  board().report = report;
  hal::HostBoard::boot();
  app_ = {};
  app_.start();
  const auto hello = answer<link::Hello>();
  EXPECT_EQ(hello->reset_cause, static_cast<std::uint8_t>(hal::ResetCause::fault));
  EXPECT_EQ(hello->fault_address, 0x08001234u);
  board().report.check ^= 1u;
  app_ = {};
  app_.start();
  EXPECT_EQ(answer<link::Hello>()->fault_address, 0u) << "a report that is not whole tells nothing";
}

}  // namespace
}  // namespace axial::apps

// The main job's own source on the host board: what it answers, what it refuses, what it survives.

#include <limits>
#include <string>

#include <axial/version.hpp>

#include "app_fixture.hpp"

namespace axial::apps {
namespace {

using link::noise::Bytes;
using link::noise::wire;

class FeedforwardApp : public App<SumController> {
 protected:
  FeedforwardApp() { open(link::Mode::lock_step); }
};

TEST_F(FeedforwardApp, GreetsFirst) {
  EXPECT_EQ(greeting_.version, link::protocol_version);
  EXPECT_EQ(greeting_.joints, SumController::joints);
  EXPECT_EQ(greeting_.tick_Hz, 1000u);
  EXPECT_STREQ(greeting_.robot.data(), "sum");
  EXPECT_STREQ(greeting_.board.data(), "host");
  EXPECT_EQ(greeting_.nonce, 0u);
  EXPECT_EQ(greeting_.library, static_cast<std::uint32_t>(axial::version_number));
}

TEST(Version, SaysTheSameInWordsAndInNumbers) {
  const std::string words = std::to_string(AXIAL_VERSION_MAJOR) + "." + std::to_string(AXIAL_VERSION_MINOR) + "." +
                            std::to_string(AXIAL_VERSION_PATCH);
  EXPECT_EQ(words, axial::version_text);
}

TEST_F(FeedforwardApp, AnswersASetPointAtOnceInLockStep) {
  ask(1.5f, 11);
  const auto torque = answer<link::Torque>();
  ASSERT_TRUE(torque);
  EXPECT_EQ(sequence_, 11u);
  EXPECT_EQ(torque->joints, SumController::joints);
  EXPECT_EQ(torque->tau[2], 1.5f);
  EXPECT_EQ(torque->status, byte_of(link::TorqueStatus::ok));
  EXPECT_EQ(torque->phase, byte_of(DrivePhase::running));
}

TEST_F(FeedforwardApp, RepeatsTheLastSafeTorqueOnANonFiniteSetPoint) {
  ask(2.0f, 1);
  link::SetPoint bad = set_point(3.0f);
  bad.qd[1] = std::numeric_limits<float>::quiet_NaN();
  send(framed(bad, 2));
  const auto torque = answer<link::Torque>();
  ASSERT_TRUE(torque);
  EXPECT_EQ(torque->tau[0], 2.0f);
  EXPECT_EQ(torque->status, byte_of(link::TorqueStatus::not_finite));
  EXPECT_EQ(torque->joint, 1u);
  EXPECT_EQ(stats().refused, 1u);
}

TEST_F(FeedforwardApp, RefusesNumbersThatDoNotComeAfterTheLast) {
  ask(1.0f, 10);
  answer<link::Torque>();
  for (const std::uint32_t number : {10u, 9u, 0u}) {
    ask(5.0f, number);
    const auto error = answer<link::ErrorReply>();
    ASSERT_TRUE(error) << number;
    EXPECT_EQ(error->fault, index_of(link::Fault::out_of_order));
  }
  ask(5.0f, 14);
  EXPECT_TRUE(answer<link::Torque>());
  EXPECT_EQ(stats().gaps, 12u);
  EXPECT_EQ(faults(link::Fault::out_of_order), 3u);
}

TEST_F(FeedforwardApp, ANumberFarAheadBlocksNothing) {
  ask(1.0f, 1);
  answer<link::Torque>();
  for (const std::uint32_t number : {2 + link::sequence_window, 1000u, 0x7FFFFFFFu}) {
    ask(5.0f, number);
    const auto error = answer<link::ErrorReply>();
    ASSERT_TRUE(error) << number;
    EXPECT_EQ(error->fault, index_of(link::Fault::far_ahead));
  }
  ask(3.0f, 2);
  EXPECT_EQ(answer<link::Torque>()->tau[0], 3.0f);
}

TEST_F(FeedforwardApp, SequenceNumbersGoOnFromTheStartsOwnAndWrap) {
  open(link::Mode::lock_step, 0xFFFFFFFE);
  for (const std::uint32_t number : {0xFFFFFFFFu, 0u, 1u}) {
    ask(1.0f, number);
    EXPECT_TRUE(answer<link::Torque>()) << number;
  }
  EXPECT_EQ(stats().gaps, 0u);
}

TEST_F(FeedforwardApp, RefusesAnotherRobotsSetPointAndUnknownTypes) {
  link::SetPoint seven = set_point(1.0f);
  seven.joints = 7;
  send(framed(seven, 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::bad_payload));
  send(wire(link::Start{9, hello_.session, 7}, 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::bad_payload));
  send(wire(link::Start{0, hello_.session, 0}, 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::bad_payload)) << "a nonce of 0 is none";
  send(wire(link::Hello{}, 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::unknown_type));
  link::Measurement measurement{};
  measurement.joints = SumController::joints;
  send(framed(measurement, 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::unknown_type)) << "it closes no loop";
}

struct Measuring : SumController {
  void measure(const link::Measurement& m) { seen() = m.position[1] + 100 * m.feeds_forward; }
  static int& seen() {
    static int value = 0;
    return value;
  }
};

class ClosedLoopApp : public App<Measuring> {};

TEST_F(ClosedLoopApp, PassesMeasurementsOnAndRefusesAnotherRobotsAndAnotherSessions) {
  link::Measurement measurement{};
  measurement.joints = SumController::joints;
  measurement.position = {1, 7, 3}, measurement.feeds_forward = 1;
  Measuring::seen() = 0;
  send(framed(measurement, 1));
  EXPECT_EQ(Measuring::seen(), 0);
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::no_session)) << "none is open";
  open(link::Mode::lock_step);
  send(framed(measurement, 1));
  EXPECT_EQ(Measuring::seen(), 107);
  EXPECT_TRUE(board().from_board.empty()) << "the set-point has the answer";
  measurement.position[1] = 9;
  send(wire(measurement, 1));
  EXPECT_EQ(Measuring::seen(), 107) << "of no session";
  measurement.joints = 2;
  send(framed(measurement, 1));
  EXPECT_EQ(Measuring::seen(), 107);
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::bad_payload));
}

TEST_F(FeedforwardApp, ABurstOfGarbageGetsOneAnswerWithEveryCounter) {
  answers_ = 0;
  Bytes burst;
  for (int i = 0; i < 50; ++i)
    burst.insert(burst.end(), {0x02, 0x11, 0x00});
  send(burst);
  const auto error = answer<link::ErrorReply>();
  ASSERT_TRUE(error);
  EXPECT_EQ(answers_, 1);
  EXPECT_EQ(error->counters[index_of(link::Fault::truncated)], 50u);
}

TEST_F(FeedforwardApp, ABurstOfRequestsGetsOneAnswerOfEachKind) {
  answers_ = 0;
  Bytes burst;
  for (int i = 0; i < 50; ++i) {
    const Bytes stats = wire(link::StatsRequest{}, 9), start = start_frame(link::Mode::lock_step, 1, 7);
    burst.insert(burst.end(), stats.begin(), stats.end());
    burst.insert(burst.end(), start.begin(), start.end());
  }
  send(burst);
  const Bytes answered(board().from_board.begin(), board().from_board.end());
  EXPECT_TRUE(answer<link::Stats>());
  EXPECT_EQ(answers_, 1);
  EXPECT_EQ(sequence_, 9u);
  board().from_board.assign(answered.begin(), answered.end());
  EXPECT_TRUE(answer<link::Hello>());
  EXPECT_EQ(answers_, 2);
}

TEST_F(FeedforwardApp, ReportsBytesLostInTheReceiver) {
  board().overruns = 3;
  app_.step();
  EXPECT_EQ(answer<link::ErrorReply>()->counters[index_of(link::Fault::overrun)], 3u);
}

TEST_F(FeedforwardApp, FreeRunningAnswersTheNewestSetPointAtTheTick) {
  open(link::Mode::free_running);
  EXPECT_EQ(board().tick_rate_Hz, 1000u);
  EXPECT_EQ(hello_.mode, static_cast<std::uint8_t>(link::Mode::free_running));
  ask(1.0f, 1);
  ask(2.0f, 2);
  EXPECT_FALSE(answer<link::Torque>()) << "answered before the tick";
  tick();
  const auto torque = answer<link::Torque>();
  ASSERT_TRUE(torque);
  EXPECT_EQ(torque->tau[0], 2.0f);
  EXPECT_EQ(sequence_, 2u);
}

TEST_F(FeedforwardApp, ShutdownAndInjectionAreUnknownToAnImageForFlash) {
  send(framed(link::Shutdown{7}, 0));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::unknown_type));
  EXPECT_FALSE(board().exited);
  send(framed(link::Injection{3, 0}, 0));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::unknown_type));
}

class InjectableApp : public App<SumController, true> {};

TEST_F(InjectableApp, ShutdownEndsTheBoardWithItsCode) {
  send(wire(link::Shutdown{7}, 0));
  EXPECT_TRUE(board().exited);
  EXPECT_EQ(board().exit_code, 7);
}

/// Spoilt frames may by chance hold a good one (a doubled frame does), so the good frame that follows takes a number
/// that no earlier frame can have used.
TEST_F(FeedforwardApp, AGoodFrameAfterAnyOf100000SpoiltOnesIsAnswered) {
  constexpr unsigned seed = 20240919;
  std::mt19937 random(seed);
  std::uint32_t number = 0;
  for (int round = 0; round < 100000; ++round) {
    const auto value = static_cast<float>(random() % 1000);
    send(link::noise::spoilt(random, framed(set_point(-1.0f), ++number)));
    ask(value, ++number);
    const auto torque = answer<link::Torque>();
    ASSERT_TRUE(torque && sequence_ == number) << "seed " << seed << ", round " << round;
    ASSERT_EQ(torque->tau[0], value) << "seed " << seed << ", round " << round;
  }
  const link::Stats counted = stats();
  for (const link::Fault fault : {link::Fault::bad_cobs, link::Fault::truncated, link::Fault::oversized,
                                  link::Fault::bad_length, link::Fault::bad_crc}) {
    EXPECT_GT(counted.counters[index_of(fault)], 0u) << "fault " << index_of(fault);
  }
}

}  // namespace
}  // namespace axial::apps

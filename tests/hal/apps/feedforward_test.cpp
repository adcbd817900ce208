// The main job's own source on the host board: what it answers, what it refuses, what it survives.

#include <firmware/apps/feedforward/feedforward.hpp>

#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include <hal/host/board.hpp>

#include "../link/noise.hpp"
#include "sum_controller.hpp"

namespace axial::apps {
namespace {

using hal::HostBoard;
using link::noise::Bytes;
using link::noise::wire;

constexpr std::uint8_t byte_of(link::TorqueStatus status) { return static_cast<std::uint8_t>(status); }
constexpr std::size_t index_of(link::Fault fault) { return static_cast<std::size_t>(fault); }

link::SetPoint set_point(float value) {
  link::SetPoint out{};
  out.joints = SumController::joints;
  out.q = {value, value, value};
  return out;
}

class FeedforwardApp : public testing::Test {
 protected:
  FeedforwardApp() {
    HostBoard::fresh();
    app_.start();
  }

  void send(const Bytes& bytes) {
    HostBoard::state.to_board.insert(HostBoard::state.to_board.end(), bytes.begin(), bytes.end());
    app_.step();
  }

  /// One tick of the board's timer.
  void tick() {
    ++HostBoard::state.ticks;
    app_.step();
  }

  /// The newest answer of a type since the last call, the older ones dropped.
  template <class Message>
  std::optional<Message> answer() {
    std::optional<Message> found;
    for (const std::uint8_t byte : HostBoard::state.from_board) {
      if (decoder_.feed(byte) != link::FrameEvent::frame) continue;
      Message message{};
      if (!decode_message(decoder_.frame(), message)) continue;
      found = message;
      sequence_ = decoder_.frame().sequence;
      ++answers_;
    }
    HostBoard::state.from_board.clear();
    return found;
  }

  link::Stats stats() {
    send(wire(link::StatsRequest{}, 0));
    return answer<link::Stats>().value();
  }

  void choose(link::Mode mode) { send(wire(link::Start{static_cast<std::uint8_t>(mode)}, 0)); }

  Feedforward<HostBoard, SumController> app_;
  link::FrameDecoder decoder_;
  std::uint32_t sequence_ = 0;
  int answers_ = 0;
};

TEST_F(FeedforwardApp, GreetsFirst) {
  const auto hello = answer<link::Hello>();
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->version, link::protocol_version);
  EXPECT_EQ(hello->joints, SumController::joints);
  EXPECT_EQ(hello->tick_Hz, 1000u);
  EXPECT_STREQ(hello->robot.data(), "sum");
  EXPECT_STREQ(hello->board.data(), "host");
}

TEST_F(FeedforwardApp, AnswersASetPointAtOnceInLockStep) {
  send(wire(set_point(1.5f), 41));
  const auto torque = answer<link::Torque>();
  ASSERT_TRUE(torque);
  EXPECT_EQ(sequence_, 41u);
  EXPECT_EQ(torque->joints, SumController::joints);
  EXPECT_EQ(torque->tau[2], 1.5f);
  EXPECT_EQ(torque->status, byte_of(link::TorqueStatus::ok));
}

TEST_F(FeedforwardApp, RepeatsTheLastSafeTorqueOnANonFiniteSetPoint) {
  send(wire(set_point(2.0f), 1));
  link::SetPoint bad = set_point(3.0f);
  bad.qd[1] = std::numeric_limits<float>::quiet_NaN();
  send(wire(bad, 2));
  const auto torque = answer<link::Torque>();
  ASSERT_TRUE(torque);
  EXPECT_EQ(torque->tau[0], 2.0f);
  EXPECT_EQ(torque->status, byte_of(link::TorqueStatus::not_finite));
  EXPECT_EQ(torque->joint, 1u);
  EXPECT_EQ(stats().refused, 1u);
}

TEST_F(FeedforwardApp, RefusesNumbersThatDoNotComeAfterTheLast) {
  send(wire(set_point(1.0f), 10));
  answer<link::Torque>();
  for (const std::uint32_t number : {10u, 9u, 0u}) {
    send(wire(set_point(5.0f), number));
    const auto error = answer<link::ErrorReply>();
    ASSERT_TRUE(error) << number;
    EXPECT_EQ(error->fault, index_of(link::Fault::out_of_order));
  }
  send(wire(set_point(5.0f), 14));
  EXPECT_TRUE(answer<link::Torque>());
  EXPECT_EQ(stats().gaps, 3u);
  EXPECT_EQ(stats().counters[index_of(link::Fault::out_of_order)], 3u);
}

TEST_F(FeedforwardApp, SequenceNumbersWrap) {
  send(wire(set_point(1.0f), 0xFFFFFFFFu));
  EXPECT_TRUE(answer<link::Torque>());
  send(wire(set_point(1.0f), 0));
  EXPECT_TRUE(answer<link::Torque>());
  EXPECT_EQ(stats().gaps, 0u);
}

TEST_F(FeedforwardApp, RefusesAnotherRobotsSetPointAndUnknownTypes) {
  link::SetPoint seven = set_point(1.0f);
  seven.joints = 7;
  send(wire(seven, 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::bad_payload));
  send(wire(link::Start{9}, 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::bad_payload));
  send(wire(link::Hello{}, 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::unknown_type));
  link::Measurement measurement{};
  measurement.joints = SumController::joints;
  send(wire(measurement, 1));
  EXPECT_EQ(answer<link::ErrorReply>()->fault, index_of(link::Fault::unknown_type)) << "it closes no loop";
}

TEST(ClosedLoopApp, PassesMeasurementsOnAndRefusesAnotherRobots) {
  struct Measuring : SumController {
    void measure(const link::Measurement& m) { seen() = m.position[1] + 100 * m.feeds_forward; }
    static int& seen() {
      static int value = 0;
      return value;
    }
  };
  HostBoard::fresh();
  Feedforward<HostBoard, Measuring> app;
  app.start();
  const auto send = [&](const Bytes& bytes) {
    HostBoard::state.to_board.insert(HostBoard::state.to_board.end(), bytes.begin(), bytes.end());
    app.step();
  };
  link::Measurement measurement{};
  measurement.joints = SumController::joints;
  measurement.position = {1, 7, 3}, measurement.feeds_forward = 1;
  HostBoard::state.from_board.clear();
  send(wire(measurement, 1));
  EXPECT_EQ(Measuring::seen(), 107);
  EXPECT_TRUE(HostBoard::state.from_board.empty()) << "the set-point has the answer";
  measurement.joints = 2, measurement.position[1] = 9;
  send(wire(measurement, 1));
  EXPECT_EQ(Measuring::seen(), 107);
  EXPECT_FALSE(HostBoard::state.from_board.empty());
}

TEST_F(FeedforwardApp, ABurstOfGarbageGetsOneAnswerWithEveryCounter) {
  answer<link::Hello>();
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

TEST_F(FeedforwardApp, ReportsBytesLostInTheReceiver) {
  HostBoard::state.overruns = 3;
  app_.step();
  EXPECT_EQ(answer<link::ErrorReply>()->counters[index_of(link::Fault::overrun)], 3u);
}

TEST_F(FeedforwardApp, FreeRunningAnswersTheNewestSetPointAtTheTick) {
  choose(link::Mode::free_running);
  EXPECT_EQ(HostBoard::state.tick_rate_Hz, 1000u);
  EXPECT_EQ(answer<link::Hello>()->mode, static_cast<std::uint8_t>(link::Mode::free_running));
  send(wire(set_point(1.0f), 1));
  send(wire(set_point(2.0f), 2));
  EXPECT_FALSE(answer<link::Torque>()) << "answered before the tick";
  tick();
  const auto torque = answer<link::Torque>();
  ASSERT_TRUE(torque);
  EXPECT_EQ(torque->tau[0], 2.0f);
  EXPECT_EQ(sequence_, 2u);
}

TEST_F(FeedforwardApp, TheWatchdogHoldsTheLastSafeTorque) {
  choose(link::Mode::free_running);
  for (std::uint32_t i = 0; i < 3 * watchdog_ticks; ++i)
    tick();
  EXPECT_FALSE(answer<link::Torque>()) << "nothing to hold before the first set-point";
  send(wire(set_point(4.0f), 1));
  tick();
  answer<link::Torque>();
  for (std::uint32_t i = 1; i < watchdog_ticks; ++i)
    tick();
  EXPECT_FALSE(answer<link::Torque>());
  tick();
  const auto held = answer<link::Torque>();
  ASSERT_TRUE(held);
  EXPECT_EQ(held->status, byte_of(link::TorqueStatus::watchdog));
  EXPECT_EQ(held->tau[1], 4.0f);
  send(wire(set_point(5.0f), 2));
  tick();
  EXPECT_EQ(answer<link::Torque>()->status, byte_of(link::TorqueStatus::ok));
  EXPECT_EQ(stats().watchdog_holds, 1u);
}

TEST_F(FeedforwardApp, ShutdownEndsTheBoardWithItsCode) {
  send(wire(link::Shutdown{7}, 0));
  EXPECT_TRUE(HostBoard::state.exited);
  EXPECT_EQ(HostBoard::state.exit_code, 7);
}

/// Spoilt frames may by chance hold a good one (a doubled frame does), so the good frame that follows takes a number
/// that no earlier frame can have used.
TEST_F(FeedforwardApp, AGoodFrameAfterAnyOf100000SpoiltOnesIsAnswered) {
  constexpr unsigned seed = 20240919;
  std::mt19937 random(seed);
  std::uint32_t number = 0;
  for (int round = 0; round < 100000; ++round) {
    const auto value = static_cast<float>(random() % 1000);
    send(link::noise::spoilt(random, wire(set_point(-1.0f), ++number)));
    send(wire(set_point(value), ++number));
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

// The conversation with the firmware, against a firmware that the test plays at the other end of a socket pair.
#include <host_sim/boards/link/firmware.hpp>

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <stdexcept>
#include <thread>

#include <sys/socket.h>

namespace {

namespace link = host_sim::link;
using host_sim::Descriptor;
using host_sim::Firmware;
using host_sim::SerialLine;

/// Plays a board: greets, then answers every frame with what the test gives.
class PlayedBoard {
 public:
  using Answer = std::function<void(PlayedBoard&, const link::FrameView&)>;

  explicit PlayedBoard(Answer answer) : answer_(std::move(answer)) {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    host = SerialLine(Descriptor(ends[0]));
    board_ = SerialLine(Descriptor(ends[1]));
    thread_ = std::thread([this] { run(); });
  }
  ~PlayedBoard() {
    host = SerialLine();
    thread_.join();
  }

  template <class Message>
  void send(const Message& message, std::uint32_t sequence) {
    const auto wire = link::encode_message(message, sequence, session_);
    board_.write(wire.bytes.data(), wire.size);
  }
  void send_broken_frame() {
    auto wire = link::encode_message(link::StatsRequest{}, 1);
    wire.bytes[3] ^= 0x40;
    board_.write(wire.bytes.data(), wire.size);
  }
  [[noreturn]] void hang_up() {
    board_ = SerialLine();
    throw std::runtime_error("hung up");  // ends run()
  }
  void greet(std::uint8_t version = link::protocol_version, std::uint32_t nonce = 0) {
    greet(version, nonce, nonce == 0 ? booted : opened);
  }
  void greet(std::uint8_t version, std::uint32_t nonce, std::uint32_t session) {
    link::Hello hello{};
    hello.version = version;
    hello.joints = 2;
    hello.session = session;
    hello.nonce = nonce;
    session_ = link::no_session;
    send(hello, 0);
    session_ = hello.session;
  }
  /// Opens a session where the frame asks for one as it should.
  void open(const link::FrameView& frame, std::uint32_t nonce_off = 0) {
    link::Start start{};
    if (!link::decode_message(frame, start) || frame.session != link::no_session || start.session != booted) return;
    greet(link::protocol_version, start.nonce + nonce_off);
  }

  SerialLine host;
  static constexpr std::uint32_t booted = 0xB007, opened = 0x5E55;

 private:
  void run() try {
    greet();
    link::FrameDecoder decoder;
    std::uint8_t byte = 0;
    while (true) {
      if (board_.read(&byte, 1, std::chrono::seconds(10)) == 0) continue;
      decoder.set_session(session_);
      if (decoder.feed(byte) == link::FrameEvent::frame) answer_(*this, decoder.frame());
    }
  } catch (const std::runtime_error&) {  // one side hung up
  }

  Answer answer_;
  SerialLine board_;
  std::uint32_t session_ = link::no_session;
  std::thread thread_;
};

bool is(const link::FrameView& frame, link::MessageType type) { return frame.type == static_cast<std::uint8_t>(type); }

/// A good board: greets on start, and its torque is q + 10 qd + 100 qdd.
void answer_well(PlayedBoard& board, const link::FrameView& frame) {
  board.open(frame);
  link::SetPoint in{};
  if (!link::decode_message(frame, in) || frame.session != PlayedBoard::opened) return;
  link::Torque out{};
  out.joints = in.joints;
  for (std::size_t i = 0; i < in.joints; ++i)
    out.tau[i] = in.q[i] + 10.0F * in.qd[i] + 100.0F * in.qdd[i];
  out.count = 77;
  board.send(out, frame.sequence);
}

/// A board that starts well and answers set-points badly.
PlayedBoard::Answer with_torque(std::function<void(PlayedBoard&, const link::FrameView&)> bad) {
  return [bad = std::move(bad)](PlayedBoard& board, const link::FrameView& frame) {
    if (is(frame, link::MessageType::start)) return board.open(frame);
    bad(board, frame);
  };
}

const link::SetPoint set_point = host_sim::to_message({0.0, {1.0, 2.0}, {0.5, 0.25}, {3.0, -1.0}});

std::string failure(PlayedBoard::Answer answer) {
  PlayedBoard board(std::move(answer));
  try {
    Firmware(board.host).torque(set_point);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Firmware, AnswersASetPointWithATorque) {
  PlayedBoard board(answer_well);
  Firmware firmware(board.host);
  EXPECT_EQ(firmware.hello().joints, 2);
  for (int i = 0; i < 100; ++i) {
    const link::Torque torque = firmware.torque(set_point);
    EXPECT_EQ(torque.tau[0], 306.0F);
    EXPECT_EQ(torque.tau[1], -95.5F);
    EXPECT_EQ(torque.count, 77u);
  }
}

TEST(Firmware, SetPointsAreSentAsFloat) {
  const link::SetPoint message = host_sim::to_message({0.0, {0.1}, {0.2}, {0.3}});
  EXPECT_EQ(message.joints, 1u);
  EXPECT_EQ(message.q[0], 0.1F);
  EXPECT_EQ(message.qd[0], 0.2F);
  EXPECT_EQ(message.qdd[0], 0.3F);
}

TEST(Firmware, NoticesAnotherProtocolVersion) {
  const auto old = [](PlayedBoard& board, const link::FrameView&) { board.greet(99); };
  EXPECT_NE(failure(old).find("protocol version 99"), std::string::npos);
}

TEST(Firmware, NoticesTheAnswerToAnotherStart) {
  const auto other = [](PlayedBoard& board, const link::FrameView& frame) { board.open(frame, 1); };
  EXPECT_NE(failure(other).find("another session"), std::string::npos);
}

TEST(Firmware, AsksAgainWhereAResetHasMadeTheFirstStartVoid) {
  constexpr std::uint32_t after_asking = 0xA5CED;
  const auto fresh = [](PlayedBoard& board, const link::FrameView& frame) {
    link::Start start{};
    if (!link::decode_message(frame, start)) return answer_well(board, frame);
    if (start.session == PlayedBoard::booted) return board.greet(link::protocol_version, 0, after_asking);
    if (start.session == after_asking) board.greet(link::protocol_version, start.nonce);
  };
  PlayedBoard board(fresh);
  EXPECT_EQ(Firmware(board.host).torque(set_point).tau[0], 306.0F);
}

TEST(Firmware, ABoardThatNeverOpensASessionIsNamed) {
  const auto never = [](PlayedBoard& board, const link::FrameView& frame) {
    if (is(frame, link::MessageType::start)) board.greet();
  };
  EXPECT_NE(failure(never).find("another session"), std::string::npos);
}

TEST(Firmware, ReportsOfAHeldTorqueAreNoAnswers) {
  const auto late = [](PlayedBoard& board, const link::FrameView& frame) {
    if (is(frame, link::MessageType::start)) return board.open(frame);
    link::Torque held{};
    held.joints = 2;
    held.status = static_cast<std::uint8_t>(link::TorqueStatus::watchdog);
    board.send(held, frame.sequence - 1);
    answer_well(board, frame);
  };
  PlayedBoard board(late);
  EXPECT_EQ(Firmware(board.host).torque(set_point).tau[0], 306.0F);
}

TEST(Firmware, ATorqueOfAnotherSessionIsABrokenFrame) {
  const auto other = [](PlayedBoard& board, const link::FrameView& frame) {
    board.greet();
    link::Torque torque{};
    torque.joints = 2;
    board.send(torque, frame.sequence);
  };
  EXPECT_FALSE(failure(with_torque(other)).empty());
}

/// A good arm: its encoders count the numbers that it was asked by, and its speed is the effort.
void move_well(PlayedBoard& board, const link::FrameView& frame) {
  board.open(frame);
  link::Torque in{};
  link::ArmCommand told{};
  link::ArmLoad load{};
  link::Encoders out{};
  out.joints = 2;
  if (link::decode_message(frame, in))
    out.position[0] = static_cast<std::int32_t>(frame.sequence), out.speed[0] = in.tau[0];
  else if (link::decode_message(frame, told))
    out.speed[0] = 10.0F * told.values[0], out.phase = told.action;
  else if (link::decode_message(frame, load))
    out.speed[1] = 100.0F * load.mass;
  else
    return;
  board.send(out, frame.sequence);
}

TEST(Firmware, MovesAnArm) {
  PlayedBoard board(move_well);
  Firmware arm(board.host);
  link::Torque tau{};
  tau.joints = 2, tau.tau = {0.5F};
  EXPECT_EQ(arm.command({2, {2.0F}, 3}).speed[0], 20.0F);
  EXPECT_EQ(arm.carry({1.5F, {}, {}}).speed[1], 150.0F);
  EXPECT_EQ(arm.move(tau).position[0], 1);
  EXPECT_EQ(arm.move(tau).speed[0], 0.5F);
  arm.skip(5);
  EXPECT_EQ(arm.try_move(tau, std::chrono::seconds(5))->position[0], 8);
  EXPECT_EQ(arm.try_command({2, {2.0F}, 3}, std::chrono::seconds(5))->phase, 3);
}

/// Every start is answered, also one of a session that is none; that is told late.
void run_for_long(PlayedBoard& board, const link::FrameView& frame) {
  link::Start start{};
  if (!link::decode_message(frame, start)) return move_well(board, frame);
  if (start.session == PlayedBoard::booted)
    board.greet(link::protocol_version, start.nonce);
  else
    board.greet();
}

TEST(Firmware, AsksABoardThatHasRunForLongAndPassesOverWhatElseItSays) {
  PlayedBoard board(run_for_long);
  Firmware arm(board.host, Firmware::Runs::already);
  EXPECT_EQ(arm.hello().session, PlayedBoard::opened);
  link::Torque tau{};
  tau.joints = 2, tau.tau = {0.5F};
  EXPECT_EQ(arm.move(tau).position[0], 1);
}

TEST(Firmware, PassesOverWhatIsNoAnswerWhereTheLineMayFail) {
  const auto noisy = [](PlayedBoard& board, const link::FrameView& frame) {
    if (is(frame, link::MessageType::start)) return board.open(frame);
    board.send_broken_frame();
    board.send(link::ErrorReply{}, 0);
    link::Encoders old{};
    old.joints = 2;
    board.send(old, frame.sequence - 1);
    old.status = static_cast<std::uint8_t>(link::TorqueStatus::watchdog);
    board.send(old, frame.sequence);
    move_well(board, frame);
  };
  PlayedBoard board(noisy);
  Firmware arm(board.host);
  link::Torque tau{};
  tau.joints = 2;
  EXPECT_EQ(arm.try_move(tau, std::chrono::seconds(5))->position[0], 1);
  EXPECT_THROW(arm.move(tau), std::runtime_error);
}

TEST(Firmware, WhatDoesNotComeInTimeIsNone) {
  PlayedBoard board(with_torque([](PlayedBoard&, const link::FrameView&) {}));
  Firmware firmware(board.host);
  EXPECT_FALSE(firmware.try_torque({}, set_point, std::chrono::milliseconds(50)));
  EXPECT_FALSE(firmware.try_report(std::chrono::milliseconds(50)));
  EXPECT_FALSE(firmware.try_stats(std::chrono::milliseconds(50)));
  EXPECT_FALSE(firmware.try_session(std::chrono::milliseconds(50))) << "this board's session is open already";
}

TEST(Firmware, NoticesALostTorque) {
  const auto skip = [](PlayedBoard& board, const link::FrameView& frame) {
    link::Torque out{};
    out.joints = 2;
    board.send(out, frame.sequence + 1);
  };
  EXPECT_NE(failure(with_torque(skip)).find("expected torque 1, got torque 2"), std::string::npos);
}

TEST(Firmware, NoticesAWrongNumberOfJoints) {
  const auto short_answer = [](PlayedBoard& board, const link::FrameView& frame) {
    link::Torque out{};
    out.joints = 1;
    board.send(out, frame.sequence);
  };
  EXPECT_NE(failure(with_torque(short_answer)).find("wrong number of joints"), std::string::npos);
}

TEST(Firmware, PassesOnWhatTheFirmwareReports) {
  const auto refuse = [](PlayedBoard& board, const link::FrameView& frame) {
    link::ErrorReply reply{};
    reply.fault = static_cast<std::uint8_t>(link::Fault::bad_crc);
    board.send(reply, frame.sequence);
  };
  EXPECT_NE(failure(with_torque(refuse)).find("a bad CRC"), std::string::npos);
}

TEST(Firmware, NoticesABrokenFrame) {
  const auto broken = [](PlayedBoard& board, const link::FrameView&) { board.send_broken_frame(); };
  EXPECT_NE(failure(with_torque(broken)).find("broken frame"), std::string::npos);
}

TEST(Firmware, NoticesAClosedLine) {
  const auto hang_up = [](PlayedBoard& board, const link::FrameView&) { board.hang_up(); };
  EXPECT_NE(failure(with_torque(hang_up)).find("closed its serial line"), std::string::npos);
}

}  // namespace

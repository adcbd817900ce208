#pragma once
/// The main job's own source on the host board, and a host that speaks with it.

#include <firmware/apps/feedforward/feedforward.hpp>

#include <optional>

#include <gtest/gtest.h>

#include <hal/host/board.hpp>

#include "../link/noise.hpp"
#include "sum_controller.hpp"

namespace axial::apps {

constexpr std::uint8_t byte_of(link::TorqueStatus status) { return static_cast<std::uint8_t>(status); }
constexpr std::uint8_t byte_of(DrivePhase phase) { return static_cast<std::uint8_t>(phase); }
constexpr std::size_t index_of(link::Fault fault) { return static_cast<std::size_t>(fault); }

inline link::SetPoint set_point(float value) {
  link::SetPoint out{};
  out.joints = SumController::joints;
  out.q = {value, value, value};
  return out;
}

template <class Controller, bool injectable = false>
class App : public testing::Test {
 protected:
  using Bytes = link::noise::Bytes;

  App() {
    hal::HostBoard::fresh();
    app_.start();
    greeting_ = hello_ = answer<link::Hello>().value_or(link::Hello{});
  }

  static hal::HostBoardState& board() { return hal::HostBoard::state; }

  /// Steps until everything that came is taken and answered; a step takes a part and gives an answer.
  void send(const Bytes& bytes) {
    board().to_board.insert(board().to_board.end(), bytes.begin(), bytes.end());
    do
      app_.step();
    while (!board().asleep);
  }
  /// A frame of the session.
  template <class Message>
  Bytes framed(const Message& message, std::uint32_t number) const {
    return link::noise::wire(message, number, hello_.session);
  }
  void ask(float value, std::uint32_t number) { send(framed(set_point(value), number)); }

  /// Ticks of the board's timer.
  void tick(std::uint32_t count = 1) {
    for (; count > 0; --count) {
      ++board().ticks;
      app_.step();
    }
  }

  Bytes start_frame(link::Mode mode, std::uint32_t session, std::uint32_t nonce, std::uint32_t number = 0) {
    return link::noise::wire(link::Start{static_cast<std::uint8_t>(mode), session, nonce}, number);
  }
  /// Opens a session whose set-points are counted from `number`; out: what was sent. The first start since boot makes
  /// the identifier that the next must name.
  Bytes open(link::Mode mode, std::uint32_t number = 0) {
    Bytes sent;
    do {
      const Bytes start = start_frame(mode, hello_.session, 7, number);
      sent.insert(sent.end(), start.begin(), start.end());
      send(start);
      hello_ = answer<link::Hello>().value();
    } while (hello_.nonce != 7 && sent.size() < 3 * start_frame(mode, 1, 7).size());
    return sent;
  }

  /// The newest answer of a type since the last call, the older ones dropped.
  template <class Message>
  std::optional<Message> answer() {
    std::optional<Message> found;
    for (const std::uint8_t byte : board().from_board) {
      if (decoder_.feed(byte) != link::FrameEvent::frame) continue;
      Message message{};
      if (!decode_message(decoder_.frame(), message)) continue;
      found = message;
      sequence_ = decoder_.frame().sequence;
      ++answers_;
      if constexpr (Message::type == link::MessageType::hello) decoder_.set_session(message.session);
    }
    board().from_board.clear();
    return found;
  }

  link::Stats stats() {
    send(link::noise::wire(link::StatsRequest{}, 0));
    return answer<link::Stats>().value();
  }
  std::uint32_t faults(link::Fault fault) { return stats().counters[index_of(fault)]; }

  Feedforward<hal::HostBoard, Controller, injectable> app_;
  link::FrameDecoder decoder_;
  link::Hello greeting_{}, hello_{};
  std::uint32_t sequence_ = 0;
  int answers_ = 0;
};

}  // namespace axial::apps

// The firmware at the other end of the serial line, in messages.
#pragma once

#include <host_sim/boards/emulator/serial_line.hpp>
#include <host_sim/robots/trajectory/set_point.hpp>

#include <hal/link/messages.hpp>

#include <chrono>
#include <optional>
#include <string>

namespace host_sim {

namespace link = axial::hal::link;

/// Lock-step conversation with the feedforward image: one set-point out, one torque in.
/// Every member throws std::runtime_error when the answer is late, broken or not the expected one.
class Firmware {
 public:
  /// Whether a board starts now and says hello of itself, or has run for long.
  enum class Runs { from_now, already };

  /// Waits for the hello frame, or asks for it, and opens a session in lock-step.
  explicit Firmware(SerialLine& line, Runs runs = Runs::from_now);

  const link::Hello& hello() const { return hello_; }

  /// The torque for a set-point, which is sent as float.
  link::Torque torque(const link::SetPoint& set_point);
  /// The same from an image that closes a loop, which is told first what the encoders say.
  link::Torque torque(const link::Measurement& measurement, const link::SetPoint& set_point);
  /// Third and fourth derivative of the set-point that comes next, to an image that takes them.
  void send_derivatives(const link::Derivatives& derivatives);
  link::Stats stats();
  /// A tick of an image that stands in for an arm, by a controller's torque.
  link::Encoders move(const link::Torque& efforts);
  link::Encoders command(const link::ArmCommand& command);
  link::Encoders carry(const link::ArmLoad& load);

  // --- where the line may fail: what did not come in time is none, and all else that came is passed over

  std::optional<link::Torque> try_torque(const std::optional<link::Measurement>& measurement,
                                         const link::SetPoint& set_point, std::chrono::milliseconds limit);
  std::optional<link::Encoders> try_move(const link::Torque& efforts, std::chrono::milliseconds limit);
  std::optional<link::Encoders> try_command(const link::ArmCommand& command, std::chrono::milliseconds limit);
  /// What a controller exerts of itself and reports.
  std::optional<link::Torque> try_report(std::chrono::milliseconds limit);
  std::optional<link::Stats> try_stats(std::chrono::milliseconds limit);
  /// A session anew: disabled drives are idle again.
  bool try_session(std::chrono::milliseconds limit);
  /// The next number is so much farther, or back.
  void skip(std::int32_t numbers) { sequence_ += static_cast<std::uint32_t>(numbers); }

 private:
  void check_version() const;
  void open_session();
  void ask_for_session();
  void use_session();
  template <class Answer>
  Answer wait_for(std::chrono::milliseconds limit, const std::string& what);
  template <class Answer>
  std::optional<Answer> look_for(std::chrono::milliseconds limit, bool reports = false);
  link::FrameView next_frame(std::chrono::steady_clock::time_point end, const std::string& what);
  template <class Message>
  void send(const Message& message, std::uint32_t sequence);

  SerialLine& line_;
  link::FrameDecoder decoder_;
  std::uint8_t received_[512];
  std::size_t size_ = 0, at_ = 0;
  std::uint32_t sequence_ = 0, session_ = link::no_session;
  link::Hello hello_{};
};

/// The float set-point that stands for a desired motion; what is sent and what the oracle evaluates.
link::SetPoint to_message(const SetPoint& point);
/// Its third and fourth derivative, as float.
link::Derivatives derivatives_of(const SetPoint& point);

}  // namespace host_sim

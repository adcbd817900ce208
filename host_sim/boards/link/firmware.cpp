#include <host_sim/boards/link/firmware.hpp>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace host_sim {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto start_limit = std::chrono::seconds(20);
constexpr auto answer_limit = std::chrono::seconds(5);

const char* fault_name(std::uint8_t fault) {
  constexpr const char* names[] = {"bad stuffing",
                                   "a truncated frame",
                                   "an oversized frame",
                                   "a bad length",
                                   "a bad CRC",
                                   "a sequence number out of order",
                                   "a bad payload",
                                   "an unknown type",
                                   "an overrun",
                                   "a frame of no session",
                                   "a sequence number far ahead"};
  static_assert(sizeof names / sizeof *names == link::fault_kinds);
  return fault < link::fault_kinds ? names[fault] : "an unknown fault";
}

std::string describe_error(const link::FrameView& frame) {
  if (frame.type == static_cast<std::uint8_t>(link::MessageType::hello) && frame.length > 0)
    return "a hello of protocol version " + std::to_string(frame.payload[0]);
  link::ErrorReply reply{};
  return link::decode_message(frame, reply) ? std::string("the firmware reports ") + fault_name(reply.fault)
                                            : "frame of type " + std::to_string(frame.type);
}

/// What a controller exerts, or an arm does, of itself while nothing is asked for.
template <class Answer>
bool reports(const link::FrameView& frame) {
  Answer answer{};
  return link::decode_message(frame, answer) &&
         answer.status == static_cast<std::uint8_t>(link::TorqueStatus::watchdog);
}
bool is_report(const link::FrameView& frame) { return reports<link::Torque>(frame) || reports<link::Encoders>(frame); }

/// Whether a message has the number of what it answers.
template <class Answer>
constexpr bool is_numbered = Answer::type == link::MessageType::torque || Answer::type == link::MessageType::encoders;

}  // namespace

Firmware::Firmware(SerialLine& line, Runs runs) : line_(line) {
  if (runs == Runs::already) {
    ask_for_session();
  } else {
    hello_ = wait_for<link::Hello>(start_limit, "hello");
    check_version();
    use_session();
    open_session();
  }
}

void Firmware::ask_for_session() {
  int tries = 0;
  while (!try_session(std::chrono::milliseconds(500)))
    if (++tries == 5)
      throw std::runtime_error(
          "nothing says hello: does the board run an image of axial, at this rate, and do its two wires cross?");
  while (look_for<link::Hello>(std::chrono::milliseconds(200))) {
  }  // one for each start that was sent, and what it said of itself
  check_version();
}

void Firmware::check_version() const {
  if (hello_.version != link::protocol_version)
    throw std::runtime_error("the firmware speaks protocol version " + std::to_string(hello_.version) +
                             ", this program " + std::to_string(link::protocol_version));
}

void Firmware::open_session() {
  const std::uint32_t nonce = std::random_device{}() | 1U;
  int tries = 0;
  do {  // the first start after a reset is answered by the identifier that the next must name
    send(link::Start{static_cast<std::uint8_t>(link::Mode::lock_step), hello_.session, nonce}, sequence_);
    hello_ = wait_for<link::Hello>(answer_limit, "hello in lock-step");
    check_version();
  } while (hello_.nonce == 0 && ++tries < 2);
  if (hello_.nonce != nonce)
    throw std::runtime_error("the firmware opened another session than this program asked for");
  use_session();
}

void Firmware::use_session() {
  session_ = hello_.session;
  decoder_.set_session(session_);
}

link::Torque Firmware::torque(const link::SetPoint& set_point) {
  send(set_point, ++sequence_);
  const auto answer = wait_for<link::Torque>(answer_limit, "torque " + std::to_string(sequence_));
  if (answer.joints != set_point.joints) throw std::runtime_error("a torque has the wrong number of joints");
  return answer;
}

link::Torque Firmware::torque(const link::Measurement& measurement, const link::SetPoint& set_point) {
  send(measurement, sequence_);
  return torque(set_point);
}

void Firmware::send_derivatives(const link::Derivatives& derivatives) { send(derivatives, sequence_); }

link::Stats Firmware::stats() {
  send(link::StatsRequest{}, ++sequence_);
  return wait_for<link::Stats>(answer_limit, "statistics");
}

link::Encoders Firmware::move(const link::Torque& efforts) {
  send(efforts, ++sequence_);
  return wait_for<link::Encoders>(answer_limit, "encoders " + std::to_string(sequence_));
}

link::Encoders Firmware::command(const link::ArmCommand& command) {
  send(command, sequence_);
  return wait_for<link::Encoders>(answer_limit, "encoders after a command");
}

link::Encoders Firmware::carry(const link::ArmLoad& load) {
  send(load, sequence_);
  return wait_for<link::Encoders>(answer_limit, "encoders after a load");
}

std::optional<link::Torque> Firmware::try_torque(const std::optional<link::Measurement>& measurement,
                                                 const link::SetPoint& set_point, std::chrono::milliseconds limit) {
  if (measurement) send(*measurement, sequence_);
  send(set_point, ++sequence_);
  return look_for<link::Torque>(limit);
}

std::optional<link::Encoders> Firmware::try_move(const link::Torque& efforts, std::chrono::milliseconds limit) {
  send(efforts, ++sequence_);
  return look_for<link::Encoders>(limit);
}

std::optional<link::Encoders> Firmware::try_command(const link::ArmCommand& command, std::chrono::milliseconds limit) {
  send(command, sequence_);
  return look_for<link::Encoders>(limit);
}

std::optional<link::Torque> Firmware::try_report(std::chrono::milliseconds limit) {
  return look_for<link::Torque>(limit, true);
}

std::optional<link::Stats> Firmware::try_stats(std::chrono::milliseconds limit) {
  send(link::StatsRequest{}, sequence_);
  return look_for<link::Stats>(limit);
}

bool Firmware::try_session(std::chrono::milliseconds limit) {
  const std::uint32_t nonce = std::random_device{}() | 1U;
  for (int tries = 0; tries < 4; ++tries) {
    send(link::Start{static_cast<std::uint8_t>(link::Mode::lock_step), hello_.session, nonce}, sequence_);
    const auto hello = look_for<link::Hello>(limit);
    if (hello) hello_ = *hello;
    if (hello && hello->nonce == nonce) return use_session(), true;
  }
  return false;
}

template <class Answer>
std::optional<Answer> Firmware::look_for(std::chrono::milliseconds limit, bool reports) {
  const auto end = Clock::now() + limit;
  while (Clock::now() < end) {
    while (at_ < size_) {
      if (decoder_.feed(received_[at_++]) != link::FrameEvent::frame) continue;
      const auto frame = decoder_.frame();
      Answer answer{};
      const bool fits = reports || !is_numbered<Answer> || frame.sequence == sequence_;
      if (link::decode_message(frame, answer) && is_report(frame) == reports && fits) return answer;
    }
    at_ = 0;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    size_ = left.count() > 0 ? line_.read(received_, sizeof received_, left) : 0;
  }
  return {};
}

template <class Answer>
Answer Firmware::wait_for(std::chrono::milliseconds limit, const std::string& what) {
  const auto end = Clock::now() + limit;
  link::FrameView frame = next_frame(end, what);
  while (is_report(frame))
    frame = next_frame(end, what);
  Answer answer{};
  if (!link::decode_message(frame, answer))
    throw std::runtime_error("expected " + what + ", got: " + describe_error(frame));
  if (is_numbered<Answer> && frame.sequence != sequence_)
    throw std::runtime_error("expected " + what + ", got " +
                             (Answer::type == link::MessageType::torque ? "torque " : "encoders ") +
                             std::to_string(frame.sequence));
  return answer;
}

link::FrameView Firmware::next_frame(Clock::time_point end, const std::string& what) {
  while (true) {
    while (at_ < size_) {
      const link::FrameEvent event = decoder_.feed(received_[at_++]);
      if (event == link::FrameEvent::frame) return decoder_.frame();
      if (event != link::FrameEvent::none) throw std::runtime_error("a broken frame came instead of " + what);
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0) throw std::runtime_error("no " + what + " came in time");
    at_ = 0;
    size_ = line_.read(received_, sizeof received_, left);
  }
}

template <class Message>
void Firmware::send(const Message& message, std::uint32_t sequence) {
  const link::WireBytes wire =
      link::encode_message(message, sequence, Message::type == link::MessageType::start ? link::no_session : session_);
  line_.write(wire.bytes.data(), wire.size);
}

link::SetPoint to_message(const SetPoint& point) {
  link::SetPoint message{};
  message.joints = point.q.size();
  const auto narrow = [](double value) { return static_cast<float>(value); };
  std::transform(point.q.begin(), point.q.end(), message.q.begin(), narrow);
  std::transform(point.qd.begin(), point.qd.end(), message.qd.begin(), narrow);
  std::transform(point.qdd.begin(), point.qdd.end(), message.qdd.begin(), narrow);
  return message;
}

link::Derivatives derivatives_of(const SetPoint& point) {
  link::Derivatives message{};
  message.joints = point.q3.size();
  const auto narrow = [](double value) { return static_cast<float>(value); };
  std::transform(point.q3.begin(), point.q3.end(), message.q3.begin(), narrow);
  std::transform(point.q4.begin(), point.q4.end(), message.q4.begin(), narrow);
  return message;
}

}  // namespace host_sim

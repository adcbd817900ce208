#pragma once
/// Every message of the link, and the only place of their layouts. A layout is written once, as `layout(archive,
/// message)`, and serves writing and reading. README.md has the table.

#include <array>
#include <cstddef>
#include <cstdint>

#include <hal/link/bytes.hpp>
#include <hal/link/frame.hpp>

namespace axial::hal::link {

constexpr std::uint8_t protocol_version = 3;
constexpr std::size_t max_joints = 8;
constexpr std::size_t name_size = 16;

enum class MessageType : std::uint8_t {
  hello = 1,          ///< firmware: after start-up, and as the answer to `start`
  set_point = 2,      ///< host
  torque = 3,         ///< firmware: the answer to a set-point, with its sequence number
  error = 4,          ///< firmware: something on the line was refused
  stats_request = 5,  ///< host
  stats = 6,          ///< firmware
  shutdown = 7,       ///< host: end the emulator; in images for fault injection alone
  start = 8,          ///< host: open a session and choose a mode
  measurement = 9,    ///< host: what the encoders say, for images that close a loop; before the tick's set-point
  injection = 10,     ///< host: fail; in images for fault injection alone
  derivatives =
      11,         ///< host: third and fourth derivative of the motion, for images that take them; before the set-point
  encoders = 12,  ///< a board that stands in for an arm: the answer to a torque, with its sequence number
  arm_command = 13,  ///< host, to such a board
  arm_load = 14      ///< host, to such a board: what the arm carries from now on
};

enum class Mode : std::uint8_t {
  lock_step = 0,    ///< a set-point is answered at once; its sequence number is the time
  free_running = 1  ///< the newest set-point is answered at the board's tick
};

enum class TorqueStatus : std::uint8_t {
  ok = 0,
  not_finite = 1,      ///< the set-point holds NaN or infinity; the drives are held
  outside_limits = 2,  ///< of position, speed, acceleration or payload; the drives are held
  effort_limited = 3,  ///< the torque was cut to the joint's effort limit, or to its rate
  watchdog = 4,        ///< no good set-point came in time: a report, no answer
  disabled = 5,        ///< the drives are disabled until a session is started
  not_measured = 6     ///< no measurement came with the set-point of an image that closes a loop; the drives are held
};
constexpr std::uint8_t no_joint = 255;

/// What was refused; each has a counter.
enum class Fault : std::uint8_t {
  bad_cobs = 0,      ///< the stuffing ends inside a block
  truncated = 1,     ///< shorter than a header and a CRC
  oversized = 2,     ///< longer than any message
  bad_length = 3,    ///< the length field disagrees with the frame
  bad_crc = 4,       //
  out_of_order = 5,  ///< a sequence number not after the last one
  bad_payload = 6,   ///< a payload that does not fit its type
  unknown_type = 7,  //
  overrun = 8,       ///< bytes lost in the receiver
  no_session = 9,    ///< what only a session's frames may ask for
  far_ahead = 10     ///< a sequence number beyond the window
};
constexpr std::size_t fault_kinds = 11;
/// How far after the last one a sequence number may be. Lost frames are passed over, and a number that is wrong blocks
/// no more than these.
constexpr std::uint32_t sequence_window = 20;
using FaultCounters = std::array<std::uint32_t, fault_kinds>;
using Name = std::array<char, name_size>;  ///< padded with zeros, at least one

struct Hello {
  static constexpr MessageType type = MessageType::hello;
  std::uint8_t version, joints, clock_source, counter_kind, mode;  ///< see ClockSource, CounterKind, Mode
  std::uint32_t clock_Hz, baud, tick_Hz;
  std::uint32_t counter_numerator,
      counter_denominator;      ///< count over raw ticks; counts in messages are scaled already
  std::uint32_t empty_bracket;  ///< subtracted already
  Name robot, board;
  std::uint32_t session;        ///< of the frames that follow; what the next `start` must name
  std::uint32_t nonce;          ///< of the `start` that this answers; 0 after a reset
  std::uint8_t reset_cause;     ///< see hal::ResetCause
  std::uint32_t fault_address;  ///< program counter of the last fault; 0 where none is known
  std::uint32_t library;        ///< version of axial: major * 10000 + minor * 100 + patch
};

struct SetPoint {
  static constexpr MessageType type = MessageType::set_point;
  std::size_t joints;  ///< not sent: the payload's length tells
  std::array<float, max_joints> q, qd, qdd;
};

struct Torque {
  static constexpr MessageType type = MessageType::torque;
  std::size_t joints;  ///< not sent: the payload's length tells
  std::array<float, max_joints> tau;
  std::uint32_t count;         ///< instructions or cycles of this torque
  std::uint16_t overruns;      ///< deadlines missed so far; stays at 65535
  std::uint8_t status, joint;  ///< see TorqueStatus
  std::uint8_t phase;          ///< of the drives: see axial::DrivePhase
};

struct ErrorReply {
  static constexpr MessageType type = MessageType::error;
  std::uint8_t fault;  ///< the latest
  FaultCounters counters;
};

struct StatsRequest {
  static constexpr MessageType type = MessageType::stats_request;
};

struct Stats {
  static constexpr MessageType type = MessageType::stats;
  std::uint32_t frames, set_points, refused, gaps;  ///< good frames; torques computed; held by status; numbers left out
  std::uint32_t ticks, watchdog_holds;
  std::uint32_t count_min, count_max;
  std::uint32_t stack_bytes;        ///< deepest use so far
  std::uint32_t deadline_overruns;  ///< deadlines missed so far
  FaultCounters counters;
};

struct Shutdown {
  static constexpr MessageType type = MessageType::shutdown;
  std::uint8_t exit_code;
};

/// Starts a session: its own sequence number is the one after which set-points are counted.
struct Start {
  static constexpr MessageType type = MessageType::start;
  std::uint8_t mode;
  std::uint32_t session;  ///< as the last hello said: what was recorded earlier names another
  std::uint32_t nonce;    ///< the host's choice, not 0; the hello that answers repeats it
};

/// What an image for fault injection can be made to do.
enum class InjectedFault : std::uint8_t {
  stack_overflow = 0,  //
  wild_jump = 1,       ///< to `address`
  hang = 2,            ///< an endless loop; with interrupts masked where `address` is not 0
  stray_write = 3      ///< of a zero to `address`
};
struct Injection {
  static constexpr MessageType type = MessageType::injection;
  std::uint8_t fault;  ///< see InjectedFault
  std::uint32_t address;
};

/// What the motion's own torque is computed for.
enum class FeedForward : std::uint8_t {
  none = 0,  ///< the feedback alone; of a hand-guiding image: gravity compensation
  full = 1,  ///< the robot as it is declared
  rigid = 2  ///< an image that knows elastic joints takes them as rigid
};

/// Encoders: 2^-32 turns, or 0.1 um on a slide. No answer: the set-point that follows has one.
struct Measurement {
  static constexpr MessageType type = MessageType::measurement;
  std::size_t joints;  ///< not sent: the payload's length tells
  std::array<std::int32_t, max_joints> position;
  std::uint8_t feeds_forward;  ///< see FeedForward
};

/// More of the set-point that follows: rad or m per s^3, per s^4. No answer.
struct Derivatives {
  static constexpr MessageType type = MessageType::derivatives;
  std::size_t joints;  ///< not sent: the payload's length tells
  std::array<float, max_joints> q3, q4;
};

/// How a board that stands in for an arm answers a torque: what its encoders say after a tick of it.
struct Encoders {
  static constexpr MessageType type = MessageType::encoders;
  std::size_t joints;                             ///< not sent: the payload's length tells
  std::array<std::int32_t, max_joints> position;  ///< as a measurement has them
  std::array<float, max_joints> speed;            ///< rad/s or m/s
  std::uint32_t count;                            ///< instructions or cycles of this tick
  std::uint16_t overruns;                         ///< deadlines missed so far; stays at 65535
  std::uint8_t status, joint;                     ///< see TorqueStatus
  std::uint8_t phase;                             ///< of the arm's drives
};

/// What becomes of an arm that a board stands in for.
enum class ArmAction : std::uint8_t {
  place = 0,  ///< it is at rest at `values`, rad or m
  push = 1,   ///< `values`, N m or N, act on the joints besides, until the next push
  blind = 2,  ///< encoders whose value is not 0 say 0, as of a broken wire
  stop = 3,   ///< time stands still
  go = 4      ///< it goes on
};
struct ArmCommand {
  static constexpr MessageType type = MessageType::arm_command;
  std::size_t joints;  ///< not sent: the payload's length tells
  std::array<float, max_joints> values;
  std::uint8_t action;  ///< see ArmAction
};

/// What the last link carries besides, in its frame; none where all is 0.
struct ArmLoad {
  static constexpr MessageType type = MessageType::arm_load;
  float mass;                    ///< kg
  std::array<float, 3> com;      ///< m
  std::array<float, 6> inertia;  ///< kg m^2 about com: xx, yy, zz, xy, xz, yz
};

template <class Archive, class Array>
void each(Archive& archive, Array& values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    archive(values[i]);
}

template <class Archive>
void layout(Archive& a, Name& name) {
  for (char& c : name) {
    auto byte = static_cast<std::uint8_t>(c);
    a(byte);
    c = static_cast<char>(byte);
  }
}

template <class Archive>
void layout(Archive& a, Hello& m) {
  a(m.version), a(m.joints), a(m.clock_source), a(m.counter_kind), a(m.mode);
  a(m.clock_Hz), a(m.baud), a(m.tick_Hz);
  a(m.counter_numerator), a(m.counter_denominator), a(m.empty_bracket);
  layout(a, m.robot), layout(a, m.board);
  a(m.session), a(m.nonce), a(m.reset_cause), a(m.fault_address), a(m.library);
}

template <class Archive>
void layout(Archive& a, SetPoint& m) {
  each(a, m.q, m.joints), each(a, m.qd, m.joints), each(a, m.qdd, m.joints);
}

template <class Archive>
void layout(Archive& a, Torque& m) {
  each(a, m.tau, m.joints);
  a(m.count), a(m.overruns), a(m.status), a(m.joint), a(m.phase);
}

template <class Archive>
void layout(Archive& a, ErrorReply& m) {
  a(m.fault), each(a, m.counters, fault_kinds);
}

template <class Archive>
void layout(Archive&, StatsRequest&) {}

template <class Archive>
void layout(Archive& a, Stats& m) {
  a(m.frames), a(m.set_points), a(m.refused), a(m.gaps), a(m.ticks), a(m.watchdog_holds);
  a(m.count_min), a(m.count_max), a(m.stack_bytes), a(m.deadline_overruns), each(a, m.counters, fault_kinds);
}

template <class Archive>
void layout(Archive& a, Shutdown& m) {
  a(m.exit_code);
}

template <class Archive>
void layout(Archive& a, Start& m) {
  a(m.mode), a(m.session), a(m.nonce);
}

template <class Archive>
void layout(Archive& a, Injection& m) {
  a(m.fault), a(m.address);
}

template <class Archive>
void layout(Archive& a, Derivatives& m) {
  each(a, m.q3, m.joints), each(a, m.q4, m.joints);
}

template <class Archive, class Message>
void positions(Archive& a, Message& m) {
  for (std::size_t i = 0; i < m.joints; ++i) {
    auto word = static_cast<std::uint32_t>(m.position[i]);
    a(word);
    m.position[i] = static_cast<std::int32_t>(word);
  }
}

template <class Archive>
void layout(Archive& a, Measurement& m) {
  positions(a, m), a(m.feeds_forward);
}

template <class Archive>
void layout(Archive& a, Encoders& m) {
  positions(a, m), each(a, m.speed, m.joints);
  a(m.count), a(m.overruns), a(m.status), a(m.joint), a(m.phase);
}

template <class Archive>
void layout(Archive& a, ArmCommand& m) {
  each(a, m.values, m.joints), a(m.action);
}

template <class Archive>
void layout(Archive& a, ArmLoad& m) {
  a(m.mass), each(a, m.com, m.com.size()), each(a, m.inertia, m.inertia.size());
}

constexpr std::size_t set_point_size(std::size_t joints) { return 12 * joints; }
constexpr std::size_t torque_size(std::size_t joints) { return 4 * joints + 9; }
constexpr std::size_t measurement_size(std::size_t joints) { return 4 * joints + 1; }
constexpr std::size_t derivatives_size(std::size_t joints) { return 8 * joints; }
constexpr std::size_t encoders_size(std::size_t joints) { return 8 * joints + 9; }
constexpr std::size_t arm_command_size(std::size_t joints) { return 4 * joints + 1; }
static_assert(set_point_size(max_joints) <= max_payload && torque_size(max_joints) <= max_payload);
static_assert(encoders_size(max_joints) <= max_payload);

/// Bytes of a message with a frame around it.
struct WireBytes {
  std::array<std::uint8_t, max_wire_size> bytes;
  std::size_t size;
};

/// `message` stays as it is: a layout that reads it is one that writes it.
template <class Message>
std::size_t encode_message(Message& message, std::uint32_t sequence, std::uint32_t session, std::uint8_t* out) {
  std::uint8_t payload[max_payload];
  ByteWriter writer(payload, sizeof payload);
  layout(writer, message);
  return encode_frame({static_cast<std::uint8_t>(Message::type), sequence, payload, writer.size(), session}, out);
}

template <class Message>
WireBytes encode_message(const Message& message, std::uint32_t sequence, std::uint32_t session = no_session) {
  WireBytes wire{};
  Message copy = message;
  wire.size = encode_message(copy, sequence, session, wire.bytes.data());
  return wire;
}

template <class Message>
bool set_joints(Message&, std::size_t) {
  return true;
}
inline bool set_joints(SetPoint& m, std::size_t length) {
  m.joints = length / 12;
  return length % 12 == 0 && m.joints <= max_joints;
}
inline bool set_joints(Torque& m, std::size_t length) {
  m.joints = length < torque_size(0) ? 0 : (length - torque_size(0)) / 4;
  return length == torque_size(m.joints) && m.joints <= max_joints;
}
inline bool set_joints(Measurement& m, std::size_t length) {
  m.joints = length / 4;
  return length == measurement_size(m.joints) && m.joints <= max_joints;
}
inline bool set_joints(Derivatives& m, std::size_t length) {
  m.joints = length / 8;
  return length % 8 == 0 && m.joints <= max_joints;
}
inline bool set_joints(Encoders& m, std::size_t length) {
  m.joints = length < encoders_size(0) ? 0 : (length - encoders_size(0)) / 8;
  return length == encoders_size(m.joints) && m.joints <= max_joints;
}
inline bool set_joints(ArmCommand& m, std::size_t length) {
  m.joints = length / 4;
  return length == arm_command_size(m.joints) && m.joints <= max_joints;
}

/// Reads `frame` as a `Message`; false when the type or the payload's length does not fit.
template <class Message>
bool decode_message(const FrameView& frame, Message& message) {
  if (frame.type != static_cast<std::uint8_t>(Message::type) || !set_joints(message, frame.length)) return false;
  ByteReader reader(frame.payload, frame.length);
  layout(reader, message);
  return reader.complete();
}

constexpr Name make_name(const char* text) {
  Name name{};
  for (std::size_t i = 0; i + 1 < name_size && text[i] != '\0'; ++i)
    name[i] = text[i];
  return name;
}

/// Whether a set-point and its answer, one after the other, fit one tick on a line of 10 bits a byte; with a
/// measurement before them where the loop is closed. Where two more derivatives are taken the answer may leave while
/// the next set-point comes in, for the line is duplex: then a torque is that of the tick before.
constexpr bool fits_tick(std::size_t joints, std::uint32_t baud, std::uint32_t tick_Hz, bool closes_loop = false,
                         bool takes_derivatives = false) {
  const std::size_t bytes = wire_size(set_point_size(joints)) +
                            (takes_derivatives ? wire_size(derivatives_size(joints)) : wire_size(torque_size(joints))) +
                            (closes_loop ? wire_size(measurement_size(joints)) : 0);
  return bytes * 10 * tick_Hz <= baud;
}
/// Likewise a torque and what the encoders of an arm answer.
constexpr bool arm_fits_tick(std::size_t joints, std::uint32_t baud, std::uint32_t tick_Hz) {
  return (wire_size(torque_size(joints)) + wire_size(encoders_size(joints))) * 10 * tick_Hz <= baud;
}

}  // namespace axial::hal::link

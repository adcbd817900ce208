#pragma once
/// The main job: set-points in, feed-forward torques and their cost out. A template on the board and on the controller,
/// so that the same source runs on a microcontroller, in an emulator and inside a host test.
///
/// Lock-step: every set-point is answered at once. Free-running: the newest set-point is answered at the board's tick.
/// In both the tick runs: it ages the last good set-point, whose torque then fades into what holds the arm until the
/// drives are disabled (deadlines.hpp, doc/guides/safety.md), and feeds the watchdog where the loop came round in time.

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <axial/version.h>
#include <hal/fault_report.hpp>
#include <hal/link/messages.hpp>

#include "deadlines.hpp"
#include "injection.hpp"
#include "sequence.hpp"
#include "session.hpp"
#include "tally.hpp"

namespace axial::apps {

namespace link = hal::link;

/// Whether a controller closes a loop: it has measure(measurement).
template <class Controller, class = void>
inline constexpr bool closes_loop = false;
template <class Controller>
inline constexpr bool closes_loop<Controller, std::void_t<decltype(&Controller::measure)>> = true;

/// Whether a controller takes third and fourth derivatives: it has take(derivatives).
template <class Controller, class = void>
inline constexpr bool takes_derivatives = false;
template <class Controller>
inline constexpr bool takes_derivatives<Controller, std::void_t<decltype(&Controller::take)>> = true;

/// Whether it is no controller but an arm: it takes torques and answers encoders (LinkRequest, LinkAnswer), and has
/// choose(mode), pass(numbers), command(command), and where it `carries` carry(load).
template <class Controller, class = void>
inline constexpr bool stands_for_arm = false;
template <class Controller>
inline constexpr bool stands_for_arm<Controller, std::void_t<decltype(Controller::carries)>> = true;

/// What is asked for, and answered.
///@{
template <class Controller, bool arm = stands_for_arm<Controller>>
struct LinkMessages {
  using Request = link::SetPoint;
  using Answer = link::Torque;
  static constexpr std::size_t request_size = link::set_point_size(Controller::joints);
  template <class Board>
  static constexpr bool fit = link::fits_tick(Controller::joints, Board::baud, Board::tick_Hz, closes_loop<Controller>,
                                              takes_derivatives<Controller>);
};
template <class Arm>
struct LinkMessages<Arm, true> {
  using Request = link::Torque;
  using Answer = link::Encoders;
  static constexpr std::size_t request_size = link::torque_size(Arm::joints);
  template <class Board>
  static constexpr bool fit = link::arm_fits_tick(Arm::joints, Board::baud, Board::tick_Hz);
};
///@}

/// `Board`: see hal/README.md. `Controller`: see controller.hpp; `joints`, `name`, load(set-point), compute(), which is
/// measured, settle(set-point), store(torque), and of its fall-back store_exerted(torque), set_times(times),
/// advance(ticks), restart(), phase(); where it closes a loop, measure(measurement), and where it knows elastic joints
/// take(derivatives); or an arm, stands_for_arm. `injectable` images end and fail
/// on request; they are for emulators.
template <class Board, class Controller, bool injectable = false>
class Feedforward {
  using Messages = LinkMessages<Controller>;
  using Request = typename Messages::Request;
  using Answer = typename Messages::Answer;
  static_assert(Messages::template fit<Board>,
                "A set-point and its answer do not fit a tick: raise the board's baud rate or lower its tick_Hz.");

 public:
  void start() {
    Board::start();
    Board::enable_drives(false);
    Board::guard_stack();
    Board::start_tick(Board::tick_Hz);
    last_tick_ = aged_ = woke_ = Board::ticks();
    session_.boot(Board::entropy());
    decoder_.set_session(session_.id());
    choose(link::Mode::lock_step);
    greet();
    Board::start_watchdog(hardware_watchdog_ms);
  }

  /// Handles a part of what has arrived, and what is due; then sleeps until there is more.
  void step() {
    receive();
    run_ticks();
    answer_requests();
    Board::sleep_unless([this] { return !Board::serial_idle() || owes_answers() || Board::ticks() != last_tick_; });
    woke_ = Board::ticks();
  }

 private:
  /// So many bytes and no more: whoever floods the line does not keep the tick waiting.
  static constexpr int bytes_a_step = 32;

  void receive() {
    std::uint8_t byte = 0;
    for (int left = bytes_a_step; left > 0 && Board::read(byte); --left) {
      const link::FrameEvent event = decoder_.feed(byte);
      if (event == link::FrameEvent::frame) {
        ++tally_.frames;
        handle(decoder_.frame());
      } else if (event != link::FrameEvent::none) {
        tally_.refuse(fault_of(event));
      }
      if (left == bytes_a_step) Board::entropy();  // when bytes come is what differs from start to start
    }
    tally_.note_overruns(Board::overruns());
  }

  void handle(const link::FrameView& frame) {
    if constexpr (takes_derivatives<Controller>)
      if (frame.type == static_cast<std::uint8_t>(link::MessageType::derivatives)) return take_derivatives(frame);
    if constexpr (stands_for_arm<Controller>) {
      if (frame.type == static_cast<std::uint8_t>(link::MessageType::arm_command)) return take_command(frame);
      if constexpr (Controller::carries)
        if (frame.type == static_cast<std::uint8_t>(link::MessageType::arm_load)) return take_load(frame);
    }
    switch (static_cast<link::MessageType>(frame.type)) {
      case Request::type:
        return take_request(frame);
      case link::MessageType::stats_request:
        return with<link::StatsRequest>(frame, [&](auto&) {
          stats_wanted_ = true;
          stats_number_ = frame.sequence;
        });
      case link::MessageType::start:
        return with<link::Start>(frame, [&](auto& m) { restart(m, frame.sequence); });
      case link::MessageType::measurement:
        return take_measurement(frame);
      default:
        return handle_injection(frame);
    }
  }

  void handle_injection(const link::FrameView& frame) {
    if constexpr (injectable) {
      const auto type = static_cast<link::MessageType>(frame.type);
      if (type == link::MessageType::shutdown)
        return with<link::Shutdown>(frame, [&](auto& m) { Board::exit(m.exit_code); });
      if (type == link::MessageType::injection)
        return with<link::Injection>(frame, [&](auto& m) { injection::commit<Board>(m); });
    }
    tally_.refuse(link::Fault::unknown_type);
  }

  void take_measurement(const link::FrameView& frame) {
    if constexpr (!closes_loop<Controller>) {
      tally_.refuse(link::Fault::unknown_type);
    } else {
      if (frame.length != link::measurement_size(Controller::joints)) return tally_.refuse(link::Fault::bad_payload);
      if (!in_session(frame)) return tally_.refuse(link::Fault::no_session);
      with<link::Measurement>(frame, [&](auto& m) { controller_.measure(m); });
    }
  }

  void take_derivatives(const link::FrameView& frame) {
    if (frame.length != link::derivatives_size(Controller::joints)) return tally_.refuse(link::Fault::bad_payload);
    if (!in_session(frame)) return tally_.refuse(link::Fault::no_session);
    with<link::Derivatives>(frame, [&](auto& m) { controller_.take(m); });
  }

  void take_command(const link::FrameView& frame) {
    if (frame.length != link::arm_command_size(Controller::joints)) return tally_.refuse(link::Fault::bad_payload);
    obey<link::ArmCommand>(frame, [&](auto& m) { return controller_.command(m); });
  }
  void take_load(const link::FrameView& frame) {
    obey<link::ArmLoad>(frame, [&](auto& m) { return controller_.carry(m); });
  }
  /// What happens to an arm; the answer is what its encoders say now.
  template <class Command, class Action>
  void obey(const link::FrameView& frame, Action action) {
    if (!in_session(frame)) return tally_.refuse(link::Fault::no_session);
    with<Command>(frame, [&](auto& m) {
      if (!action(m)) return tally_.refuse(link::Fault::bad_payload);
      Answer now{};
      controller_.store_exerted(now);
      now.overruns = tally_.missed_deadlines();
      send(now, frame.sequence, session_.id());
    });
  }

  template <class Message, class Action>
  void with(const link::FrameView& frame, Action action) {
    Message message{};
    if (!decode_message(frame, message)) return tally_.refuse(link::Fault::bad_payload);
    action(message);
  }

  /// The decoder passes frames of this session and of none.
  bool in_session(const link::FrameView& frame) const { return session_.is_open() && frame.session == session_.id(); }

  void take_request(const link::FrameView& frame) {
    if (frame.length != Messages::request_size) return tally_.refuse(link::Fault::bad_payload);
    if (!in_session(frame)) return tally_.refuse(link::Fault::no_session);
    const std::uint32_t last = sequence_.last();
    const Sequence::Verdict verdict = sequence_.take(frame.sequence);
    if (verdict != Sequence::Verdict::next)
      return tally_.refuse(verdict == Sequence::Verdict::old ? link::Fault::out_of_order : link::Fault::far_ahead);
    decode_message(frame, request_);
    if constexpr (stands_for_arm<Controller>) controller_.pass(frame.sequence - last);
    fresh_ = true;
    if (mode_ == link::Mode::lock_step) answer();
  }

  /// Once a tick, however late; ticks that were missed count with the others.
  void run_ticks() {
    const std::uint32_t now = Board::ticks(), passed = now - last_tick_;
    if (passed == 0) return;
    last_tick_ = now;
    tally_.ticks += passed;
    if (!Board::stack_intact()) return Board::fail(hal::ResetCause::stack_overflow);
    const DrivePhase before = controller_.phase();
    age();
    set_drives();
    bool punctual = now - woke_ <= deadline_ticks();  // an emulator that paused while the board slept is not late
    if (fresh_) punctual = answer() && punctual;
    report(before, passed);
    feed_watchdog(punctual);
  }

  /// The fall-back's clock up to this moment: ticks that passed before a set-point was taken are none of its own.
  void age() {
    const std::uint32_t now = Board::ticks();
    controller_.advance(now - aged_);
    aged_ = now;
  }

  void feed_watchdog(bool punctual) {
    if (!punctual) {
      recovering_ = recovery_ticks;
      return tally_.note_missed_deadline();
    }
    if (recovering_ > 0)
      --recovering_;
    else if (Board::drives_enabled() == drives_wanted())
      Board::feed_watchdog();
  }

  /// In lock-step the sequence number is the time: the loop must come round while the hardware's watchdog waits.
  std::uint32_t deadline_ticks() const { return mode_ == link::Mode::free_running ? 1 : watchdog_ticks; }

  /// False where the torque took longer than a tick that it had to meet.
  bool answer() {
    auto compute = [this] { controller_.compute(); };
    Answer answer{};
    age();
    controller_.load(request_);
    const std::uint32_t count = Board::count(compute);
    controller_.settle(request_);
    set_drives();
    controller_.store(answer);
    answer.count = count;
    answer.overruns = tally_.missed_deadlines();
    tally_.add(answer);
    fresh_ = false;
    send(answer, sequence_.last(), session_.id());
    return mode_ == link::Mode::lock_step || count <= counts_a_tick<Board>();
  }

  bool drives_wanted() const {
    const DrivePhase phase = controller_.phase();
    return phase != DrivePhase::idle && phase != DrivePhase::disabled;
  }

  /// The pin is written when it is to change, so that a pin that disagrees afterwards is seen (run_ticks).
  void set_drives() {
    if (drives_wanted() == drives_) return;
    drives_ = !drives_;
    Board::enable_drives(drives_);
  }

  /// While the drives are held the host hears of it: when that begins, every `watchdog_ticks`, and when it ends.
  void report(DrivePhase before, std::uint32_t ticks) {
    const DrivePhase now = controller_.phase();
    const bool held = now == DrivePhase::fading || now == DrivePhase::holding;
    if (held) tally_.watchdog_holds += ticks;
    since_report_ = now == before ? since_report_ + ticks : watchdog_ticks;
    const bool due = since_report_ >= watchdog_ticks && now != DrivePhase::running && now != DrivePhase::idle;
    if (!due || (!held && now == before)) return;
    since_report_ = 0;
    Answer exerted{};
    controller_.store_exerted(exerted);
    exerted.overruns = tally_.missed_deadlines();
    exerted.status = static_cast<std::uint8_t>(link::TorqueStatus::watchdog);
    exerted.joint = link::no_joint;
    send(exerted, sequence_.last(), session_.id());
  }

  /// A `start` that names another session was recorded, or its sender has not heard the last hello: the answer is one.
  /// So is that to the first since the board started: only then have bytes come, whose times make an identifier.
  void restart(const link::Start& wanted, std::uint32_t number) {
    if (wanted.mode > static_cast<std::uint8_t>(link::Mode::free_running))
      return tally_.refuse(link::Fault::bad_payload);
    if (wanted.nonce == 0) return tally_.refuse(link::Fault::bad_payload);
    const bool opened = session_.open(wanted.session, wanted.nonce, Board::entropy());
    decoder_.set_session(session_.id());
    if (!opened) {
      hello_wanted_ = true;
      return;
    }
    nonce_ = wanted.nonce;
    sequence_.restart(number);
    fresh_ = false;
    controller_.restart();
    choose(static_cast<link::Mode>(wanted.mode));
    set_drives();
    greet();
  }

  void choose(link::Mode mode) {
    mode_ = mode;
    if constexpr (stands_for_arm<Controller>)
      controller_.choose(mode, Board::tick_Hz);
    else
      controller_.set_times(fall_back_times(mode, Board::tick_Hz));
  }

  void greet() {
    link::Hello hello{};
    const auto& clock = Board::clock();
    const auto counter = Board::counter_scale();
    hello.version = link::protocol_version;
    hello.joints = Controller::joints;
    hello.clock_source = static_cast<std::uint8_t>(clock.source);
    hello.counter_kind = static_cast<std::uint8_t>(counter.kind);
    hello.mode = static_cast<std::uint8_t>(mode_);
    hello.clock_Hz = clock.core_Hz;
    hello.baud = Board::baud_running();
    hello.tick_Hz = Board::tick_Hz;
    hello.counter_numerator = counter.numerator;
    hello.counter_denominator = counter.denominator;
    hello.empty_bracket = Board::empty_bracket();
    hello.robot = link::make_name(Controller::name);
    hello.board = link::make_name(Board::name);
    hello.session = session_.id();
    hello.nonce = nonce_;
    hello.reset_cause = static_cast<std::uint8_t>(Board::reset_cause());
    hello.fault_address = hal::sound(Board::last_fault()) ? Board::last_fault().program_counter : 0;
    hello.library = AXIAL_VERSION_NUMBER;
    send(hello, sequence_.last(), link::no_session);
  }

  /// Not before the stack is measured, which takes many steps.
  void send_stats() {
    std::uint32_t stack_bytes = 0;
    if (!Board::measure_stack(stack_bytes)) return;
    stats_wanted_ = false;
    link::Stats stats = tally_.stats();
    stats.gaps = sequence_.gaps();
    stats.stack_bytes = stack_bytes;
    send(stats, stats_number_, session_.id());
  }

  bool owes_answers() const { return hello_wanted_ || stats_wanted_ || tally_.has_news(); }

  /// Once the line is quiet: a burst of garbage or of requests gets one answer of each kind, so that answers cannot
  /// crowd out what comes in. One a step, so that the tick does not wait for all of them.
  void answer_requests() {
    if (!Board::serial_idle()) return;
    if (hello_wanted_) {
      hello_wanted_ = false;
      greet();
    } else if (stats_wanted_) {
      send_stats();
    } else if (tally_.has_news()) {
      link::ErrorReply reply = tally_.error_reply();
      send(reply, sequence_.last(), session_.id());
    }
  }

  /// Not inlined: one wire buffer on the stack, not one for every caller.
  template <class Message>
  [[gnu::noinline]] void send(Message& message, std::uint32_t sequence, std::uint32_t session) {
    std::uint8_t wire[link::max_wire_size];
    Board::write(wire, link::encode_message(message, sequence, session, wire));
  }

  link::FrameDecoder decoder_{};
  Request request_{};
  Controller controller_{};
  Tally tally_{};
  Sequence sequence_{};
  Session session_{};
  link::Mode mode_ = link::Mode::lock_step;
  std::uint32_t last_tick_ = 0, aged_ = 0, woke_ = 0, since_report_ = 0, stats_number_ = 0, nonce_ = 0, recovering_ = 0;
  bool fresh_ = false, drives_ = false, hello_wanted_ = false, stats_wanted_ = false;
};

}  // namespace axial::apps

#pragma once
/// The main job: set-points in, feed-forward torques and their cost out. A template on the board and on the controller,
/// so that the same source runs on a microcontroller, in an emulator and inside a host test.
///
/// Lock-step: every set-point is answered at once; its sequence number is the time. Free-running: the newest set-point
/// is answered at the board's tick; without one for `watchdog_ticks` the last safe torque is repeated, reported and
/// counted.

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <hal/link/messages.hpp>

#include "sequence.hpp"
#include "tally.hpp"

namespace axial::apps {

namespace link = hal::link;

constexpr std::uint32_t watchdog_ticks = 20;

/// Whether a controller closes a loop: it has measure(measurement).
template <class Controller, class = void>
inline constexpr bool closes_loop = false;
template <class Controller>
inline constexpr bool closes_loop<Controller, std::void_t<decltype(&Controller::measure)>> = true;

/// `Board`: see hal/README.md. `Controller`: see controller.hpp; `joints`, `name`, load(set-point), compute(), which is
/// measured, store(torque) and store_last_safe(torque); where it closes a loop, measure(measurement).
template <class Board, class Controller>
class Feedforward {
  static_assert(link::fits_tick(Controller::joints, Board::baud, Board::tick_Hz, closes_loop<Controller>),
                "A set-point and its answer do not fit a tick: raise the board's baud rate or lower its tick_Hz.");

 public:
  void start() {
    Board::start();
    greet();
  }

  /// Handles what has arrived and what is due; then sleeps until there is more.
  void step() {
    receive();
    if (mode_ == link::Mode::free_running) run_ticks();
    answer_faults();
    Board::sleep_unless([this] { return !Board::serial_idle() || tick_is_due(); });
  }

 private:
  void receive() {
    std::uint8_t byte = 0;
    while (Board::read(byte)) {
      const link::FrameEvent event = decoder_.feed(byte);
      if (event == link::FrameEvent::frame) {
        ++tally_.frames;
        handle(decoder_.frame());
      } else if (event != link::FrameEvent::none) {
        tally_.refuse(fault_of(event));
      }
    }
    tally_.note_overruns(Board::overruns());
  }

  void handle(const link::FrameView& frame) {
    switch (static_cast<link::MessageType>(frame.type)) {
      case link::MessageType::set_point:
        return take_set_point(frame);
      case link::MessageType::stats_request:
        return with<link::StatsRequest>(frame, [&](auto&) { send_stats(frame.sequence); });
      case link::MessageType::start:
        return with<link::Start>(frame, [&](auto& m) { restart(m.mode); });
      case link::MessageType::shutdown:
        return with<link::Shutdown>(frame, [&](auto& m) { Board::exit(m.exit_code); });
      case link::MessageType::measurement:
        return take_measurement(frame);
      default:
        return tally_.refuse(link::Fault::unknown_type);
    }
  }

  void take_measurement(const link::FrameView& frame) {
    if constexpr (!closes_loop<Controller>) {
      tally_.refuse(link::Fault::unknown_type);
    } else {
      if (frame.length != link::measurement_size(Controller::joints)) return tally_.refuse(link::Fault::bad_payload);
      with<link::Measurement>(frame, [&](auto& m) { controller_.measure(m); });
    }
  }

  template <class Message, class Action>
  void with(const link::FrameView& frame, Action action) {
    Message message{};
    if (!decode_message(frame, message)) return tally_.refuse(link::Fault::bad_payload);
    action(message);
  }

  void take_set_point(const link::FrameView& frame) {
    if (frame.length != link::set_point_size(Controller::joints)) return tally_.refuse(link::Fault::bad_payload);
    if (!sequence_.accept(frame.sequence)) return tally_.refuse(link::Fault::out_of_order);
    decode_message(frame, set_point_);
    fresh_ = true;
    if (mode_ == link::Mode::lock_step) answer();
  }

  /// One answer a tick, however late; a tick that was missed is counted with the others.
  void run_ticks() {
    const std::uint32_t now = Board::ticks();
    if (now == last_tick_) return;
    tally_.ticks += now - last_tick_;
    last_tick_ = now;
    if (fresh_) {
      answer();
    } else if (sequence_.started() && ++age_ >= watchdog_ticks) {
      hold();
    }
  }

  bool tick_is_due() const { return mode_ == link::Mode::free_running && Board::ticks() != last_tick_; }

  void answer() {
    auto compute = [this] { controller_.compute(); };
    link::Torque torque{};
    controller_.load(set_point_);
    const std::uint32_t count = Board::count(compute);
    controller_.store(torque);
    torque.count = count;
    tally_.add(torque);
    fresh_ = false;
    age_ = 0;
    send(torque, sequence_.last());
  }

  /// The torque stays; the host hears of it once every `watchdog_ticks`.
  void hold() {
    ++tally_.watchdog_holds;
    if (age_ % watchdog_ticks != 0) return;
    link::Torque held{};
    held.joints = Controller::joints;
    held.status = static_cast<std::uint8_t>(link::TorqueStatus::watchdog);
    held.joint = link::no_joint;
    controller_.store_last_safe(held);
    send(held, sequence_.last());
  }

  void restart(std::uint8_t mode) {
    if (mode > static_cast<std::uint8_t>(link::Mode::free_running)) return tally_.refuse(link::Fault::bad_payload);
    mode_ = static_cast<link::Mode>(mode);
    sequence_ = {};
    fresh_ = false;
    age_ = 0;
    mode_ == link::Mode::free_running ? Board::start_tick(Board::tick_Hz) : Board::stop_tick();
    last_tick_ = Board::ticks();
    greet();
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
    send(hello, 0);
  }

  void send_stats(std::uint32_t sequence) {
    link::Stats stats = tally_.stats();
    stats.gaps = sequence_.gaps();
    stats.stack_bytes = Board::stack_used_bytes();
    send(stats, sequence);
  }

  /// Once the line is quiet: a burst of garbage gets one answer, which holds every counter, so that answers can not
  /// crowd out what comes in.
  void answer_faults() {
    if (!tally_.has_news() || !Board::serial_idle()) return;
    send(tally_.error_reply(), sequence_.last());
  }

  /// Not inlined: one wire buffer on the stack, not one for every caller.
  template <class Message>
  [[gnu::noinline]] void send(const Message& message, std::uint32_t sequence) {
    std::uint8_t wire[link::max_wire_size];
    Board::write(wire, link::encode_message(message, sequence, wire));
  }

  link::FrameDecoder decoder_{};
  link::SetPoint set_point_{};
  Controller controller_{};
  Tally tally_{};
  Sequence sequence_{};
  link::Mode mode_ = link::Mode::lock_step;
  std::uint32_t last_tick_ = 0, age_ = 0;
  bool fresh_ = false;
};

}  // namespace axial::apps

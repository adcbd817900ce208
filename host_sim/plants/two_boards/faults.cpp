#include <host_sim/plants/two_boards/board_arm.hpp>
#include <host_sim/plants/two_boards/faults.hpp>

#include <axial/control/drive_phase.hpp>
#include <firmware/apps/feedforward/deadlines.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace host_sim::two_boards {

namespace {

using axial::DrivePhase;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds in_time(400), soon(2000);
constexpr std::chrono::seconds lifetime(60);  // of drives that nobody asks for, on a busy machine
constexpr int ticks = 100, every = 10, broken = ticks / every;

constexpr std::uint8_t byte(DrivePhase phase) { return static_cast<std::uint8_t>(phase); }
constexpr std::uint8_t byte(link::TorqueStatus status) { return static_cast<std::uint8_t>(status); }

/// One bit of a frame's body; no byte becomes a delimiter.
void flip_a_bit(Bytes& bytes) {
  std::uint8_t& byte = bytes[bytes.size() / 2];
  byte = static_cast<std::uint8_t>(byte == 4 || byte == 0 ? byte ^ 2U : byte ^ 4U);
}

/// Two boards in lock-step on a line that may fail: what is lost is left out, and the loop goes on.
class Bench {
 public:
  Bench(const Boards& boards, const Trajectory& cycle)
      : cycle_(cycle),
        controller(boards.controller, boards.controller_app, boards.robot),
        arm(boards.arm, boards.arm_app, boards.robot),
        encoders(arm.firmware.command(command_of(link::ArmAction::place, cycle.front().q))) {}

  /// A tick. `measures`: whether the controller hears of the encoders.
  void tick(bool measures = true) {
    ask(measures);
    if (torque) move(*torque);
  }
  void ask(bool measures) {
    std::optional<link::Measurement> measurement;
    if (measures && encoders) measurement = measurement_of(*encoders);
    torque = controller.firmware.try_torque(measurement, to_message(cycle_[number_++ % cycle_.size()]), in_time);
    if (!torque) return;
    note(torque->phase);
    refused += torque->status == byte(link::TorqueStatus::not_measured) ? 1 : 0;
  }
  void move(const link::Torque& efforts) {
    encoders = arm.firmware.try_move(efforts, in_time);
    if (encoders) last = *encoders;
  }
  void run(int count) {
    for (int k = 0; k < count; ++k)
      tick();
  }
  /// Until the controller's drives are disabled.
  template <class Step>
  bool disabled_by(Step step) {
    for (const auto end = Clock::now() + lifetime; Clock::now() < end;) {
      step();
      if (torque && torque->phase == byte(DrivePhase::disabled)) return true;
    }
    return false;
  }
  std::uint32_t refusals(BoardOnLine& board, link::Fault fault) {
    const auto stats = board.firmware.try_stats(soon);
    return stats ? stats->counters[static_cast<std::size_t>(fault)] : 0;
  }
  /// Pieces between delimiters that are no frames of the session.
  std::uint32_t broken_frames(BoardOnLine& board) {
    const auto stats = board.firmware.try_stats(soon);
    std::uint32_t sum = 0;
    for (std::size_t i = 0; stats && i <= static_cast<std::size_t>(link::Fault::bad_crc); ++i)
      sum += stats->counters[i];
    return sum;
  }
  std::uint32_t left_out() {
    const auto stats = arm.firmware.try_stats(soon);
    return stats ? stats->gaps : 0;
  }
  bool running() const {
    return torque && torque->phase == byte(DrivePhase::running) && encoders &&
           encoders->phase == byte(DrivePhase::running) && encoders->status == byte(link::TorqueStatus::ok);
  }
  /// Both boards in new sessions, the arm where its cycle begins.
  bool starts_again() {
    if (!controller.firmware.try_session(soon) || !arm.firmware.try_session(soon)) return false;
    number_ = 0;
    encoders = command(link::ArmAction::place, cycle_.front().q);
    run(5);
    return running();
  }
  std::optional<link::Encoders> command(link::ArmAction action, const std::vector<double>& values) {
    return arm.firmware.try_command(command_of(action, values), soon);
  }
  /// Whether the arm stands where it did.
  bool is_at(const decltype(link::Encoders::position)& position) {
    const auto now = command(link::ArmAction::go, std::vector<double>(last.joints));
    return now && now->position == position;
  }
  bool faded_held_disabled() const {
    const std::vector<std::uint8_t> all{byte(DrivePhase::running), byte(DrivePhase::fading), byte(DrivePhase::holding),
                                        byte(DrivePhase::disabled)};
    return phases_ == all;
  }
  void note(std::uint8_t phase) {
    if (phases_.empty() || phases_.back() != phase) phases_.push_back(phase);
  }

 private:
  const Trajectory& cycle_;
  std::size_t number_ = 0;
  std::vector<std::uint8_t> phases_;

 public:
  BoardOnLine controller, arm;
  std::optional<link::Torque> torque;
  std::optional<link::Encoders> encoders;
  link::Encoders last{};
  int refused = 0;
};

/// What a fault led to, besides what had to be; empty where it ended so.
class Found {
 public:
  void expect(bool held, const std::string& otherwise) {
    if (!held) text_ += (text_.empty() ? "" : "; ") + otherwise;
  }
  void expect(const std::string& what, std::uint32_t found, std::uint32_t wanted) {
    expect(found == wanted, what + " " + std::to_string(found) + ", not " + std::to_string(wanted));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// How the loop is without a fault.
struct Undisturbed {
  decltype(link::Encoders::position) position{};
};

void efforts_corrupted(Bench& b, Found& f, const Undisturbed&) {
  b.run(every);
  for (int k = 0; k < broken; ++k) {
    b.arm.line.outward = flip_a_bit;
    b.tick();
    f.expect(!b.encoders, "a broken frame was answered");
    b.arm.line.outward = {};
    b.encoders = b.last;  // what was measured last
    b.run(every - 1);
  }
  f.expect("the arm counts", b.broken_frames(b.arm), broken);
  f.expect("numbers left out", b.left_out(), broken);
  f.expect(b.running(), "the loop does not go on");
}

void encoders_corrupted(Bench& b, Found& f, const Undisturbed&) {
  b.run(every);
  for (int k = 0; k < broken; ++k) {
    b.arm.line.inward = flip_a_bit;
    b.tick();
    b.arm.line.inward = {};
    f.expect(!b.encoders, "a broken frame was believed");
    b.run(every - 1);
  }
  f.expect("set-points refused", static_cast<std::uint32_t>(b.refused), broken);
  f.expect("numbers left out", b.left_out(), 0);
  f.expect(b.running(), "the loop does not go on");
}

void efforts_twice(Bench& b, Found& f, const Undisturbed& whole) {
  int sent = 0;
  b.arm.line.outward = [&](Bytes& bytes) {
    if (++sent % every != 0) return;
    const Bytes once = bytes;
    bytes.insert(bytes.end(), once.begin(), once.end());
  };
  b.run(ticks);
  b.arm.line.outward = {};
  f.expect("the arm counts", b.refusals(b.arm, link::Fault::out_of_order), broken);
  f.expect(b.last.position == whole.position, "the motion is another");
}

void noise(Bench& b, Found& f, const Undisturbed& whole) {
  std::uint32_t draw = 1;
  b.arm.line.outward = b.controller.line.outward = [&](Bytes& bytes) {
    Bytes garbage(200);
    for (std::uint8_t& byte : garbage)
      draw = draw * 1664525U + 1013904223U, byte = static_cast<std::uint8_t>(draw >> 24);
    garbage.push_back(0);
    bytes.insert(bytes.begin(), garbage.begin(), garbage.end());
  };
  b.run(ticks);
  b.arm.line.outward = b.controller.line.outward = {};
  f.expect(b.last.position == whole.position, "the motion is another");
  f.expect(b.running(), "the loop does not go on");
}

void number_far_ahead(Bench& b, Found& f, const Undisturbed&) {
  b.run(every);
  b.arm.firmware.skip(1000);
  b.tick();
  f.expect(!b.encoders, "it was answered");
  b.arm.firmware.skip(-1001);
  b.encoders = b.last;
  b.run(every);
  f.expect("the arm counts", b.refusals(b.arm, link::Fault::far_ahead), 1);
  f.expect("numbers left out", b.left_out(), 0);
  f.expect(b.running(), "the loop does not go on");
}

void earlier_session(Bench& b, Found& f, const Undisturbed&) {
  Bytes recorded;
  b.arm.line.outward = [&](Bytes& bytes) { recorded = bytes; };
  b.run(every);
  b.arm.line.outward = {};
  f.expect(b.starts_again(), "no session was opened");
  const auto before = b.last.position;
  const auto counted = b.refusals(b.arm, link::Fault::bad_crc);
  b.arm.line.write(recorded.data(), recorded.size());
  const auto after = b.refusals(b.arm, link::Fault::bad_crc);
  f.expect("the arm counts", after - counted, 1);
  f.expect(b.is_at(before), "it was done");
  b.run(every);
  f.expect(b.running(), "the loop does not go on");
}

void efforts_no_numbers(Bench& b, Found& f, const Undisturbed&) {
  b.run(every);
  link::Torque bad = *b.torque;
  bad.tau[0] = std::numeric_limits<float>::quiet_NaN();
  std::uint32_t to_fade = 0, to_end = 0;
  for (int k = 0; k < 1000 && b.last.phase != byte(DrivePhase::disabled); ++k) {
    b.move(bad);
    f.expect(b.last.status == byte(link::TorqueStatus::not_finite) || k > 0, "it was taken");
    to_fade += b.last.phase == byte(DrivePhase::running) ? 1 : 0, ++to_end;
  }
  f.expect("ticks of patience", to_fade + 1, axial::apps::watchdog_ticks);
  f.expect("ticks until the drives are off", to_end, axial::apps::watchdog_ticks + axial::apps::ramp_ms + 1);
  b.move(*b.torque);
  f.expect(b.last.status == byte(link::TorqueStatus::disabled), "drives that are off took an effort");
  f.expect(b.starts_again(), "a new session does not enable them");
}

void measurements_stop(Bench& b, Found& f, const Undisturbed&) {
  b.run(every);
  f.expect(b.disabled_by([&] { b.tick(false); }), "the controller's drives stay enabled");
  f.expect(b.faded_held_disabled(), "they did not fade, hold and end in this order");
  b.tick(false);
  f.expect(b.torque->tau == decltype(b.torque->tau){}, "drives that are off exert something");
  f.expect(b.starts_again(), "a new session does not enable them");
}

void controller_hears_nothing(Bench& b, Found& f, const Undisturbed&) {
  b.run(every);
  f.expect(b.disabled_by([&] {
    b.torque = b.controller.firmware.try_report(in_time);
    if (!b.torque) return;
    b.note(b.torque->phase);
    b.arm.firmware.skip(axial::apps::watchdog_ticks - 1);  // as long as the report says that it stands
    b.move(*b.torque);
  }),
           "the controller's drives stay enabled");
  f.expect(b.faded_held_disabled(), "they did not fade, hold and end in this order");
  f.expect(b.starts_again(), "a new session does not enable them");
}

void arm_hears_nothing(Bench& b, Found& f, const Undisturbed&) {
  b.run(every);
  const auto before = b.last.position;
  b.arm.line.outward = [](Bytes& bytes) { bytes.clear(); };
  b.arm.firmware.skip(30);
  b.encoders.reset();
  f.expect(b.disabled_by([&] { b.ask(true); }), "the controller's drives stay enabled");
  f.expect(b.faded_held_disabled(), "they did not fade, hold and end in this order");
  b.arm.line.outward = {};
  b.move(*b.torque);
  f.expect("the arm refuses numbers far ahead:", b.refusals(b.arm, link::Fault::far_ahead), 1);
  f.expect(b.is_at(before), "time went on");
  f.expect(b.starts_again(), "a new session does not go on");
}

void encoder_breaks(Bench& b, Found& f, const Undisturbed&) {
  b.run(every);
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < b.last.joints; ++i)
    if (std::abs(std::int64_t{b.last.position[i]}) > std::abs(std::int64_t{b.last.position[farthest]})) farthest = i;
  std::vector<double> which(b.last.joints, 0.0);
  which[farthest] = 1.0;
  f.expect(b.command(link::ArmAction::blind, which).has_value(), "it was not told to");
  f.expect(b.disabled_by([&] { b.tick(); }), "the controller's drives stay enabled");
  f.expect(b.faded_held_disabled(), "they did not fade, hold and end in this order");
  f.expect(b.refused > 0, "the reading was believed");
}

struct Scenario {
  const char *fault, *ends;
  void (*run)(Bench&, Found&, const Undisturbed&);
};
constexpr Scenario scenarios[] = {
    {"efforts corrupted, every tenth", "the arm counts them and moves on under the last ones", efforts_corrupted},
    {"encoders corrupted, every tenth", "such set-points are refused, the loop goes on", encoders_corrupted},
    {"efforts twice, every tenth", "refused by number, the motion is the same to the bit", efforts_twice},
    {"noise between frames, on both lines", "the motion is the same to the bit", noise},
    {"a number far ahead", "refused; the next number is good", number_far_ahead},
    {"efforts of an earlier session", "not done", earlier_session},
    {"efforts that are no numbers, again and again",
     "after 20 ticks the arm's drives fade, after 101 more they are off", efforts_no_numbers},
    {"measurements stop, set-points go on", "the controller fades, holds, disables", measurements_stop},
    {"the controller hears nothing", "it fades, holds, disables; the arm moves by its reports",
     controller_hears_nothing},
    {"the arm hears nothing", "its time stands still; the controller fades, holds, disables", arm_hears_nothing},
    {"an encoder's wire breaks", "it is not believed; the controller fades, holds, disables", encoder_breaks}};

}  // namespace

std::size_t fault_count() { return std::size(scenarios); }

std::vector<FaultRow> faults_of_line(const Boards& boards, const Trajectory& cycle,
                                     const std::function<void(std::size_t done)>& at) {
  Undisturbed whole;
  {
    Bench bench(boards, cycle);
    bench.run(ticks);
    whole.position = bench.last.position;
  }
  std::vector<FaultRow> rows;
  for (const Scenario& scenario : scenarios) {
    at(rows.size());
    Bench bench(boards, cycle);
    Found found;
    scenario.run(bench, found, whole);
    rows.push_back({scenario.fault, scenario.ends, found.text().empty(), found.text()});
  }
  return rows;
}

}  // namespace host_sim::two_boards

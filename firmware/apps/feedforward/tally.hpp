#pragma once
/// What the main job counts.

#include <cstdint>

#include <hal/link/messages.hpp>

namespace axial::apps {

/// The counter of a refused piece of the byte stream. `event` is neither `none` nor `frame`.
constexpr hal::link::Fault fault_of(hal::link::FrameEvent event) {
  using hal::link::Fault;
  using hal::link::FrameEvent;
  switch (event) {
    case FrameEvent::bad_cobs:
      return Fault::bad_cobs;
    case FrameEvent::truncated:
      return Fault::truncated;
    case FrameEvent::oversized:
      return Fault::oversized;
    case FrameEvent::bad_length:
      return Fault::bad_length;
    default:
      return Fault::bad_crc;
  }
}

class Tally {
 public:
  std::uint32_t frames = 0, ticks = 0, watchdog_holds = 0;

  void refuse(hal::link::Fault fault) {
    ++faults_[static_cast<std::size_t>(fault)];
    latest_ = fault;
    news_ = true;
  }

  void note_overruns(std::uint32_t total) {
    if (total == faults_[overrun]) return;
    refuse(hal::link::Fault::overrun);
    faults_[overrun] = total;
  }

  void note_missed_deadline() { ++missed_deadlines_; }
  /// As a torque reports them.
  std::uint16_t missed_deadlines() const {
    return static_cast<std::uint16_t>(missed_deadlines_ < 0xFFFF ? missed_deadlines_ : 0xFFFF);
  }

  /// A torque, or what encoders say.
  template <class Answer>
  void add(const Answer& answer) {
    const auto status = static_cast<hal::link::TorqueStatus>(answer.status);
    const bool computed = status == hal::link::TorqueStatus::ok || status == hal::link::TorqueStatus::effort_limited;
    if (!computed) {
      ++refused_;
      return;
    }
    ++computed_;
    if (answer.count < count_min_) count_min_ = answer.count;
    if (answer.count > count_max_) count_max_ = answer.count;
  }

  /// Something was refused since the last error reply.
  bool has_news() const { return news_; }

  hal::link::ErrorReply error_reply() {
    news_ = false;
    return {static_cast<std::uint8_t>(latest_), faults_};
  }

  hal::link::Stats stats() const {
    hal::link::Stats out{};
    out.frames = frames;
    out.set_points = computed_;
    out.refused = refused_;
    out.ticks = ticks;
    out.watchdog_holds = watchdog_holds;
    out.count_min = computed_ == 0 ? 0 : count_min_;
    out.count_max = count_max_;
    out.deadline_overruns = missed_deadlines_;
    out.counters = faults_;
    return out;
  }

 private:
  static constexpr auto overrun = static_cast<std::size_t>(hal::link::Fault::overrun);

  std::uint32_t missed_deadlines_ = 0;
  std::uint32_t computed_ = 0, refused_ = 0, count_min_ = 0xFFFFFFFF, count_max_ = 0;
  hal::link::FaultCounters faults_{};
  hal::link::Fault latest_ = hal::link::Fault::bad_cobs;
  bool news_ = false;
};

}  // namespace axial::apps

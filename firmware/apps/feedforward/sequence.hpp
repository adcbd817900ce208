#pragma once
/// Sequence numbers of set-points: each must come after the last, within a window. Numbers wrap.

#include <cstdint>

#include <hal/link/messages.hpp>

namespace axial::apps {

class Sequence {
 public:
  enum class Verdict : std::uint8_t { next, old, far_ahead };

  /// A session counts on from `number`.
  constexpr void restart(std::uint32_t number) {
    last_ = number;
    gaps_ = 0;
  }

  /// `next`, and remembered, where `number` comes after the last one, by the window at most. Numbers left out are
  /// counted, not refused: the frames that carried them were lost on the line. A number that is refused changes
  /// nothing.
  constexpr Verdict take(std::uint32_t number) {
    const std::uint32_t step = number - last_;
    if (step == 0 || step > half_range) return Verdict::old;
    if (step > hal::link::sequence_window) return Verdict::far_ahead;
    gaps_ += step - 1;
    last_ = number;
    return Verdict::next;
  }

  constexpr std::uint32_t last() const { return last_; }
  constexpr std::uint32_t gaps() const { return gaps_; }

 private:
  static constexpr std::uint32_t half_range = 0x7FFFFFFF;
  std::uint32_t last_ = 0, gaps_ = 0;
};

}  // namespace axial::apps

#pragma once
/// Sequence numbers of set-points: each must come after the last. Numbers wrap; "after" is within half their range.

#include <cstdint>

namespace axial::apps {

class Sequence {
 public:
  /// True, and remembered, when `number` comes after the last one. Numbers left out are counted, not refused: the
  /// frames that carried them were lost on the line.
  constexpr bool accept(std::uint32_t number) {
    const std::uint32_t step = number - last_;
    if (started_ && (step == 0 || step > half_range)) return false;
    if (started_) gaps_ += step - 1;
    last_ = number;
    started_ = true;
    return true;
  }

  constexpr bool started() const { return started_; }
  constexpr std::uint32_t last() const { return last_; }
  constexpr std::uint32_t gaps() const { return gaps_; }

 private:
  static constexpr std::uint32_t half_range = 0x7FFFFFFF;
  std::uint32_t last_ = 0, gaps_ = 0;
  bool started_ = false;
};

}  // namespace axial::apps

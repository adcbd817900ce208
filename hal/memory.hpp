#pragma once
/// Memory of an image: symbols of sections.ld, what start-up does to RAM, and the stack's measured depth.

#include <cstddef>
#include <cstdint>

extern "C" {
extern std::uint32_t axial_stack_bottom[], axial_stack_top[];
extern std::uint32_t axial_data_begin[], axial_data_end[], axial_data_image[];
extern std::uint32_t axial_bss_begin[], axial_bss_end[];
extern const std::uint16_t axial_code_begin[], axial_code_end[];
}

namespace axial::hal {

/// Written over the free stack at start-up.
constexpr std::uint32_t stack_paint = 0x5AFE57AC;

/// Lowest part of the stack, which no program may write: the smallest region of an Arm memory protection unit.
constexpr std::uint32_t guard_bytes = 32;

inline void fill(std::uint32_t* from, const std::uint32_t* to, std::uint32_t value) {
  while (from < to)
    *from++ = value;
}

inline void copy(std::uint32_t* from, const std::uint32_t* to, const std::uint32_t* source) {
  while (from < to)
    *from++ = *source++;
}

/// Leaves alone what is painted already: a guard that outlives a reset must not be written.
inline void paint(std::uint32_t* from, const std::uint32_t* to) {
  for (; from < to; ++from) {
    if (*from != stack_paint) *from = stack_paint;
  }
}

/// Variables to their first values, paint over the free stack. Called once, before anything looks at a variable.
inline void prepare_memory() {
  copy(axial_data_begin, axial_data_end, axial_data_image);
  fill(axial_bss_begin, axial_bss_end, 0);
  const auto* here = static_cast<const std::uint32_t*>(__builtin_frame_address(0));
  paint(axial_stack_bottom, here - 32);  // what lies under the frame is in use
}

/// Finds the bytes of a painted stack that were used, by the paint that is gone: a part a call, for the whole may take
/// longer than a tick. What is used meanwhile below the part that was looked at, the next measurement finds.
class StackMeter {
 public:
  static constexpr int words_a_look = 128;

  constexpr StackMeter(const std::uint32_t* bottom, const std::uint32_t* top) : bottom_(bottom), top_(top) {}

  /// Looks further. True, and `bytes` found, at the deepest word that was used; the next call begins anew.
  bool look(std::uint32_t& bytes) {
    const std::uint32_t* word = bottom_ + looked_at_;
    int left = words_a_look;
    for (; left > 0 && word < top_ && *word == stack_paint; --left)
      ++word;
    looked_at_ = left > 0 ? 0 : word - bottom_;
    bytes = static_cast<std::uint32_t>((top_ - word) * std::ptrdiff_t{sizeof *word});
    return left > 0;
  }

 private:
  const std::uint32_t *bottom_, *top_;
  std::ptrdiff_t looked_at_ = 0;
};

/// Whether the guard still holds its paint: the canary of a core without hardware that guards it.
inline bool stack_intact() {
  for (std::uint32_t i = 0; i < guard_bytes / sizeof(std::uint32_t); ++i) {
    if (static_cast<const volatile std::uint32_t*>(axial_stack_bottom)[i] != stack_paint) return false;
  }
  return true;
}

}  // namespace axial::hal

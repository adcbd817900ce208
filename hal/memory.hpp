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

inline void fill(std::uint32_t* from, const std::uint32_t* to, std::uint32_t value) {
  while (from < to)
    *from++ = value;
}

inline void copy(std::uint32_t* from, const std::uint32_t* to, const std::uint32_t* source) {
  while (from < to)
    *from++ = *source++;
}

/// Variables to their first values, paint over the free stack. Called once, before anything looks at a variable.
inline void prepare_memory() {
  copy(axial_data_begin, axial_data_end, axial_data_image);
  fill(axial_bss_begin, axial_bss_end, 0);
  const auto* here = static_cast<const std::uint32_t*>(__builtin_frame_address(0));
  fill(axial_stack_bottom, here - 32, stack_paint);  // what lies under the frame is in use
}

/// Bytes of stack used since the start, by the paint that is gone.
inline std::uint32_t stack_used_bytes() {
  const std::uint32_t* word = axial_stack_bottom;
  while (word < axial_stack_top && *word == stack_paint)
    ++word;
  return static_cast<std::uint32_t>((axial_stack_top - word) * std::ptrdiff_t{sizeof *word});
}

}  // namespace axial::hal

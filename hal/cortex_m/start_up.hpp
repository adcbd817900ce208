#pragma once
/// Memory symbols of sections.ld, the vector table's shape, and the stack's measured depth.

#include <cstddef>
#include <cstdint>

extern "C" {
extern std::uint32_t axial_stack_bottom[], axial_stack_top[];
extern std::uint32_t axial_data_begin[], axial_data_end[], axial_data_image[];
extern std::uint32_t axial_bss_begin[], axial_bss_end[];
extern const std::uint16_t axial_code_begin[], axial_code_end[];
}

namespace axial::hal::cortex_m {

using Handler = void (*)();

/// A board lists the interrupts it serves: `static constexpr Interrupt interrupts[]`.
struct Interrupt {
  unsigned number;
  Handler handler;
};

/// Written over the free stack at start-up.
constexpr std::uint32_t stack_paint = 0x5AFE57AC;

/// Bytes of stack used since the start, by the paint that is gone.
inline std::uint32_t stack_used_bytes() {
  const std::uint32_t* word = axial_stack_bottom;
  while (word < axial_stack_top && *word == stack_paint)
    ++word;
  return static_cast<std::uint32_t>((axial_stack_top - word) * std::ptrdiff_t{sizeof *word});
}

}  // namespace axial::hal::cortex_m

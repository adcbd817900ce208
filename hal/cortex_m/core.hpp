#pragma once
/// The processor itself: masking interrupts, sleeping, enabling an interrupt line.

#include <cstdint>

#include <hal/cortex_m/registers.hpp>

namespace axial::hal::cortex_m {

/// Interrupts are masked while an object of this type lives; nests.
class InterruptMask {
 public:
  InterruptMask() { asm volatile("mrs %0, primask\n\tcpsid i" : "=r"(before_)::"memory"); }
  ~InterruptMask() { asm volatile("msr primask, %0" ::"r"(before_) : "memory"); }
  InterruptMask(const InterruptMask&) = delete;
  InterruptMask& operator=(const InterruptMask&) = delete;

 private:
  std::uint32_t before_;
};

/// Sleeps until an interrupt unless `awake()` holds. An interrupt between the question and the sleep is not lost:
/// a masked one still ends WFI, and is taken when the mask is lifted.
template <class Predicate>
void sleep_unless(Predicate awake) {
  const InterruptMask mask;
  if (!awake()) asm volatile("dsb\n\twfi" ::: "memory");
}

inline void enable_interrupt(unsigned number) { interrupt_set_enable(number) = 1u << (number % 32); }

}  // namespace axial::hal::cortex_m

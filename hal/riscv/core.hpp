#pragma once
/// The processor itself: masking interrupts, sleeping.

#include <cstdint>

#include <hal/riscv/csr.hpp>

namespace axial::hal::riscv {

/// Interrupts are masked while an object of this type lives; nests.
class InterruptMask {
 public:
  InterruptMask() : before_(clear<Csr::status>(status::interrupts)) {}
  ~InterruptMask() { set<Csr::status>(before_ & status::interrupts); }
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
  if (!awake()) asm volatile("wfi" ::: "memory");
}

}  // namespace axial::hal::riscv

#pragma once
/// What a program can do wrong, on request: for images of fault injection alone (AXIAL_INJECTION), never for flash.

#include <cstdint>

#include <hal/link/messages.hpp>

namespace axial::apps::injection {

/// Endless recursion that no optimiser unrolls.
[[gnu::noinline]] inline std::uint32_t overflow(std::uint32_t depth) {
  volatile std::uint32_t frame[8] = {depth};
  return depth == 0xFFFFFFFF ? frame[0] : overflow(depth + 1) + frame[0];
}

inline void jump(std::uint32_t address) { reinterpret_cast<void (*)()>(static_cast<std::uintptr_t>(address))(); }

inline void write(std::uint32_t address) {
  *reinterpret_cast<volatile std::uint32_t*>(static_cast<std::uintptr_t>(address)) = 0;
}

template <class Board>
void hang(bool masked) {
  auto for_ever = [] {
    for (;;)
      asm volatile("");
  };
  if (masked) Board::count(for_ever);  // it masks interrupts
  for_ever();
}

template <class Board>
void commit(const hal::link::Injection& wanted) {
  using hal::link::InjectedFault;
  switch (static_cast<InjectedFault>(wanted.fault)) {
    case InjectedFault::stack_overflow:
      overflow(0);
      return;
    case InjectedFault::wild_jump:
      return jump(wanted.address);
    case InjectedFault::hang:
      return hang<Board>(wanted.address != 0);
    case InjectedFault::stray_write:
      return write(wanted.address);
  }
}

}  // namespace axial::apps::injection

#pragma once
/// USERLED0 of Arm's FPGA boards, which stands for the drives' pin: bit 0 of the first register of FPGAIO. The
/// processor's reset leaves the lights alone, so start-up turns them off.

#include <cstdint>

namespace axial::hal::cmsdk {

template <std::uintptr_t address>
struct LightPin {
  static constexpr std::uintptr_t off_register = address;
  static constexpr std::uint32_t off_word = 0;

  static void start() { set(false); }
  static void set(bool enabled) { lights() = enabled ? 1u : off_word; }
  static bool level() { return (lights() & 1u) != 0; }

 private:
  static volatile std::uint32_t& lights() { return *reinterpret_cast<volatile std::uint32_t*>(address); }
};

}  // namespace axial::hal::cmsdk

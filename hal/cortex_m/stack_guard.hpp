#pragma once
/// The guard under the stack: a region of the memory protection unit that may be read, for the paint in it, and not be
/// written. The unit rests while a fault is served (HFNMIENA is 0).

#include <cstdint>

#include <hal/cortex_m/registers.hpp>
#include <hal/memory.hpp>

namespace axial::hal::cortex_m {

/// RBAR and RASR or RLAR of a read-only region of `bytes`, a power of two, at `begin`, a multiple of it.
struct RegionWords {
  std::uint32_t base, attributes;
};

constexpr unsigned exponent_of(std::uint32_t power_of_two) {
  return power_of_two <= 1 ? 0 : 1 + exponent_of(power_of_two / 2);
}

/// ARMv6-M: no execution, read by all; no region is smaller than 256 bytes, of whose eight parts those of the guard are
/// enabled.
constexpr RegionWords read_only_v6(std::uint32_t begin, std::uint32_t bytes) {
  constexpr std::uint32_t never_execute = 1u << 28, read_only = 6u << 24, normal_memory = 1u << 17, enable = 1u;
  constexpr std::uint32_t region = 256, part = region / 8, all = 0xFF;
  const std::uint32_t guarded = ((1u << bytes / part) - 1) << begin % region / part;
  return {begin & ~(region - 1),
          never_execute | read_only | normal_memory | (all & ~guarded) << 8 | (exponent_of(region) - 1) << 1 | enable};
}

/// ARMv7-M: no execution, read by all, size 2^(field + 1).
constexpr RegionWords read_only_v7(std::uint32_t begin, std::uint32_t bytes) {
  constexpr std::uint32_t never_execute = 1u << 28, read_only = 6u << 24, normal_memory = 1u << 19, enable = 1u;
  return {begin, never_execute | read_only | normal_memory | (exponent_of(bytes) - 1) << 1 | enable};
}

/// ARMv8-M: no execution, read by privileged code, limit inclusive.
constexpr RegionWords read_only_v8(std::uint32_t begin, std::uint32_t bytes) {
  constexpr std::uint32_t never_execute = 1u, privileged_read_only = 2u << 1, enable = 1u;
  return {begin | privileged_read_only | never_execute, ((begin + bytes - 1) & ~31u) | enable};
}

/// Guards `bytes` from `begin`; everywhere else the default map holds on. False where the part has no unit (the
/// Cortex-M0 and the smaller STM32F1 have none). The registers are an argument so that a host test can play them.
template <class Registers>
bool guard(Registers& unit, RegionWords words) {
  constexpr std::uint32_t regions = 0xFF00u;
  if ((unit.type & regions) == 0) return false;
  unit.control = 0;
  unit.region = 0;
  unit.base = words.base;
  unit.attributes = words.attributes;
  unit.control = protection_control::enable | protection_control::default_map;
  return true;
}

#ifdef __arm__
inline bool guard_stack() {
  const auto begin = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(axial_stack_bottom));
#ifdef __ARM_ARCH_8M_MAIN__
  // The limit sees what would jump over the region.
  asm volatile("msr msplim, %0" ::"r"(begin + guard_bytes));
  const bool guarded = guard(protection(), read_only_v8(begin, guard_bytes));
#elif defined(__ARM_ARCH_6M__)
  const bool guarded = guard(protection(), read_only_v6(begin, guard_bytes));
#else
  const bool guarded = guard(protection(), read_only_v7(begin, guard_bytes));
#endif
  asm volatile("dsb\n\tisb" ::: "memory");
  return guarded;
}
#endif

}  // namespace axial::hal::cortex_m

#pragma once
/// Core peripherals of ARMv7-M. Source: ARMv7-M Architecture Reference Manual (DDI 0403E), sections B3.2 to B3.5,
/// C1.8; of ARMv8-M's memory protection: ARMv8-M Architecture Reference Manual (DDI 0553), D1.2.

#include <cstdint>

namespace axial::hal::cortex_m {

using Register = volatile std::uint32_t;

/// The register block of type `Block` at a fixed address.
template <class Block>
Block& at(std::uintptr_t address) {
  return *reinterpret_cast<Block*>(address);
}

struct SysTickRegisters {
  Register control, reload, current, calibration;
};
namespace sys_tick_control {
constexpr std::uint32_t enable = 1u << 0, interrupts = 1u << 1, core_clock = 1u << 2, wrapped = 1u << 16;
}
constexpr std::uintptr_t sys_tick_address = 0xE000E010;
inline SysTickRegisters& sys_tick() { return at<SysTickRegisters>(sys_tick_address); }

struct DwtRegisters {
  Register control, cycle_count;
};
constexpr std::uintptr_t dwt_address = 0xE0001000;
constexpr std::uint32_t dwt_cycle_counter_enable = 1u << 0;
/// ARMv6-M has no cycle counter.
#ifdef __ARM_ARCH_6M__
constexpr bool has_dwt = false;
#else
constexpr bool has_dwt = true;
#endif
inline DwtRegisters& dwt() { return at<DwtRegisters>(dwt_address); }

/// Debug exception and monitor control: bit 24 powers DWT.
inline Register& debug_monitor_control() { return at<Register>(0xE000EDFC); }
constexpr std::uint32_t trace_enable = 1u << 24;

struct SystemControlRegisters {
  Register cpu_id, interrupt_control, vector_table, reset_control, system_control, configuration;
  Register priorities[3];
  Register handler_control, configurable_fault, hard_fault, debug_fault, memory_address, bus_address;
};
namespace interrupt_control {
constexpr std::uint32_t set_pending_sys_tick = 1u << 26, clear_pending_sys_tick = 1u << 25;
}
namespace reset_control {
constexpr std::uint32_t key = 0x05FAu << 16, request = 1u << 2;
}
namespace configurable_fault {
/// MSTKERR, STKERR, STKOF: the frame of an exception did not fit the stack.
constexpr std::uint32_t stacking = 1u << 4 | 1u << 12 | 1u << 20;
constexpr std::uint32_t memory_address_valid = 1u << 7, bus_address_valid = 1u << 15;
}  // namespace configurable_fault
inline SystemControlRegisters& system_control() { return at<SystemControlRegisters>(0xE000ED00); }

/// Memory protection. `type` says in bits 8 to 15 how many regions there are; `attributes` is RASR, on ARMv8-M RLAR.
struct ProtectionRegisters {
  Register type, control, region, base, attributes;
};
namespace protection_control {
constexpr std::uint32_t enable = 1u << 0, default_map = 1u << 2;
}
inline ProtectionRegisters& protection() { return at<ProtectionRegisters>(0xE000ED90); }

/// Coprocessor access: bits 20 to 23 grant the FPU (CP10, CP11).
inline Register& coprocessor_access() { return at<Register>(0xE000ED88); }
constexpr std::uint32_t fpu_full_access = 0xFu << 20;

inline Register& interrupt_set_enable(unsigned number) { return at<Register>(0xE000E100 + 4 * (number / 32)); }

}  // namespace axial::hal::cortex_m

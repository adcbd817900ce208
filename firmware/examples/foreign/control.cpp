// The control interrupt: all that this firmware has to do with axial.
#include "control.h"

#include <axial/axial.hpp>
#include <robots/planar2r.hpp>

namespace {

using Arm = robots::Planar2r;
using Joints = axial::Joints<Arm, float>;

constexpr std::uint32_t core_Hz = 168'000'000, rate_Hz = 1000;
constexpr std::uint32_t on = 1u << 0, interrupt = 1u << 1, from_core = 1u << 2, pending = 1u << 26;
struct SysTick {
  volatile std::uint32_t control, reload, value;
};
volatile std::uint32_t& interrupt_control() { return *reinterpret_cast<volatile std::uint32_t*>(0xE000ED04); }  // ICSR
SysTick& sys_tick() { return *reinterpret_cast<SysTick*>(0xE000E010); }

axial::FeedforwardState<Arm, float> state{};
volatile std::uint32_t tick = 0, missed = 0, torque_bits[2] = {}, status_code = 0;

struct Motion {
  Joints q, qd, qdd;
};
// From rest to rest in a second: q = from + way (3 t^2 - 2 t^3).
Motion desired(float t) {
  constexpr float from[] = {-0.5F, 1.0F}, way[] = {1.25F, -1.5F};
  Motion motion{};
  for (int i = 0; i < Joints::size; ++i) {
    motion.q[i] = from[i] + way[i] * t * t * (3.0F - 2.0F * t);
    motion.qd[i] = way[i] * 6.0F * t * (1.0F - t);
    motion.qdd[i] = way[i] * (6.0F - 12.0F * t);
  }
  return motion;
}

}  // namespace

extern "C" void SysTick_Handler() {
  const Motion m = desired(static_cast<float>(tick) / static_cast<float>(control_ticks));
  const auto safe = axial::feedforward<Arm>(state, m.q, m.qd, m.qdd);
  for (int i = 0; i < Joints::size; ++i)
    torque_bits[i] = __builtin_bit_cast(std::uint32_t, safe.tau[i]);
  status_code = static_cast<std::uint32_t>(safe.status.code);
  tick = tick + 1;
  if ((interrupt_control() & pending) != 0) missed = missed + 1;
}

void control_start() {
  sys_tick().reload = core_Hz / rate_Hz - 1;
  sys_tick().value = 0;
  sys_tick().control = on | interrupt | from_core;
}
std::uint32_t control_tick() { return tick; }
std::uint32_t control_missed() { return missed; }
void control_read(std::uint32_t torque[2], std::uint32_t* status) {
  asm volatile("cpsid i" ::: "memory");
  torque[0] = torque_bits[0];
  torque[1] = torque_bits[1];
  *status = status_code;
  asm volatile("cpsie i" ::: "memory");
}

/* The main loop: sleeps, and tells every hundredth torque. */
#include "console.h"
#include "control.h"

static void print_line(uint32_t tick) {
  uint32_t torque[2], status;
  control_read(torque, &status);
  console_hex(tick);
  console_text(",");
  console_hex(torque[0]);
  console_text(",");
  console_hex(torque[1]);
  console_text(",");
  console_hex(status);
  console_text("\n");
}

int main(void) {
  uint32_t seen = 0;
  console_start();
  control_start();
  while (seen < control_ticks) {
    __asm__ volatile("wfi");
    if (control_tick() == seen) continue;
    seen = control_tick();
    if (seen % 100 == 0) print_line(seen);
  }
  console_text("end,");
  console_hex(seen);
  console_text(",");
  console_hex(control_missed());
  console_text("\n");
  for (;;)
    __asm__ volatile("wfi");
}

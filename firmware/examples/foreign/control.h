#ifndef CONTROL_H
#define CONTROL_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { control_ticks = 1000 };

/** Starts the interrupt at 1 kHz. */
void control_start(void);
/** Ticks so far; interrupts that came before the one before them was done. */
uint32_t control_tick(void);
uint32_t control_missed(void);
/** Bits of the torques (float, N m) and the status code of the last tick, all of one tick. */
void control_read(uint32_t torque[2], uint32_t* status);

#ifdef __cplusplus
}
#endif

#endif

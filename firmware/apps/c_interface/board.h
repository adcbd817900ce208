/* What the loop in C needs of a board. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

#include "arm.h"

#ifdef __cplusplus
extern "C" {
#endif

void board_start(uint32_t tick_Hz);
/** Sleeps until the next tick of the control timer; returns its number. */
uint32_t board_wait_for_tick(void);
void board_print(const char* text);
void board_print_hex(uint32_t word);
void board_exit(int code);

/** The same request answered by the C++ interface itself, printed in the same form. */
void print_reference(uint32_t row, const arm_joints* q, const arm_joints* qd, const arm_joints* qdd);

#ifdef __cplusplus
}
#endif

#endif

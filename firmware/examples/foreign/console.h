#ifndef CONSOLE_H
#define CONSOLE_H

#include <stdint.h>

void console_start(void);
void console_text(const char* text);
void console_hex(uint32_t word);

#endif

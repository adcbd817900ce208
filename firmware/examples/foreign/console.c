/* USART1 of the STM32F405, polled (RM0090, chapter 30). */
#include "console.h"

#define USART1_SR (*(volatile uint32_t*)0x40011000)
#define USART1_DR (*(volatile uint32_t*)0x40011004)
#define USART1_CR1 (*(volatile uint32_t*)0x4001100C)

void console_start(void) { USART1_CR1 = 1u << 13 | 1u << 3; /* on, transmitter on */ }

static void put(char c) {
  while ((USART1_SR & 1u << 7) == 0) { /* transmit register empty */
  }
  USART1_DR = (uint32_t)(unsigned char)c;
}

void console_text(const char* text) {
  while (*text)
    put(*text++);
}

void console_hex(uint32_t word) {
  int shift;
  for (shift = 28; shift >= 0; shift -= 4)
    put("0123456789abcdef"[word >> shift & 15u]);
}

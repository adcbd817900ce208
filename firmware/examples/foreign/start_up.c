/* Reset and vectors, as any project has them. */
#include <stdint.h>

extern uint32_t _sidata, _sdata, _edata, _sbss, _ebss, _estack;

int main(void);
void SysTick_Handler(void);

static void stop(void) {
  for (;;) {
  }
}

void Reset_Handler(void) {
  volatile uint32_t* const coprocessors = (volatile uint32_t*)0xE000ED88; /* CPACR */
  const uint32_t* from = &_sidata;
  uint32_t* to;
  *coprocessors |= 0xFu << 20; /* the floating-point unit, before any code that uses it */
  __asm__ volatile("dsb\n\tisb");
  for (to = &_sdata; to < &_edata;)
    *to++ = *from++;
  for (to = &_sbss; to < &_ebss;)
    *to++ = 0;
  main();
  stop();
}

typedef void (*handler)(void);
__attribute__((section(".isr_vector"), used)) static const handler vectors[16] = {
    (handler)&_estack, Reset_Handler, stop, stop, stop, stop, stop, 0, 0, 0, 0, stop, stop, 0, stop, SysTick_Handler};

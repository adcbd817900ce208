'use strict';
// SysTick as the processor has it: one count a cycle of the core. rp2040js's own counts nanoseconds, and a store to it interrupts.

const [CONTROL, RELOAD, CURRENT] = [0x10, 0x14, 0x18];
const [ENABLE, INTERRUPTS, CORE_CLOCK, WRAPPED] = [1, 2, 4, 1 << 16];

class SysTick {
  // `cyclesPerTick`: 1; a negative control has another.
  constructor(core, cyclesPerTick) {
    Object.assign(this, {core, cyclesPerTick, control: 0, reload: 0, begin: 0, flagged: 0});
  }

  has(offset) {
    return offset >= CONTROL && offset <= CURRENT;
  }

  // Ticks since the last store to CURRENT; 0 while it stands still.
  get ticks() {
    return this.control & ENABLE ? Math.floor((this.core.cycles - this.begin) / this.cyclesPerTick) : 0;
  }

  read(offset) {
    const period = this.reload + 1;
    if (offset === RELOAD) return this.reload;
    if (offset === CURRENT) return (period - (this.ticks % period)) % period;
    const turns = Math.floor(this.ticks / period);
    const flag = turns > this.flagged ? WRAPPED : 0;
    this.flagged = turns;
    return this.control | flag;
  }

  write(offset, value) {
    if (offset === RELOAD) this.reload = value & 0xffffff;
    if (offset === CONTROL) {
      if (value & INTERRUPTS) throw new Error("SysTick's interrupt is not emulated: the tick is the timer's");
      if ((value & ENABLE) > (this.control & ENABLE)) this.restart();
      this.control = value & (ENABLE | CORE_CLOCK);
    }
    if (offset === CURRENT) this.restart();
  }

  restart() {
    this.begin = this.core.cycles;
    this.flagged = 0;
  }
}

module.exports = {SysTick};

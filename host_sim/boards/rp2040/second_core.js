'use strict';
// The second core: what its boot ROM does while the first launches it, the mailboxes between the two, and the core itself. Where the first
// sleeps for good behind the launch, its interrupts masked, the emulator goes on as the second, with interrupts and SysTick; where the first
// goes on and tells the second what to do, both run, and the second has neither.

const [CPUID, STATUS, WRITE, READ] = [0, 0x50, 0x54, 0x58];
const [HAS_WORD, HAS_ROOM] = [1, 2];
const WORDS = 8; // that a mailbox holds
const BEGIN = [0, 0, 1]; // then the vectors' address, the stack pointer, the first instruction

class SecondCore {
  constructor(sio) {
    Object.assign(this, {told: [], boxes: [[], []], current: 0, core: null, due: 0}); // `boxes`: what each core has not read yet
    const [read, write] = [sio.readUint32.bind(sio), sio.writeUint32.bind(sio)];
    sio.readUint32 = (offset) => {
      const [own, other] = this.current === 0 ? this.boxes : [this.boxes[1], this.boxes[0]];
      if (offset === CPUID) return this.current;
      if (offset === STATUS) return (other.length < WORDS ? HAS_ROOM : 0) | (own.length > 0 ? HAS_WORD : 0);
      return offset === READ ? own.shift() ?? 0 : read(offset);
    };
    sio.writeUint32 = (offset, word) => (offset === WRITE ? this.tell(word >>> 0) : write(offset, word));
  }

  // Of a launch every word comes back, and one out of order begins anew.
  tell(word) {
    if (this.launched) {
      this.boxes[1 - this.current].push(word);
      return;
    }
    const at = this.told.length;
    if (at < BEGIN.length && word !== BEGIN[at]) this.told = [];
    else this.told.push(word);
    this.boxes[0].push(word);
  }

  get launched() {
    return this.told.length === BEGIN.length + 3;
  }

  // The core out of its reset, at what it was told.
  become(core) {
    const [vectors, stack, entry] = this.told.slice(BEGIN.length);
    Object.assign(core, {VTOR: vectors, SP: stack, LR: 0, PC: entry & ~1, PM: false, enabledInterrupts: 0, waiting: false});
  }

  // Whether it has to begin beside the first, which goes on and has something to tell it.
  get isAwaited() {
    return this.core === null && this.current === 0 && this.launched && this.boxes[1].length > 0;
  }
  beginBeside(first) {
    this.core = new first.constructor(first.rp2040);
    this.become(this.core);
  }
  get isBusy() {
    return this.core !== null && (!this.core.waiting || this.core.eventRegistered);
  }
  // SEV of the core that runs now wakes the other.
  signal() {
    if (this.core !== null && this.current === 0) this.core.eventRegistered = true;
  }

  // Executes for as many cycles as passed, or until it waits; the cycles that it took.
  run(cycles) {
    let taken = 0;
    this.due += cycles;
    this.current = 1;
    while (this.due > 0 && this.isBusy) {
      if (this.core.waiting) this.core.waiting = this.core.eventRegistered = false;
      const spent = this.core.executeInstruction();
      this.due -= spent;
      taken += spent;
    }
    this.current = 0;
    if (!this.isBusy) this.due = 0;
    return taken;
  }
}

module.exports = {SecondCore};

'use strict';
// What the boot ROM of the second core does while the first launches it. The cores never run at once here: when the first has launched the
// second and sleeps with its interrupts masked, as it does for good, the emulator goes on as the second.

const [CPUID, STATUS, WRITE, READ] = [0, 0x50, 0x54, 0x58];
const [HAS_WORD, HAS_ROOM] = [1, 2];
const BEGIN = [0, 0, 1]; // then the vectors' address, the stack pointer, the first instruction

class SecondCore {
  constructor(sio) {
    Object.assign(this, {told: [], answers: [], running: false});
    const [read, write] = [sio.readUint32.bind(sio), sio.writeUint32.bind(sio)];
    sio.readUint32 = (offset) => {
      if (offset === CPUID) return this.running ? 1 : 0;
      if (offset === STATUS) return HAS_ROOM | (this.answers.length > 0 ? HAS_WORD : 0);
      return offset === READ ? this.answers.shift() ?? 0 : read(offset);
    };
    sio.writeUint32 = (offset, word) => (offset === WRITE ? this.tell(word >>> 0) : write(offset, word));
  }

  // Every word comes back; one out of order begins anew.
  tell(word) {
    const at = this.told.length;
    if (at < BEGIN.length && word !== BEGIN[at]) this.told = [];
    else this.told.push(word);
    this.answers.push(word);
  }

  get launched() {
    return !this.running && this.told.length === BEGIN.length + 3;
  }

  // The core out of its reset, at what it was told.
  become(core) {
    const [vectors, stack, entry] = this.told.slice(BEGIN.length);
    Object.assign(core, {VTOR: vectors, SP: stack, LR: 0, PC: entry & ~1, PM: false, enabledInterrupts: 0, waiting: false});
    this.running = true;
  }
}

module.exports = {SecondCore};

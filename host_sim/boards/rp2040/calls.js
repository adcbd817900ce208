'use strict';
// Every call of one function: the instructions that it executed, the words of flash that they read, the cycles that they took.

const fs = require('fs');

const isFlash = (address) => address >>> 24 === 0x10;

class Calls {
  // `entry`: the function's first address. `file`: written as the program ends, 32-bit words, for each call its cycles, those of its
  // return, a count of words and those: an even one is the address of an instruction, an odd one less 1 that of a word that it read.
  constructor(entry, file) {
    Object.assign(this, {entry, words: [], open: null, link: 0, read: []});
    process.on('exit', () => fs.writeFileSync(file, Buffer.from(Uint32Array.from(this.words).buffer)));
  }

  // Sees the core's instructions and its reads; fetches are reads, too.
  watch(chip) {
    const {core} = chip;
    for (const name of ['readUint32', 'readUint16', 'readUint8']) {
      const read = core[name].bind(core);
      core[name] = (address) => {
        if (this.open && isFlash(address) && !(name === 'readUint16' && (address === chip.pc || address === chip.pc + 2))) this.read.push((address & ~3) | 1);
        return read(address);
      };
    }
    chip.executed = (from, to, cycles) => this.executed(core, from, to, cycles);
  }

  executed(core, from, to, cycles) {
    if (!this.open && from === this.entry) this.open = {returnsTo: this.link, cycles: 0, words: []};
    this.link = core.LR & ~1;
    const call = this.open;
    if (!call) return;
    call.words.push(from, ...this.read);
    this.read = [];
    call.cycles += cycles;
    if (to !== call.returnsTo) return;
    this.words.push(call.cycles - cycles, cycles, call.words.length);
    for (const word of call.words) this.words.push(word);
    this.open = null;
  }
}

module.exports = {Calls};

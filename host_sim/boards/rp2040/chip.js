'use strict';
// An RP2040 from reset to reset: rp2040js, and around it what that emulator does otherwise than the part.

const fs = require('fs');
const {RP2040} = require(process.env.AXIAL_RP2040JS);
const {boot2Of} = require('./image.js');
const {SecondCore} = require('./second_core.js');
const {SysTick} = require('./sys_tick.js');
const {Uart} = require('./uart.js');

const BOOT2_ADDRESS = 0x20041f00;
const HARD_FAULT = 3;
const ALL_BLOCKS = 0x1ffffff;
const LEFT_BY_BOOT_ROM = (1 << 6) | (1 << 9) | (1 << 18) | (1 << 24); // IO_QSPI, PADS_QSPI, SYSCFG, USBCTRL
const BLOCKS = {0x40000: 19, 0x40014: 5, 0x4001c: 8, 0x40028: 12, 0x40034: 22, 0x40054: 21}; // whose bit of RESETS
const RESETS = 0x4000c;
const SYSINFO = 0x40000;
// Fault status, absent in ARMv6-M, and the MPU, which the part has and rp2040js has not: read as 0.
const isAbsent = (offset) => offset >= 0xd24 && offset <= 0xd90;

// An access that the bus refuses.
class BusFault extends Error {}

// Where rp2040js warns, either the bus would refuse, or it does not emulate what the image uses: then nothing is known any more. Of SEV it
// tells, and does nothing.
const loggerOf = (second) => ({
  debug() {},
  info(component, message) {
    if (message === 'SEV') second.signal();
  },
  warn(component, message) {
    throw component === 'RP2040' ? new BusFault(message) : new Error(`rp2040js: ${component}: ${message}`);
  },
  error(component, message) {
    this.warn(component, message);
  },
});

class Chip {
  // `breakpoint(core)`: semihosting; whether somebody took it. `sram`: what a restart keeps; `reason`: of the restart.
  constructor({flash, cyclesPerTick, breakpoint, send}, sram, reason) {
    const chip = new RP2040();
    Object.assign(this, {chip, core: chip.core, clock: chip.clock, cyclesPerTick, asleep: false, lockedUp: false, restarts: false, pc: 0});
    this.second = new SecondCore(chip.sio);
    chip.logger = loggerOf(this.second);
    chip.flash.set(flash);
    chip.sram.set(sram);
    chip.clkSys = chip.clkPeri = chip.roscFreq;
    chip.onBreak = () => {
      if (this.chip.readUint16(this.pc) !== 0xbeab || !breakpoint(this.core)) throw new BusFault('breakpoint');
    };
    this.replaceSysTick(new SysTick(this.core, cyclesPerTick));
    this.keepInReset();
    chip.peripherals[SYSINFO].readUint32 = () => 0; // PLATFORM: neither silicon nor an FPGA
    this.watchdog = chip.peripherals[0x40058];
    this.watchdog.reason = reason;
    this.watchdog.onWatchdogTrigger = () => {
      this.unfedNanos = this.clock.nanos - this.watchdog.timer.baseNanos;
      this.watchdog.alarm.enable = false; // or it comes for ever, without time passing
      this.restarts = true;
    };
    this.uart = new Uart(chip, send);
    this.boot(flash);
  }

  get sram() {
    return this.chip.sram;
  }
  get reason() {
    return this.watchdog.reason;
  }

  replaceSysTick(sysTick) {
    const ppb = this.chip.ppb;
    const [read, write] = [ppb.readUint32.bind(ppb), ppb.writeUint32.bind(ppb)];
    ppb.readUint32 = (offset) => (sysTick.has(offset) ? sysTick.read(offset) : isAbsent(offset) ? 0 : read(offset));
    ppb.writeUint32 = (offset, value) => {
      if (sysTick.has(offset)) sysTick.write(offset, value);
      else if (!isAbsent(offset)) write(offset, value);
    };
  }

  // Blocks are in reset until they are released, and nobody may use them before.
  keepInReset() {
    const resets = this.chip.peripherals[RESETS];
    const read = resets.readUint32.bind(resets);
    resets.reset = ALL_BLOCKS & ~LEFT_BY_BOOT_ROM;
    resets.readUint32 = (offset) => (offset === 8 ? ALL_BLOCKS & ~resets.reset : read(offset));
    for (const [base, bit] of Object.entries(BLOCKS)) {
      const block = this.chip.peripherals[base];
      for (const access of ['readUint32', 'writeUint32Atomic']) {
        const done = block[access].bind(block);
        block[access] = (...rest) => {
          if (resets.reset & (1 << bit)) throw new Error(`${block.name} is used while it is in reset`);
          return block === this.chip.peripherals[SYSINFO] ? 0 : done(...rest);
        };
      }
    }
  }

  // What the boot ROM does.
  boot(flash) {
    this.sram.set(boot2Of(flash), BOOT2_ADDRESS - 0x20000000);
    this.core.SP = BOOT2_ADDRESS;
    this.core.LR = 0;
    this.core.PC = BOOT2_ADDRESS;
  }

  // One instruction, or nothing while the core sleeps; `executed(from, to, cycles)`, where there is one, sees it. rp2040js's own sleep loses interrupts that are masked or pending before it, so it never
  // sees one.
  step() {
    const core = this.core;
    try {
      if (core.interruptsUpdated) core.checkForInterrupts();
      this.pc = (core.PC & ~1) >>> 0; // a vector has bit 0 set
      const cycles = core.executeInstruction();
      this.executed?.(this.pc, core.PC & ~1, cycles);
      this.clock.tick(this.nanosOf(cycles));
      if (this.second.isBusy) this.runSecond(cycles);
      else if (this.second.isAwaited) this.goOnWithBoth();
    } catch (error) {
      if (!(error instanceof BusFault)) throw error;
      this.hardFault(error);
    }
    if (core.waiting) {
      core.waiting = false;
      const forGood = core.PM && core.enabledInterrupts === 0;
      if (this.second.launched && forGood) this.goOnAsSecond();
      else this.asleep = !this.interrupted;
    }
  }

  nanosOf(cycles) {
    return (cycles * 1e9) / this.chip.clkSys;
  }

  // What the bus refuses to the second core, nobody is told of.
  runSecond(cycles) {
    try {
      return this.second.run(cycles);
    } catch (error) {
      throw error instanceof BusFault ? new Error(`the second core: ${error.message}`) : error;
    }
  }

  goOnWithBoth() {
    this.second.beginBeside(this.core);
    fs.writeSync(1, 'second core: beside the first\n');
  }

  goOnAsSecond() {
    this.second.become(this.core);
    this.second.current = 1;
    this.replaceSysTick(new SysTick(this.core, this.cyclesPerTick));
    fs.writeSync(1, 'second core: started\n');
  }

  get interrupted() {
    return (this.core.pendingInterrupts & this.core.enabledInterrupts) !== 0;
  }

  // A fault within a fault locks the core up: only a reset helps. A frame that the bus refuses is not saved.
  hardFault(error) {
    const core = this.core;
    this.lockedUp = core.IPSR === HARD_FAULT;
    if (this.lockedUp) {
      this.why = error.message;
      return;
    }
    core.PC = this.pc;
    core.writeUint32 = (address, word) => {
      try {
        this.chip.writeUint32(address, word);
      } catch (refused) {
        if (!(refused instanceof BusFault)) throw refused;
      }
    };
    core.exceptionEntry(HARD_FAULT);
    delete core.writeUint32;
  }

  // Lets time pass until `nanos`, at most to the next event; while the core sleeps. Where the second core computes, as long as that does.
  idle(nanos) {
    const until = Math.min(nanos, this.nextEvent);
    for (let slices = 1000; slices > 0 && this.second.isBusy && this.clock.nanos < until; --slices) this.clock.tick(this.nanosOf(this.runSecond(10)));
    if (!this.second.isBusy) this.clock.tick(Math.max(0, until - this.clock.nanos));
    if (!this.lockedUp && this.interrupted) this.asleep = false;
  }

  get nextEvent() {
    return this.clock.nextAlarm ? this.clock.nextAlarm.nanos : Infinity;
  }
}

module.exports = {Chip};

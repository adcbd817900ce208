#!/usr/bin/env node
'use strict';
// Runs an image on an emulated RP2040. usage:
//   run.js -kernel IMAGE [-serial null|unix:PATH|tcp:HOST:PORT|stdio] [-fast] [-no-semihosting] [-sys-tick CYCLES]
//     [-steps FILE] [-calls ADDRESS:FILE]
// IMAGE is ELF or UF2. Ends with the image's exit code; with 3 and a sentence where the image does what is not emulated.
// -steps: what instructions took, a line "from to cycles" (addresses in hexadecimal) for each pair that was met and each of its cycles.
// -calls: what each call of the function at ADDRESS (hexadecimal) executed, as calls.js writes it.
// -fast: time that the board sleeps passes at once. -check: does nothing but look whether rp2040js is installed.

const fs = require('fs');
const net = require('net');
const path = require('path');

const BY_WATCHDOG = 1; // of the reasons
const STEPS = 20000; // between two looks at the host

function options(words) {
  const found = {serial: 'null', 'sys-tick': '1'};
  for (let i = 0; i < words.length; ++i) {
    const name = words[i].slice(1);
    if (['check', 'fast', 'no-semihosting'].includes(name)) found[name] = true;
    else if (['kernel', 'serial', 'sys-tick', 'steps', 'calls'].includes(name) && i + 1 < words.length) found[name] = words[++i];
    else throw new Error(`unknown option '${words[i]}'`);
  }
  if (!found.kernel && !found.check) throw new Error('name an image: -kernel IMAGE');
  return found;
}

function fail(error) {
  fs.writeSync(2, `rp2040: ${error.message}\n`);
  process.exit(3);
}

function textAt(chip, address) {
  let text = '';
  for (let byte = chip.readUint8(address); byte !== 0; byte = chip.readUint8(++address)) text += String.fromCharCode(byte);
  return text;
}

// Arm IHI 0100: a string to the console, the last error, the end.
function semihosting(core) {
  const [operation, argument] = core.registers;
  if (operation === 0x04) fs.writeSync(1, textAt(core.rp2040, argument));
  else if (operation === 0x20) process.exit(core.readUint32(argument + 4));
  else if (operation !== 0x13) throw new Error(`semihosting operation ${operation} is not emulated`);
  core.registers[0] = 0;
  return true;
}

// {send(byte), on(receive)} of the host's end of the line.
function open(serial) {
  if (serial === 'null') return {send() {}, on() {}};
  if (serial === 'stdio') return {send: (byte) => fs.writeSync(1, Buffer.of(byte)), on: (receive) => process.stdin.on('data', receive)};
  const [kind, ...where] = serial.split(':');
  const line = kind === 'unix' ? net.connect(where[0]) : net.connect(Number(where[1]), where[0]);
  line.setNoDelay(true);
  line.on('error', fail).on('close', () => process.exit(0));
  return {send: (byte) => line.write(Buffer.of(byte)), on: (receive) => line.on('data', receive)};
}

class Machine {
  constructor(chosen) {
    const {Chip} = require('./chip.js');
    const {flashOf} = require('./image.js');
    this.fast = chosen.fast;
    const line = open(chosen.serial);
    const part = {
      flash: flashOf(chosen.kernel),
      cyclesPerTick: Number(chosen['sys-tick']),
      breakpoint: chosen['no-semihosting'] ? () => false : semihosting,
      send: line.send,
    };
    const watch = watcher(chosen);
    this.powerUp = (sram, reason) => watch((this.chip = new Chip(part, sram, reason)));
    this.powerUp(unknownRam(264 * 1024), 0);
    this.idleSince = null; // on the wall, and on the board
    this.timer = null;
    this.deaf = chosen.serial === 'null';
    line.on((bytes) => {
      this.chip.uart.receive(bytes);
      this.soon();
    });
  }

  soon() {
    clearTimeout(this.timer);
    if (this.timer !== 'now') setImmediate(() => this.run());
    this.timer = 'now';
  }

  // Until when the board may sleep by now: as long as it slept on the wall, but for bytes on the line, which nobody waits for. What it
  // computed slowly is not caught up with.
  get sleepsUntil() {
    if (this.fast || this.chip.second.isBusy || this.chip.uart.waiting.length > 0) return Infinity;
    const now = process.hrtime.bigint();
    this.idleSince ??= {wall: now, board: this.chip.clock.nanos};
    return this.idleSince.board + Number(now - this.idleSince.wall);
  }

  run() {
    this.timer = null;
    try {
      if (!this.chip.asleep) this.idleSince = null;
      for (let i = 0; i < STEPS && !this.chip.asleep && !this.chip.lockedUp; ++i) {
        this.chip.step();
        if (this.chip.restarts) this.restart();
      }
      if (this.chip.asleep || this.chip.lockedUp) this.idle();
      else this.soon();
    } catch (error) {
      fail(error);
    }
  }

  idle() {
    const {chip} = this;
    if (chip.nextEvent === Infinity) {
      if (chip.lockedUp) throw new Error(`the core locked up at ${chip.pc.toString(16)}: ${chip.why}`);
      if (this.deaf) throw new Error('the board sleeps, and nothing will wake it');
      return;
    }
    if (chip.second.isBusy) this.idleSince = null;
    chip.idle(this.sleepsUntil);
    if (chip.restarts) this.restart();
    const left = this.chip.asleep && !this.chip.second.isBusy ? this.chip.nextEvent - this.sleepsUntil : 0;
    if (left > 0) this.timer = setTimeout(() => this.run(), left / 1e6);
    else this.soon();
  }

  restart() {
    const reason = this.chip.reason;
    if (reason === BY_WATCHDOG) fs.writeSync(1, `watchdog: restarted ${Math.round(this.chip.unfedNanos / 1000)} us after it was fed\n`);
    this.powerUp(this.chip.sram, reason);
  }
}

// What looks at a chip's instructions as the options say.
function watcher({steps, calls}) {
  const executed = steps ? recorder(steps) : undefined;
  if (!calls) return (chip) => Object.assign(chip, {executed});
  const {Calls} = require('./calls.js');
  const [entry, ...file] = calls.split(':');
  const recorded = new Calls(parseInt(entry, 16), file.join(':'));
  return (chip) => recorded.watch(chip);
}

// Sees every instruction, and writes what was met as the program ends.
function recorder(file) {
  const met = new Map(); // from -> to -> cycles, a bit for each number of them
  process.on('exit', () => fs.writeFileSync(file, linesOf(met).join('')));
  return (from, to, cycles) => {
    let of = met.get(from);
    if (!of) met.set(from, (of = new Map()));
    of.set(to, of.get(to) | (1 << cycles));
  };
}

function linesOf(met) {
  const lines = [];
  for (const [from, of] of met)
    for (const [to, bits] of of)
      for (let cycles = 0; cycles < 32; ++cycles)
        if (bits & (1 << cycles)) lines.push(`${from.toString(16)} ${(to >>> 0).toString(16)} ${cycles}\n`);
  return lines;
}

// RAM after power-on, by xorshift32: nobody may rely on zeros.
function unknownRam(bytes) {
  let random = 0x20241123;
  return Uint8Array.from({length: bytes}, () => {
    random ^= random << 13;
    random ^= random >>> 17;
    random ^= random << 5;
    return random & 0xff;
  });
}

process.env.AXIAL_RP2040JS ??= path.resolve(__dirname, '../../../build/rp2040js-1.4.1/package/dist/cjs/index.js');
try {
  if (!fs.existsSync(process.env.AXIAL_RP2040JS))
    throw new Error(`no ${process.env.AXIAL_RP2040JS}: ./axial demo --board rp2040, or ./axial test, installs it`);
  const chosen = options(process.argv.slice(2));
  if (!chosen.check) new Machine(chosen).soon();
} catch (error) {
  fail(error);
}

'use strict';
// What rp2040js's PL011 lacks: bytes that take their time, interrupts by the queue's level and by silence, overruns, and a
// transmitter that needs reset, clock and pin.

const [DATA, RECEIVED, SILENT, OVERRUN] = [0, 1 << 4, 1 << 6, 1 << 11];
const LEVEL = 16; // half of the queue, as reset has it
const UART_FUNCTION = 2;

class Uart {
  // `send(byte)`: to the host.
  constructor(chip, send) {
    Object.assign(this, {chip, port: chip.uart[0], waiting: [], lost: false});
    this.next = chip.clock.createAlarm(() => this.arrive());
    this.silence = chip.clock.createAlarm(() => this.raise(SILENT));
    this.port.onByte = (byte) => {
      this.check();
      send(byte);
    };
    const read = this.port.readUint32.bind(this.port);
    this.port.readUint32 = (offset) => (offset === DATA ? this.take() : read(offset));
  }

  check() {
    if (!this.port.enabled || !this.port.txEnabled) throw new Error('UART0 sends while it is disabled');
    if (this.chip.clocks.periFreq === 0) throw new Error('UART0 sends without a clock');
    if (this.chip.gpio[0].functionSelect !== UART_FUNCTION) throw new Error('UART0 sends while its pin is not connected');
  }

  get bitNanos() {
    return 1e9 / this.port.baudRate;
  }

  // Bytes of the host, one after the other.
  receive(bytes) {
    const idle = this.waiting.length === 0;
    for (const byte of bytes) this.waiting.push(byte);
    if (idle && this.waiting.length > 0) this.next.schedule(10 * this.bitNanos);
  }

  arrive() {
    const byte = this.waiting.shift();
    if (this.waiting.length > 0) this.next.schedule(10 * this.bitNanos);
    if (!this.port.enabled || !this.port.rxEnabled || this.chip.gpio[1].functionSelect !== UART_FUNCTION) return;
    const queue = this.port.rxFIFO;
    if (queue.full) this.lost = true;
    else {
      queue.push(byte | (this.lost ? OVERRUN : 0));
      this.lost = false;
    }
    if (queue.itemCount >= LEVEL) this.raise(RECEIVED);
    this.silence.schedule(32 * this.bitNanos);
  }

  raise(interrupt) {
    this.port.interruptStatus |= interrupt;
    this.port.checkInterrupts();
  }

  take() {
    const queue = this.port.rxFIFO;
    const data = queue.pull();
    if (queue.itemCount < LEVEL) this.port.interruptStatus &= ~RECEIVED;
    if (queue.empty) {
      this.port.interruptStatus &= ~SILENT;
      this.silence.cancel();
    }
    this.port.checkInterrupts();
    return data;
  }
}

module.exports = {Uart};

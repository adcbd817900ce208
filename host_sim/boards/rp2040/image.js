'use strict';
// An image as a flash chip holds it: the loadable parts of an ELF file, or the blocks of a UF2 file; and the boot ROM's checksum.

const fs = require('fs');

const FLASH = 0x10000000;
const FLASH_BYTES = 2 * 1024 * 1024;
const BOOT2_BYTES = 256;

function put(flash, address, bytes) {
  const at = address - FLASH;
  if (at < 0 || at + bytes.length > flash.length) throw new Error(`0x${address.toString(16)} is not in flash`);
  flash.set(bytes, at);
}

// Program headers that are loaded, at their physical addresses.
function loadElf(file, flash) {
  const [table, size, count] = [file.readUInt32LE(28), file.readUInt16LE(42), file.readUInt16LE(44)];
  for (let i = 0; i < count; ++i) {
    const header = file.subarray(table + i * size, table + (i + 1) * size);
    const [type, offset, , physical, bytes] = [0, 4, 8, 12, 16].map((at) => header.readUInt32LE(at));
    if (type === 1 && bytes > 0) put(flash, physical, file.subarray(offset, offset + bytes));
  }
}

function loadUf2(file, flash) {
  for (let at = 0; at < file.length; at += 512) {
    const [begin, second, flags, address, bytes, , , family] = Array.from({length: 8}, (_, i) => file.readUInt32LE(at + 4 * i));
    const isBlock = begin === 0x0a324655 && second === 0x9e5d5157 && file.readUInt32LE(at + 508) === 0x0ab16f30;
    if (!isBlock || !(flags & 0x2000) || family !== 0xe48bff56 || bytes !== 256) throw new Error(`a block is no UF2 of an RP2040, at ${at}`);
    put(flash, address, file.subarray(at + 32, at + 32 + bytes));
  }
}

// The whole flash; what the image leaves out is erased.
function flashOf(path) {
  const file = fs.readFileSync(path);
  const flash = Buffer.alloc(FLASH_BYTES, 0xff);
  if (file.readUInt32LE(0) === 0x464c457f) loadElf(file, flash);
  else if (file.readUInt32LE(0) === 0x0a324655) loadUf2(file, flash);
  else throw new Error(`${path} is neither ELF nor UF2`);
  return flash;
}

// CRC-32/MPEG-2 by bits.
function bootCrc(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes)
    for (let bit = 7; bit >= 0; --bit) {
      const odd = (crc >>> 31) ^ ((byte >> bit) & 1);
      crc = ((crc << 1) ^ (odd ? 0x04c11db7 : 0)) >>> 0;
    }
  return crc;
}

// boot2, which the boot ROM does not start when its checksum is wrong.
function boot2Of(flash) {
  const boot2 = flash.subarray(0, BOOT2_BYTES);
  const [told, found] = [boot2.readUInt32LE(252), bootCrc(boot2.subarray(0, 252))];
  if (told !== found) throw new Error(`boot2's checksum is ${told.toString(16)}, its bytes' ${found.toString(16)}`);
  return boot2;
}

module.exports = {flashOf, boot2Of};

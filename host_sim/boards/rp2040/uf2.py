#!/usr/bin/python3
"""Writes an image as the UF2 file that a Raspberry Pi Pico takes when it shows itself as a drive.

Source: Microsoft's UF2 file format; RP2040 Datasheet, 2.8.4.2 (family, pages of 256 bytes).
"""

import pathlib
import struct
import sys

FLASH, PAGE = 0x10000000, 256
BEGIN, SECOND, END, FAMILY = 0x0A324655, 0x9E5D5157, 0x0AB16F30, 0xE48BFF56
FAMILY_IS_TOLD = 0x2000
LOADED = 1


class Refused(Exception):
    pass


def parts(elf):
    """(address, bytes) of all that an ELF file of 32 bits loads."""
    if elf[:6] != b"\x7fELF\x01\x01":
        raise Refused("is no ELF file of 32 bits, little-endian")
    table, size, count = struct.unpack_from("<I", elf, 28)[0], *struct.unpack_from("<HH", elf, 42)
    for i in range(count):
        kind, offset, _, address, length = struct.unpack_from("<5I", elf, table + i * size)
        if kind == LOADED and length > 0:
            yield address, elf[offset:offset + length]


def flash_of(elf):
    """What flash holds from its begin to the image's end, whole pages; erased where nothing is."""
    found = list(parts(elf))
    if not found or min(address for address, _ in found) != FLASH:
        raise Refused("does not begin where flash does: it is no image of this board")
    end = max(address - FLASH + len(data) for address, data in found)
    flash = bytearray(b"\xff" * (-(-end // PAGE) * PAGE))
    for address, data in found:
        flash[address - FLASH:address - FLASH + len(data)] = data
    return bytes(flash)


def block(number, count, page):
    head = struct.pack("<8I", BEGIN, SECOND, FAMILY_IS_TOLD, FLASH + number * PAGE, PAGE, number, count, FAMILY)
    return head + page.ljust(476, b"\0") + struct.pack("<I", END)


def uf2(elf):
    flash = flash_of(elf)
    count = len(flash) // PAGE
    return b"".join(block(i, count, flash[i * PAGE:(i + 1) * PAGE]) for i in range(count))


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: uf2.py IMAGE.elf FILE.uf2")
    try:
        data = uf2(pathlib.Path(sys.argv[1]).read_bytes())
        pathlib.Path(sys.argv[2]).write_bytes(data)
    except Refused as error:
        sys.exit(f"axial: {sys.argv[1]} {error}")
    except OSError as error:
        sys.exit(f"axial: {error}")
    print(f"axial: wrote {sys.argv[2]}, {len(data) // 512} blocks")


if __name__ == "__main__":
    main()

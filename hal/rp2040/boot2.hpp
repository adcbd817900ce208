#pragma once
/// The second stage of the RP2040's boot: 256 bytes at the begin of flash, which the boot ROM copies to RAM, checks and
/// executes. It has the flash read by the slow, plain command 03h that every chip knows, then enters the image behind
/// it. Source: RP2040 Datasheet, 2.8.1.3 (boot2 and its checksum), 4.10 (SSI).

#include <array>
#include <cstddef>
#include <cstdint>

namespace axial::hal::rp2040 {

constexpr std::uint32_t flash_address = 0x10000000, vectors_address = flash_address + 256;

/// A word and where boot2 stores it; address 0 ends the list, with the address of the vector table as its word.
struct Store {
  std::uint32_t address, word;
};

namespace ssi {
constexpr std::uint32_t base = 0x18000000;
constexpr std::uint32_t control0 = base, control1 = base + 0x04, enable = base + 0x08, clock_divider = base + 0x14,
                        spi_control0 = base + 0xF4;
constexpr std::uint32_t bits_32 = 31u << 16, send_command_then_read = 3u << 8;
constexpr std::uint32_t read_command = 0x03u << 24, command_of_8_bits = 2u << 8, address_of_24_bits = 6u << 2;
constexpr std::uint32_t divider =
    4;  // 125 MHz / 4 = 31.25 MHz, under the 50 MHz that command 03h allows (W25Q16JV, 9.6)
}  // namespace ssi

constexpr std::array<Store, 8> boot2_stores{{
    {ssi::enable, 0},  // its settings are locked while it is enabled
    {ssi::clock_divider, ssi::divider},
    {ssi::control0, ssi::bits_32 | ssi::send_command_then_read},
    {ssi::spi_control0, ssi::read_command | ssi::command_of_8_bits | ssi::address_of_24_bits},
    {ssi::control1, 0},  // one word a read
    {ssi::enable, 1},
    {0xE000ED08, vectors_address},  // VTOR
    {0, vectors_address},
}};

constexpr std::array<std::uint16_t, 10> boot2_code{
    0xA304,          //       adr   r3, stores
    0xCB03,          // next: ldmia r3!, {r0, r1}
    0x2800,          //       cmp   r0, #0
    0xD001,          //       beq   enter
    0x6001,          //       str   r1, [r0]
    0xE7FA,          //       b     next
    0xC905,          // enter: ldmia r1!, {r0, r2}
    0xF380, 0x8808,  //       msr   msp, r0
    0x4710,          //       bx    r2
};

/// CRC-32 as the boot ROM computes it: 0x04C11DB7, the highest bit first, begun with ones, nothing inverted at the end.
template <std::size_t size>
constexpr std::uint32_t boot_crc(const std::array<std::uint8_t, size>& bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) {
    crc ^= std::uint32_t{byte} << 24;
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc & 0x80000000u) != 0 ? crc << 1 ^ 0x04C11DB7u : crc << 1;
  }
  return crc;
}

namespace detail {
/// Appends the lowest `bytes` bytes of `word`, the least significant first, at `at`.
template <std::size_t size>
constexpr void append(std::array<std::uint8_t, size>& to, std::size_t& at, std::uint32_t word, int bytes) {
  for (int i = 0; i < bytes; ++i)
    to[at++] = static_cast<std::uint8_t>(word >> 8 * i);
}
}  // namespace detail

/// The 252 bytes that the checksum is of: code, stores, zeros.
constexpr std::array<std::uint8_t, 252> boot2_body() {
  std::array<std::uint8_t, 252> bytes{};
  std::size_t at = 0;
  for (const std::uint16_t instruction : boot2_code)
    detail::append(bytes, at, instruction, 2);
  for (const Store& store : boot2_stores) {
    detail::append(bytes, at, store.address, 4);
    detail::append(bytes, at, store.word, 4);
  }
  return bytes;
}

/// What stands in flash: the body and its checksum.
constexpr std::array<std::uint8_t, 256> boot2() {
  std::array<std::uint8_t, 256> bytes{};
  std::size_t at = 0;
  for (const std::uint8_t byte : boot2_body())
    bytes[at++] = byte;
  detail::append(bytes, at, boot_crc(boot2_body()), 4);
  return bytes;
}

}  // namespace axial::hal::rp2040

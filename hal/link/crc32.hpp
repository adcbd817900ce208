#pragma once
/// CRC-32 of IEEE 802.3: polynomial 0x04C11DB7 reflected, initial value and final xor 0xFFFFFFFF. "123456789" gives
/// 0xCBF43926.

#include <array>
#include <cstddef>
#include <cstdint>

namespace axial::hal::link {

/// Byte by byte, with a table of 16 entries: 64 bytes of flash, two steps a byte.
class Crc32 {
 public:
  constexpr void add(std::uint8_t byte) {
    state_ = step(state_ ^ byte);
    state_ = step(state_);
  }

  constexpr void add(const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      add(bytes[i]);
  }

  constexpr std::uint32_t value() const { return ~state_; }

 private:
  static constexpr std::array<std::uint32_t, 16> make_table() {
    std::array<std::uint32_t, 16> table{};
    for (std::uint32_t nibble = 0; nibble < 16; ++nibble) {
      std::uint32_t r = nibble;
      for (int bit = 0; bit < 4; ++bit)
        r = (r >> 1) ^ ((r & 1u) != 0 ? 0xEDB88320u : 0u);
      table[nibble] = r;
    }
    return table;
  }

  static constexpr std::uint32_t step(std::uint32_t state) { return (state >> 4) ^ table_[state & 0xFu]; }

  static const std::array<std::uint32_t, 16> table_;
  std::uint32_t state_ = 0xFFFFFFFF;
};

inline constexpr std::array<std::uint32_t, 16> Crc32::table_ = Crc32::make_table();

constexpr std::uint32_t crc32(const std::uint8_t* bytes, std::size_t count) {
  Crc32 crc;
  crc.add(bytes, count);
  return crc.value();
}

}  // namespace axial::hal::link

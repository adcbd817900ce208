#pragma once
/// What the RP2350's boot ROM looks for in the first 4 KiB of flash: a block that says that an image is here, for which
/// of the part's two architectures, and where it begins. Without a signature and without a hash.
/// Source: RP2350 Datasheet, 5.9 (metadata blocks), 5.9.3 (items).

#include <array>
#include <cstdint>

namespace axial::hal::rp2350 {

constexpr std::uint32_t flash_address = 0x10000000;

namespace boot_word {
constexpr std::uint32_t begin = 0xFFFFDED3, end = 0xAB123579;
/// Items: type in the lowest byte, size in words above it.
constexpr std::uint32_t image_type = 0x42 | 1u << 8, entry_point = 0x44 | 3u << 8;
/// The flags of image_type, in its upper half.
constexpr std::uint32_t executable = 1u << 16, riscv = 1u << 24, rp2350 = 1u << 28;
constexpr std::uint32_t items_words = 4;
constexpr std::uint32_t last = 0xFF | items_words << 8;
}  // namespace boot_word

using BootBlock = std::array<std::uint32_t, 8>;

/// The block of an image that begins at `entry` with the stack pointer `stack`. Its link, from a block to the next,
/// says 0: it is the only one.
constexpr BootBlock boot_block(std::uint32_t entry, std::uint32_t stack) {
  using namespace boot_word;
  return {begin, image_type | executable | riscv | rp2350, entry_point, entry, stack, last, 0, end};
}

}  // namespace axial::hal::rp2350

/// What stands before the first instruction.

#include <hal/rp2350/boot_block.hpp>

namespace axial::hal::rp2350 {
namespace {

constexpr std::uint32_t first_instruction = flash_address + sizeof(BootBlock), end_of_ram = 0x20082000;

[[gnu::section(".boot"), gnu::used]] constexpr BootBlock block = boot_block(first_instruction, end_of_ram);

}  // namespace
}  // namespace axial::hal::rp2350

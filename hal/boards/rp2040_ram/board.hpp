#pragma once
/// Raspberry Pi Pico, 125 MHz: start-up copies code and constants from flash to RAM, where nothing waits for flash.

#include <hal/rp2040/board.hpp>

namespace axial::hal {

struct Rp2040Ram : RaspberryPiPico {
  static constexpr const char* name = "rp2040_ram";
};

using Board = Rp2040Ram;

}  // namespace axial::hal

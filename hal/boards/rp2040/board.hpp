#pragma once
/// Raspberry Pi Pico, 125 MHz: code and constants in flash, read through a cache of 16 KiB.

#include <hal/rp2040/board.hpp>

namespace axial::hal {

struct Rp2040 : RaspberryPiPico {
  static constexpr const char* name = "rp2040";
};

using Board = Rp2040;

}  // namespace axial::hal

#pragma once
/// For boards that only measure.

#include <cstddef>
#include <cstdint>

namespace axial::hal {

/// A serial port that is not there.
struct NoSerialPort {
  static std::uint32_t start(std::uint32_t, std::uint32_t) { return 0; }
  static bool read(std::uint8_t&) { return false; }
  static bool write(const std::uint8_t*, std::size_t) { return false; }
  static bool idle() { return true; }
  static std::uint32_t overruns() { return 0; }
  static void interrupt() {}
};

}  // namespace axial::hal

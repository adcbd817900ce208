#pragma once
/// What serial ports of every family share: a ring for what comes in by interrupt, sending by polling with a bound.

#include <cstddef>
#include <cstdint>

#include <hal/ring.hpp>

namespace axial::hal {

/// `Family`, which derives from it, has `static bool send(std::uint8_t)`: sends a byte, false when the port did not
/// take it in time.
template <class Family, std::size_t receive_capacity>
class SerialPort {
 public:
  static bool read(std::uint8_t& byte) { return received_.pop(byte); }
  static bool idle() { return received_.empty(); }

  /// Bytes lost because the ring, or what the port has of a queue, was full; at least one each.
  static std::uint32_t overruns() { return overruns_; }

  /// Sends `count` bytes. False when the port did not take a byte in time: the rest is dropped.
  static bool write(const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (!Family::send(bytes[i])) return false;
    }
    return true;
  }

 protected:
  /// A received byte. False when there is no room for it.
  static bool keep(std::uint8_t byte) { return received_.push(byte); }
  static void lose() { overruns_ = overruns_ + 1; }

  /// Whether `ready()` became true in time.
  template <class Ready>
  static bool wait_until(const Ready& ready) {
    constexpr unsigned polls = 20000;  // a byte takes under 1 000 looks at every supported rate
    for (unsigned i = 0; i < polls; ++i) {
      if (ready()) return true;
    }
    return false;
  }

 private:
  inline static ByteRing<receive_capacity> received_{};
  inline static volatile std::uint32_t overruns_ = 0;
};

}  // namespace axial::hal

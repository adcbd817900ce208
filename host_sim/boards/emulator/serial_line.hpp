// The emulated UART as a byte stream: a UNIX socket that the emulator connects to.
#pragma once

#include <host_sim/tools/system/descriptor.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace host_sim {

/// The connected line. Reads and writes throw std::runtime_error when the other side is gone.
class SerialLine {
 public:
  SerialLine() = default;
  explicit SerialLine(Descriptor socket) : socket_(static_cast<Descriptor&&>(socket)) {}
  SerialLine(SerialLine&&) = default;
  SerialLine& operator=(SerialLine&&) = default;
  virtual ~SerialLine() = default;

  virtual void write(const std::uint8_t* bytes, std::size_t count);
  /// Waits for bytes and returns how many came, at most `capacity`; 0 when none came in time.
  virtual std::size_t read(std::uint8_t* bytes, std::size_t capacity, std::chrono::milliseconds limit);

 private:
  Descriptor socket_;
};

/// Waits at a path for the emulator. It exists before the emulator starts, so neither side has to try again.
class SerialListener {
 public:
  explicit SerialListener(const std::string& path);

  bool wait(std::chrono::milliseconds limit) const;
  SerialLine accept() const;

 private:
  Descriptor socket_;
};

}  // namespace host_sim

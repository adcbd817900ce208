// The serial line of a board on the desk: a device of this machine.
#pragma once

#include <host_sim/boards/emulator/serial_line.hpp>

#include <string>

namespace host_sim {

/// A serial device, raw, of eight bits without parity, that nobody else opens meanwhile. What had come before is
/// dropped.
class SerialPort : public SerialLine {
 public:
  /// `device`: a path, or path:baud; 2 Mbit/s where none is named. Throws std::runtime_error that names it.
  explicit SerialPort(const std::string& device);

  void write(const std::uint8_t* bytes, std::size_t count) override;
  std::size_t read(std::uint8_t* bytes, std::size_t capacity, std::chrono::milliseconds limit) override;

 private:
  std::string path_;
  Descriptor port_;
};

}  // namespace host_sim

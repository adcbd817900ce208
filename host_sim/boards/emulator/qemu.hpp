// A board in QEMU: an image that runs, its serial line, its console.
#pragma once

#include <host_sim/boards/emulator/board.hpp>
#include <host_sim/boards/emulator/serial_line.hpp>
#include <host_sim/tools/system/own_processor.hpp>
#include <host_sim/tools/system/process.hpp>
#include <host_sim/tools/system/temporary_folder.hpp>

#include <chrono>
#include <string>

namespace host_sim {

/// An image running in QEMU with its UART connected. The destructor ends the emulator. While it lives, it and the
/// thread that made it stay on one processor: QEMU hands every byte from thread to thread and waits, several times as
/// long across two.
class Emulator {
 public:
  /// Throws std::runtime_error with the emulator's own words when it does not come up.
  Emulator(const Board& board, const std::string& image);

  SerialLine& serial() { return serial_; }
  /// Waits until the image ends the emulator (semihosting exit); empty when it has not in time.
  std::optional<int> wait(std::chrono::milliseconds limit) { return process_.wait(limit); }
  /// What image and emulator have printed so far.
  std::string console() const;

 private:
  SerialLine connect();

  OwnProcessor processor_;  // before the process, which inherits it
  TemporaryFolder folder_;
  SerialListener listener_;
  Process process_;
  SerialLine serial_;
};

/// What an image printed that runs to its end by itself.
struct ConsoleRun {
  std::string output;
  int exit_status = 0;
};

/// Runs an image without a serial line until it exits. Throws std::runtime_error when it has not within the limit.
ConsoleRun run_to_end(const Board& board, const std::string& image, std::chrono::seconds limit);

}  // namespace host_sim

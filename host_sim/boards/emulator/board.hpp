// What the host needs to know of a board: hal/boards/<board>/board.json.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace host_sim {

struct Board {
  std::string name, cpu;
  std::uint32_t flash_bytes = 0, ram_bytes = 0;  ///< of the part
  std::vector<std::string> emulator;             ///< program and arguments
  std::string emulator_name;                     ///< QEMU, or which other one
  std::string counts;                            ///< what the board's counter counts there: instructions, cycles
  bool serial_queue = false;  ///< whether the emulator queues what it has for the UART: one byte at a time without
};

/// Names of all boards that run every app, sorted; those that only measure are left to host_sim/boards/size.
std::vector<std::string> board_names();

/// Of those, the ones whose emulator counts instructions, as documents compare them.
std::vector<std::string> boards_that_count_instructions();

/// Throws std::runtime_error that names the boards there are.
Board read_board(const std::string& name);

/// Path of an image, e.g. build/stm32f405/images/feedforward-scara.elf.
/// Throws std::runtime_error that says how to build it.
std::string image_path(const Board& board, const std::string& app, const std::string& robot);

}  // namespace host_sim

#include <host_sim/boards/emulator/qemu.hpp>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace host_sim {

namespace {

constexpr auto connection_limit = std::chrono::seconds(20);

std::string read_text(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> command_line(const Board& board, const std::string& image,
                                      const std::vector<std::string>& serial) {
  std::vector<std::string> command = board.emulator;
  command.insert(command.end(), serial.begin(), serial.end());
  command.insert(command.end(), {"-kernel", image});
  return command;
}

/// The queue is a multiplexer's, though of one user: it hands over a byte as the board takes the one before, where two
/// threads of QEMU would wait for each other. 256: no byte is the multiplexer's own.
std::vector<std::string> connected_to(const std::string& socket, bool queue) {
  if (!queue) return {"-serial", "unix:" + socket};
  return {"-chardev", "socket,id=uart,mux=on,path=" + socket, "-serial", "chardev:uart", "-echr", "256"};
}

}  // namespace

Emulator::Emulator(const Board& board, const std::string& image)
    : listener_(folder_.file("uart")),
      process_(command_line(board, image, connected_to(folder_.file("uart"), board.serial_queue)),
               folder_.file("console")),
      serial_(connect()) {}

SerialLine Emulator::connect() {
  const auto end = std::chrono::steady_clock::now() + connection_limit;
  while (!listener_.wait(std::chrono::milliseconds(50))) {
    if (process_.exit_status()) throw std::runtime_error("the emulator ended at once; it says: " + console());
    if (std::chrono::steady_clock::now() > end)
      throw std::runtime_error("the emulator did not connect its serial line");
  }
  return listener_.accept();
}

std::string Emulator::console() const { return read_text(folder_.file("console")); }

ConsoleRun run_to_end(const Board& board, const std::string& image, std::chrono::seconds limit) {
  const TemporaryFolder folder;
  Process process(command_line(board, image, {"-serial", "null"}), folder.file("console"));
  const auto status = process.wait(limit);
  const std::string output = read_text(folder.file("console"));
  if (!status) throw std::runtime_error(image + " did not end within " + std::to_string(limit.count()) + " s");
  return {output, *status};
}

}  // namespace host_sim

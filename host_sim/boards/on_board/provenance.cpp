#include <host_sim/boards/on_board/provenance.hpp>

#include <host_sim/boards/emulator/board.hpp>
#include <host_sim/tools/system/process.hpp>
#include <host_sim/tools/system/temporary_folder.hpp>

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace host_sim {

namespace {

/// First line that a program prints; empty when it fails.
std::string first_line(const std::vector<std::string>& command) {
  const TemporaryFolder folder;
  Process process(command, folder.file("output"));
  std::string line;
  if (process.wait(std::chrono::seconds(10)) == 0) std::getline(std::ifstream(folder.file("output")) >> std::ws, line);
  return line;
}

/// Value of a variable in the CMake cache of a build folder.
std::string cached(const std::string& board, const std::string& variable) {
  std::ifstream cache(std::string(AXIAL_IMAGES_ROOT) + "/" + board + "/CMakeCache.txt");
  for (std::string line; std::getline(cache, line);)
    if (line.rfind(variable + ":", 0) == 0) return line.substr(line.find('=') + 1);
  return "";
}

}  // namespace

nlohmann::json provenance() {
  nlohmann::json boards;
  for (const std::string& board : boards_that_count_instructions())
    boards[board] = {{"compiler", first_line({cached(board, "AXIAL_TOOLS") + "g++", "--version"})},
                     {"flags", cached(board, "CMAKE_CXX_FLAGS")}};
  return {{"commit", first_line({AXIAL_ROOT "/host_sim/tools/system/commit.sh"})}, {"boards", boards}};
}

}  // namespace host_sim

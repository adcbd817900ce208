#include <host_sim/boards/emulator/board.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace host_sim {

namespace {

namespace fs = std::filesystem;

fs::path description(const std::string& board) { return fs::path(AXIAL_ROOT) / "hal/boards" / board / "board.json"; }

bool runs_every_app(const nlohmann::json& board) { return !board.value("measuring_only", false); }

bool counts_instructions(const nlohmann::json& board) { return runs_every_app(board) && board.contains("qemu"); }

std::vector<std::string> names_where(bool (*holds)(const nlohmann::json&)) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(AXIAL_ROOT) / "hal/boards")) {
    std::ifstream file(entry.path() / "board.json");
    if (file && holds(nlohmann::json::parse(file))) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

std::vector<std::string> board_names() { return names_where(runs_every_app); }

std::vector<std::string> boards_that_count_instructions() { return names_where(counts_instructions); }

Board read_board(const std::string& name) {
  const auto known = board_names();
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw std::runtime_error("unknown board '" + name + "'; there are: " + joined(known));
  std::ifstream file(description(name));
  const auto json = nlohmann::json::parse(file);
  const auto& emulator = json.contains("qemu") ? json.at("qemu") : json.at("runner");
  Board board{name, json.at("cpu"), json.at("flash_bytes"), json.at("ram_bytes"), {}, "QEMU", "instructions", false};
  board.emulator = {emulator.at("program").get<std::string>()};
  if (json.contains("runner")) {
    board.emulator_name = emulator.at("machine");
    board.counts = emulator.at("counts");
    board.emulator.push_back((fs::path(AXIAL_ROOT) / emulator.at("script").get<std::string>()).string());
  }
  for (const auto& argument : emulator.at("arguments"))
    board.emulator.push_back(argument);
  board.serial_queue = emulator.value("serial_queue", false);
  return board;
}

std::string image_path(const Board& board, const std::string& app, const std::string& robot) {
  const fs::path path = fs::path(AXIAL_IMAGES_ROOT) / board.name / "images" / (app + "-" + robot + ".elf");
  if (!fs::exists(path))
    throw std::runtime_error("no image " + path.string() + "; build it: cmake --preset " + board.name +
                             " && cmake --build --preset " + board.name);
  return path.string();
}

}  // namespace host_sim

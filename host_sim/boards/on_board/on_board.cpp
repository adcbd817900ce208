#include <host_sim/boards/on_board/on_board.hpp>

#include <host_sim/boards/emulator/qemu.hpp>
#include <host_sim/boards/on_board/provenance.hpp>
#include <host_sim/boards/on_board/rows.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/progress.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace host_sim {

namespace {

constexpr auto run_limit = std::chrono::seconds(300);

std::vector<std::string> one_or_all(const std::string& name, const std::vector<std::string>& all) {
  return name.empty() ? all : std::vector<std::string>{name};
}

std::vector<OnBoardRow> measure(const Board& board, const Robot& robot) {
  const ConsoleRun run = run_to_end(board, image_path(board, "kernels", robot.name), run_limit);
  if (run.exit_status != 0)
    throw std::runtime_error("the kernels image of " + robot.name + " on " + board.name + " failed: " + run.output);
  return rows_of(parse_kernel_output(run.output), robot, board.name);
}

std::vector<OnBoardRow> measure_all(const OnBoardOptions& options) {
  const auto robots = one_or_all(options.robot, robot_names());
  const auto boards = one_or_all(options.board, boards_that_count_instructions());
  Progress progress("measuring kernels", robots.size() * boards.size());
  std::vector<OnBoardRow> rows;
  std::size_t done = 0;
  for (const std::string& board : boards)
    for (const std::string& robot : robots) {
      progress.at(done++);
      const auto measured = measure(read_board(board), find_robot(robot));
      rows.insert(rows.end(), measured.begin(), measured.end());
    }
  return rows;
}

std::string table(const std::vector<OnBoardRow>& rows) {
  Table table({"board", "robot", "kernel", "scalar", "largest error", "RMS error", "instructions"});
  for (const OnBoardRow& row : rows) {
    const std::string least = row.work.min == row.work.max ? "" : grouped(row.work.min) + " to ";
    table.add({row.board, row.robot, row.subject, row.scalar, significant(row.error, 2), significant(row.error_rms, 2),
               least + grouped(row.work.max)});
  }
  return table.text();
}

void write_csv(const std::string& path, const std::vector<OnBoardRow>& rows) {
  CsvFile file(path, {"subject", "robot", "scalar", "variant", "board", "error", "error_rms", "error_bound", "work",
                      "work_min", "unit_of_work"});
  for (const OnBoardRow& row : rows) {
    for (const auto* text : {&row.subject, &row.robot, &row.scalar, &row.variant, &row.board})
      file.cell(*text);
    for (const double value : {row.error, row.error_rms, row.bound})
      file.cell(value, 4);
    file.cell(row.work.max), file.cell(row.work.min);
    file.cell(row.unit_of_work);
    file.end_row();
  }
}

void write_files(const OnBoardOptions& options, const std::vector<OnBoardRow>& rows) {
  make_folder(options.output);
  const std::string stem = options.output + "/on_board";
  write_csv(stem + ".csv", rows);
  write_json(stem + ".json", to_json(rows));
  write_json(options.output + "/provenance.json", provenance());
  if (!options.json.empty()) write_json(options.json, to_json(rows));
  std::printf("\ndata     %s.csv, %s.json\n", stem.c_str(), stem.c_str());
}

int verdict(const std::vector<OnBoardRow>& rows) {
  int status = 0;
  for (const OnBoardRow& row : rows) {
    if (row.error <= row.bound) continue;
    std::fprintf(stderr, "on board: %s of %s on %s in %s: error %s is above its bound %s\n", row.subject.c_str(),
                 row.robot.c_str(), row.board.c_str(), row.scalar.c_str(), significant(row.error).c_str(),
                 significant(row.bound).c_str());
    status = 1;
  }
  return status;
}

}  // namespace

int run_on_board(const OnBoardOptions& options) {
  const std::vector<OnBoardRow> rows = measure_all(options);
  std::printf("%s\nerrors relative to the largest of the joint or quantity; instructions counted by QEMU, not cycles\n",
              table(rows).c_str());
  write_files(options, rows);
  return verdict(rows);
}

}  // namespace host_sim

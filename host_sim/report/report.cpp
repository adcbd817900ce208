#include <host_sim/report/report.hpp>

#include <host_sim/emulator/qemu.hpp>
#include <host_sim/output/files.hpp>
#include <host_sim/output/progress.hpp>
#include <host_sim/output/table.hpp>
#include <host_sim/report/provenance.hpp>
#include <host_sim/report/rows.hpp>

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

std::vector<ReportRow> measure(const Board& board, const Robot& robot) {
  const ConsoleRun run = run_to_end(board, image_path(board, "kernels", robot.name), run_limit);
  if (run.exit_status != 0)
    throw std::runtime_error("the kernels image of " + robot.name + " on " + board.name + " failed: " + run.output);
  return rows_of(parse_kernel_output(run.output), robot, board.name);
}

std::vector<ReportRow> measure_all(const ReportOptions& options) {
  const auto robots = one_or_all(options.robot, robot_names());
  const auto boards = one_or_all(options.board, board_names());
  Progress progress("measuring kernels", robots.size() * boards.size());
  std::vector<ReportRow> rows;
  std::size_t done = 0;
  for (const std::string& board : boards)
    for (const std::string& robot : robots) {
      progress.at(done++);
      const auto measured = measure(read_board(board), find_robot(robot));
      rows.insert(rows.end(), measured.begin(), measured.end());
    }
  mark_pareto_front(rows);
  return rows;
}

std::string table(const std::vector<ReportRow>& rows) {
  Table table({"board", "robot", "kernel", "scalar", "largest error", "RMS error", "instructions", "front"});
  for (const ReportRow& row : rows) {
    const std::string least = row.work.min == row.work.max ? "" : grouped(row.work.min) + " to ";
    table.add({row.board, row.robot, row.subject, row.scalar, significant(row.error, 2), significant(row.error_rms, 2),
               least + grouped(row.work.max), row.pareto ? "*" : ""});
  }
  return table.text();
}

void write_csv(const std::string& path, const std::vector<ReportRow>& rows) {
  CsvFile file(path, {"subject", "robot", "scalar", "variant", "board", "error", "error_rms", "error_bound", "work",
                      "work_min", "unit_of_work", "pareto"});
  for (const ReportRow& row : rows) {
    for (const auto* text : {&row.subject, &row.robot, &row.scalar, &row.variant, &row.board})
      file.cell(*text);
    for (const double value : {row.error, row.error_rms, row.bound})
      file.cell(value, 4);
    file.cell(row.work.max), file.cell(row.work.min);
    file.cell(row.unit_of_work), file.cell(row.pareto ? std::string("true") : "false");
    file.end_row();
  }
}

void write_files(const ReportOptions& options, const std::vector<ReportRow>& rows) {
  make_folder(options.output);
  const std::string stem = options.output + "/report";
  write_csv(stem + ".csv", rows);
  write_json(stem + ".json", to_json(rows));
  write_json(options.output + "/provenance.json", provenance());
  if (!options.json.empty()) write_json(options.json, to_json(rows));
  run_plot("report.py", {stem + ".csv"});
  std::printf("\npicture  %s.png (and .svg)\ndata     %s.csv, %s.json\n", stem.c_str(), stem.c_str(), stem.c_str());
}

int verdict(const std::vector<ReportRow>& rows) {
  int status = 0;
  for (const ReportRow& row : rows) {
    if (row.error <= row.bound) continue;
    std::fprintf(stderr, "report: %s of %s on %s in %s: error %s is above its bound %s\n", row.subject.c_str(),
                 row.robot.c_str(), row.board.c_str(), row.scalar.c_str(), significant(row.error).c_str(),
                 significant(row.bound).c_str());
    status = 1;
  }
  return status;
}

}  // namespace

int run_report(const ReportOptions& options) {
  const std::vector<ReportRow> rows = measure_all(options);
  std::printf(
      "%s\nerrors relative to the largest of the joint or quantity; instructions counted by QEMU, not cycles;\n"
      "* nothing that does the same job on that board is as exact and as cheap\n",
      table(rows).c_str());
  write_files(options, rows);
  return verdict(rows);
}

}  // namespace host_sim

// loop: the closed loop with the firmware in it, and sweeps of the same sources on the host.
#include <host_sim/boards/on_board/provenance.hpp>
#include <host_sim/plants/loop/cycle.hpp>
#include <host_sim/plants/loop/verdicts.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/progress.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace {

using namespace host_sim::loop;

constexpr unsigned seeds = 8;
constexpr std::uint32_t most_places = 4;
constexpr std::size_t drawn_ticks = 4000;
constexpr double seconds_alone = 10.0;  // of the feedback alone on a board, at most: the cycle repeats itself

struct Options {
  std::string robot = "scara", board = "stm32f405", number = "float", output = "output/loop", json, provenance;
  double seconds = 10.0;
  bool sweep = false, check = false;
};

Row on_host_row(const Options& options, const std::string& name, Case situation) {
  situation.robot = options.robot;
  Row row{situation, "host", options.number, name, {}, 0.0};
  const auto controller = on_host(options.robot, options.number);
  row.tracking = follow(situation, *controller);
  return row;
}

/// With and without what is fed forward; the median of the seeds by tool error.
void add_pair(std::vector<Row>& rows, const Options& options, const std::string& name, Case situation) {
  const unsigned count = situation.parameter_error > 0.0 ? seeds : 1;
  std::vector<Row> fed, alone;
  for (unsigned seed = 0; seed < count; ++seed) {
    situation.seed = seed;
    situation.feeds_forward = false;
    alone.push_back(on_host_row(options, name, situation));
    situation.feeds_forward = true;
    fed.push_back(on_host_row(options, name, situation));
    fed.back().ratio = alone.back().tracking.tool_rms / fed.back().tracking.tool_rms;
  }
  const auto by_error = [](const Row& a, const Row& b) { return a.tracking.tool_rms < b.tracking.tool_rms; };
  for (auto* list : {&fed, &alone}) {
    std::sort(list->begin(), list->end(), by_error);
    rows.push_back((*list)[list->size() / 2]);
  }
}

std::vector<Row> sweep(const Options& options) {
  std::vector<Row> rows;
  Case base;
  base.seconds = 10.0;
  for (const double error : {0.0, 0.01, 0.05, 0.1}) {
    Case c = base;
    c.parameter_error = error;
    add_pair(rows, options,
             error > 0.0 ? "parameters " + host_sim::significant(100.0 * error) + " % off" : "exact parameters", c);
  }
  Case rough = base;
  rough.friction = true;
  if (declares_friction(options.robot)) add_pair(rows, options, "friction that the model lacks", rough);
  for (const int bits : {20, 16, 14, 12}) {
    Case c = base;
    c.encoder_bits = bits;
    add_pair(rows, options, "encoders of " + std::to_string(bits) + " bits", c);
  }
  for (const int delay : {1, 2, 5, 10}) {
    Case c = base;
    c.delay = delay;
    add_pair(rows, options, "torques " + std::to_string(delay) + " ms late", c);
  }
  return rows;
}

/// The motion with the image in the board's emulator, drawn and told.
Row in_loop(const Options& options, bool feeds_forward, host_sim::CsvFile& file) {
  Case situation;
  situation.robot = options.robot, situation.feeds_forward = feeds_forward;
  situation.seconds = feeds_forward ? options.seconds : std::min(options.seconds, seconds_alone);
  Row row{situation, options.board, options.number, "exact parameters", {}, 0.0};
  const auto controller = in_firmware(options.board, options.robot, options.number);
  std::size_t done = 0;
  host_sim::Progress progress(feeds_forward ? "with feed-forward" : "feedback alone",
                              static_cast<std::size_t>(std::lround(1000.0 * situation.seconds)));
  row.tracking = follow(situation, *controller,
                        [&](const host_sim::SetPoint& wanted, const JointState& joints, const link::Measurement&,
                            const link::Torque& answer) {
                          const std::vector<double>& q = joints.q;
                          progress.at(++done);
                          if (done > drawn_ticks) return;
                          file.cell(feeds_forward ? "feed-forward" : "feedback alone");
                          file.cell(static_cast<double>(done - 1) * 1e-3);
                          for (std::size_t i = 0; i < q.size(); ++i)
                            file.cell(wanted.q[i]), file.cell(wanted.q[i] - q[i], 5);
                          for (std::size_t i = 0; i < q.size(); ++i)
                            file.cell(static_cast<double>(answer.tau[i]));
                          file.end_row();
                        });
  return row;
}

/// The image against the same source on the host, both told the same; the largest difference in last places.
std::uint32_t compare(const Options& options) {
  const auto board = in_firmware(options.board, options.robot, options.number);
  const auto host = on_host(options.robot, options.number);
  Both both(*board, *host);
  Case situation;
  situation.robot = options.robot, situation.seconds = options.seconds, situation.encoder_bits = 20;
  follow(situation, both);
  return both.worst;
}

std::string micrometres(double metres) { return host_sim::significant(1e6 * metres, 3); }

void print(const std::vector<Row>& rows) {
  host_sim::Table table({"situation", "board", "loop", "tool RMS, um", "largest, um", "feedback alone / this"});
  for (const Row& r : rows)
    table.add({r.name, r.board, r.situation.feeds_forward ? "feed-forward" : "feedback alone",
               micrometres(r.tracking.tool_rms), micrometres(r.tracking.tool_largest),
               r.ratio > 0.0 ? host_sim::significant(r.ratio) : ""});
  std::printf("%s", table.text().c_str());
}

int measure(const Options& options) {
  host_sim::make_folder(options.output);
  const std::string stem =
      options.output + "/loop-" + options.robot + (options.number == "float" ? "" : "-" + options.number);
  std::vector<Row> rows;
  {
    std::vector<std::string> header{"loop", "time"};
    const std::size_t joints = cycle_of(options.robot).front().q.size();
    for (std::size_t i = 1; i <= joints; ++i)
      header.push_back("q" + std::to_string(i)), header.push_back("error" + std::to_string(i));
    for (std::size_t i = 1; i <= joints; ++i)
      header.push_back("torque" + std::to_string(i));
    host_sim::CsvFile file(stem + ".csv", header);
    rows.push_back(in_loop(options, true, file));
    rows.push_back(in_loop(options, false, file));
  }
  rows[0].ratio = rows[1].tracking.tool_rms / rows[0].tracking.tool_rms;
  if (options.sweep) {
    const auto more = sweep(options);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  print(rows);
  if (!options.provenance.empty()) host_sim::write_json(options.provenance, host_sim::provenance());
  host_sim::write_json(stem + ".json", to_json(rows));
  if (!options.json.empty()) host_sim::write_json(options.json, to_json(rows));
  host_sim::run_plot("loop.py", {stem + ".csv", stem + ".json"});
  std::printf("\npicture  %s.png\ndata     %s.csv, %s.json\n", stem.c_str(), stem.c_str(), stem.c_str());
  host_sim::Verdict verdict("loop");
  for (const Row& r : rows)
    expect_tracking(verdict, r);
  return verdict.status();
}

int check(const Options& options) {
  const std::uint32_t worst = compare(options), allowed = options.number == "float" ? most_places : 0;
  std::printf("%s, %s, %s: board and host differ by %u last places at most over %g s; allowed: %u\n",
              options.robot.c_str(), options.board.c_str(), options.number.c_str(), worst, options.seconds, allowed);
  return worst <= allowed ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  host_sim::CommandLine line("a closed loop with the firmware in it", "loop");
  line.option("--robot", options.robot,
              "scara, puma560, or whose joints share drives: scara_quill, palletiser, wrist_arm, gripper")
      .show_default();
  line.option("--board", options.board, "folder of hal/boards").show_default();
  line.option("--number", options.number, "float or fixed32").show_default();
  line.option("--seconds", options.seconds, "of motion").show_default().range(0.001, 3600.0);
  line.flag("--sweep", options.sweep, "besides, errors of parameters, encoders and time, on the host");
  line.flag("--check", options.check, "only hold the image to the same source on the host");
  line.option("--output", options.output, "folder of CSV, JSON and picture").show_default();
  line.option("--json", options.json, "one more copy of the figures");
  line.option("--provenance", options.provenance, "file for compilers, flags and commit");
  return line.run(count, arguments, [&] { return options.check ? check(options) : measure(options); });
}

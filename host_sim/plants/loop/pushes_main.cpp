// pushes: the regulator's image brings an arm back onto its motion, beside the tracking image in the same situations.
#include <host_sim/boards/on_board/provenance.hpp>
#include <host_sim/plants/loop/regulators.hpp>
#include <host_sim/plants/loop/verdicts.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace {

using namespace host_sim::loop;

constexpr double pushed_at = 0.5;  // s into the cycle, in motion
constexpr double watched = 1.5;    // s, of a push

struct Options {
  std::string robot = "puma560", board = "stm32f405", number = "float", output = "output/lqr", json, provenance;
  double seconds = 4.0;
  bool sweep = false, check = false;
};

std::unique_ptr<Controller> controller_of(const std::string& name, const std::string& board, const std::string& robot) {
  if (board == "host") return name == "lqr" ? regulator_on_host(robot) : on_host(robot, "float");
  return name == "lqr" ? regulator_in_firmware(board, robot) : in_firmware(board, robot, "float");
}

PushRow row_of(const std::string& controller, const std::string& board, const std::string& name, const Case& situation,
               const Watch& watch = {}) {
  const auto who = controller_of(controller, board, situation.robot);
  return {situation, controller, board, name, recover(situation, *who, watch)};
}

Case following(const Options& options, double seconds) {
  Case c;
  c.robot = options.robot, c.seconds = seconds;
  return c;
}

Case pushed(const Options& options, int joint, double start) {
  Case c = following(options, watched);
  c.start = start, c.push = push_of(options.robot, joint);
  return c;
}

/// In the board's emulator: the motion, and a push of every joint, which is drawn.
std::vector<PushRow> in_loop(const Options& options, const std::string& csv) {
  const Case push = pushed(options, -1, pushed_at);
  const std::size_t joints = push.push.size();
  std::vector<std::string> header{"controller", "time"};
  for (const char* what : {"error", "effort"})
    for (std::size_t i = 1; i <= joints; ++i)
      header.push_back(what + std::to_string(i));
  host_sim::CsvFile file(csv, header);
  const auto limits = effort_limits(options.robot);
  std::vector<PushRow> rows;
  for (const char* controller : {"lqr", "pd"}) {
    rows.push_back(row_of(controller, options.board, "the motion", following(options, options.seconds)));
    int ticks = 0;
    const auto draw = [&](const auto& wanted, const JointState& state, const auto&, const link::Torque& answer) {
      file.cell(controller), file.cell(static_cast<double>(ticks++) / ticks_a_second);
      for (std::size_t i = 0; i < joints; ++i)
        file.cell(state.q[i] - wanted.q[i], 5);
      for (std::size_t i = 0; i < joints; ++i)
        file.cell(static_cast<double>(answer.tau[i]) / limits[i], 5);
      file.end_row();
    };
    rows.push_back(row_of(controller, options.board, "every joint pushed", push, draw));
  }
  return rows;
}

/// The slowest to come back of pushes all along the motion.
PushRow worst_push(const Options& options, const std::string& controller, int joint) {
  std::vector<PushRow> all;
  for (double start = 0.0; start < 4.0; start += 0.25)
    all.push_back(row_of(controller, "host",
                         joint < 0 ? "every joint pushed, slowest of 16"
                                   : "joint " + std::to_string(joint + 1) + " pushed, slowest of 16",
                         pushed(options, joint, start)));
  return *std::max_element(all.begin(), all.end(),
                           [](const PushRow& a, const PushRow& b) { return a.recovery.seconds < b.recovery.seconds; });
}

std::vector<PushRow> sweep(const Options& options) {
  std::vector<PushRow> rows;
  const int joints = static_cast<int>(push_of(options.robot, -1).size());
  const Case base = following(options, 10.0);
  Case wrong = base, coarse = base, late = base, rough = base;
  wrong.parameter_error = 0.05, wrong.seed = 3, coarse.encoder_bits = 16, late.delay = 2, rough.friction = true;
  for (const char* controller : {"lqr", "pd"}) {
    for (int joint = -1; joint < joints; ++joint)
      rows.push_back(worst_push(options, controller, joint));
    rows.push_back(row_of(controller, "host", "parameters 5 % off", wrong));
    rows.push_back(row_of(controller, "host", "encoders of 16 bits", coarse));
    rows.push_back(row_of(controller, "host", "torques 2 ms late", late));
    if (declares_friction(options.robot))
      rows.push_back(row_of(controller, "host", "friction that the model lacks", rough));
  }
  return rows;
}

void print(const std::vector<PushRow>& rows) {
  host_sim::Table table({"situation", "torques by", "loop", "back within 1 mrad, s", "largest effort / limit",
                         "beyond, mrad", "tool RMS, um", "instructions"});
  for (const PushRow& r : rows)
    table.add({r.name, r.board, r.controller,
               r.situation.push.empty() ? "" : host_sim::significant(r.recovery.seconds, 3),
               host_sim::significant(r.recovery.effort, 3),
               r.situation.push.empty() ? "" : host_sim::significant(1e3 * r.recovery.overshoot, 2),
               host_sim::significant(1e6 * r.recovery.tracking.tool_rms, 3),
               r.board == "host" ? "" : std::to_string(r.recovery.most)});
  std::printf("%s", table.text().c_str());
}

int measure(const Options& options) {
  host_sim::make_folder(options.output);
  const std::string stem = options.output + "/lqr-" + options.robot;
  auto rows = in_loop(options, stem + ".csv");
  host_sim::Verdict verdict("pushes");
  verdict.expect(rows[0].recovery.tracking.tool_rms < rows[2].recovery.tracking.tool_rms,
                 "the regulator follows the motion less well than the tracking image");
  if (options.sweep) {
    const auto more = sweep(options);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  print(rows);
  if (!options.provenance.empty()) host_sim::write_json(options.provenance, host_sim::provenance());
  for (const std::string& path : {stem + ".json", options.json})
    if (!path.empty()) host_sim::write_json(path, to_json(rows));
  host_sim::run_plot("pushes.py", {stem + ".csv", stem + ".json"});
  std::printf("\npicture  %s.png\ndata     %s.csv, %s.json\n", stem.c_str(), stem.c_str(), stem.c_str());
  for (const PushRow& r : rows)
    expect_recovery(verdict, r);
  return verdict.status();
}

int check(const Options& options) {
  const auto board = regulator_in_firmware(options.board, options.robot);
  const auto host = regulator_on_host(options.robot);
  Both both(*board, *host);
  const Case situation = pushed(options, -1, pushed_at);
  const PushRow row{situation, "lqr", options.board, "every joint pushed", recover(situation, both)};
  std::printf(
      "%s on %s: back within %.3f s, %.2f of the largest effort, %u to %u instructions; board and host differ by %u "
      "last places at most\n",
      options.robot.c_str(), options.board.c_str(), row.recovery.seconds, row.recovery.effort, row.recovery.least,
      row.recovery.most, both.worst);
  host_sim::Verdict verdict("pushes");
  verdict.expect(both.worst == 0, "image and host differ");
  expect_recovery(verdict, row);
  return verdict.status();
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  host_sim::CommandLine line("a linear-quadratic regulator brings an arm back onto its motion", "pushes");
  line.option("--robot", options.robot, "scara, puma560 or wrist_arm").show_default();
  line.option("--board", options.board, "folder of hal/boards").one_of({"stm32f405"}).show_default();
  line.option("--number", options.number, "what the regulator computes in").one_of({"float"}).show_default();
  line.option("--seconds", options.seconds, "of the motion without a push").show_default().range(0.001, 3600.0);
  line.flag("--sweep", options.sweep,
            "besides, pushes of each joint all along the motion and wrong models, on the host");
  line.flag("--check", options.check, "only a push of every joint, the image held to the same source on the host");
  line.option("--output", options.output, "folder of CSV, JSON and picture").show_default();
  line.option("--json", options.json, "one more copy of the figures");
  line.option("--provenance", options.provenance, "file for compilers, flags and commit");
  return line.run(count, arguments, [&] { return options.check ? check(options) : measure(options); });
}

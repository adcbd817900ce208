// The host's side of ./axial demo and ./axial report --on-board.
#include <host_sim/demo/demo.hpp>
#include <host_sim/on_board/on_board.hpp>
#include <host_sim/output/program.hpp>

#include <CLI/CLI.hpp>

namespace {

/// Adds a verb whose run() gives the exit status.
template <class Options, class Run>
CLI::App* add_verb(CLI::App& app, const char* name, const char* text, const Options& options, int& status, Run run) {
  CLI::App* verb = app.add_subcommand(name, text);
  verb->callback([&status, &options, run] { status = run(options); });
  return verb;
}

void add_demo(CLI::App& app, host_sim::DemoOptions& options, int& status) {
  CLI::App* verb =
      add_verb(app, "demo", "streams a pick-and-place cycle to a board in QEMU", options, status, host_sim::run_demo);
  verb->add_option("--robot", options.robot, "name as in robots/README.md")->capture_default_str();
  verb->add_option("--board", options.board, "folder of hal/boards")->capture_default_str();
  verb->add_option("--number", options.number, "what the firmware computes in: float or fixed32")
      ->capture_default_str();
  verb->add_option("--trajectory", options.trajectory, "way-points (.json) or set-points (.csv)")
      ->check(CLI::ExistingFile);
  verb->add_option("--output", options.output, "folder of CSV, JSON and picture")->capture_default_str();
  verb->add_flag("--without-picture", options.without_picture, "data alone");
  verb->add_option("--json", options.json, "one more copy of the figures");
}

void add_on_board(CLI::App& app, host_sim::OnBoardOptions& options, int& status) {
  CLI::App* verb = add_verb(app, "on-board", "every kernel on the boards, against the oracle", options, status,
                            host_sim::run_on_board);
  verb->add_option("--robot", options.robot, "only this one");
  verb->add_option("--board", options.board, "only this one");
  verb->add_option("--output", options.output, "folder of CSV and JSON")->capture_default_str();
  verb->add_option("--json", options.json, "one more copy of the figures");
}

}  // namespace

int main(int count, char** arguments) {
  int status = 0;
  host_sim::DemoOptions demo;
  host_sim::OnBoardOptions on_board;
  CLI::App app("axial's host side: emulated boards, checked against the oracle", "host_sim");
  app.require_subcommand(1);
  add_demo(app, demo, status);
  add_on_board(app, on_board, status);
  return host_sim::run_program(app, count, arguments, [&] { return status; });
}

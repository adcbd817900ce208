// The host's side of ./axial demo and ./axial report --on-board.
#include <host_sim/boards/demo/demo.hpp>
#include <host_sim/boards/on_board/on_board.hpp>
#include <host_sim/tools/output/command_line.hpp>

namespace {

void add_demo(host_sim::CommandLine& line, host_sim::DemoOptions& options, int& status) {
  auto verb =
      line.verb("demo", "streams a pick-and-place cycle to an emulated board", [&] { status = run_demo(options); });
  verb.option("--robot", options.robot, "name as in robots/README.md").show_default();
  verb.option("--board", options.board, "folder of hal/boards").show_default();
  verb.option("--number", options.number, "what the firmware computes in: float or fixed32").show_default();
  verb.option("--trajectory", options.trajectory, "way-points (.json) or set-points (.csv)").existing_file();
  verb.option("--output", options.output, "folder of CSV, JSON and picture").show_default();
  verb.flag("--without-picture", options.without_picture, "data alone");
  verb.option("--json", options.json, "one more copy of the figures");
}

void add_on_board(host_sim::CommandLine& line, host_sim::OnBoardOptions& options, int& status) {
  auto verb =
      line.verb("on-board", "every kernel on the boards, against the oracle", [&] { status = run_on_board(options); });
  verb.option("--robot", options.robot, "only this one");
  verb.option("--board", options.board, "only this one");
  verb.option("--output", options.output, "folder of CSV and JSON").show_default();
  verb.option("--json", options.json, "one more copy of the figures");
}

}  // namespace

int main(int count, char** arguments) {
  int status = 0;
  host_sim::DemoOptions demo;
  host_sim::OnBoardOptions on_board;
  host_sim::CommandLine line("axial's host side: emulated boards, checked against the oracle", "host_sim");
  add_demo(line, demo, status);
  add_on_board(line, on_board, status);
  return line.run(count, arguments, [&] { return status; });
}

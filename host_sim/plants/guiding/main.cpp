// guiding: a hand guides an arm whose torques an image in QEMU computes, held to the same source on the host.
#include <host_sim/plants/guiding/guiding.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/verdict.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace {

using namespace host_sim;
using namespace host_sim::guiding;

constexpr std::uint32_t most_places = 8;  // of float: contraction and the order of sums differ between processors
constexpr double largest_force = 60.0;    // N
constexpr double largest_drift = 0.01;    // m
constexpr double largest_sag = 0.005;     // m

struct Options {
  std::string robot = "scara", board = "stm32f405", number = "float";
};

int judge(const Options& options) {
  const auto board = in_firmware(options.board, options.robot, options.number);
  const auto host = on_host(options.robot, options.number);
  loop::Both both(*board, *host);
  Session session;
  session.robot = options.robot;
  const Felt felt = guide(session, both);
  const auto steps = declared_steps(options.robot);
  bool slow = true;
  for (std::size_t i = 0; i < steps.size(); ++i)
    slow = slow && felt.steps[i] <= steps[i] * (1.0 + 1e-5);
  std::printf(
      "%s on %s, %s: the tool went %.3f m, the hand pulled %.1f N at most; let go, it drifted %.2f mm\n"
      "%ld answers of %u to %u instructions; largest difference from the host: %u last places\n",
      options.robot.c_str(), options.board.c_str(), options.number.c_str(), felt.way, felt.largest_force,
      1e3 * felt.drift, felt.answers, both.least, both.most, both.worst);
  Verdict verdict("guiding");
  verdict.expect(both.worst <= (loop::is_fixed(options.number) ? 0 : most_places), "image and host differ");
  verdict.expect(felt.refused == 0, "answers were refused");
  verdict.expect(slow, "an effort changed faster than declared");
  verdict.expect(felt.way > 0.1, "the hand did not move the arm");
  verdict.expect(felt.largest_force < largest_force, "the arm is heavy in the hand");
  verdict.expect(felt.drift < largest_drift && std::fabs(felt.sag) < largest_sag, "the arm does not float");
  verdict.expect(felt.held < largest_drift, "set-points do not hold the arm");
  return verdict.status();
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  CommandLine line("an arm with the firmware in it that a hand guides", "guiding");
  line.option("--robot", options.robot, "scara or puma560").show_default();
  line.option("--board", options.board, "folder of hal/boards").show_default();
  line.option("--number", options.number, "float or fixed32").show_default();
  return line.run(count, arguments, [&] { return judge(options); });
}

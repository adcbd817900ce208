/// The part that all probes of a robot share: runs the kernel on seeded states and prints the count of each. It
/// computes nothing at run time, so that whatever arithmetic a probe links (soft float above all) is the kernel's.

#include <board.hpp>
#include <robot.hpp>

#include <array>

#include <hal/text.hpp>

#include "../states.hpp"
#include "argument.hpp"

extern "C" void axial_kernel(void* argument);

namespace axial::apps::size {
namespace {

using hal::Board;

constexpr int states = 8;
constexpr std::uint32_t seed = 0x20240920;

constexpr Argument<Robot> next_argument(Random& random) {
  const auto state = next_state<Robot, float>(random);
  const auto any = [&] { return 0.5f * random.symmetric(); };
  const auto positive = [&] { return 1.0f + any(); };
  Argument<Robot> a{};
  a.q = state.q, a.qd = state.qd, a.qdd = state.qdd;
  for (int i = 0; i < joint_count<Robot>; ++i)
    a.tau[i] = 20.0f * any();
  const auto near = [&] { return 0.25f * any(); };  // within every robot's declared payload
  a.payload = {
      positive(), {near(), near(), near()}, {0.02f, 0.02f, 0.02f, 0.02f * any(), 0.02f * any(), 0.02f * any()}};
  const auto vector = [&] { return Vec3<float>{any(), any(), any()}; };
  a.tip_wrench = {vector(), vector()};
  a.gravity = vector();
  a.base_motion = {vector(), vector(), vector()};
  for (int i = 0; i < joint_count<Robot>; ++i) {
    a.wrenches[i] = {vector(), vector()};
    a.turns[i] = sincos(a.q[i]);
  }
  return a;
}

constexpr auto make_arguments() {
  Random random(seed);
  std::array<Argument<Robot>, states> all{};
  for (auto& a : all)
    a = next_argument(random);
  return all;
}

constexpr auto arguments = make_arguments();
Argument<Robot> argument{};

void print(const char* head, std::uint32_t value) {
  Board::print(head);
  Board::print(hal::decimal(value).text);
  Board::print("\n");
}

}  // namespace
}  // namespace axial::apps::size

int main() {
  using namespace axial::apps::size;
  Board::start();
  for (const auto& each : arguments) {
    argument = each;
    print("count,", Board::Counter::count(axial_kernel, &argument));
  }
  Board::print("end\n");
  Board::exit(0);
}

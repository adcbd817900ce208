/// The part that all probes of a robot share: runs the kernel on seeded states and prints the count of each. It
/// computes nothing at run time, so that whatever arithmetic a probe links (soft float above all) is the kernel's. One
/// for each type of numbers.

#include <board.hpp>
#include <robot.hpp>

#include <array>

#include <hal/text.hpp>

#include "../number_systems.hpp"
#include "../states.hpp"
#include "argument.hpp"

extern "C" void axial_kernel(void* argument);

namespace axial::apps::size {
namespace {

using hal::Board;

constexpr int states = 8;
constexpr std::uint32_t seed = 0x20240920;

using Number = number_systems::AXIAL_PROBE_NUMBERS::Number;
using Given = Argument<Robot, Number>;

/// What scenes need beyond the bare robot, which only probes in float have.
template <class T>
constexpr void add_loads(Argument<Robot, T>&, Random&) {}
constexpr void add_loads(Argument<Robot, float>& a, Random& random) {
  const auto any = [&] { return 0.5f * random.symmetric(); };
  const auto positive = [&] { return 1.0f + any(); };
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
}

constexpr Given next_argument(Random& random) {
  const auto state = next_state<Robot, float>(random);
  Joints<Robot, float> tau{};
  for (float& each : tau.values)
    each = 10.0f * random.symmetric();
  Given a{};
  a.q = nearest_positions<Robot, Number>(state.q);
  a.qd = nearest<Velocities<Robot, Number>>(state.qd);
  a.qdd = nearest<Accelerations<Robot, Number>>(state.qdd);
  a.tau = nearest<Efforts<Robot, Number>>(tau);
  add_loads(a, random);
  return a;
}

constexpr auto make_arguments() {
  Random random(seed);
  std::array<Given, states> all{};
  for (auto& a : all)
    a = next_argument(random);
  return all;
}

constexpr auto arguments = make_arguments();
Given argument{};

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

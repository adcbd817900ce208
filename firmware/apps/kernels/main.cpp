/// Measures every kernel of one robot on seeded states and prints each result bit by bit; README.md has the format.

#include <board.hpp>
#include <robot.hpp>

#include <cstring>
#include <string_view>

#include <hal/text.hpp>

#include "kernels.hpp"

namespace axial::apps::kernels {
namespace {

using hal::Board;

constexpr int states = 32;
constexpr std::uint32_t seed = 0x20240920;
/// All kernels of a long arm in soft double take 150 KiB.
constexpr bool has_room_for_double = Board::flash_bytes >= 256 * 1024;
constexpr bool has_closed_form = std::string_view(Robot::name) == "scara";

void print(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  Board::print(",");
  Board::print(hal::hex(bits).text);
}

[[maybe_unused]] void print(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  Board::print(",");
  Board::print(hal::hex(static_cast<std::uint32_t>(bits >> 32)).text);
  Board::print(hal::hex(static_cast<std::uint32_t>(bits)).text);
}

void print(const char* head, std::uint32_t value) {
  Board::print(head);
  Board::print(hal::decimal(value).text);
}

constexpr const char* name_of(float) { return "float"; }
constexpr const char* name_of(double) { return "double"; }

template <class T>
void print_state(int index, const MotionState<Robot, T>& state) {
  print("state,", static_cast<std::uint32_t>(index));
  const auto put = [](float value) { print(value); };
  for (const auto* values : {&state.q, &state.qd, &state.qdd})
    for (int i = 0; i < joint_count<Robot>; ++i)
      put(static_cast<float>((*values)[i]));
  Board::print("\n");
}

/// One row: kernel,robot,scalar,state,count,result bits. Returns the result for the kernels that need it.
template <class Kernel, class T>
auto measure(int index, const MotionState<Robot, T>& state, const Joints<Robot, T>& tau) {
  decltype(Kernel::run(state, tau)) result{};
  auto code = [&] { result = Kernel::run(state, tau); };
  const std::uint32_t count = Board::count(code);
  Board::print(Kernel::name);
  Board::print(",");
  Board::print(Robot::name);
  Board::print(",");
  Board::print(name_of(T{}));
  print(",", static_cast<std::uint32_t>(index));
  print(",", count);
  Kernel::write(result, [](T value) { print(value); });
  Board::print("\n");
  return result;
}

template <class T>
[[gnu::noinline]] void measure_all(int index, const MotionState<Robot, T>& state) {
  const auto tau = measure<InverseDynamics<Robot, T>>(index, state, {});
  measure<BiasTorque<Robot, T>>(index, state, tau);
  measure<GravityTorque<Robot, T>>(index, state, tau);
  measure<MassMatrixKernel<Robot, T>>(index, state, tau);
  measure<ForwardDynamicsKernel<Robot, T>>(index, state, tau);
  measure<ForwardKinematicsKernel<Robot, T>>(index, state, tau);
  measure<JacobianKernel<Robot, T>>(index, state, tau);
  if constexpr (has_closed_form) measure<ClosedForm<Robot, T>>(index, state, tau);
}

void print_head() {
  Board::print("board,");
  Board::print(Board::name);
  Board::print(Board::counter_scale().kind == hal::CounterKind::instructions ? ",instructions" : ",cycles");
  print(",", Board::empty_bracket());
  print("\nrobot,", joint_count<Robot>);
  Board::print("\n");
}

template <class T>
void run() {
  Random random(seed);
  for (int i = 0; i < states; ++i) {
    const auto state = next_state<Robot, T>(random);
    if constexpr (sizeof(T) == sizeof(float)) print_state(i, state);
    measure_all(i, state);
  }
}

}  // namespace
}  // namespace axial::apps::kernels

int main() {
  using namespace axial::apps::kernels;
  Board::start();
  print_head();
  run<float>();
  if constexpr (has_room_for_double) run<double>();
  print("stack,", Board::stack_used_bytes());
  Board::print("\nend\n");
  Board::exit(0);
}

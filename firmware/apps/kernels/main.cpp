/// Measures every kernel of one robot on seeded states and prints each result bit by bit; README.md has the format.

#include <board.hpp>
#include <robot.hpp>

#include <cstring>

#include <hal/text.hpp>

#include "corners.hpp"
#include "kernels.hpp"

namespace axial::apps::kernels {
namespace {

using hal::Board;

static_assert(joint_count<Robot> == AXIAL_JOINTS, "mend AXIAL_MATRIX_JOINTS in cmake/AxialMatrix.cmake");

constexpr int states = 32;
constexpr std::uint32_t seed = 0x20240920;
/// In soft float a state takes a hundred times as long, and its count depends on data anyway.
#ifdef __ARM_FP
constexpr int range_states = 10000;
#else
constexpr int range_states = 500;
#endif

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

/// One row: kernel,robot,scalar,state,count,result bits.
template <class T>
void measure(const Kernel& kernel, int index, Argument<T>& argument) {
  const std::uint32_t count = Board::Counter::count(kernel.code, &argument);
  Board::print(kernel.name);
  Board::print(",");
  Board::print(Robot::name);
  Board::print(",");
  Board::print(name_of(T{}));
  print(",", static_cast<std::uint32_t>(index));
  print(",", count);
  for (int i = 0; i < kernel.values; ++i) {
    T value;
    std::memcpy(&value, argument.result + static_cast<std::size_t>(i) * sizeof value, sizeof value);
    print(value);
  }
  Board::print("\n");
}

template <class T>
void measure_all(int index, const MotionState<Robot, T>& state) {
  Argument<T> argument{};
  argument.q = state.q, argument.qd = state.qd, argument.qdd = state.qdd;
  measure(Kernels<T>::torque(), index, argument);
  std::memcpy(&argument.tau, argument.result, sizeof argument.tau);
  Kernels<T>::for_each([&](const Kernel& kernel) { measure(kernel, index, argument); });
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

/// Least and most that a kernel costs over many states, some inside the limits, some at every corner of the number
/// system. Rows: range,<kernel>,<robot>,<states>,<least>,<most>.
void print_range(const Kernel& kernel) {
  Argument<float> argument{};
  Random random(seed);
  std::uint32_t least = ~0u, most = 0;
  for (int i = 0; i < range_states; ++i) {
    const auto [state, tau] = next_call<Robot>(random, i);
    argument.q = state.q, argument.qd = state.qd, argument.qdd = state.qdd, argument.tau = tau;
    const std::uint32_t count = Board::Counter::count(kernel.code, &argument);
    least = count < least ? count : least;
    most = count > most ? count : most;
  }
  Board::print("range,");
  Board::print(kernel.name);
  Board::print(",");
  Board::print(Robot::name);
  print(",", range_states);
  print(",", least);
  print(",", most);
  Board::print("\n");
}

void print_ranges() {
  print_range(Kernels<float>::torque());
  Kernels<float>::for_each(print_range);
  Kernels<float>::for_each_without_row(print_range);
}

}  // namespace
}  // namespace axial::apps::kernels

int main() {
  using namespace axial::apps::kernels;
  Board::start();
  print_head();
  run<float>();
  print_ranges();
#ifdef AXIAL_IN_DOUBLE
  run<double>();
#endif
  std::uint32_t stack_bytes = 0;
  while (!Board::measure_stack(stack_bytes)) {
  }
  print("stack,", stack_bytes);
  Board::print("\nend\n");
  Board::exit(0);
}

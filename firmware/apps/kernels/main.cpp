/// Measures every kernel of one robot on seeded states and prints each result bit by bit; README.md has the format.

#include <board.hpp>
#include <robot.hpp>

#include <cstring>
#include <string_view>

#include <hal/text.hpp>

#include "corners.hpp"
#include "kernels.hpp"

namespace axial::apps::kernels {
namespace {

using hal::Board;

constexpr int states = 32;
constexpr std::uint32_t seed = 0x20240920;
/// In soft float a state takes a hundred times as long, and its count depends on data anyway.
#ifdef __ARM_FP
constexpr int range_states = 10000;
#else
constexpr int range_states = 500;
#endif
/// All kernels in soft double take up to 33 KiB a joint (a Cortex-M0).
constexpr bool has_room_for_double =
    Board::flash_bytes >= 256 * 1024 && Board::flash_bytes >= 40 * 1024 * joint_count<Robot>;
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

template <class Kernel, class T>
using ResultOf = decltype(Kernel::run(MotionState<Robot, T>{}, Joints<Robot, T>{}));

/// What a kernel costs. Not inlined: one copy of the kernel in the image.
template <class Kernel, class T>
[[gnu::noinline]] std::uint32_t count_of(const MotionState<Robot, T>& state, const Joints<Robot, T>& tau,
                                         ResultOf<Kernel, T>& result) {
  auto code = [&] { result = Kernel::run(state, tau); };
  return Board::count(code);
}

/// One row: kernel,robot,scalar,state,count,result bits. Returns the result for the kernels that need it.
template <class Kernel, class T>
auto measure(int index, const MotionState<Robot, T>& state, const Joints<Robot, T>& tau) {
  ResultOf<Kernel, T> result{};
  const std::uint32_t count = count_of<Kernel, T>(state, tau, result);
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
  measure<SeparationKernel<Robot, T>>(index, state, tau);
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

/// Least and most that a kernel costs over many states, some inside the limits, some at every corner of the number
/// system. Rows: range,<kernel>,<robot>,<states>,<least>,<most>.
template <class Kernel>
void print_range() {
  Random random(seed);
  ResultOf<Kernel, float> result{};
  std::uint32_t least = ~0u, most = 0;
  for (int i = 0; i < range_states; ++i) {
    const auto [state, tau] = next_call<Robot>(random, i);
    const std::uint32_t count = count_of<Kernel, float>(state, tau, result);
    least = count < least ? count : least;
    most = count > most ? count : most;
  }
  Board::print("range,");
  Board::print(Kernel::name);
  Board::print(",");
  Board::print(Robot::name);
  print(",", range_states);
  print(",", least);
  print(",", most);
  Board::print("\n");
}

/// Nothing for the route that forward dynamics takes by itself: it has its row.
template <class Tag>
void print_range_of_route() {
  if constexpr (forward_dynamics_route<Scene<Robot, Tag>> != forward_dynamics_route<Robot>)
    print_range<ForwardDynamicsBy<Robot, Tag>>();
}

void print_ranges() {
  print_range<InverseDynamics<Robot, float>>();
  print_range<SeparationKernel<Robot, float>>();
  print_range<BiasTorque<Robot, float>>();
  print_range<GravityTorque<Robot, float>>();
  print_range<MassMatrixKernel<Robot, float>>();
  print_range<ForwardDynamicsKernel<Robot, float>>();
  print_range_of_route<ArticulatedBody>();
  print_range_of_route<SplitArticulatedBody>();
  print_range_of_route<CompositeBody>();
  print_range<ForwardKinematicsKernel<Robot, float>>();
  print_range<JacobianKernel<Robot, float>>();
  if constexpr (has_closed_form) print_range<ClosedForm<Robot, float>>();
}

}  // namespace
}  // namespace axial::apps::kernels

int main() {
  using namespace axial::apps::kernels;
  Board::start();
  print_head();
  run<float>();
  print_ranges();
  if constexpr (has_room_for_double) run<double>();
  print("stack,", Board::stack_used_bytes());
  Board::print("\nend\n");
  Board::exit(0);
}

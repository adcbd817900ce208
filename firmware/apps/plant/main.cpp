/// Integrates a robot, open loop, by the efforts that the host wrote into the image (input.hpp); prints states and what a
/// step cost. README.md has the format.

#include <robot.hpp>

#include <board.hpp>

#include <hal/text.hpp>

#include "input.hpp"

extern "C" {
extern const std::uint32_t axial_plant_input[axial::apps::plant::input_words<axial::apps::Robot>];
void axial_plant_semi_implicit(void* plant);
void axial_plant_runge_kutta_4(void* plant);
}

namespace {

using namespace axial;
using namespace axial::apps::plant;
using apps::Robot;
using hal::Board;
using Number = AXIAL_NUMBER;
using Step = StepOf<SceneOf<Robot>, Number>;
constexpr int joints = joint_count<Robot>;

struct Plant {
  MotionOf<Robot, Number> x{};
  Held<SceneOf<Robot>, Number> held{};
  Step h = step_of<Robot, Number>[0];
  Status status{};

  template <class Method>
  void move() {
    status = advance<Method>(x, h, held);
  }
};
Plant plant{};

std::uint32_t read(std::uint32_t word) { return axial_plant_input[word]; }

void take_start() {
  std::uint32_t at = head_words;
  each_word(plant.x, [&](auto& value) { put_word(value, read(at++)); });
  plant.h = step_of<Robot, Number>[read(step_choice)];
}

/// Efforts of a tick; the last that there are from then on.
void take_efforts(std::uint32_t tick) {
  const std::uint32_t ticks = read(effort_ticks), held = tick < ticks ? tick : ticks - 1;
  if (ticks == 0) return;
  for (int i = 0; i < joints; ++i)
    put_word(plant.held.tau[i], read(head_words + state_words<Robot> +
                                     held * static_cast<std::uint32_t>(joints) + static_cast<std::uint32_t>(i)));
}

void print_number(std::uint32_t number) { Board::print(","), Board::print(hal::decimal(number).text); }

void report(std::uint32_t count) {
  Board::print("count"), print_number(count);
  Board::print("\nstate"), print_number(static_cast<std::uint32_t>(plant.x.steps));
  each_word(plant.x, [](const auto& value) { Board::print(","), Board::print(hal::hex(word_of(value)).text); });
  Board::print("\n");
}

void run() {
  const auto kernel = read(method) == 0 ? axial_plant_semi_implicit : axial_plant_runge_kutta_4;
  const auto per_tick = static_cast<std::uint32_t>(steps_per_tick[read(step_choice)]);
  std::uint32_t least = ~0U, most = 0;
  for (std::uint32_t k = 0, of_tick = 0, tick = 0; k < read(steps); ++k) {
    if (of_tick == 0) take_efforts(tick++);
    of_tick = of_tick + 1 == per_tick ? 0 : of_tick + 1;
    const std::uint32_t count = Board::Counter::count(kernel, &plant);
    least = count < least ? count : least, most = count > most ? count : most;
    if ((k + 1) % read(report_every) == 0) report(count);
  }
  Board::print("steps"), print_number(static_cast<std::uint32_t>(plant.x.steps));
  print_number(least), print_number(most);
  Board::print("\n");
}

}  // namespace

void axial_plant_semi_implicit(void* one) { static_cast<Plant*>(one)->move<SemiImplicitEuler>(); }
void axial_plant_runge_kutta_4(void* one) { static_cast<Plant*>(one)->move<RungeKutta4>(); }

int main() {
  Board::start();
  for (const char* text : {"plant,", Robot::name, ",", Board::name, "\n"})
    Board::print(text);
  take_start();
  run();
  Board::print("end\n");
  Board::exit(0);
}

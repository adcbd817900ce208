/// One image a robot and number system; the build defines AXIAL_NUMBER.

#include <robot.hpp>

#include <board.hpp>

#include "plant.hpp"

extern "C" {
extern const std::uint32_t axial_plant_input[axial::apps::plant::input_words<axial::apps::Robot>];
void axial_plant_semi_implicit(void* plant);
void axial_plant_runge_kutta_4(void* plant);
}

namespace {
using axial::hal::Board;
using Plant = axial::apps::plant::Plant<Board, axial::apps::Robot, AXIAL_NUMBER>;
Plant plant(axial_plant_input);
}  // namespace

void axial_plant_semi_implicit(void* one) { static_cast<Plant*>(one)->move<axial::SemiImplicitEuler>(); }
void axial_plant_runge_kutta_4(void* one) { static_cast<Plant*>(one)->move<axial::RungeKutta4>(); }

int main() {
  Board::start();
  for (const char* text : {"plant,", axial::apps::Robot::name, ",", Board::name, "\n"})
    Board::print(text);
  plant.run(axial_plant_semi_implicit, axial_plant_runge_kutta_4);
  Board::print("end\n");
  Board::exit(0);
}

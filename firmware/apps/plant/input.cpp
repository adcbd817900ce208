/// Apart from the program, whose compiler must not know that these words are 0.

#include <robot.hpp>

#include "input.hpp"

extern "C" {
extern const std::uint32_t axial_plant_input[axial::apps::plant::input_words<axial::apps::Robot>];
const std::uint32_t axial_plant_input[axial::apps::plant::input_words<axial::apps::Robot>] = {};
}

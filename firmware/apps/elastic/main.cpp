/// One image a robot, as tracking/main.cpp, for an arm behind harmonic drives of 12 Hz.

#include <board.hpp>
#include <robot.hpp>

#include <firmware/apps/feedforward/feedforward.hpp>

#include "controller.hpp"

namespace {
using Arm = axial::apps::Elastic<axial::apps::Robot, 12>;
axial::apps::Feedforward<axial::hal::Board, axial::apps::ElasticController<Arm>, false> app;
}  // namespace

int main() {
  app.start();
  for (;;)
    app.step();
}

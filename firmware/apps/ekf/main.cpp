/// One image a robot, as tracking/main.cpp, with an extended Kalman filter in the loop.

#include <board.hpp>
#include <robot.hpp>

#include <firmware/apps/feedforward/feedforward.hpp>

#include "controller.hpp"

namespace {
axial::apps::Feedforward<axial::hal::Board, axial::apps::EkfController<axial::apps::Robot>, false> app;
}

int main() {
  app.start();
  for (;;)
    app.step();
}

/// One image a robot and number system, as feedforward/main.cpp; a hand guides the arm, or it follows set-points.

#include <board.hpp>
#include <robot.hpp>

#include <firmware/apps/feedforward/feedforward.hpp>

#include "controller.hpp"

namespace {
axial::apps::Feedforward<axial::hal::Board, axial::apps::HandGuidingController<axial::apps::Robot, AXIAL_NUMBER>,
                         AXIAL_INJECTION>
    app;
}

int main() {
  app.start();
  for (;;)
    app.step();
}

/// One image a robot and number system, as feedforward/main.cpp; besides, it takes measurements and closes the loop.

#include <board.hpp>
#include <robot.hpp>

#include <firmware/apps/feedforward/feedforward.hpp>

#include "controller.hpp"

namespace {
axial::apps::Feedforward<axial::hal::Board, axial::apps::TrackingController<axial::apps::Robot, AXIAL_NUMBER>,
                         AXIAL_INJECTION>
    app;
}

int main() {
  app.start();
  for (;;)
    app.step();
}

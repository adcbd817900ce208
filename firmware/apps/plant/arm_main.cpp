/// An arm on the link: one image a robot and number system; the build defines AXIAL_NUMBER and AXIAL_INJECTION.

#include <robot.hpp>

#include <board.hpp>

#include <firmware/apps/feedforward/feedforward.hpp>

#include "arm.hpp"

namespace {
axial::apps::Feedforward<axial::hal::Board, axial::apps::plant::Arm<axial::apps::Robot, AXIAL_NUMBER>, AXIAL_INJECTION>
    app;
}

int main() {
  app.start();
  for (;;)
    app.step();
}

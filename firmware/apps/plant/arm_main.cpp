/// An arm on the link: one image a robot and number system; the build defines AXIAL_NUMBER and AXIAL_INJECTION.

#include <robot.hpp>

#include <board.hpp>

#include <firmware/apps/feedforward/feedforward.hpp>

#include "arm.hpp"

namespace {
using Board = axial::hal::Board;
using Worker = axial::apps::plant::WorkerOf<Board>;
axial::apps::Feedforward<Board, axial::apps::plant::Arm<axial::apps::Robot, AXIAL_NUMBER, 1, Worker>, AXIAL_INJECTION>
    app;
}  // namespace

int main() {
  app.start();
  Worker::start();
  for (;;) {
    app.step();
    if (!Worker::stack_intact()) Board::fail(axial::hal::ResetCause::stack_overflow);
  }
}

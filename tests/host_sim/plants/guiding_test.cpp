// Hand guiding in the loop with a plant, a hand and the image's own source on the host: what the hand feels. In QEMU:
// host_sim.Guiding.*; faults: guiding_faults_test.cpp.
#include <host_sim/plants/guiding/guiding.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace host_sim::guiding;

namespace {

Felt felt(const std::string& robot, const std::string& number, double gripper = 1.0) {
  Session session;
  session.robot = robot, session.gripper = gripper;
  const auto controller = on_host(robot, number);
  return guide(session, *controller);
}

}  // namespace

TEST(Guiding, AHandMovesTheArmAndTheArmStaysWhereItIsLeft) {
  for (const std::string& robot : host_sim::guiding::robots())
    for (const char* number : {"float", "fixed32"}) {
      SCOPED_TRACE(robot + ", " + number);
      const Felt f = felt(robot, number);
      std::printf(
          "%s, %s: way %.3f m, force %.1f N, behind the hand %.3f m, drift %.2f mm, held %.2f mm, sag %.2f mm\n",
          robot.c_str(), number, f.way, f.largest_force, f.followed, 1e3 * f.drift, 1e3 * f.held, 1e3 * f.sag);
      EXPECT_EQ(f.refused, 0);
      EXPECT_GT(f.way, 0.1);
      EXPECT_LT(f.largest_force, 60.0);
      EXPECT_LT(f.drift, 0.01);
      EXPECT_LT(f.held, 0.01);
      EXPECT_LT(std::fabs(f.sag), 0.005);
    }
}

TEST(Guiding, NoEffortChangesFasterThanDeclared) {
  for (const std::string& robot : host_sim::guiding::robots())
    for (const char* number : {"float", "fixed32"}) {
      const Felt f = felt(robot, number);
      const auto declared = declared_steps(robot);
      double nearest = 0.0;
      for (std::size_t i = 0; i < declared.size(); ++i) {
        EXPECT_LE(f.steps[i], declared[i] * (1.0 + 1e-5)) << robot << ", " << number << ", joint " << i;
        nearest = std::fmax(nearest, f.steps[i] / declared[i]);
      }
      EXPECT_GT(nearest, 0.99) << "the first torque comes up as fast as it may";
    }
}

// What the model does not know the hand has to carry, or the arm sinks.
TEST(Guiding, AGripperThatTheModelDoesNotKnowSinks) {
  const Felt known = felt("scara", "float"), heavy = felt("scara", "float", 3.0);
  EXPECT_GT(heavy.drift, 10.0 * known.drift);
  EXPECT_GT(heavy.drift, 0.01);
}

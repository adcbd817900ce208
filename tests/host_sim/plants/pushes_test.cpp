// The regulator in a loop with a plant, on the host: it brings arms back from wherever they were pushed to. The image
// is held to the same source, bit by bit, by `pushes --check` (host_sim.Pushes.*).
#include <host_sim/plants/loop/pushes.hpp>
#include <host_sim/plants/loop/regulators.hpp>

#include <gtest/gtest.h>

#include <cstdio>

using namespace host_sim::loop;

namespace {

Recovery after(const std::string& robot, int joint, double start) {
  Case c;
  c.robot = robot, c.seconds = 1.0, c.start = start, c.push = push_of(robot, joint);
  const auto controller = regulator_on_host(robot);
  return recover(c, *controller);
}

void expect_back(const Recovery& r) {
  EXPECT_EQ(r.tracking.refused, 0);
  EXPECT_GT(r.seconds, 0.05);
  EXPECT_LT(r.seconds, 0.5);
  EXPECT_LE(r.effort, 1.0 + 1e-6);
}

}  // namespace

TEST(Pushes, AnArmComesBackWhereverItsMotionIs) {
  for (const std::string& robot : robots_of_single_drives())
    for (double start = 0.0; start < 3.0; start += 0.5) {
      SCOPED_TRACE(robot + ", " + std::to_string(start));
      expect_back(after(robot, -1, start));
    }
}

TEST(Pushes, AJointComesBackAndDisturbsTheOthersLittle) {
  for (const std::string& robot : robots_of_single_drives())
    for (int joint = 0; joint < static_cast<int>(push_of(robot, -1).size()); ++joint) {
      SCOPED_TRACE(robot + ", joint " + std::to_string(joint));
      const Recovery r = after(robot, joint, 0.5);
      std::printf("%s, joint %d: back in %.3f s, %.4f rad beyond\n", robot.c_str(), joint + 1, r.seconds, r.overshoot);
      expect_back(r);
      EXPECT_LT(r.overshoot, 0.3 * push_rad);
    }
}

TEST(Pushes, TheRegulatorFollowsAtLeastAsWellAsTheTrackingImage) {
  for (const std::string& robot : robots_of_single_drives())
    for (const double wrong : {0.0, 0.05}) {
      Case c;
      c.robot = robot, c.seconds = 4.0, c.parameter_error = wrong, c.seed = 3;
      const auto lqr = regulator_on_host(robot), pd = on_host(robot, "float");
      EXPECT_LT(follow(c, *lqr).tool_rms, follow(c, *pd).tool_rms) << robot << ", " << wrong;
    }
}

TEST(Pushes, SaysWhatItDoesNotKnow) { EXPECT_THROW(regulator_on_host("panda"), std::runtime_error); }

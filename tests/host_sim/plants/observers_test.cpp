// The loop around an extended Kalman filter, on the host: what it knows of velocities, and what that is worth. The
// image is held to the same source, bit by bit, by `observers --check` (host_sim.Observers.*).
#include <host_sim/plants/loop/observers.hpp>

#include <gtest/gtest.h>

#include <cstdio>

using namespace host_sim::loop;

namespace {

Case noisy(const std::string& robot) {
  Case c;
  c.robot = robot, c.seconds = 3.0, c.encoder_bits = 14, c.encoder_noise = 1.0;
  return c;
}

}  // namespace

TEST(Observers, VelocitiesAreBetterThanDifferences) {
  for (const std::string& robot : robots_of_single_drives())
    for (const double wrong : {0.0, 0.05}) {
      Case c = noisy(robot);
      c.parameter_error = wrong, c.seed = 3;
      const auto observer = observer_on_host(robot);
      const VelocityErrors e = observe(c, *observer);
      EXPECT_EQ(e.tracking.refused, 0);
      for (std::size_t i = 0; i < e.filter.size(); ++i) {
        std::printf("%s, joint %zu: %.4f, differences %.4f, of ten ticks %.4f\n", robot.c_str(), i + 1, e.filter[i],
                    e.difference[i], e.slow[i]);
        EXPECT_LT(10.0 * e.filter[i], e.difference[i]);
        EXPECT_LT(2.0 * e.filter[i], e.slow[i]);
      }
    }
}

TEST(Observers, NoiseReachesTheTorqueLess) {
  for (const std::string& robot : robots_of_single_drives()) {
    const auto observer = observer_on_host(robot);
    const auto pd = on_host(robot, "float");
    const VelocityErrors filtered = observe(noisy(robot), *observer), differenced = observe(noisy(robot), *pd);
    EXPECT_LT(20.0 * filtered.chatter, differenced.chatter) << robot;
    EXPECT_LT(2.0 * filtered.tracking.tool_rms, differenced.tracking.tool_rms) << robot;
  }
}

TEST(Observers, SaysWhatItDoesNotKnow) { EXPECT_THROW(observer_on_host("panda"), std::runtime_error); }

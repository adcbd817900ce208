#include "closed_loop.hpp"

#include <gtest/gtest.h>
#include <host_sim/robots/trajectory/files.hpp>

#include <cstdio>

using namespace closed_loop;

namespace {

constexpr double seconds = 60.0;
constexpr double agreement = 0.01;

host_sim::Trajectory pick_and_place() {
  std::vector<host_sim::JointLimits> limits;
  for (const axial::LinkParameters& p : Arm::chain.links)
    limits.push_back({p.position_min, p.position_max, p.speed_limit, p.acceleration_limit});
  return host_sim::load_trajectory(AXIAL_ROOT "/host_sim/robots/trajectories/scara.json", "scara", limits);
}

void print(const char* plant, const char* controller, const PerJoint<Tracking>& t) {
  std::printf("  %-24s %-16s", plant, controller);
  for (int i = 0; i < joints; ++i)
    std::printf("  joint %d: RMS %.5e largest %.5e %s", i + 1, t[i].rms(), t[i].largest, i < 2 ? "rad" : "m");
  std::printf("\n");
}

void expect_equal(const PerJoint<Tracking>& found, const PerJoint<Tracking>& wanted) {
  for (int i = 0; i < joints; ++i) {
    EXPECT_NEAR(found[i].rms() / wanted[i].rms(), 1.0, agreement) << i;
    EXPECT_NEAR(found[i].largest / wanted[i].largest, 1.0, agreement) << i;
  }
}

template <class Scene>
void compare(const char* name, const axial::Inputs<Scene, double>& in) {
  const auto cycle = pick_and_place();
  DoubleController in_double, without(false);
  FixedController<axial::Fixed32> in_fixed;
  const auto wanted = follow<Scene>(cycle, seconds, in_double, in);
  const auto found = follow<Scene>(cycle, seconds, in_fixed, in);
  const auto alone = follow<Scene>(cycle, seconds / 10, without, in);
  EXPECT_TRUE(in_double.all_ok());
  EXPECT_TRUE(in_fixed.all_ok());
  print(name, "double", wanted);
  print(name, "fixed32", found);
  print(name, "PD and weight", alone);
  expect_equal(found, wanted);
  for (int i = 0; i < joints; ++i)
    EXPECT_GT(alone[i].rms(), 1.02 * wanted[i].rms()) << "the comparison sees what is fed forward";
}

}  // namespace

TEST(ClosedLoop, FixedPointTracksAsDoubleDoes) { compare<Arm>("as modelled", {}); }

TEST(ClosedLoop, LikewiseWithALoadThatTheModelDoesNotKnow) {
  using Loaded = axial::Scene<Arm, axial::Gravity, axial::RotorInertia, axial::Payload>;
  axial::Inputs<Loaded, double> in;
  in.payload = {0.5, {0.0, 0.02, 0.05}, {0.001, 0.001, 0.001, 0.0, 0.0, 0.0}};
  compare<Loaded>("0.5 kg more", in);
}

// Two plants in the lanes of a batch move as each does alone, each under its own efforts, noise and payload.
#include <gtest/gtest.h>
#include <host_sim/plants/collide/arm.hpp>
#include <host_sim/plants/collide/robot.hpp>

#include <cmath>

namespace {

using host_sim::collide::Known, host_sim::collide::Moving;
using Mover = host_sim::collide::Arm<Known, Moving, axial::Scene<Known, axial::Gravity, axial::Friction>,
                                     axial::Scene<Moving, axial::Gravity, axial::Friction, axial::Payload>>;

#ifdef FP_FAST_FMA
constexpr double rounding = 1e-7;  // rad: products that are fused in one may move a count of an encoder
#else
constexpr double rounding = 1e-12;  // rad: the same operations
#endif
constexpr double moved = 1e-3;  // rad: what is told apart has moved on by far more

void expect_same(const Mover& one, const Mover& other, double most) {
  for (int i = 0; i < Mover::joints; ++i)
    EXPECT_NEAR(one.positions()[i], other.positions()[i], most) << i;
}
double distance(const Mover& one, const Mover& other) {
  double largest = 0.0;
  for (int i = 0; i < Mover::joints; ++i)
    largest = std::fmax(largest, std::fabs(one.positions()[i] - other.positions()[i]));
  return largest;
}

}  // namespace

TEST(Plants, InLanesMoveAsEachAlone) {
  Mover alone[] = {Mover(3), Mover(4)}, together[] = {Mover(3), Mover(4)}, bare(4);
  Mover::Inputs in[2];
  in[0].payload = {1.0, {0.05, -0.03, 0.15}, {0.002, 0.003, 0.004, 0.0005, -0.0002, 0.0001}};
  in[1].payload = {3.0, {-0.02, 0.04, 0.1}, {0.02, 0.01, 0.015, -0.001, 0.0004, 0.002}};
  Mover::Values external[2] = {};
  external[0][1] = 5.0, external[1][5] = -1.0;
  for (int tick = 0; tick < 300; ++tick) {
    for (int k = 0; k < 2; ++k) {
      const auto& m = alone[k].measure();
      const auto& n = together[k].measure();
      for (int i = 0; i < Mover::joints; ++i)
        ASSERT_NEAR(m.tau[i], n.tau[i], 5e4 * rounding) << tick;
      alone[k].move(external[k], in[k]);
    }
    bare.measure(), bare.move({});
    Mover::move_both(together, external, in);
  }
  for (int k = 0; k < 2; ++k)
    expect_same(alone[k], together[k], rounding);
  EXPECT_GT(distance(alone[0], alone[1]), moved);
  EXPECT_GT(distance(alone[1], bare), moved);  // payload and external effort matter
}

// doc/guides/conventions.md, doc/guides/two_boards.md, doc/guides/trees.md, doc/guides/moving_base.md,
// doc/guides/fixed_point.md: robots and number systems as documents write them.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <axial/robot/classical.hpp>
#include <cmath>
#include <firmware/apps/plant/arm.hpp>
#include <robots/puma560.hpp>

namespace {

constexpr double a1 = 0.3, a2 = 0.25, m1 = 2.0, m2 = 1.5, m3 = 0.5, L = 0.2;
constexpr double rod1 = m1 * a1 * a1 / 12.0, rod2 = m2 * a2 * a2 / 12.0, rod3 = m3 * L * L / 12.0;

namespace classical {
#include "conventions-1.inc"
}  // namespace classical

namespace tree {
#include "trees-1.inc"
}  // namespace tree

TEST(Conventions, AClassicalTableIsARobot) {
  const axial::Joints<classical::Scara, double> q{0.4, -0.7, 0.1}, still{};
  const auto tau = axial::inverse_dynamics<classical::Scara>(q, still, still);
  EXPECT_NEAR(tau[0], 0.0, 1e-12);
  EXPECT_NEAR(std::abs(tau[2]), m3 * 9.81, 1e-12);
}

TEST(Trees, BranchesPullOnTheWaist) {
  const axial::Joints<tree::TwoArms, double> q{}, qd{}, qdd{0.0, 1.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(axial::joint_count<tree::TwoArms>, 5);
  EXPECT_TRUE(
      axial::forward_dynamics<tree::TwoArms>(q, qd, axial::inverse_dynamics<tree::TwoArms>(q, qd, qdd)).status.ok());
}

namespace base {
#include "moving_base-1.inc"
}  // namespace base

TEST(MovingBase, ThrustersLiftIt) {
  using base::Flight;
  const axial::Joints<base::Manipulator, float> q{}, qd{}, tau{};
#include "moving_base-2.inc"
  EXPECT_TRUE(a.status.ok());
  EXPECT_GT(a.base_acceleration.linear.z, -9.81F);
}

namespace two_boards {
struct MyArm {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, 0.0, -9.81), axial::payload_limit(2.0, 0.2, 0.1),
                                             axial::revolute()
                                                 .mass(2.0)
                                                 .inertia_com(0.1, 0.1, 0.1)
                                                 .coulomb(1.0)
                                                 .position_limits(-1.0, 1.0)
                                                 .speed_limit(2.0)
                                                 .effort_limit(9.0),
                                             axial::revolute()
                                                 .a(0.3)
                                                 .mass(1.0)
                                                 .inertia_com(0.1, 0.1, 0.1)
                                                 .coulomb(1.0)
                                                 .position_limits(-1.0, 1.0)
                                                 .speed_limit(2.0)
                                                 .effort_limit(9.0));
};
#include "two_boards-1.inc"
}  // namespace two_boards

TEST(TwoBoards, AnArmHasWhatItsHeaderNames) {
  using Mechanics = axial::apps::plant::MechanicsOf<two_boards::WornArm>;
  static_assert(axial::apps::plant::has_friction<Mechanics> && axial::apps::plant::has_stops<Mechanics>);
  static_assert(axial::apps::plant::has_backlash<Mechanics> && axial::apps::plant::encoder_bits<Mechanics> == 17);
  static_assert(axial::apps::plant::has_noise<Mechanics> && axial::apps::plant::encoder_delay<Mechanics> == 1);
  axial::apps::plant::Arm<two_boards::WornArm, float> arm;
  arm.choose(axial::hal::link::Mode::lock_step, 1000);
  ASSERT_TRUE(arm.command({2, {0.5F, -0.5F}, 0}));
  for (int k = 0; k < 100; ++k) {
    arm.pass(1), arm.load({2, {0.2F, -0.9F}, 0, 0, 0, 0, 1});  // and 0.7 N m of noise at most
    arm.compute();
  }
  EXPECT_EQ(arm.state().q[0], 0.5F) << "it sticks";
  EXPECT_TRUE(arm.carry({1.5F, {0.1F, 0.0F, 0.0F}, {}}));
  EXPECT_FALSE(arm.carry({2.5F, {}, {}})) << "beyond what it declares";
}

TEST(FixedPoint, WordsGiveATorque) {
#include "fixed_point-1.inc"
  EXPECT_GT(std::abs(tau[1].raw), 0);
}

}  // namespace

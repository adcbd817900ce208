// Arms whose links stand behind springs: two bodies by their closed form, springs that a weight bends, and an arm so
// stiff that it is rigid.

#include <cmath>

#include "arm_fixture.hpp"

namespace axial::apps {
namespace {

constexpr double rotor = 0.75, link_inertia = 0.5, spring = 640.0;
/// A motor and a wheel, and a spring between them.
struct Wheel : robots::Scara {
  static constexpr const char* name = "wheel";
  static constexpr auto chain = axial::chain(axial::gravity(0.0, 0.0, 0.0), axial::revolute()
                                                                                .mass(1.0)
                                                                                .inertia_com(0.3, 0.3, link_inertia)
                                                                                .rotor_inertia(rotor)
                                                                                .stiffness(spring)
                                                                                .position_limits(-3.0, 3.0)
                                                                                .speed_limit(5.0)
                                                                                .acceleration_limit(50.0)
                                                                                .effort_limit(100.0));
  struct Mechanics {
    static constexpr bool elastic = true;
  };
};
using ElasticWheel = ArmApp<Wheel, float>;

/// An arm in a vertical plane, its first joint rigid, its second one elastic with friction on the motor, a slide.
template <int stiffness, bool is_elastic>
struct Upright : robots::Scara {
  static constexpr const char* name = "upright";
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.8125, 0.0),
                                             axial::revolute()
                                                 .mass(4.0)
                                                 .com(0.1875, 0.0, 0.0)
                                                 .inertia_com(0.0, 0.05, 0.05)
                                                 .rotor_inertia(1e-4, 50.0)
                                                 .position_limits(-2.5, 2.5)
                                                 .speed_limit(4.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(80.0),
                                             axial::revolute()
                                                 .a(0.375)
                                                 .mass(2.5)
                                                 .com(0.15, 0.0, 0.0)
                                                 .inertia_com(0.0, 0.02, 0.02)
                                                 .rotor_inertia(1e-4, 50.0)
                                                 .stiffness(stiffness)
                                                 .position_limits(-2.6, 2.6)
                                                 .speed_limit(5.0)
                                                 .acceleration_limit(30.0)
                                                 .effort_limit(25.0)
                                                 .coulomb(1.0),
                                             axial::prismatic()
                                                 .a(0.3125)
                                                 .alpha_deg(180)
                                                 .mass(1.25)
                                                 .rotor_inertia(0.5)
                                                 .position_limits(0.0, 0.25)
                                                 .speed_limit(1.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(30.0));
  struct Mechanics {
    static constexpr bool friction = true, elastic = is_elastic;
  };
};
using Soft = Upright<2000, true>;
using ElasticArm = ArmApp<Soft, float>;

// What is refused: a spring in front of nothing, two springs about one link.
struct WithoutMotor {
  static constexpr auto chain =
      axial::chain(axial::gravity(0.0, 0.0, 0.0), axial::revolute().mass(1.0).stiffness(spring));
};
struct TwiceSprung {
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, 0.0), axial::revolute().mass(1.0).rotor_inertia(rotor).stiffness(spring).spring(1.0));
};
using plant::links_have_one_spring;
using plant::motors_are_heavy;
TEST(ElasticJoints, HaveAMotorAndOneSpring) {
  EXPECT_TRUE(motors_are_heavy<Wheel>() && links_have_one_spring<Wheel>());
  EXPECT_TRUE(!motors_are_heavy<WithoutMotor>() && links_have_one_spring<WithoutMotor>());
  EXPECT_TRUE(motors_are_heavy<TwiceSprung>() && !links_have_one_spring<TwiceSprung>());
}

// Driven by a constant effort both run away together, and swing against each other: J th'' = tau - K (th - q), I q'' =
// K (th - q).
TEST_F(ElasticWheel, IsTwoBodiesAndASpring) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, {0.1F});
  const double both = rotor + link_inertia, w = std::sqrt(spring * (1.0 / rotor + 1.0 / link_inertia));
  double worst = 0.0, swing = 0.0;
  for (std::uint32_t k = 1; k <= 300; ++k) {
    const double t = 1e-3 * k, found = ask({10.0F}, k).position[0] / counts_a_rad;
    const double swings = 10.0 * link_inertia / (rotor * both) * (1.0 - std::cos(w * t)) / (w * w);
    worst = std::fmax(worst, std::fabs(found - 0.1 - 5.0 * t * (t + 1e-3) / both - swings));
    swing = std::fmax(swing, swings);
  }
  EXPECT_LT(worst, 1e-3) << "first order: a swing of a tick of 1 ms is damped";
  EXPECT_GT(swing, 5.0 * worst);
}
// A hand turns the wheel, whose spring drags the motor behind it.
TEST_F(ElasticWheel, IsPushedAtItsLink) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, {0.1F});
  tell(link::ArmAction::push, {10.0F});
  const double both = rotor + link_inertia, w = std::sqrt(spring * (1.0 / rotor + 1.0 / link_inertia));
  for (std::uint32_t k = 1; k <= 100; ++k) {
    const double t = 1e-3 * k, found = ask({0.0F}, k).position[0] / counts_a_rad;
    const double swings = -10.0 / both * (1.0 - std::cos(w * t)) / (w * w);
    ASSERT_NEAR(found, 0.1 + 5.0 * t * t / both + swings, 1.5e-3) << k;
  }
}

// Placed, links are where they were asked to be: motors are ahead by what weights bend springs. Held by what it weighs,
// it stays.
TEST_F(ElasticArm, StandsWithItsSpringsBent) {
  open(link::Mode::lock_step);
  const JointValues at = {0.3F, -0.4F, 0.1F};
  const auto first = tell(link::ArmAction::place, at);
  const auto weight = gravity_torque<Scene<Soft, Gravity>>(Joints<Soft, double>{0.3F, -0.4F, 0.1F});
  EXPECT_GT(weight[1], 5.0);
  EXPECT_NEAR(first.position[0] / counts_a_rad, static_cast<double>(at[0]), 1e-6) << "rigid";
  EXPECT_NEAR(first.position[1] / counts_a_rad, static_cast<double>(at[1]) + weight[1] / 2000.0, 1e-6);
  const JointValues efforts = {static_cast<float>(weight[0]), static_cast<float>(weight[1]),
                               static_cast<float>(weight[2])};
  link::Encoders last{};
  for (std::uint32_t k = 1; k <= 500; ++k)
    last = ask(efforts, k);
  EXPECT_NEAR(last.position[0] / counts_a_rad, static_cast<double>(at[0]), 1e-4);
  EXPECT_EQ(last.position[1], first.position[1]) << "its motor sticks";
}
// What the motor's friction holds a hand may bend all the same: its encoder does not see it, but the joint before it
// recoils.
TEST_F(ElasticArm, RubsAtTheMotor) {
  open(link::Mode::lock_step);
  const auto first = tell(link::ArmAction::place, {-1.5707964F, 0.0F, 0.1F});
  tell(link::ArmAction::push, {0.0F, 0.4F, 0.0F});
  link::Encoders last{};
  for (std::uint32_t k = 1; k <= 30; ++k) {
    last = ask({0.0F, 0.0F, 0.0F}, k);
    ASSERT_EQ(last.position[1], first.position[1]) << k;
  }
  EXPECT_LT(last.position[0] - first.position[0], -5e-6 * counts_a_rad);
}

/// Behind springs of 10^7 N m/rad, and rigid.
TEST(ElasticArms, ThatAreStiffAreRigid) {
  const auto stiff = Answers<Upright<10'000'000, true>, float>().of(200);
  const auto rigid = Answers<Upright<10'000'000, false>, float>().of(200);
  const auto soft = Answers<Soft, float>().of(200);
  double apart = 0.0;
  for (std::size_t k = 0; k < rigid.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      const double unit = i < 2 ? counts_a_rad : 1e7;
      ASSERT_NEAR(stiff[k].position[i] / unit, rigid[k].position[i] / unit, 1e-4) << k << ' ' << i;
      apart = std::fmax(apart, std::fabs(soft[k].position[i] / unit - rigid[k].position[i] / unit));
    }
  EXPECT_GT(apart, 1e-3);
}

}  // namespace
}  // namespace axial::apps

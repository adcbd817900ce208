// The plant's parts: the arms that it has, what they carry, its stops, its ground.
#include <host_sim/plants/simulation/integrate.hpp>
#include <host_sim/plants/simulation/plant.hpp>

#include <gtest/gtest.h>
#include <cases/scenarios.hpp>
#include <oracle/recursive.hpp>

#include <cmath>
#include <functional>

using namespace host_sim::simulation;

namespace {

Values<double> pushed_into_a_stop(Method method, double h) {
  const auto links = robot_links("planar2r");
  Surroundings surroundings;
  surroundings.stops = {1e6, 1e3};
  const Plant plant(robot_model("planar2r"), links, surroundings,
                    [](const auto&, Values<double>& tau, auto&) { tau[0] = 200.0, tau[1] = -80.0; });
  Motion<double> x;
  run(method, plant.model(), x, h, std::lround(2.0 / h), std::cref(plant), [](const auto&) {});
  return x.q;
}

void plant_of_nobody(const Instant<double>&, Values<double>&, Stiffness<double>&) {}

}  // namespace

TEST(Plant, HasTheNominalArmOfTheScenarios) {
  const auto arm = cases::nominal_arm();
  const Model model = sprung_arm(0.0, nominal_pose());
  Values<double> q{};
  for (int i = 0; i < 6; ++i)
    q[i] = arm.q[static_cast<std::size_t>(i)];
  const auto mine = axial::gravity_torque(model, q, {});
  const auto theirs = oracle::recursive_inverse_dynamics(arm.chain, arm.q, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0});
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(mine[i], theirs[static_cast<std::size_t>(i)], 1e-13);
}

// What is fixed to the last link weighs as a payload of the same numbers does.
TEST(Plant, CarriesABodyAsAPayload) {
  using Loaded = axial::Model<12, axial::Gravity, axial::RotorInertia, axial::Friction, axial::Payload>;
  const axial::PayloadBody<double> load{1.7, {0.05, -0.12, 0.2}, {0.02, 0.03, 0.025, 0.004, -0.003, 0.002}};
  auto links = robot_links("puma560");
  Loaded bare;
  bare.set_gravity(0.0, 0.0, -9.81);
  for (const auto& link : links)
    EXPECT_TRUE(bare.add(link));
  links.back() = carrying(links.back(), load);
  const Model model = model_of("puma560", links);
  const Values<double> q = {0.3, -0.5, 0.4, 0.3, 0.7, 0.2}, qd = {1.0, -2.0, 1.5, 3.0, -2.5, 4.0},
                       qdd = {5.0, -4.0, 7.0, 9.0, -8.0, 11.0};
  axial::Inputs<Loaded, double> in{};
  in.payload = load;
  const auto of = [](const Values<double>& values) {
    axial::Joints<Loaded, double> same{};
    for (int i = 0; i < 6; ++i)
      same[i] = values[i];
    return same;
  };
  const auto fixed = axial::inverse_dynamics(model, q, qd, qdd, {});
  const auto held = axial::inverse_dynamics(bare, of(q), of(qd), of(qdd), in);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(fixed[i], held[i], 1e-11) << i;
}

// Hunt and Crossley's force, friction against the slip, nothing above the ground.
TEST(Plant, IsPushedByTheGroundAsItsFormulaSays) {
  Surroundings surroundings;
  surroundings.ground = Ground{0.06, 2e4, 0.4, 0.7, 2e-3};
  const Plant plant(leg(), surroundings, [](const Instant<double>&, Values<double>&, Stiffness<double>&) {});
  const Values<double> q = {0.45, 2.2, -1.2};
  const double height = axial::forward_kinematics(plant.model(), q, {}).tool.position.z;
  for (const double depth : {-0.001, 0.002, 0.01})
    for (const double fall : {-0.5, 0.0, 0.3, 9.0}) {
      const Values<double> at = {q[0] + 0.06 - depth - height, q[1], q[2]}, qd = {fall, 0.4, -0.3};
      const auto poses = axial::forward_kinematics(plant.model(), at, {});
      ASSERT_NEAR(poses.tool.position.z, 0.06 - depth, 1e-12) << "the first joint lifts";
      const double h = 1e-6;
      Values<double> later = at;
      for (int i = 0; i < 3; ++i)
        later[i] += h * qd[i];
      const auto v =
          (1.0 / h) * (axial::forward_kinematics(plant.model(), later, {}).tool.position - poses.tool.position);
      const double normal = depth > 0.0 ? std::fmax(0.0, 2e4 * depth * (1.0 - 1.5 * 0.4 * v.z)) : 0.0;
      const double slip = std::hypot(v.x, v.y), rubbed = 0.7 * normal * std::tanh(slip / 2e-3);
      const auto force = plant.ground_force(at, qd);
      EXPECT_NEAR(force.z, normal, 1e-4 * normal) << depth << ", " << fall;
      EXPECT_NEAR(force.x, -rubbed * v.x / slip, 1e-4 * normal);
      EXPECT_NEAR(force.y, -rubbed * v.y / slip, 1e-4 * normal);
    }
}

// Explicitly at 20 us, implicitly at 1 ms, where stops of 1e6 N m/rad are far beyond every explicit limit.
TEST(Plant, RestsAgainstItsEndStops) {
  const auto links = robot_links("planar2r");
  const auto finely = pushed_into_a_stop(Method::rk4, 2e-5),
             coarsely = pushed_into_a_stop(Method::linearly_implicit, 1e-3);
  for (const auto& q : {finely, coarsely}) {
    EXPECT_NEAR(q[0], links[0].position_max, 1e-3);
    EXPECT_NEAR(q[1], links[1].position_min, 1e-3);
    EXPECT_GT(q[0], links[0].position_max) << "a stop is a spring";
  }
  EXPECT_NEAR(finely[0], coarsely[0], 1e-6);
  EXPECT_NEAR(finely[1], coarsely[1], 1e-6);
}

TEST(Plant, StandsOnTheGroundWithItsWeight) {
  Surroundings surroundings;
  surroundings.ground = Ground{};
  const Plant plant(leg(), surroundings,
                    [](const Instant<double>& at, Values<double>& tau, Stiffness<double>& stiffness) {
                      for (const int i : {1, 2}) {
                        tau[i] = -400.0 * (at.q[i] - (i == 1 ? 2.2 : -1.2)) - 20.0 * at.qd[i];
                        stiffness.stiffness[i] = 400.0, stiffness.damping[i] = 20.0;
                      }
                    });
  Motion<double> x;
  x.q = {0.45, 2.2, -1.2};
  run(Method::rk4, plant.model(), x, 2e-5, 50'000, std::cref(plant), [](const auto&) {});
  EXPECT_NEAR(plant.ground_force(x.q, x.qd).z, 2.75 * 9.8125, 0.05);
  const auto nothing = Plant(leg(), Surroundings{}, plant_of_nobody).ground_force(x.q, x.qd);
  EXPECT_EQ(std::fabs(nothing.x) + std::fabs(nothing.y) + std::fabs(nothing.z), 0.0) << "there is no ground";
}

// What becomes of motions: every scenario of host_sim/plants/simulation inside its gates, and the plant's parts.
#include <host_sim/plants/simulation/reference.hpp>
#include <host_sim/plants/simulation/rows.hpp>

#include <gtest/gtest.h>
#include <cases/scenarios.hpp>
#include <oracle/recursive.hpp>

#include <cmath>
#include <cstdio>
#include <ostream>

namespace host_sim::simulation {
void PrintTo(const MotionScenario& scenario, std::ostream* out) { *out << scenario.name; }
}  // namespace host_sim::simulation

using namespace host_sim::simulation;

namespace {

class MotionScenarios : public testing::TestWithParam<MotionScenario> {};

TEST_P(MotionScenarios, AreInsideTheirGates) {
  const auto rows = GetParam().measure();
  EXPECT_FALSE(rows.empty());
  for (const Row& r : rows) {
    std::printf("%-20s %-7s %-24s h %.3g s: %s %.2g (gate %.2g)\n", r.scenario.c_str(), r.scalar.c_str(),
                r.route.c_str(), r.step, r.quantity.c_str(), r.error, r.gate);
    EXPECT_TRUE(r.pass) << r.quantity << ": " << r.status;
    if (r.quantity == "position, rad") {
      EXPECT_NE(r.error, 0.0) << "steps of " << r.step << " s leave something";
    }
  }
}

std::vector<MotionScenario> quick_scenarios() {
  std::vector<MotionScenario> list;
  for (const auto& scenario : motion_scenarios())
    if (!scenario.slow) list.push_back(scenario);
  return list;
}

INSTANTIATE_TEST_SUITE_P(All, MotionScenarios, testing::ValuesIn(quick_scenarios()),
                         [](const auto& info) { return info.param.name; });

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

TEST(References, AgreeWithEachOtherAndTheLibrary) {
  if (!has_references()) GTEST_SKIP() << "no SUNDIALS here: ./axial motion installs it";
  for (const std::string& robot : robot_names()) {
    SCOPED_TRACE(robot);
    Motion<double> start, ours;
    auto links = robot_links(robot);
    for (auto& link : links)  // dry friction jumps, at which a solver with error control stops
      link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
    const Model model = model_of(robot, links);
    for (int i = 0; i < model.size(); ++i)
      start.q[i] = 0.2 + 0.1 * i, start.qd[i] = i % 2 == 0 ? 0.5 : -0.5;
    ours = start;
    const Drive<double> damp = [](const auto& at, Values<double>& tau, auto&, auto&) {
      for (int i = 0; i < Values<double>::size; ++i)
        tau[i] = -0.5 * at.qd[i];
    };
    constexpr double seconds = 0.25;
    run(Method::rk4, model, ours, seconds / 1000, 1000, damp, [](const auto&) {});
    const auto adams = reference(ReferenceMethod::cvode_adams, model, start, seconds, damp, 1e-11).end;
    const auto bdf = reference(ReferenceMethod::cvode_bdf, model, start, seconds, damp, 1e-11).end;
    const auto pair = reference(ReferenceMethod::arkode_erk, model, start, seconds, damp, 1e-11).end;
    for (int i = 0; i < model.size(); ++i) {
      EXPECT_NEAR(ours.q[i], pair.q[i], 1e-10) << robot;
      EXPECT_NEAR(adams.q[i], pair.q[i], 1e-9) << robot;
      EXPECT_NEAR(bdf.q[i], pair.q[i], 1e-8) << robot;
    }
  }
}

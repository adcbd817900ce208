// What becomes of motions: every scenario of host_sim/plants/simulation inside its gates.
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

}  // namespace

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

// Plants with elastic joints: closed forms of one joint, Spong's equations of whole arms, energy, references, and the
// rigid arm that they tend to.
#include <host_sim/plants/simulation/elastic.hpp>
#include <host_sim/plants/simulation/reference.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace host_sim::simulation;

namespace {

std::vector<axial::LinkParameters> sprung(const std::string& robot, double resonance) {
  auto links = elastic_links(robot, robot_links(robot), resonance);
  for (auto& link : links)
    link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
  return links;
}

Values<double> pose(int n, double a, double b) {
  Values<double> result{};
  for (int i = 0; i < n; ++i)
    result[i] = a + b * (i % 2 == 0 ? i : -i);
  return result;
}

/// Of a scara's first joint alone, in its plane, a rotor and a link behind a spring: I = m l^2, free.
struct OneJoint {
  std::vector<axial::LinkParameters> links;
  double inertia = 0.0, rotor = 0.75, stiffness = 640.0;
  OneJoint() {
    links.push_back(axial::revolute().mass(2.0).com(0.5, 0, 0).rotor_inertia(rotor).stiffness(stiffness).parameters());
    inertia = 2.0 * 0.25;
  }
};

void nothing(const Instant<double>&, Values<double>&, axial::Inputs<Model, double>&, Stiffness<double>&) {}

Motion<double> moved(Method method, const ElasticArm& arm, Motion<double> x, double h, long steps,
                     const Drive<double>& drive = nothing) {
  run(method, arm.model(), x, h, steps, drive, [](const auto&) {});
  return x;
}

}  // namespace

// The deflection of two inertias with a spring and a damper between them is e^-at (cos wt + a/w sin wt).
TEST(ElasticPlant, OneJointSwingsAsItsClosedForm) {
  const OneJoint joint;
  const double reduced = joint.inertia * joint.rotor / (joint.inertia + joint.rotor), damping = 3.0;
  const ElasticArm arm("scara", joint.links, {damping});  // gravity along its axis
  const double a = 0.5 * damping / reduced, w = std::sqrt(joint.stiffness / reduced - a * a), t = 0.25;
  Motion<double> start;
  start.q[1] = 0.01;
  const double exact = 0.01 * std::exp(-a * t) * (std::cos(w * t) + a / w * std::sin(w * t));
  EXPECT_NEAR(moved(Method::rk4, arm, start, t / 2000, 2000).q[1], exact, 1e-11);
  const auto error = [&](int steps) {
    return std::fabs(moved(Method::linearly_implicit, arm, start, t / steps, steps).q[1] - exact);
  };
  EXPECT_LT(error(4000), 2e-4);
  EXPECT_NEAR(error(4000) / error(8000), 2.0, 0.1) << "of the first order";
  EXPECT_NEAR(arm.state({0.25}, {}, {6.4}).q[1], -0.01, 1e-15) << "its spring carries that effort";
}

// Accelerations of the chain of twice the joints, against M^-1 (tau_l - h) and (tau_m - tau_l) / B.
TEST(ElasticPlant, ArmsObeySpongsEquations) {
  for (const std::string robot : {"puma560", "scara"}) {
    const auto links = sprung(robot, 12.0);
    const std::vector<double> damping(links.size(), 0.5);
    const ElasticArm arm(robot, links, damping);
    auto bare = links;
    for (auto& link : bare)
      link.rotor_inertia = 0.0;
    const Model rigid = model_of(robot, bare);
    const int n = arm.joints();
    auto x = arm.state(pose(n, 0.3, 0.2), pose(n, 0.5, -0.3), pose(n, 4.0, 1.0));
    const auto tau_m = pose(n, 3.0, 2.0), spread = arm.deflections(x.q);
    for (int i = 0; i < n; ++i)
      x.qd[2 * i + 1] = 0.1 * i - 0.2;
    const auto q = arm.positions(x), qd = arm.velocities(x), rate = arm.deflections(x.qd);
    Values<double> tau_l{};
    for (int i = 0; i < n; ++i)
      tau_l[i] = -links[static_cast<std::size_t>(i)].stiffness * spread[i] - 0.5 * rate[i];
    const auto links_move = axial::forward_dynamics(rigid, q, qd, tau_l, {});
    const auto chain = axial::forward_dynamics(arm.model(), x.q, x.qd, arm.efforts(tau_m), {});
    const auto motors = arm.motors(chain), more = arm.deflections(chain);
    for (int i = 0; i < n; ++i) {
      const auto& link = links[static_cast<std::size_t>(i)];
      const double B = link.gear * link.gear * link.rotor_inertia;
      const double exact = (tau_m[i] - tau_l[i]) / B, scale = std::fabs(exact) + std::fabs(links_move[i]) + 1.0;
      EXPECT_NEAR(motors[i], exact, 1e-9 * scale) << robot << i;
      EXPECT_NEAR(motors[i] + more[i], links_move[i], 1e-9 * scale) << robot << i;
    }
  }
}

TEST(ElasticPlant, KeepsItsEnergyWithoutDamping) {
  const auto links = sprung("puma560", 12.0);
  const ElasticArm arm("puma560", links);
  const auto start = arm.state(pose(6, 0.2, 0.1), pose(6, 0.5, 0.0));
  const double before = energy(arm.model(), start.q, start.qd);
  const double scale = 20.0;  // J, that change from one kind into another
  const auto after = [&](Method method, double h) {
    const auto end = moved(method, arm, start, h, std::lround(0.2 / h));
    return (energy(arm.model(), end.q, end.qd) - before) / scale;
  };
  EXPECT_NEAR(after(Method::rk4, 1e-4), 0.0, 1e-8);
  const double coarse = after(Method::linearly_implicit, 1e-4), fine = after(Method::linearly_implicit, 5e-5);
  EXPECT_LT(coarse, 0.0) << "what it does not resolve it damps";
  EXPECT_NEAR(coarse / fine, 2.0, 0.2);
}

TEST(ElasticPlant, EndsWhereTheReferenceDoes) {
  if (!has_references()) GTEST_SKIP() << "no SUNDIALS here: ./axial motion installs it";
  const ElasticArm arm("puma560", sprung("puma560", 12.0), std::vector<double>(6, 0.1));
  const auto start = arm.state(pose(6, 0.2, 0.1), pose(6, 0.3, 0.0));
  const Drive<double> push = [&](const auto& at, Values<double>& tau, auto&, auto&) {
    tau = arm.efforts(pose(6, 5.0 * std::cos(20.0 * at.time), 0.5));
  };
  const auto exact = reference(ReferenceMethod::cvode_bdf, arm.model(), start, 0.1, push, 1e-11).end;
  const auto ours = moved(Method::rk4, arm, start, 1e-4, 1000, push);
  const auto implicit = moved(Method::linearly_implicit, arm, start, 1e-6, 100'000, push);
  for (int i = 0; i < arm.model().size(); ++i) {
    EXPECT_NEAR(ours.q[i], exact.q[i], 1e-7);
    EXPECT_NEAR(implicit.q[i], exact.q[i], 2e-5);
  }
}

TEST(ElasticPlant, SaysWhatItCannotBe) {
  auto links = sprung("scara", 12.0);
  links[0].rotor_inertia = 0.0;
  EXPECT_THROW(ElasticArm("scara", links), std::runtime_error);
  links = sprung("scara", 12.0);
  links[1].spring_stiffness = 1.0;
  EXPECT_THROW(ElasticArm("scara", links), std::runtime_error);
}

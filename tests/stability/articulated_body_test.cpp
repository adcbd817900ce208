// Forward error of the articulated-body algorithm on stiff and extreme chains, against quadruple precision. The
// residual can not see this: it stays small while digits of the acceleration are lost.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cases/scenarios.hpp>
#include <cases/to_axial.hpp>
#include <memory>
#include <oracle/compare.hpp>

namespace {

using cases::Scenario;

constexpr int capacity = 300;
using Model = axial::Model<capacity>;

template <class T>
struct Answer {
  oracle::Vector<T> qdd;
  axial::Status status;
};

template <class T>
Answer<T> solve(const oracle::Chain<double>& chain, const oracle::Vector<double>& q, const oracle::Vector<double>& qd,
                const oracle::Vector<double>& tau) {
  const auto model = std::make_unique<Model>(cases::to_model<Model>(chain));
  axial::Joints<Model, T> x{}, v{}, f{};
  for (int i = 0; i < model->size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    x[i] = static_cast<T>(q[k]), v[i] = static_cast<T>(qd[k]), f[i] = static_cast<T>(tau[k]);
  }
  const auto result = axial::forward_dynamics(*model, x, v, f);
  return {oracle::Vector<T>(result.values, result.values + model->size()), result.status};
}
template <class T>
Answer<T> solve(const Scenario& s) {
  return solve<T>(s.chain, s.q, s.qd, s.tau);
}

void expect_inside_the_gates(const std::vector<Scenario>& family) {
  for (const Scenario& scenario : family) {
    const auto reference = cases::reference_acceleration(scenario);
    const double in_double = oracle::relative_error(solve<double>(scenario).qdd, reference);
    const double in_float = oracle::relative_error(solve<float>(scenario).qdd, reference);
    std::printf("%-28s N %3d  double %.1e  float %.1e\n", scenario.name.c_str(), scenario.size(), in_double, in_float);
    EXPECT_LE(in_double, scenario.gate_double) << scenario.name;
    EXPECT_LE(in_float, scenario.gate_float) << scenario.name;
  }
}

template <class T>
void expect_same_bits_when_scaled(const Scenario& scenario, int length, int mass) {
  const auto plain = solve<T>(scenario).qdd, scaled = solve<T>(cases::scaled(scenario, length, mass, true)).qdd;
  for (std::size_t i = 0; i < plain.size(); ++i)
    EXPECT_EQ(plain[i], scaled[i]) << "length 2^" << length << " mass 2^" << mass;
}

// A pendulum whose far link is massless hangs nothing on joint 2: D is 0, or what rounding left of it.
oracle::Chain<double> cubes(double m1, double m2, double m3) {
  oracle::Chain<double> chain;
  const double masses[] = {m1, m2, m3}, side = 0.25;
  for (int i = 0; i < 3; ++i) {
    oracle::Link<double> link;
    link.parent = i - 1, link.a = i == 0 ? 0.0 : side, link.mass = masses[i];
    link.com = {side / 2, 0.0, 0.0};
    const double inertia = masses[i] * side * side / 6.0;
    link.inertia = oracle::symmetric(inertia, inertia, inertia, 0.0, 0.0, 0.0);
    chain.links.push_back(link);
  }
  chain.gravity = {0.0, -9.8125, 0.0};
  return chain;
}

template <class T>
void expect_reported(const oracle::Chain<double>& chain, const oracle::Vector<double>& q) {
  const auto answer = solve<T>(chain, q, oracle::Vector<double>(q.size(), 0.0), oracle::Vector<double>(q.size(), 0.5));
  EXPECT_EQ(answer.status.code, axial::Status::Code::near_singular);
  for (const T x : answer.qdd)
    EXPECT_TRUE(std::isfinite(x));
}

template <class T>
void expect_healthy(const oracle::Chain<double>& chain, const oracle::Vector<double>& q) {
  const auto answer = solve<T>(chain, q, oracle::Vector<double>(q.size(), 0.0), oracle::Vector<double>(q.size(), 0.5));
  EXPECT_TRUE(answer.status.ok());
}

}  // namespace

TEST(Stability, LongChainsOfRods) { expect_inside_the_gates(cases::rods()); }
TEST(Stability, MasslessLinksNearGimbalLock) { expect_inside_the_gates(cases::gimbal()); }
TEST(Stability, FarCentresOfMass) { expect_inside_the_gates(cases::far_com()); }
TEST(Stability, MicroAndMacroScale) { expect_inside_the_gates(cases::scaled_arm()); }
TEST(Stability, SmallRotorsNearGimbalLock) { expect_inside_the_gates(cases::gimbal_with_rotors()); }

// No absolute threshold anywhere: powers of two pass through.
TEST(Stability, PowersOfTwoDoNotChangeABit) {
  const Scenario arm = cases::nominal_arm();
  for (int mass : {-20, 0, 20})
    for (int length : {-10, 0, 10}) {
      expect_same_bits_when_scaled<double>(arm, length, mass);
      expect_same_bits_when_scaled<float>(arm, length, mass);
    }
}

TEST(Stability, SingularJointsAreReportedAndFinite) {
  const auto straight = oracle::Vector<double>{0.0, 0.0, 0.0};
  expect_reported<double>(cubes(0.0, 0.0, 1.0), straight);
  expect_reported<float>(cubes(0.0, 0.0, 1.0), straight);
  expect_reported<float>(cubes(1.0, 1.0, 0.0), straight);  // the last joint moves nothing
}

TEST(Stability, MasslessLinksAreLegitimate) {
  const auto bent = oracle::Vector<double>{0.0, 0.75, -0.5}, straight = oracle::Vector<double>{0.0, 0.0, 0.0};
  expect_healthy<float>(cubes(0.0, 0.0, 1.0), bent);
  expect_healthy<float>(cubes(1.0, 0.0, 1.0), straight);
  expect_healthy<float>(cubes(0.0, 1.0, 1.0), straight);
}

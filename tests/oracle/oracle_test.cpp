// The oracle against closed forms, against physics and against its own second formulation.
#include <gtest/gtest.h>

#include <oracle/compare.hpp>
#include <oracle/convert.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/random_chain.hpp>
#include <oracle/recursive.hpp>

namespace {

using oracle::quad;
using oracle::Vector;

constexpr unsigned seed = 20240611;
constexpr double quad_eps = 1.93e-34;           // 2^-112
constexpr double rounding = 1e3 * quad_eps;     // a few hundred operations on sums of unlike size
constexpr double conditioned = 1e6 * quad_eps;  // the same through M^-1, condition number up to some 1e4

oracle::Chain<quad> pendulum(quad mass, quad length, quad inertia) {
  oracle::Link<quad> rod;
  rod.mass = mass, rod.com = {length, 0, 0}, rod.inertia = oracle::symmetric<quad>(0, inertia, inertia, 0, 0, 0);
  oracle::Chain<quad> chain;
  chain.links = {rod};
  chain.gravity = {0, quad(-9.8125), 0};
  return chain;
}

/// Two point masses at the ends of massless rods (Craig, section 6.7): closed form of M, c and g.
struct PointMassArm {
  quad m1 = 4.5, m2 = 2.25, l1 = 0.5, l2 = 0.75, gravity = 9.8125;

  oracle::Chain<quad> chain() const {
    auto result = pendulum(m1, l1, 0);
    auto second = pendulum(m2, l2, 0).links[0];
    second.parent = 0, second.a = l1;
    result.links.push_back(second);
    return result;
  }
  Vector<quad> mass_matrix(quad q2) const {
    const quad c2 = cosq(q2), m22 = m2 * l2 * l2, m12 = m22 + m2 * l1 * l2 * c2;
    return {m22 + 2 * m2 * l1 * l2 * c2 + (m1 + m2) * l1 * l1, m12, m12, m22};
  }
  Vector<quad> coriolis(quad q2, quad w1, quad w2) const {
    const quad h = m2 * l1 * l2 * sinq(q2);
    return {-h * w2 * w2 - 2 * h * w1 * w2, h * w1 * w1};
  }
  Vector<quad> gravity_torque(quad q1, quad q2) const {
    const quad g2 = m2 * l2 * gravity * cosq(q1 + q2);
    return {g2 + (m1 + m2) * l1 * gravity * cosq(q1), g2};
  }
};

class RandomState : public testing::TestWithParam<int> {
 protected:
  RandomState() : random_(seed + unsigned(GetParam())) {
    const int n = GetParam();
    chain = oracle::convert<quad>(n % 2 ? random_.tree(n) : random_.chain(n));
    q = vector(3.0), qd = vector(2.0), qdd = vector(4.0);
    load.friction = true;
    load.tip = oracle::convert<quad>(random_.wrench(10.0));
  }
  Vector<quad> vector(double size) { return oracle::convert<quad>(random_.vector(GetParam(), size)); }
  int n() const { return GetParam(); }

  oracle::RandomChains random_;
  oracle::Chain<quad> chain;
  Vector<quad> q, qd, qdd;
  oracle::Load<quad> load;
};

/// One step along qd.
Vector<quad> along(const Vector<quad>& q, const Vector<quad>& qd, quad t) {
  Vector<quad> result = q;
  for (std::size_t i = 0; i < q.size(); ++i)
    result[i] += t * qd[i];
  return result;
}
quad dot(const Vector<quad>& a, const Vector<quad>& b) {
  quad sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

TEST(Oracle, PendulumHasItsTextbookEquation) {
  const quad m = 2, l = 0.75, inertia = 0.375, q = 0.5, qdd = 1.25;
  const quad expected = (m * l * l + inertia) * qdd + m * l * quad(9.8125) * cosq(q);
  const auto tau = oracle::inverse_dynamics(pendulum(m, l, inertia), {q}, {quad(3)}, {qdd});
  EXPECT_LE(oracle::relative_error(tau, Vector<quad>{expected}), rounding);
}

TEST(Oracle, PointMassArmHasItsClosedForm) {
  const PointMassArm arm;
  const quad q1 = 0.25, q2 = -1.5, w1 = 1.25, w2 = -0.5;
  const auto chain = arm.chain();
  const auto M = oracle::elements(oracle::mass_matrix(chain, {q1, q2}));
  const auto c = oracle::coriolis_torque(chain, {q1, q2}, {w1, w2}), g = oracle::gravity_torque(chain, {q1, q2});
  EXPECT_LE(oracle::relative_error(M, arm.mass_matrix(q2)), rounding);
  EXPECT_LE(oracle::relative_error(c, arm.coriolis(q2, w1, w2)), rounding);
  EXPECT_LE(oracle::relative_error(g, arm.gravity_torque(q1, q2)), rounding);
}

TEST(Oracle, FreeSlideFallsWithGravity) {
  oracle::Chain<quad> chain = pendulum(3, 0.5, 1);
  chain.links[0].type = oracle::Joint::prismatic;
  chain.gravity = {1, 2, quad(-9.5)};
  EXPECT_EQ(oracle::forward_dynamics<quad>(chain, {quad(0.5)}, {quad(1)}, {quad(0)})[0], quad(-9.5));
}

TEST(Oracle, RightAngleTwistsAreExact) {
  for (int quarters = -4; quarters <= 4; ++quarters) {
    double sine = 0, cosine = 0;
    oracle::sincos_of_constant(quarters * oracle::right_angle<double>(), sine, cosine);
    EXPECT_EQ(std::fabs(sine) + std::fabs(cosine), 1.0) << quarters;
    EXPECT_NEAR(sine, std::sin(quarters * oracle::right_angle<double>()), 1e-15);
    EXPECT_NEAR(cosine, std::cos(quarters * oracle::right_angle<double>()), 1e-15);
  }
}

TEST_P(RandomState, MassMatrixIsSymmetricAndPositive) {
  const auto M = oracle::mass_matrix(chain, q);
  for (int i = 0; i < n(); ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_LE(double(oracle::abs(M(i, j) - M(j, i))), rounding * double(M(i, i)));
  EXPECT_GT(double(dot(qdd, M * qdd)), 0.0);
}

TEST_P(RandomState, MassMatrixDerivativesAreItsDifferences) {
  const quad h = 1e-11;  // central difference: truncation h^2 M''' ~ 1e-22, rounding eps / h ~ 1e-23
  constexpr double difference = 1e-18;
  const auto dM = oracle::mass_matrix_derivatives(chain, q);
  for (int l = 0; l < n(); ++l) {
    Vector<quad> unit(q.size(), quad(0));
    unit[std::size_t(l)] = 1;
    const auto ahead = oracle::mass_matrix(chain, along(q, unit, h));
    const auto behind = oracle::mass_matrix(chain, along(q, unit, -h));
    for (int i = 0; i < n(); ++i)
      for (int j = 0; j < n(); ++j)
        EXPECT_NEAR(double(dM[std::size_t(l)](i, j) - (ahead(i, j) - behind(i, j)) / (2 * h)), 0.0, difference);
  }
}

TEST_P(RandomState, GravityTorqueIsTheSlopeOfPotentialEnergy) {
  const quad h = 1e-11;
  const quad ahead = oracle::potential_energy(chain, along(q, qd, h));
  const quad behind = oracle::potential_energy(chain, along(q, qd, -h)), slope = (ahead - behind) / (2 * h);
  const quad power = dot(qd, oracle::gravity_torque(chain, q));
  EXPECT_NEAR(double(slope - power), 0.0, 1e-17 * (1.0 + std::fabs(double(power))));
}

TEST_P(RandomState, KineticEnergyIsTheQuadraticFormOfM) {
  const quad form = dot(qd, oracle::mass_matrix(chain, q) * qd) / 2;
  EXPECT_LE(double(oracle::abs(oracle::kinetic_energy(chain, q, qd) - form)), rounding * double(form));
}

TEST_P(RandomState, PowerOfTheTorquesIsTheRateOfEnergy) {
  const quad h = 1e-11;
  const auto energy = [&](quad t) {
    const auto q_t = along(along(q, qd, t), qdd, t * t / 2), qd_t = along(qd, qdd, t);
    return oracle::kinetic_energy(chain, q_t, qd_t) + oracle::potential_energy(chain, q_t);
  };
  const quad rate = (energy(h) - energy(-h)) / (2 * h), power = dot(qd, oracle::inverse_dynamics(chain, q, qd, qdd));
  EXPECT_NEAR(double(rate - power), 0.0, 1e-16 * (1.0 + std::fabs(double(power))));
}

TEST_P(RandomState, ForwardDynamicsUndoesInverseDynamics) {
  const auto tau = oracle::inverse_dynamics(chain, q, qd, qdd, load);
  EXPECT_LE(oracle::relative_error(oracle::forward_dynamics(chain, q, qd, tau, load), qdd), conditioned);
}

TEST_P(RandomState, RecursiveInverseDynamicsEqualsLagrange) {
  const auto reference = oracle::inverse_dynamics(chain, q, qd, qdd, load);
  EXPECT_LE(oracle::relative_error(oracle::recursive_inverse_dynamics(chain, q, qd, qdd, load), reference), rounding);
}

TEST_P(RandomState, RecursiveForwardDynamicsEqualsLagrange) {
  const auto reference = oracle::forward_dynamics(chain, q, qd, qdd, load);  // qdd serves as any torque
  EXPECT_LE(oracle::relative_error(oracle::recursive_forward_dynamics(chain, q, qd, qdd, load), reference),
            conditioned);
}

TEST_P(RandomState, JacobianIsTheVelocityOfTheTool) {
  const quad h = 1e-11;
  chain.tool.position = {0.125, -0.25, 0.5};
  const auto velocity = oracle::tool_jacobian(chain, q).linear * qd;
  const auto ahead = oracle::tool_pose(chain, along(q, qd, h)).position;
  const auto behind = oracle::tool_pose(chain, along(q, qd, -h)).position;
  const auto difference = (1 / (2 * h)) * (ahead - behind);
  EXPECT_LE(oracle::relative_error(Vector<quad>{difference.x, difference.y, difference.z}, velocity), 1e-18);
}

INSTANTIATE_TEST_SUITE_P(Oracle, RandomState, testing::Values(1, 2, 3, 4, 6, 7, 9), testing::PrintToStringParamName());

}  // namespace

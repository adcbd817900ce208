// The oracle against Orocos KDL on random serial chains and on the robots: two groups of people, one physics.
#include <gtest/gtest.h>

#include <oracle/compare.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/kdl_chain.hpp>
#include <oracle/random_chain.hpp>
#include <robots/robots.hpp>

namespace {

using oracle::Vector;

constexpr unsigned seed = 7;
constexpr double agreement = 1e-13;    // double eps times a few hundred operations
constexpr double conditioned = 1e-10;  // the same through M^-1 by L D L^T, condition number up to some 1e4

void expect_agreement(const oracle::Chain<double>& chain, oracle::RandomChains& random) {
  const oracle::KdlChain kdl(chain);
  const int n = chain.size();
  const auto q = random.vector(n, 2.5), qd = random.vector(n, 2.0), qdd = random.vector(n, 4.0);
  const auto tip = random.wrench(10.0);
  const auto tau = oracle::inverse_dynamics(chain, q, qd, qdd, {false, tip});
  EXPECT_LE(oracle::relative_error(kdl.inverse_dynamics(q, qd, qdd, tip), tau), agreement);
  EXPECT_LE(oracle::relative_error(kdl.mass_matrix(q), oracle::mass_matrix(chain, q)), agreement);
  EXPECT_LE(oracle::relative_error(kdl.gravity_torque(q), oracle::gravity_torque(chain, q)), agreement);
  EXPECT_LE(oracle::relative_error(kdl.coriolis_torque(q, qd), oracle::coriolis_torque(chain, q, qd)), agreement);
  EXPECT_LE(oracle::relative_error(kdl.forward_dynamics(q, qd, tau, tip), qdd), conditioned);
  EXPECT_LE(oracle::relative_error(kdl.tool_jacobian(q).linear, oracle::tool_jacobian(chain, q).linear), agreement);
  EXPECT_LE(oracle::relative_error(kdl.tool_jacobian(q).angular, oracle::tool_jacobian(chain, q).angular), agreement);
}

TEST(Kdl, AgreesWithTheOracleOnRandomChains) {
  oracle::RandomChains random(seed);
  for (int n = 1; n <= 10; ++n) {
    SCOPED_TRACE("joints " + std::to_string(n));
    expect_agreement(random.chain(n), random);
  }
}

TEST(Kdl, AgreesWithTheOracleOnEveryRobot) {
  oracle::RandomChains random(seed);
  robots::for_each([&](auto robot) {
    SCOPED_TRACE(robot.name);
    expect_agreement(oracle::of_robot<double, typename decltype(robot)::Robot>(), random);
  });
}

}  // namespace

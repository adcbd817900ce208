// Torques of drives as a linear function of the standard parameters of links and drives: against Lagrange's equations
// of all joints with their couplings as constraints, multipliers and all, in 113 bits.
#include <host_sim/robots/identification/regressor.hpp>

#include "constrained.hpp"

namespace {

using namespace constrained;
using host_sim::identification::Regressor;

template <class R>
std::vector<double> standard_of() {
  std::vector<double> all;
  for (const auto& link : R::chain.links)
    for (const double p : host_sim::identification::to_parameters(link))
      all.push_back(p);
  return all;
}

/// Joints with offsets, a slide that follows a turn, a spring.
struct NamedFollowers : Followers {
  static constexpr const char* name = "followers";
};

template <class R, class Named = R>
void expect_linear(unsigned seed) {
  oracle::Load<quad> load;
  load.friction = load.springs = true;
  const auto exact = Constrained::of<R>(load);
  const Regressor regressor(description::from_robot<Named>());
  const auto theta = standard_of<R>();
  const int m = exact.drives();
  ASSERT_EQ(regressor.drives(), m);
  ASSERT_EQ(regressor.columns(), int(theta.size()));
  oracle::RandomChains random(seed);
  std::vector<double> rows(std::size_t(m * (regressor.columns() + 1)));
  for (int state = 0; state < 10; ++state) {
    const auto x = motion<R>(random, exact.owner());
    regressor.evaluate(x.u.data(), x.ud.data(), x.udd.data(), rows.data());
    Vector<quad> found;
    const double* row = rows.data();
    for (int k = 0; k < m; ++k) {
      quad sum = 0;
      for (const double p : theta)
        sum += quad(*row++) * quad(p);
      found.push_back(sum + quad(*row++));
    }
    const auto tau = exact.inverse(convert<quad>(x.u), convert<quad>(x.ud), convert<quad>(x.udd));
    EXPECT_LE(error_in(tau, oracle::largest(tau), found), 1e-12) << state;
  }
}

/// Two slides that one drive moves, the second twice as far from an offset, sprung.
struct Sprung {
  static constexpr const char* name = "sprung";
  static constexpr auto chain =
      axial::chain(axial::gravity(0, 0, -9.81), prismatic().mass(2).rotor_inertia(0.01, 3).viscous(0.5),
                   prismatic().mass(1).mimic(0, 2.0, 0.25).spring(40.0, 0.5));
};

}  // namespace

TEST(DrivenRegressor, IsThatOfConstraintsWithMultipliers) {
  expect_linear<robots::ScaraQuill>(1);
  expect_linear<robots::Palletiser>(2);
  expect_linear<robots::WristArm>(3);
  expect_linear<robots::Gripper>(4);
  expect_linear<Followers, NamedFollowers>(5);
}

// Springs are known and stay at their joints; what a drive feels of them is G^T of it, by hand.
TEST(DrivenRegressor, LeavesSpringsOfJointsKnown) {
  const Regressor regressor(description::from_robot<Sprung>());
  ASSERT_EQ(regressor.drives(), 1);
  const auto theta = standard_of<Sprung>();
  std::vector<double> row(theta.size() + 1);
  const double u = 0.3, ud = -0.2, udd = 1.5;
  regressor.evaluate(&u, &ud, &udd, row.data());
  EXPECT_NEAR(row.back(), 2.0 * 40.0 * (2.0 * u + 0.25 - 0.5), 1e-12);
  double tau = row.back();
  for (std::size_t p = 0; p < theta.size(); ++p)
    tau += row[p] * theta[p];
  // The second slide rides on the first: it moves three times as far.
  EXPECT_NEAR(tau, row.back() + (2.0 + 9.0 * 1.0 + 0.09) * udd + (2.0 + 3.0) * 9.81 + 0.5 * ud, 1e-11);
}

TEST(DrivenRegressor, GivesLinksWithoutADriveNoRotorAndNoFriction) {
  const Regressor regressor(description::from_robot<robots::Palletiser>());
  const std::vector<double> one(4, 1.0);
  std::vector<double> rows(std::size_t(4 * (regressor.columns() + 1)));
  regressor.evaluate(one.data(), one.data(), one.data(), rows.data());
  for (int link = 0; link < 10; ++link)
    for (int k = 0; k < 4; ++k) {
      const double* own = rows.data() + k * (regressor.columns() + 1) + 14 * link + 10;
      const int owners[] = {0, 1, 2, 9};
      EXPECT_EQ(own[0], owners[k] == link ? 1.0 : 0.0);
      EXPECT_EQ(own[1], owners[k] == link ? 1.0 : 0.0);
      EXPECT_EQ(own[2], owners[k] == link ? 1.0 : 0.0);
      EXPECT_EQ(own[3], 0.0);
    }
}

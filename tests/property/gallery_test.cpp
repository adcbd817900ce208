// Machines of robots/gallery: inverse dynamics, the mass matrix and forward dynamics in float and double against
// Lagrange's equations in 113 bits, and inverse dynamics in 32 bits against its certified error.
#include <host_sim/figures/exhaustive/fixed_errors.hpp>

#include <robots/gallery/gallery.hpp>

#include "fixed_robots.hpp"
#include "support.hpp"

namespace property {
namespace {

constexpr int states = 50;
constexpr unsigned seed = 41;

/// The largest error of each of n values over the largest of the exact ones, over all states.
template <class Robot, class Error>
void expect_small_errors(double allowed, const Error& error_of) {
  oracle::RandomChains random(seed);
  double error = 0.0, largest = 0.0;
  for (int k = 0; k < states; ++k) {
    const auto [got, exact] = error_of(random_state<Robot>(random));
    for (std::size_t i = 0; i < exact.size(); ++i) {
      error = std::fmax(error, static_cast<double>(oracle::abs(oracle::quad(got[i]) - exact[i])));
      largest = std::fmax(largest, static_cast<double>(oracle::abs(exact[i])));
    }
  }
  std::printf("%s: %.1e of the largest\n", Robot::name, error / largest);
  EXPECT_LE(error, allowed * largest);
  EXPECT_GT(largest, 0.0);
}

template <class Robot, class T>
struct Against {
  /// Ten times what any of the machines had at most; solving loses what the condition of M takes.
  static constexpr double torque = std::is_same_v<T, double> ? 5e-15 : 2e-6;
  static constexpr double solved = std::is_same_v<T, double> ? 2.5e-13 : 1e-4;

  static void torques() {
    const auto chain = oracle::of_robot<oracle::quad, Robot>();
    expect_small_errors<Robot>(torque, [&](const State& s) {
      return std::make_pair(
          vector<Robot, T>(
              axial::inverse_dynamics<Robot>(joints<Robot, T>(s.q), joints<Robot, T>(s.qd), joints<Robot, T>(s.qdd))),
          oracle::inverse_dynamics(chain, oracle::convert<oracle::quad>(s.q), oracle::convert<oracle::quad>(s.qd),
                                   oracle::convert<oracle::quad>(s.qdd)));
    });
  }
  static void mass_matrices() {
    const auto chain = oracle::of_robot<oracle::quad, Robot>();
    expect_small_errors<Robot>(torque, [&](const State& s) {
      const auto got = axial::mass_matrix<Robot>(joints<Robot, T>(s.q));
      const auto exact = oracle::mass_matrix(chain, oracle::convert<oracle::quad>(s.q));
      std::pair<oracle::Vector<T>, oracle::Vector<oracle::quad>> entries;
      for (int i = 0; i < Robot::chain.size; ++i)
        for (int j = 0; j < Robot::chain.size; ++j)
          entries.first.push_back(got(i, j)), entries.second.push_back(exact(i, j));
      return entries;
    });
  }
  static void accelerations() {
    const auto chain = oracle::of_robot<oracle::quad, Robot>();
    expect_small_errors<Robot>(solved, [&](const State& s) {
      const auto tau =
          oracle::inverse_dynamics(chain, oracle::convert<oracle::quad>(s.q), oracle::convert<oracle::quad>(s.qd),
                                   oracle::convert<oracle::quad>(s.qdd));
      const auto got = axial::forward_dynamics<Robot>(joints<Robot, T>(s.q), joints<Robot, T>(s.qd),
                                                      joints<Robot, T>(oracle::convert<double>(tau)));
      EXPECT_TRUE(got.status.ok());
      return std::make_pair(oracle::Vector<T>(got.values, got.values + Robot::chain.size),
                            oracle::convert<oracle::quad>(s.qdd));
    });
  }
};

template <class Robot>
class Gallery : public testing::Test {};
using Machines = Joined<robots::Gallery>::Types;
TYPED_TEST_SUITE(Gallery, Machines, RobotName);

}  // namespace

TYPED_TEST(Gallery, MovesAsByLagrange) {
  Against<TypeParam, float>::torques(), Against<TypeParam, double>::torques();
  Against<TypeParam, float>::mass_matrices(), Against<TypeParam, double>::mass_matrices();
  Against<TypeParam, float>::accelerations(), Against<TypeParam, double>::accelerations();
}

TYPED_TEST(Gallery, FixedPointIsInsideItsCertifiedErrors) {
  const auto seen = exhaustive::errors<exhaustive::InverseDynamics, TypeParam, axial::Fixed32>(2000, 7);
  for (int i = 0; i < TypeParam::chain.size; ++i) {
    const double share = seen[static_cast<std::size_t>(i)].fixed / exhaustive::certified<TypeParam, axial::Fixed32>(i);
    EXPECT_LE(share, 1.0) << "joint " << i;
    EXPECT_GT(share, 0.001) << "a bound as loose as this certifies little: joint " << i;
  }
}

}  // namespace property

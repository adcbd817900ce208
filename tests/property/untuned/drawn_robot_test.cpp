// A robot that the commit draws (AXIAL_DRAWN), of those that nobody tuned for: inverse dynamics, forward dynamics and
// the mass matrix in float and double against Lagrange's equations in 113 bits, and every kernel in 32 bits against its
// certified error.
#include <tuple>

#include <property/support.hpp>
#include "untuned.hpp"
#include "untuned_kernels.hpp"

namespace property {
namespace {

using Pool = std::tuple<Drawn<0, 2, 2>, Drawn<0, 5, 5>, Drawn<1, 3, 2>, Drawn<1, 6, 4>, Drawn<2, 5, 3>, Drawn<3, 4, 3>,
                        Drawn<3, 5, 4>, Drawn<4, 6, 3>, Drawn<5, 4, 3>, Drawn<6, 4, 1>>;
using Robot = std::tuple_element_t<AXIAL_DRAWN % std::tuple_size_v<Pool>, Pool>;
using Type = testing::Types<Robot>;
INSTANTIATE_TYPED_TEST_SUITE_P(DrawnKernels, UntunedRobotsKernels, Type);
INSTANTIATE_TYPED_TEST_SUITE_P(DrawnForward, UntunedRobot, Type);

constexpr int states = 50;

/// The largest error of each of n values over the largest of the exact ones, over all states.
template <class Error>
void expect_small_errors(double allowed, const Error& error_of) {
  oracle::RandomChains random(static_cast<unsigned>(AXIAL_DRAWN));
  double error = 0.0, largest = 0.0;
  for (int k = 0; k < states; ++k) {
    const auto [got, exact] = error_of(random_state<Robot>(random));
    for (std::size_t i = 0; i < exact.size(); ++i) {
      error = std::fmax(error, static_cast<double>(oracle::abs(oracle::quad(got[i]) - exact[i])));
      largest = std::fmax(largest, static_cast<double>(oracle::abs(exact[i])));
    }
  }
  EXPECT_LE(error, allowed * largest) << Robot::name << ", drawn by " << AXIAL_DRAWN;
  EXPECT_GT(largest, 0.0);
}

template <class T>
class DrawnRobot : public testing::Test {
 protected:
  /// Ten to twenty times what 40 draws of states had at most; solving loses what the condition of M takes.
  static constexpr double torque = std::is_same_v<T, double> ? 1e-14 : 4e-6;
  static constexpr double solved = std::is_same_v<T, double> ? 2e-12 : 1e-3;
  const oracle::Chain<oracle::quad> chain = oracle::of_robot<oracle::quad, Robot>();
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(DrawnRobot, Reals);

TYPED_TEST(DrawnRobot, ExertsLagrangesTorque) {
  using T = TypeParam;
  expect_small_errors(this->torque, [&](const State& s) {
    return std::make_pair(
        vector<Robot, T>(
            axial::inverse_dynamics<Robot>(joints<Robot, T>(s.q), joints<Robot, T>(s.qd), joints<Robot, T>(s.qdd))),
        oracle::inverse_dynamics(this->chain, oracle::convert<oracle::quad>(s.q), oracle::convert<oracle::quad>(s.qd),
                                 oracle::convert<oracle::quad>(s.qdd)));
  });
}
TYPED_TEST(DrawnRobot, HasLagrangesMassMatrix) {
  using T = TypeParam;
  expect_small_errors(this->torque, [&](const State& s) {
    const auto got = axial::mass_matrix<Robot>(joints<Robot, T>(s.q));
    const auto exact = oracle::mass_matrix(this->chain, oracle::convert<oracle::quad>(s.q));
    std::pair<oracle::Vector<T>, oracle::Vector<oracle::quad>> entries;
    for (int i = 0; i < Robot::chain.size; ++i)
      for (int j = 0; j < Robot::chain.size; ++j)
        entries.first.push_back(got(i, j)), entries.second.push_back(exact(i, j));
    return entries;
  });
}
TYPED_TEST(DrawnRobot, IsAcceleratedAsByLagrange) {
  using T = TypeParam;
  expect_small_errors(this->solved, [&](const State& s) {
    const auto tau =
        oracle::inverse_dynamics(this->chain, oracle::convert<oracle::quad>(s.q), oracle::convert<oracle::quad>(s.qd),
                                 oracle::convert<oracle::quad>(s.qdd));
    const auto efforts = joints<Robot, T>(oracle::convert<double>(tau));
    const auto got = axial::forward_dynamics<Robot>(joints<Robot, T>(s.q), joints<Robot, T>(s.qd), efforts);
    EXPECT_TRUE(got.status.ok());
    return std::make_pair(oracle::Vector<T>(got.values, got.values + Robot::chain.size),
                          oracle::convert<oracle::quad>(s.qdd));
  });
}

}  // namespace
}  // namespace property

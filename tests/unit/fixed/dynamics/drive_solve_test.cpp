// The solve of M of drives in words: what it needs to know of M holds, its answers are exact to their words, and what M
// cannot say is told.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <cmath>
#include <property/drives/driven_robots.hpp>
#include <property/drives/driven_states.hpp>
#include <robots/wrist_arm.hpp>

namespace {

using namespace axial;
using T = Fixed32;
using R = robots::WristArm;
template <class Robot>
using SceneOf = scene_of<Scene<Robot, Gravity, RotorInertia>>;
using S = SceneOf<R>;
using Solve = detail::DriveSolve<S, std::int32_t>;
constexpr int size = joint_count<R>;

/// Diagonal of M^-1 by Cholesky's factor in double: column j of its inverse, squared.
template <class M>
double inverse_diagonal(const M& m, int n, int k) {
  double l[8][8] = {}, x[8] = {};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = m(i, j);
      for (int s = 0; s < j; ++s)
        sum -= l[i][s] * l[j][s];
      l[i][j] = i == j ? std::sqrt(sum) : sum / l[j][j];
    }
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    x[i] = i == k ? 1.0 : 0.0;
    for (int s = 0; s < i; ++s)
      x[i] -= l[i][s] * x[s];
    x[i] /= l[i][i];
    sum += x[i] * x[i];
  }
  return sum;
}

/// The mobility bounds M^-1 wherever drives are, and not by more than `looseness`.
template <class Robot, class... Features>
void expect_mobility(double looseness) {
  using Any = scene_of<Scene<Robot, Gravity, Features...>>;
  using State = exhaustive::FixedState<Scene<Robot, Gravity, Features...>, T>;
  exhaustive::Random random(3);
  constexpr int n = joint_count<Robot>;
  double nearest[n] = {};
  for (int s = 0; s < 400; ++s) {
    auto state = exhaustive::next_state<State>(random, static_cast<std::uint64_t>(s % 4));
    property::hold_joints<Robot>(state);
    Joints<Robot, double> u{};
    for (int k = 0; k < n; ++k)
      u[k] = property::real(state.q, k);
    const auto m = mass_matrix<Scene<Robot, Gravity, Features...>>(u);
    for (int k = 0; k < n; ++k) {
      const double most = detail::DriveSizes<Any, std::int32_t>::mobility(k);
      const double found = std::sqrt(inverse_diagonal(m, n, k)) / most;
      EXPECT_LE(found, 1.0) << Robot::name << " " << k;
      nearest[k] = std::fmax(nearest[k], found);
    }
  }
  for (int k = 0; k < n; ++k)
    EXPECT_GT(looseness * nearest[k], 1.0) << Robot::name << " " << k;
}

constexpr Link light(const Link& link) {
  return link.mass(0.5).inertia_com(1e-3, 1e-3, 1e-3).speed_limit(2.0).acceleration_limit(9.0);
}
/// A slide that carries a light body far beside its axis: as the body turns about its centre, the slide shifts.
struct LightBodies {
  static constexpr const char* name = "light_bodies";
  static constexpr auto chain =
      axial::chain(gravity(0.0, 0.0, -9.81),
                   light(revolute()).position_limits(-2.0, 2.0).effort_limit(4.0).drive_limits(-2.0, 2.0, 2.0, 9.0),
                   light(prismatic().alpha_deg(90).com(0.3, 0.0, 0.0))
                       .position_limits(0.0, 0.02)
                       .driven_by(0, -0.25)
                       .effort_limit(9.0)
                       .drive_limits(-1.0, 1.0, 2.0, 9.0));
};

}  // namespace

TEST(DriveMobility, BoundsTheInverseOfM) {
  expect_mobility<LightBodies>(3.0);
  expect_mobility<R, RotorInertia>(4.0);
  expect_mobility<R>(60.0);
  expect_mobility<property::Followers>(30.0);
  expect_mobility<property::Coupled<1>, RotorInertia>(30.0);
}

TEST(DriveSolve, AnswersToTheLastBitsOfItsWords) {
  using Bare = scene_of<Scene<R, Gravity>>;  // links alone resist: the elimination loses more
  const auto m = mass_matrix<Bare>(Positions<R, T>{});
  const detail::DriveSolve<Bare, std::int32_t> solve(m);
  EXPECT_EQ(solve.lost(), -1);
  const std::int64_t left[size] = {123456789, -400000000, 5000000, 77777, -66666};
  std::int32_t x[size] = {};
  int spilt = -1;
  solve.accelerations(left, x, spilt);
  EXPECT_EQ(spilt, -1);
  // M x in units of efforts, in double: what the words of M make of x is `left` to a unit of each acceleration.
  using Answers = FreeAccelerations<Bare, T>;
  for (int k = 0; k < size; ++k) {
    double made = 0.0, unit = 0.0;
    for (int l = 0; l < size; ++l) {
      const double entry = m(k, l).raw * detail::power_of_two(-m.exponent(k, l));
      made += entry * x[l] * detail::power_of_two(-Answers::exponent(l));
      unit += std::fabs(entry) * detail::power_of_two(-Answers::exponent(l));
    }
    const double given = static_cast<double>(left[k]) * detail::power_of_two(-EffortsOf<Bare, T>::exponent(k));
    EXPECT_NEAR(made, given, unit) << k;
  }
}
TEST(DriveSolve, NamesADriveWhoseInertiaIsLostAndHoldsIt) {
  auto m = mass_matrix<S>(Positions<R, T>{});
  m(3, 3).raw = 1000;
  for (int l = 0; l < size; ++l)
    if (l != 3) m(3, l).raw = 0;
  const Solve solve(m);
  EXPECT_EQ(solve.lost(), 3);
  const std::int64_t left[size] = {0, 0, 0, 1000000, 1000000};
  std::int32_t x[size] = {};
  int spilt = -1;
  solve.accelerations(left, x, spilt);
  EXPECT_EQ(x[3], 0);
  EXPECT_GT(x[4], 0);
}
TEST(DriveSolve, NamesADriveThatAWordDoesNotHold) {
  const auto m = mass_matrix<S>(Positions<R, T>{});
  const Solve solve(m);
  const std::int64_t left[size] = {0, 0, 0, 0, std::int64_t{1} << 32};
  std::int32_t x[size] = {};
  int spilt = -1;
  solve.accelerations(left, x, spilt);
  EXPECT_LT(spilt, 0) << "a whole word of effort at a tip drives it within its format";
  const std::int64_t all[size] = {std::int64_t{1} << 35, std::int64_t{1} << 35, 0, 0, 0};
  solve.accelerations(all, x, spilt);
  EXPECT_GE(spilt, 0);
}

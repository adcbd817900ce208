// The 6x6 solve of a free body against Gauss' elimination of the oracle.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <oracle/compare.hpp>
#include <random>

namespace {

using namespace axial;
using oracle::quad;

template <class T>
struct Problem {
  ArticulatedInertia<Sym3<T>, Mat3<Vec3<T>>, Sym3<T>> inertia;
  ForceVector<Vec3<T>, Vec3<T>> bias;
  CompositeScale<T, T, T> scale;
};

// B B^T + 1 of a random B, angular rows first.
template <class T>
Problem<T> random_problem(std::mt19937& engine, oracle::Matrix<quad>& dense, oracle::Vector<quad>& right) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  oracle::Matrix<quad> b(6, 6);
  for (int i = 0; i < 36; ++i)
    b(i / 6, i % 6) = uniform(engine);
  T m[6][6], p[6];
  dense = oracle::Matrix<quad>(6, 6), right.assign(6, quad(0));
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      quad sum = i == j ? 1 : 0;
      for (int k = 0; k < 6; ++k)
        sum += b(i, k) * b(j, k);
      m[i][j] = T(sum), dense(i, j) = quad(m[i][j]);
    }
    p[i] = T(uniform(engine)), right[std::size_t(i)] = -quad(p[i]);
  }
  return {{{m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]},
           {{m[0][3], m[0][4], m[0][5]}, {m[1][3], m[1][4], m[1][5]}, {m[2][3], m[2][4], m[2][5]}},
           {m[3][3], m[4][4], m[5][5], m[3][4], m[3][5], m[4][5]}},
          {{p[0], p[1], p[2]}, {p[3], p[4], p[5]}},
          {T(10), T(10), T(10)}};
}

template <class T>
void expect_solved(double tolerance) {
  std::mt19937 engine(7);
  oracle::Matrix<quad> dense;
  oracle::Vector<quad> right;
  for (int k = 0; k < 200; ++k) {
    const auto p = random_problem<T>(engine, dense, right);
    const auto result = free_motion<T>(Plain{}, p.inertia, p.bias, p.scale);
    const auto& [w, v] = result.acceleration;
    EXPECT_FALSE(result.singular);
    EXPECT_LE(oracle::relative_error(oracle::Vector<T>{w.x, w.y, w.z, v.x, v.y, v.z}, oracle::solve(dense, right)),
              tolerance);
  }
}

}  // namespace

// Condition numbers here scale 20 or so.
TEST(BaseSolve, EqualsElimination) {
  expect_solved<double>(1e-14);
  expect_solved<float>(5e-6);
}

TEST(BaseSolve, ScalesByPowersOfTwoToTheBit) {
  std::mt19937 engine(8);
  oracle::Matrix<quad> dense;
  oracle::Vector<quad> right;
  auto p = random_problem<float>(engine, dense, right);
  const auto before = free_motion<float>(Plain{}, p.inertia, p.bias, p.scale).acceleration;
  const float mass = 0x1p-40F, length = 0x1p9F;
  const auto scale = [](auto& s, float by) {
    for (float* x : {&s.xx, &s.yy, &s.zz, &s.xy, &s.xz, &s.yz})
      *x *= by;
  };
  scale(p.inertia.angular, mass * length * length), scale(p.inertia.linear, mass);
  for (auto* row : {&p.inertia.coupling.x, &p.inertia.coupling.y, &p.inertia.coupling.z})
    *row = mass * length * *row;
  p.bias = {mass * length * length * p.bias.moment, mass * length * p.bias.force};
  p.scale = {mass * p.scale.mass, mass * length * p.scale.first_moment, mass * length * length * p.scale.polar};
  const auto after = free_motion<float>(Plain{}, p.inertia, p.bias, p.scale).acceleration;
  EXPECT_EQ(after.angular.x, before.angular.x);
  EXPECT_EQ(after.angular.z, before.angular.z);
  EXPECT_EQ(after.linear.y, length * before.linear.y);
}

TEST(BaseSolve, ABodyThatResistsInNothingDoesNotMoveAndIsNamed) {
  const Sym3<double> none{};
  const ArticulatedInertia inertia{none, Mat3<Vec3<double>>{}, none};
  const auto result = free_motion<double>(Plain{}, inertia, ForceVector{Vec3{1.0, 1.0, 1.0}, Vec3{1.0, 1.0, 1.0}},
                                          CompositeScale{1.0, 1.0, 1.0});
  EXPECT_TRUE(result.singular);
  EXPECT_EQ(result.acceleration.linear.x, 0.0);
  EXPECT_EQ(result.acceleration.angular.z, 0.0);
}

// Derivatives of accelerations in float and double: what says ok is finite, whatever was asked.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/derivatives/forward_dynamics_along.hpp>
#include <axial/derivatives/forward_dynamics_derivatives.hpp>

#include "hostile.hpp"

namespace {

using namespace axial;
using property::SlidingTree;
using property::Wrong;

template <class T, class Joints>
Joints drawn(exhaustive::Random& random, std::uint64_t state, bool& finite) {
  Joints all{};
  for (auto& x : all.values) {
    const bool hostile = state % 2 == 0 && random.between(0, 3) == 0;
    x = hostile ? property::hostile_number<T>(random) : static_cast<T>(random.between(-1000, 1000)) * T(1e-3);
    finite = finite && is_finite(x);
  }
  return all;
}
template <class Matrix>
bool all_finite(const Matrix& matrix, int size) {
  bool finite = true;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      finite = finite && is_finite(matrix(i, j));
  return finite;
}

template <class T>
class HostileSlopes : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(HostileSlopes, Numbers);

}  // namespace

TYPED_TEST(HostileSlopes, AreFiniteOrSayOtherwise) {
  using T = TypeParam;
  using R = SlidingTree;
  exhaustive::Random random(property::hostile_seed);
  Wrong slopes, along;
  std::uint64_t ok = 0;
  const std::uint64_t states = property::hostile_states(100000, 2);
  for (std::uint64_t k = 0; k < states; ++k) {
    bool finite = true;
    const auto q = drawn<T, Positions<R, T>>(random, k, finite);
    const auto qd = drawn<T, Velocities<R, T>>(random, k, finite);
    const auto tau = drawn<T, EffortsOf<R, T>>(random, k, finite);
    const auto all = forward_dynamics_derivatives<R>(q, qd, tau);
    const bool right = finite && check_finite(all.qdd).ok() && all_finite(all.M_inverse, joint_count<R>) &&
                       all_finite(all.dqdd_dq, joint_count<R>) && all_finite(all.dqdd_dqd, joint_count<R>);
    slopes.note(!all.qdd.status.ok() || right, "derivatives", k, 0.0, 1.0);
    const auto way = drawn<T, Joints<R, T>>(random, k, finite);
    const auto one = forward_dynamics_along<R>(q, qd, tau, {way, way, way});
    const bool known = finite && check_finite(one.qdd, one.dqdd).ok();
    along.note(!one.qdd.status.ok() || known, "along a direction", k, 0.0, 1.0);
    ok += all.qdd.status.ok() && one.qdd.status.ok() ? 1 : 0;
  }
  EXPECT_EQ(slopes.count, 0U) << slopes.first;
  EXPECT_EQ(along.count, 0U) << along.first;
  EXPECT_GT(ok, states / 4) << "then this tests nothing";
}

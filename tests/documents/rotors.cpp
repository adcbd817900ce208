// doc/guides/rotors.md: a wrist whose rotors spin.
#include <gtest/gtest.h>

#include <axial/axial.hpp>
#include <axial/cost.hpp>
#include <robots/puma560.hpp>

namespace {

#include "rotors-1.inc"

TEST(RotorsPage, AWristFeelsThem) {
  const axial::Joints<Wrist, double> q{0.1, 0.2, 0.3, 0.4}, qd{2.0, 3.0, -4.0, 5.0}, qdd{1.0, 2.0, 3.0, 4.0};
  const auto with = axial::inverse_dynamics<Spinning>(q, qd, qdd), without = axial::inverse_dynamics<Wrist>(q, qd, qdd);
  EXPECT_NE(with[0], without[0]);
  const auto back = axial::forward_dynamics<Spinning>(q, qd, with);
  EXPECT_TRUE(back.status.ok());
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(back[i], qdd[i], 1e-10);
}

// What the page says of the Puma.
TEST(RotorsPage, CostsWhatItSays) {
  using Bare = robots::Puma560;
  using Rotors = axial::Scene<Bare, axial::Gravity, axial::RotorInertia, axial::RotorDynamics>;
  constexpr auto inverse = axial::cost<Rotors>(axial::algorithm::inverse_dynamics);
  constexpr auto bare = axial::cost<Bare>(axial::algorithm::inverse_dynamics);
  EXPECT_EQ(inverse.mul - bare.mul, 20);
  EXPECT_EQ(inverse.add - bare.add, 16);
  constexpr auto matrix = axial::cost<Rotors>(axial::algorithm::mass_matrix);
  constexpr auto plain = axial::cost<Bare>(axial::algorithm::mass_matrix);
  EXPECT_EQ(matrix.mul - plain.mul, 0);
  EXPECT_EQ(matrix.add - plain.add, 2);
}

}  // namespace

// Every rounding of mass_matrix() is in the plain loops, too: the route is judged by them.
#include <gtest/gtest.h>
#include <axial/dynamics/elimination_loss.hpp>
#include <robots/puma560.hpp>
#include <robots/scara_rrpr.hpp>
#include <robots/torso.hpp>

using namespace axial;

namespace {

template <class S, class T>
Positions<robot_of<S>, T> sampled(int sample) {
  using Robot = typename S::Robot;
  Positions<robot_of<S>, T> q{};
  for (int i = 0; i < Robot::chain.size; ++i)
    q[i] =
        static_cast<T>(static_cast<float>(detail::sampled_position(Robot::chain.links, Robot::chain.size, sample, i)));
  return q;
}

template <class S, class Matrix, class Plain>
void expect_same(const Matrix& m, const Plain& plain) {
  for (int i = 0; i < S::Robot::chain.size; ++i)
    for (int j = i; j >= 0; j = S::Robot::chain.parent(j))
      EXPECT_EQ(plain(i, j), m(i, j)) << i << ", " << j;
}

template <class Robot, class T>
void expect_every_rounding() {
  using Bare = Scene<Robot, Looped>;
  using WithRotors = Scene<Robot, Looped, RotorInertia>;
  using Loaded = Scene<Robot, Looped, RotorInertia, Payload>;
  for (int sample = 0; sample < detail::loss_samples; ++sample) {
    const auto q = sampled<Bare, T>(sample);
    expect_same<Bare>(mass_matrix<Bare>(q), detail::sampled_matrix<Scene<Robot>, false, T>(sample));
    expect_same<WithRotors>(mass_matrix<WithRotors>(q),
                            detail::sampled_matrix<Scene<Robot, RotorInertia>, false, T>(sample));
    Inputs<Loaded, T> in{};
    in.payload = detail::largest_payload<Robot, T>(sample);
    expect_same<Loaded>(mass_matrix<Loaded>(q, in),
                        detail::sampled_matrix<Scene<Robot, RotorInertia>, true, T>(sample));
  }
}

}  // namespace

TEST(PlainMassMatrix, RoundsAsMassMatrixDoes) {
  expect_every_rounding<robots::Puma560, float>();
  expect_every_rounding<robots::Puma560, double>();
}
TEST(PlainMassMatrix, RoundsAsMassMatrixDoesOfSlides) { expect_every_rounding<robots::ScaraRrpr, float>(); }
TEST(PlainMassMatrix, RoundsAsMassMatrixDoesOfTrees) { expect_every_rounding<robots::Torso, float>(); }

// What the algorithms cost: exact operation counts of generic chains, so that a change of the kernels shows here.
#include <gtest/gtest.h>

#include <axial/cost.hpp>
#include <cstdio>
#include <ostream>
#include <utility>

#include "generic_robots.hpp"

using namespace generic;

namespace axial {
static void PrintTo(const Operations& o, std::ostream* out) {
  *out << o.mul << "M " << o.add << "A " << o.div << "D " << o.sincos << "T";
}
}  // namespace axial

namespace {

constexpr int general = 37;  // a twist that is no multiple of 90 degrees

template <class R>
axial::Operations id() {
  return axial::cost<R>(axial::algorithm::inverse_dynamics);
}
template <class R>
constexpr axial::Operations aba() {
  using namespace axial;
  return cost<axial::Scene<R, Gravity, RotorInertia, ArticulatedBody>>(axial::algorithm::forward_dynamics);
}

// As a user states a budget; a miss does not compile.
static_assert(axial::cost<Robot<4, 0, true>>(axial::algorithm::inverse_dynamics).total() <= 89, "my control tick");
static_assert(axial::cost<Robot<4, 0, true>>(axial::algorithm::forward_dynamics).sincos <= 3);

// McMillan and Orin 1995: [(224N - 259)M, (205N - 248)A], divisions among the multiplications.
template <int N>
void expect_at_most_the_paper() {
  constexpr auto ours = aba<Robot<N, general>>();
  constexpr int mul = 224 * N - 259, add = 205 * N - 248;
  std::printf("%2d joints: %d M (paper %d), %d A (paper %d)\n", N, ours.mul + ours.div, mul, ours.add, add);
  EXPECT_LE(ours.mul + ours.div, mul) << N;
  EXPECT_LE(ours.add, add) << N;
  if (N > 2) {  // as doc/measurements/counts.md says
    EXPECT_EQ(ours.mul + ours.div, 211 * N - 303) << N;
    EXPECT_EQ(ours.add, 203 * N - 309) << N;
  }
}
template <int... I>
void expect_at_most_the_paper(std::integer_sequence<int, I...>) {
  (expect_at_most_the_paper<I + 2>(), ...);
}

}  // namespace

TEST(Counts, InverseDynamicsBySixTwists) {
  EXPECT_EQ((id<Robot<6, 0>>()), (axial::Operations{95, 75, 0, 5}));
  EXPECT_EQ((id<Robot<6, 90>>()), (axial::Operations{290, 267, 0, 5}));
  EXPECT_EQ((id<Robot<6, -90>>()), (axial::Operations{290, 267, 0, 5}));
  EXPECT_EQ((id<Robot<6, general>>()), (axial::Operations{391, 329, 0, 5}));
}

TEST(Counts, ArticulatedBodiesBySixTwists) {
  EXPECT_EQ((aba<Robot<6, 0>>()), (axial::Operations{189, 171, 5, 5}));
  EXPECT_EQ((aba<Robot<6, 90>>()), (axial::Operations{754, 759, 5, 5}));
  EXPECT_EQ((aba<Robot<6, -90>>()), (axial::Operations{754, 759, 5, 5}));
  EXPECT_EQ((aba<Robot<6, general>>()), (axial::Operations{958, 909, 5, 5}));
}

TEST(Counts, PrismaticTip) {
  EXPECT_EQ((id<Robot<4, 0, true>>()), (axial::Operations{39, 28, 0, 2}));
  EXPECT_EQ((id<Robot<4, general, true>>()), (axial::Operations{221, 181, 0, 2}));
  EXPECT_EQ((aba<Robot<4, 0, true>>()), (axial::Operations{84, 67, 2, 2}));
  EXPECT_EQ((aba<Robot<4, general, true>>()), (axial::Operations{484, 460, 3, 2}));
}

TEST(Counts, MassMatrix) {
  EXPECT_EQ((axial::cost<Robot<6, 0>>(axial::algorithm::mass_matrix)), (axial::Operations{70, 63, 0, 5}));
  EXPECT_EQ((axial::cost<Robot<6, general>>(axial::algorithm::mass_matrix)), (axial::Operations{331, 275, 0, 5}));
}

// Without regrouping every link's ten parameters are felt.
TEST(Counts, FullParametersCostMore) {
  using S = axial::Scene<Robot<6, general>, axial::Gravity, axial::FullParameters>;
  EXPECT_EQ(id<S>(), (axial::Operations{436, 374, 0, 5}));
  EXPECT_EQ(axial::cost<S>(axial::algorithm::mass_matrix), (axial::Operations{331, 297, 0, 5}));
}

TEST(Counts, WhatIsNotAskedIsNotComputed) {
  using R = Robot<6, general>;
  EXPECT_EQ(axial::cost<R>(axial::algorithm::gravity), (axial::Operations{86, 51, 0, 5}));
  EXPECT_EQ((axial::cost<Robot<6, 0>>(axial::algorithm::gravity)),
            (axial::Operations{0, 0, 0, 0}));  // gravity along the axes
  const auto whole = axial::cost<R>(axial::algorithm::inverse_dynamics), bias = axial::cost<R>(axial::algorithm::bias);
  EXPECT_LT(bias.mul + bias.add, whole.mul + whole.add);
  const auto weightless = axial::cost<axial::Scene<R, axial::RotorInertia>>(axial::algorithm::inverse_dynamics);
  EXPECT_LT(weightless.mul + weightless.add, whole.mul + whole.add);
}

TEST(Counts, FeaturesCostOnlyWhereTheyAreNamed) {
  using R = Robot<3, general>;  // declares neither rotor nor friction
  const auto bare = id<axial::Scene<R, axial::Gravity>>();
  EXPECT_EQ((id<axial::Scene<R, axial::Gravity, axial::RotorInertia>>()), bare);
  const auto wrench = id<axial::Scene<R, axial::Gravity, axial::TipWrench>>();
  EXPECT_EQ(wrench.add, bare.add + 6);
  EXPECT_EQ(wrench.mul, bare.mul);
}

TEST(Counts, ArticulatedBodiesStayBelowMcMillanAndOrin) {
  expect_at_most_the_paper(std::make_integer_sequence<int, 15>{});  // 2 to 16 joints
}

// Fixed point against float on the same states, each against double at its own inputs; bounds and certified errors
// under a search that tries to exceed them.
#include <host_sim/figures/exhaustive/fixed_quantities.hpp>

#include "fixed_robots.hpp"

namespace {

using namespace axial;
using exhaustive::errors;
using exhaustive::gain_over_float;
constexpr std::uint64_t states = 20000, seed = 7;

template <class R>
class FixedErrors : public testing::Test {};
TYPED_TEST_SUITE(FixedErrors, property::EveryArm, property::RobotName);

}  // namespace

TYPED_TEST(FixedErrors, InverseDynamicsIsFiveTimesBetterThanFloat) {
  const double gain = gain_over_float(errors<exhaustive::InverseDynamics, TypeParam, Fixed32>(states, seed));
  std::printf("%.1f times better than float\n", gain);
  EXPECT_GE(gain, 5.0);
}

TYPED_TEST(FixedErrors, NoStateExceedsTheCertifiedError) {
  const auto seen = errors<exhaustive::InverseDynamics, TypeParam, Fixed32>(states, seed);
  for (int i = 0; i < TypeParam::chain.size; ++i) {
    const double bound = exhaustive::certified<TypeParam, Fixed32>(i);
    const double worst = std::fmax(seen[static_cast<std::size_t>(i)].fixed / bound,
                                   exhaustive::adversary<TypeParam, Fixed32>(i, 4000, seed));
    std::printf("joint %d: certified %.2e, of which a search reaches %.3f\n", i, bound, worst);
    EXPECT_LE(worst, 1.0) << "joint " << i;
    EXPECT_GT(worst, 0.001) << "a bound as loose as this certifies little: joint " << i;
  }
}

TEST(FixedErrorBounds, NoStateOfThePumaExceedsABound) {
  for (const auto& quantity : exhaustive::bounded) {
    double nearest = 0.0;
    for (int i = 0; i < 6; ++i) {
      const double near = exhaustive::nearness<robots::Puma560>(quantity, i, 2000, seed);
      EXPECT_LE(near, 1.0 + 1e-12) << quantity.name << " of link " << i;
      nearest = std::fmax(nearest, near);
    }
    std::printf("%s: a search comes to %.3f of a bound\n", quantity.name, nearest);
    EXPECT_GT(nearest, 0.2) << quantity.name;
  }
}

template <class R>
double certified_worst() {
  double worst = 0.0;
  for (int i = 0; i < R::chain.size; ++i)
    worst = std::fmax(worst, exhaustive::certified<R, Fixed32>(i));
  return worst;
}
// RoboPrec's published bounds for 32 bits, in N m.
TEST(FixedErrorBounds, CertifiedErrorsAreAHundredTimesTighterThanPublishedOnes) {
  EXPECT_LE(100.0 * certified_worst<robots::RoarmM2>(), 1.26e-6);
  EXPECT_LE(100.0 * certified_worst<robots::Indy7>(), 3.9e-4);
  EXPECT_LE(100.0 * certified_worst<robots::PandaSlow>(), 1.0e-3);
}

TEST(FixedErrorBounds, TheScaraClosedFormIsFiftyTimesBetterThanFloat) {
  const double gain = gain_over_float(errors<exhaustive::ClosedForm, robots::Scara, Fixed32>(states, seed));
  std::printf("%.1f times better than float\n", gain);
  EXPECT_GE(gain, 50.0);
}

// Efforts uniform within the declared ones. The Panda without rotor inertias solves twice: its formats leave room for
// what its links' own inertias would allow, hundreds of times what occurs.
template <class R>
class FixedForwardErrors : public testing::Test {};
using Forward = testing::Types<robots::Scara, robots::ScaraRrpr, robots::Puma560, robots::Planar2r, robots::Panda>;
TYPED_TEST_SUITE(FixedForwardErrors, Forward, property::RobotName);

TYPED_TEST(FixedForwardErrors, TheSplitFormIsFiveTimesBetterThanFloat) {
  const double gain = gain_over_float(errors<exhaustive::ForwardDynamics, TypeParam, Fixed32>(states, seed));
  std::printf("%.1f times better than float\n", gain);
  EXPECT_GE(gain, 5.0);
}

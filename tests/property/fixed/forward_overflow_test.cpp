// Nothing overflows in forward dynamics, split or classical, whatever the efforts: at random states and corners, every
// eighth time with efforts as large as a word holds them.
#include <host_sim/figures/exhaustive/fixed_kernels.hpp>

#include "fixed_robots.hpp"

namespace {

using namespace axial;
constexpr std::uint64_t states = 10000, seed = 6;

template <class R>
class FixedForwardOverflow : public testing::Test {};
using Arms = testing::Types<robots::Scara, robots::ScaraRrpr, robots::Puma560, robots::Panda>;
TYPED_TEST_SUITE(FixedForwardOverflow, Arms, property::RobotName);

template <class R, class T, class... Mode>
void expect_none() {
  using S = Scene<R, Gravity, RotorInertia, RangeCheck, Mode...>;
  EXPECT_EQ((exhaustive::overflows<exhaustive::ForwardDynamics, S, T>(states, seed)), 0U);
}

}  // namespace

TYPED_TEST(FixedForwardOverflow, TheSplitFormNeverOverflows) { expect_none<TypeParam, Fixed32>(); }
TYPED_TEST(FixedForwardOverflow, TheClassicalFormNeverOverflows) { expect_none<TypeParam, Fixed32, ArticulatedBody>(); }

template <class R>
void expect_none_in_any_mode() {
  expect_none<R, Fixed32, RoundDown>();
  expect_none<R, Fixed32, HighWord>();
  expect_none<R, Fixed32, ArticulatedBody, HighWord>();
  expect_none<R, Fixed16>();
  expect_none<R, Fixed16, HighWord>();
  expect_none<R, Fixed16, ArticulatedBody>();
}
TEST(FixedForwardOverflows, ScaraInEveryMode) { expect_none_in_any_mode<robots::Scara>(); }

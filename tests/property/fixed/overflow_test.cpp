// Nothing overflows inside the limits: inverse dynamics of every robot, of two in both words and all modes, at random
// states and corners. `./axial exhaustive --ranges` runs the same over 10^8 states.
#include <host_sim/figures/exhaustive/fixed_kernels.hpp>

#include "fixed_robots.hpp"

namespace {

using namespace axial;
constexpr std::uint64_t states = 20000, seed = 5;

template <class R>
class FixedOverflow : public testing::Test {};
TYPED_TEST_SUITE(FixedOverflow, property::EveryRobot, property::RobotName);

template <template <class, class> class Kernel, class R, class T, class... Mode>
void expect_none() {
  using S = Scene<R, Gravity, RotorInertia, RangeCheck, Mode...>;
  EXPECT_EQ((exhaustive::overflows<Kernel, S, T>(states, seed)), 0U) << Kernel<S, T>::name;
}

}  // namespace

TYPED_TEST(FixedOverflow, InverseDynamicsNeverOverflows) {
  expect_none<exhaustive::InverseDynamics, TypeParam, Fixed32>();
}

template <class R>
void expect_none_in_any_mode() {
  expect_none<exhaustive::InverseDynamics, R, Fixed32, RoundDown>();
  expect_none<exhaustive::InverseDynamics, R, Fixed32, HighWord>();
  expect_none<exhaustive::InverseDynamics, R, Fixed16>();
  expect_none<exhaustive::InverseDynamics, R, Fixed16, RoundDown>();
  expect_none<exhaustive::InverseDynamics, R, Fixed16, HighWord>();
  expect_none<exhaustive::BiasTorque, R, Fixed32>();
  expect_none<exhaustive::GravityTorque, R, Fixed32>();
}
TEST(FixedOverflows, ScaraInEveryMode) { expect_none_in_any_mode<robots::Scara>(); }
TEST(FixedOverflows, PumaInEveryMode) { expect_none_in_any_mode<robots::Puma560>(); }

TEST(FixedOverflows, TheClosedFormNeverOverflows) {
  using R = robots::Scara;
  expect_none<exhaustive::ClosedForm, R, Fixed32>();
  expect_none<exhaustive::ClosedForm, R, Fixed32, RoundDown>();
  expect_none<exhaustive::ClosedForm, R, Fixed32, HighWord>();
  expect_none<exhaustive::ClosedForm, R, Fixed16>();
  expect_none<exhaustive::ClosedForm, R, Fixed16, HighWord>();
}

// Negative control: a speed beyond the limit does overflow, and is counted.
TEST(FixedOverflows, BeyondTheLimitsOverflowsAreSeen) {
  using S = Scene<robots::Puma560, Gravity, RotorInertia, RangeCheck>;
  exhaustive::FixedState<S, Fixed32> state;
  for (int k = 6; k < 18; ++k)
    state.set(k, INT32_MAX);
  const std::uint64_t before = range_overflows;
  for (int k = 0; k < 8; ++k) {
    for (int joint = 0; joint < 6; ++joint)
      state.set(joint, (k * 5 + joint * 3) % 8 * (std::int64_t{1} << 29) - (std::int64_t{1} << 31));
    const volatile auto raw = exhaustive::InverseDynamics<S, Fixed32>::run(state)[0].raw;
    static_cast<void>(raw);
  }
  EXPECT_GT(range_overflows, before);
}

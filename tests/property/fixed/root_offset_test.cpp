// Robots whose first joint stands off the base frame, as importers write them: nothing of them overflows, looped or
// not. What the first link sends to the base nobody reads, and its formats have no room for it.
#include <gtest/gtest.h>

#include <axial/fixed.hpp>
#include <host_sim/figures/exhaustive/fixed_search.hpp>

namespace {

using namespace axial;

constexpr Link limited(const Link& link) {
  return link.position_limits(-3.0, 3.0).speed_limit(2.0).acceleration_limit(10.0).effort_limit(200.0);
}
/// The first joint's axis is 1.5 m from the base frame; its body's centre of mass lies across the way there.
struct FarRoot {
  static constexpr auto chain = axial::chain(
      gravity(0.0, 0.0, -9.81),
      limited(revolute().a(-1.5).alpha(0.4).d(0.3).mass(3.0).com(-0.2, 0.1, 0.05).inertia_com(0.1, 0.1, 0.1)),
      limited(revolute().a(-0.26).alpha(-1.5).mass(1.0).com(-0.1, 0.1, 0.05).inertia_com(0.1, 0.1, 0.1)),
      limited(revolute().parent(0).a(-0.3).alpha(1.1).mass(2.0).com(-0.1, 0.1, 0.05).inertia_com(0.1, 0.1, 0.1)));
};
/// Two trees beside each other: links 0 and 1 both stand on the base.
struct TwoRoots {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -9.81, 0.0),
                   limited(revolute().a(2.0).alpha(-0.7).mass(2.0).com(0.3, -0.1, 0.05).inertia_com(0.05, 0.1, 0.1)),
                   limited(revolute()
                               .parent(LinkParameters::base)
                               .a(-3.0)
                               .alpha(0.7)
                               .mass(0.5)
                               .com(0.2, 0.1, 0.0)
                               .inertia_com(0.01, 0.02, 0.02)));
};

/// States at which `run` overflows, corners among them.
template <class S, class Run>
int overflowing(const Run& run) {
  using State = exhaustive::FixedState<S, Fixed32>;
  exhaustive::Random random(11);
  int found = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const auto state = exhaustive::next_state<State>(random, k % 4);
    const std::uint64_t before = range_overflows;
    run(state);
    found += before != range_overflows ? 1 : 0;
  }
  return found;
}
template <class S>
void expect_room() {
  const auto expect = [](const char* kernel, const auto& run) { EXPECT_EQ(overflowing<S>(run), 0) << kernel; };
  expect("inverse dynamics", [](const auto& s) { (void)inverse_dynamics<S>(s.q, s.qd, s.qdd); });
  expect("gravity", [](const auto& s) { (void)gravity_torque<S>(s.q); });
  expect("mass matrix", [](const auto& s) { (void)mass_matrix<S>(s.q); });
  expect("momenta", [](const auto& s) { (void)momentum_terms<S>(s.q, s.qd); });
  expect("poses", [](const auto& s) { (void)forward_kinematics<S>(s.q); });
  expect("derivatives", [](const auto& s) { (void)inverse_dynamics_derivatives<S>(s.q, s.qd, s.qdd); });
}
/// What has no looped form in fixed point.
template <class S>
void expect_room_unrolled() {
  const auto expect = [](const char* kernel, const auto& run) { EXPECT_EQ(overflowing<S>(run), 0) << kernel; };
  expect("certified", [](const auto& s) { (void)certified_forward_dynamics<S>(s.q, s.qd, s.tau); });
  expect("separation", [](const auto& s) { (void)torque(separate<S>(s.q), s.qd, s.qdd); });
  expect("forward dynamics", [](const auto& s) { (void)forward_dynamics<S>(s.q, s.qd, s.tau); });
}

}  // namespace

TEST(RootOffset, OverflowsNothing) {
  expect_room<Scene<FarRoot, Gravity, RangeCheck>>();
  expect_room<Scene<TwoRoots, Gravity, RangeCheck>>();
  expect_room_unrolled<Scene<FarRoot, Gravity, RangeCheck>>();
  expect_room_unrolled<Scene<TwoRoots, Gravity, RangeCheck>>();
}
TEST(RootOffset, OverflowsNothingInLoops) {
  expect_room<Scene<FarRoot, Gravity, Looped, RangeCheck>>();
  expect_room<Scene<TwoRoots, Gravity, Looped, RangeCheck>>();
}
TEST(RootOffset, OverflowsNothingByArticulatedBodies) {
  using S = Scene<FarRoot, Gravity, ArticulatedBody, RangeCheck>;
  EXPECT_EQ(overflowing<S>([](const auto& s) { (void)forward_dynamics<S>(s.q, s.qd, s.tau); }), 0);
}

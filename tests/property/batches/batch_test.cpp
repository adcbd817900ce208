// Batches of states: robots, scenes, routes; held joints and entry checks, lane by lane.
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include "batch_suite.hpp"

namespace property {
namespace {

/// Links on a body that floats.
struct OnBody {
  static constexpr auto chain = [] {
    auto chain = property::Everything::chain;
    chain.base_body = base_body().mass(12.0).com(0.125, -0.0625, 0.25).inertia_com(1.5, 2.25, 1.75).parameters();
    chain.has_base_body = true;
    return chain;
  }();
};

template <class... Features>
using InScene = Scene<Everything, Features...>;
using All = testing::Types<
    Case<robots::Puma560, double, 4>,
    Case<InScene<Gravity, Friction, JointSprings, ArticulatedBody, Looped>, double, 4>,
    Case<Scene<OnBody, FloatingBase>, double, 4>
#ifndef AXIAL_FEW_ROBOTS
    ,
    Case<robots::Scara, float, 16>, Case<Scene<robots::Panda, Gravity, SplitArticulatedBody>, double, 8>,
    Case<InScene<RuntimeGravity, RotorInertia, Friction, TipWrench, ExternalWrenches, ArticulatedBody>, double, 2>,
    Case<InScene<Gravity, RotorInertia, Friction, CompositeBody, Looped>, float, 8>,
    Case<InScene<Gravity, SineCosines, SplitArticulatedBody, Looped>, double, 4>,
    Case<Scene<OnBody, FloatingBase, RuntimeGravity, RotorInertia, Looped>, float, 4>
#endif
    >;
INSTANTIATE_TYPED_TEST_SUITE_P(Scenes, Batches, All);

// A last link of which nothing but a payload resists: without one its joint is held, in that lane alone.
struct Carrier {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -9.81, 0.0), revolute().mass(4.6).com(0.5, 0, 0).inertia_com(0.2, 0.3, 0.4),
                   revolute().a(0.5).mass(2.3).com(0.4, 0, 0).inertia_com(0.03, 0.03, 0.03), revolute().a(0.4));
};
using Routes = testing::Types<ArticulatedBody, SplitArticulatedBody, CompositeBody>;
template <class Route>
class HeldJoint : public testing::Test {};
TYPED_TEST_SUITE(HeldJoint, Routes);

template <class S, class T>
auto solved(const Joints<Carrier, T>& q, const T& mass) {
  Inputs<S, T> in;
  in.payload.mass = mass, in.payload.com = {T(0.25), T(Zero{}), T(Zero{})};
  return forward_dynamics<S>(q, q, q, in);
}
template <class S>
void expect_held_alone() {
  const Joints<Carrier, double> q[4] = {{0.1, 0.4, -0.2}, {0.2, 0.5, 0.3}, {-0.3, 0.7, 0.1}, {0.6, -0.5, 0.2}};
  const double masses[] = {2.0, 1.0, 0.0, 3.0};
  const auto all = solved<S>(load<4>(q), Batch<double, 4>::of([&](int k) { return masses[k]; }));
  for (int k = 0; k < 4; ++k) {
    const auto one = solved<S>(q[k], masses[k]);
    property::Answers got, wanted;
    got.add("forward dynamics", all, k), wanted.add("forward dynamics", one, 0);
    property::expect_agreement(got, wanted, 1e-9);
    EXPECT_EQ(all.status[k].code, k == 2 ? Status::Code::near_singular : Status::Code::ok);
    EXPECT_EQ(all.status[k].joint, k == 2 ? 2 : -1);
  }
  EXPECT_EQ(all[2][2], 0.0);
  EXPECT_FALSE(all.status.ok());
}
TYPED_TEST(HeldJoint, StaysInItsLane) {
  expect_held_alone<Scene<Carrier, Gravity, Payload, TypeParam>>();
  expect_held_alone<Scene<Carrier, Gravity, Payload, TypeParam, Looped>>();
}

// The entry checks' statuses: what each lane asks.
TEST(BatchChecks, SpeakOfEachLane) {
  using R = robots::Puma560;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Joints<R, double> q[4]{}, qd[4]{}, qdd[4]{};
  q[1][3] = 100.0, qd[2][4] = nan, qdd[3][5] = 1e9;
  const auto asked = check_request<R>(load<4>(q), load<4>(qd), load<4>(qdd));
  const auto placed = check_position<R>(load<4>(q));
  const auto finite = check_finite(load<4>(q), load<4>(qd), load<4>(qdd));
  for (int k = 0; k < 4; ++k) {
    const Status one = check_request<R>(q[k], qd[k], qdd[k]);
    EXPECT_EQ(asked[k].code, one.code) << k;
    EXPECT_EQ(asked[k].joint, one.joint) << k;
    EXPECT_EQ(placed[k].code, k == 1 ? Status::Code::position_limit : Status::Code::ok) << k;
    EXPECT_EQ(finite[k].code, k == 2 ? Status::Code::not_finite : Status::Code::ok) << k;
    EXPECT_EQ(finite[k].joint, k == 2 ? 4 : -1) << k;
  }
}

}  // namespace
}  // namespace property

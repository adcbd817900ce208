// Kernels ask of links what links/README.md lists and nothing else: over views that have no more they find what they
// find over the library's own.
#include <gtest/gtest.h>
#include <axial/axial.hpp>

#include "minimal_view.hpp"

namespace {

using namespace minimal;
using Values = Joints<Arm, double>;

constexpr Values q{0.3, 0.4}, qd{-0.5, 0.6}, qdd{0.7, -0.8}, effort{2.0, -1.0};
constexpr double rounding = 1e-13;  // of numbers up to 100

template <class... Features>
using Fixed = Scene<Arm, Gravity, RotorInertia, Friction, JointSprings, Payload, TipWrench, Features...>;
template <class... Features>
using Moving = Scene<Arm, RuntimeGravity, RotorInertia, ExternalWrenches, BaseMotion, SineCosines, Features...>;

template <class S>
auto inputs() {
  Inputs<S, double> in{};
  if constexpr (S::template has<Payload>) in.payload = {1.5, {0.1, 0.2, 0.3}, {0.1, 0.2, 0.2, 0.01, 0.0, 0.02}};
  if constexpr (S::template has<TipWrench>) in.tip_wrench = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  if constexpr (S::template has<RuntimeGravity>) in.gravity = {1.0, -2.0, -9.0};
  if constexpr (S::template has<ExternalWrenches>)
    in.wrenches.values[0] = in.wrenches.values[1] = {{1.0, -1.0, 2.0}, {3.0, 1.0, -2.0}};
  if constexpr (S::template has<BaseMotion>) in.base_motion = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.7, 0.8, 0.9}};
  if constexpr (S::template has<SineCosines>) in.turns = sine_cosines<S>(q);
  return in;
}

template <class A, class B>
void expect_near(const A& a, const B& b, const char* what) {
  for (int i = 0; i < 2; ++i)
    EXPECT_NEAR(a[i], b[i], rounding) << what << ' ' << i;
}
void expect_near(const Vec3<double>& a, const Vec3<double>& b, const char* what) {
  EXPECT_NEAR(a.x, b.x, rounding) << what;
  EXPECT_NEAR(a.y, b.y, rounding) << what;
  EXPECT_NEAR(a.z, b.z, rounding) << what;
}

// Every kernel that walks over links of any kind.
template <class S, class Links>
void expect_any_scene_works(const Links& links) {
  const auto in = inputs<S>();
  Values tau{};
  execute<rnea::InverseDynamics>(links, in, q, qd, qdd, tau);
  expect_near(tau, inverse_dynamics<S>(q, qd, qdd, in), "inverse_dynamics");
  EXPECT_NEAR(rnea::run_joint(links, in, links.last(), q, qd, qdd), tau[1], rounding) << "joint_torque";
  const auto wrench = base_wrench<S>(q, qd, qdd, in);
  const auto force = rnea::force_on_base(links, in, q, qd, qdd);
  expect_near(force.moment, wrench.moment, "base_wrench");
  expect_near(force.force, wrench.force, "base_wrench");

  MassMatrix<Arm, double> m{};
  execute<crba::CompositeMatrix>(links, in, q, m);
  const auto matrix = mass_matrix<S>(q, in);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(m.values[i], matrix.values[i], rounding) << "mass_matrix " << i;

  const auto wanted = forward_dynamics<S>(q, qd, effort, in);
  ForwardDynamics<Arm, double> answer{};
  EXPECT_TRUE(aba::run(links, in, q, qd, effort, answer).ok());
  expect_near(answer, wanted, "articulated body");
  EXPECT_TRUE(execute<aba::SplitForm>(links, links, in, q, qd, effort, answer).ok());
  expect_near(answer, wanted, "split form");
  EXPECT_TRUE(execute<crba::Accelerations>(links, in, q, qd, effort, answer).ok());
  expect_near(answer, wanted, "composite body");
  EXPECT_TRUE(axial::detail::sound_status(links, detail::collected_request(links, in, q, qd), answer, Status{}).ok());

  const auto poses = forward_kinematics<S>(q, in);
  ForwardKinematics<Arm, double> placed{};
  execute<kinematics::Poses>(links, in, q, placed);
  expect_near(placed.tool.position, poses.tool.position, "tool");
  expect_near(placed.frames[0].rotation.y, poses.frames[0].rotation.y, "frame");
  const auto columns = jacobian<S>(q, in);
  Jacobian<Arm, double> of_tool{}, of_link{};
  execute<kinematics::ToolColumns>(links, in, of_tool, q);
  execute<kinematics::LinkColumns>(links, in, of_link, q, links.last());
  for (int i = 0; i < 2; ++i) {
    expect_near(of_tool[i].linear, columns[i].linear, "jacobian");
    expect_near(of_link[i].angular, columns[i].angular, "jacobian of a link");
  }
}

// Those that need a base at rest.
template <class S, class Links>
void expect_base_at_rest_works(const Links& links) {
  const auto in = inputs<S>();
  const auto wanted = separate<S>(q, in);
  const auto terms = separation::collected<Separated<S, double>, S, double>(links, in, q);
  for (int i = 0; i < 2; ++i) {
    expect_near(terms.A[i], wanted.A[i], "A");
    expect_near(terms.C[i], wanted.C[i], "C");
    EXPECT_NEAR(terms.B[i][0], wanted.B[i][0], rounding) << "B";
  }
  expect_near(terms.G, wanted.G, "G");
  expect_near(separation::TorqueOf<S, double>::from(links, terms, qd, qdd), torque(wanted, qd, qdd), "torque");

  MomentumTerms<S, double> moved{};
  momentum::run(links, links, in, q, qd, moved);
  const auto momenta = momentum_terms<S>(q, qd, in);
  expect_near(moved.momentum, momenta.momentum, "momentum");
  expect_near(moved.drift, momenta.drift, "drift");

  Joints<Arm, SinCos<double>> turns{};
  axial::detail::fill_turns(links, q, turns);
  EXPECT_NEAR(turns[0].sin, std::sin(q[0]), rounding);
}

TEST(LinkViewContract, HoldsUnrolled) {
  expect_any_scene_works<Fixed<>>(UnrolledLinks<Fixed<>>{});
  expect_any_scene_works<Moving<>>(UnrolledLinks<Moving<>>{});
  expect_base_at_rest_works<Fixed<>>(UnrolledLinks<Fixed<>>{});
}

TEST(LinkViewContract, HoldsLooped) {
  expect_any_scene_works<Fixed<Looped>>(LoopedLinks<Fixed<Looped>>{});
  expect_any_scene_works<Moving<Looped>>(LoopedLinks<Moving<Looped>>{});
  expect_base_at_rest_works<Fixed<Looped>>(LoopedLinks<Fixed<Looped>>{});
}

}  // namespace

// Inverse and forward dynamics along a direction: against a closed form, and differences of what they are of.
#include <gtest/gtest.h>
#include <axial/batch.hpp>
#include <cmath>

using namespace axial;

namespace {

constexpr double g = 9.8125, m1 = 2.0, m2 = 1.5, l1 = 0.5, l2 = 0.75;

struct Planar {  // two point masses in a vertical plane, y upwards
  static constexpr auto chain =
      axial::chain(gravity(0, -g, 0), revolute().mass(m1).com(l1, 0, 0), revolute().a(l1).mass(m2).com(l2, 0, 0));
};

// Everything at once: both kinds of joints, twists of any angle, a branch, full inertias, drives.
constexpr auto body(const Link& joint, double of) {
  return joint.mass(1.0 + of)
      .com(0.1 * of, -0.07, 0.05 + 0.02 * of)
      .inertia_com(0.05, 0.06, 0.07, 0.01, -0.008, 0.004)
      .rotor_inertia(1e-3, 10);
}
struct Mixed {
  static constexpr auto chain = axial::chain(
      gravity(0.5, -1.0, -9.75), body(revolute().d(0.3), 0.5).viscous(0.5).coulomb(2.0, -1.0).smooth_speed(2.0),
      body(revolute().alpha_deg(37).a(0.2).d(0.1), 1.0).coulomb(2.0, -1.0).stribeck(3.0, 0.25),
      body(prismatic().alpha_deg(-64).a(0.15).theta_deg(28), 0.25).spring(40.0, 0.1),
      body(revolute().branch(0.4, 0.1).alpha_deg(90).a(0.05).d(0.2), 0.75).viscous(0.25),
      body(prismatic().alpha_deg(53).a(0.1), 0.5), body(revolute().alpha_deg(-37).d(0.1), 0.3));
};
struct Floating {
  static constexpr auto chain = [] {
    auto chain = Mixed::chain;
    chain.base_body = base_body().mass(12.0).com(0.125, -0.0625, 0.25).inertia_com(1.5, 2.25, 1.75).parameters();
    chain.has_base_body = true;
    return chain;
  }();
};
using Values = Joints<Mixed, double>;
constexpr Values q{0.4, -1.1, 0.3, 0.8, -0.2, 1.3}, qd{0.7, -0.9, 0.5, 1.1, 0.4, -0.6},
    x{1.0, -2.0, 0.5, 1.5, -1.0, 2.0}, dq{0.5, 1.25, -0.75, 0.25, 1.0, -1.5}, dqd{-1.0, 0.5, 0.75, 1.5, -0.25, 0.5},
    dx{2.0, -0.5, 1.0, -1.5, 0.75, 0.25};

Values moved(const Values& from, const Values& by, double step) {
  Values result = from;
  for (int i = 0; i < 6; ++i)
    result[i] += step * by[i];
  return result;
}
Values reversed(const Values& v) { return {v[5], v[4], v[3], v[2], v[1], v[0]}; }
// Slopes against differences of fourth order of f along the direction.
template <class F, class Slopes>
void expect_slopes(const F& f, const Slopes& slopes, double most) {
  constexpr double h = 1e-3;
  const auto at = [&](double step) { return f(moved(q, dq, step), moved(qd, dqd, step), moved(x, dx, step)); };
  const auto a = at(h), b = at(-h), c = at(2 * h), d = at(-2 * h);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(slopes[i], (8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * h), most) << i;
}

template <class S>
Inputs<S, double> inputs() {
  Inputs<S, double> in;
  if constexpr (S::template has<RuntimeGravity>) in.gravity = {-3, 2.5, 8};
  if constexpr (base_moves<S>) in.base_motion = {{0.75, -1.25, 0.5}, {-2, 1.5, 3}, {4, -1, 2.5}};
  if constexpr (S::template has<TipWrench>) in.tip_wrench = {{0.5, -0.25, 0.75}, {3, -2, 5}};
  if constexpr (S::template has<Payload>) in.payload = {1.25, {0.1, 0.2, -0.3}, {0.1, 0.2, 0.3, 0.01, 0.02, 0.03}};
  if constexpr (S::template has<ExternalWrenches>)
    for (int i = 0; i < 6; ++i)
      in.wrenches[i] = {{0.5 * i, -1, 0.25}, {2, 1.0 * i, -1.5}};
  return in;
}
template <class S>
void expect_inverse() {
  const auto in = inputs<S>();
  const auto torque = [&](const auto& p, const auto& v, const auto& a) { return inverse_dynamics<S>(p, v, a, in); };
  const auto along = inverse_dynamics_along<S>(q, qd, x, {dq, dqd, dx}, in);
  expect_slopes(torque, along.dtau, 1e-8);
  const auto tau = torque(q, qd, x);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(along.tau[i], tau[i], 1e-12);
}
template <class S>
void expect_forward() {
  const auto in = inputs<S>();
  const auto drive = [&](const auto& p, const auto& v, const auto& tau) { return forward_dynamics<S>(p, v, tau, in); };
  const auto along = forward_dynamics_along<S>(q, qd, x, {dq, dqd, dx}, in);
  EXPECT_TRUE(along.qdd.status.ok());
  expect_slopes(drive, along.dqdd, 1e-5);
  const auto qdd = drive(q, qd, x);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(along.qdd[i], qdd[i], 1e-10);
}
template <class... F>
struct Named {
  using Unrolled = Scene<Mixed, F...>;
  using Compact = Scene<Mixed, F..., Looped>;
};
using Full = Named<RuntimeGravity, RotorInertia, Friction, JointSprings, TipWrench, ExternalWrenches, Payload>;

}  // namespace

TEST(Along, OfTwoMassesIsTheClosedForm) {
  const double q1 = 0.4, q2 = -1.1, w1 = 0.7, w2 = -0.9, a1 = 1.25, a2 = -0.5;
  const double e1 = 0.5, e2 = -0.75, u1 = 1.5, u2 = 0.25, b1 = -1.0, b2 = 2.0;
  const auto along = inverse_dynamics_along<Planar>(Joints<Planar, double>{q1, q2}, Joints<Planar, double>{w1, w2},
                                                    Joints<Planar, double>{a1, a2}, {{e1, e2}, {u1, u2}, {b1, b2}});
  const double c = m2 * l1 * l2 * std::cos(q2), s = m2 * l1 * l2 * std::sin(q2), dc = -s * e2, ds = c * e2;
  const double weight = -m2 * g * l2 * std::sin(q1 + q2) * (e1 + e2);
  const double first = -(m1 + m2) * g * l1 * std::sin(q1) * e1 + (m1 + m2) * l1 * l1 * b1 + m2 * l2 * l2 * (b1 + b2);
  EXPECT_NEAR(along.dtau[0],
              first + weight + dc * (2 * a1 + a2) + c * (2 * b1 + b2) - ds * (2 * w1 * w2 + w2 * w2) -
                  s * (2 * u1 * w2 + 2 * w1 * u2 + 2 * w2 * u2),
              1e-13);
  EXPECT_NEAR(along.dtau[1], m2 * l2 * l2 * (b1 + b2) + weight + dc * a1 + c * b1 + ds * w1 * w1 + s * 2 * w1 * u1,
              1e-13);
}

TEST(Along, InverseDynamicsHasItsSlope) {
  expect_inverse<Full::Unrolled>();
  expect_inverse<Named<Gravity>::Unrolled>();
}
TEST(Along, InverseDynamicsHasItsSlopeInTheLoopedForm) { expect_inverse<Full::Compact>(); }
TEST(Along, InverseDynamicsHasItsSlopeOnABaseThatMoves) {
  expect_inverse<Named<Gravity, BaseMotion>::Unrolled>();
  expect_inverse<Named<Gravity, BaseMotion, Payload>::Compact>();
}
TEST(Along, ABaseThatFloatsIsOneThatMovesAsItIsTold) {
  using S = Scene<Floating, RuntimeGravity, FloatingBase>;
  using Told = Scene<Mixed, RuntimeGravity, BaseMotion>;
  const auto at = [](const Values& v) { return Joints<Floating, double>{v[0], v[1], v[2], v[3], v[4], v[5]}; };
  const auto floating = inverse_dynamics_along<S>(at(q), at(qd), at(x), {at(dq), at(dqd), at(dx)}, inputs<S>());
  const auto told = inverse_dynamics_along<Told>(q, qd, x, {dq, dqd, dx}, inputs<Told>());
  const auto slopes = inverse_dynamics_derivatives<S>(at(q), at(qd), at(x), inputs<S>());
  const auto y = torque_regressor<S>(at(q), at(qd), at(x), inputs<S>());
  const auto y_told = torque_regressor<Told>(q, qd, x, inputs<Told>());
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(floating.dtau[i], told.dtau[i], 1e-12);
    double change = 0;
    for (int j = 0; j < 6; ++j)
      change += slopes.dtau_dq(i, j) * dq[j] + slopes.dtau_dqd(i, j) * dqd[j] + slopes.M(i, j) * dx[j];
    EXPECT_NEAR(floating.dtau[i], change, 1e-12);
    for (int column = 0; column < y.columns; ++column)
      EXPECT_EQ(y(i, column), y_told(i, column));
  }
}
TEST(Along, ForwardDynamicsHasItsSlope) { expect_forward<Full::Unrolled>(); }
TEST(Along, ForwardDynamicsHasItsSlopeInTheLoopedForm) { expect_forward<Full::Compact>(); }

TEST(Along, AModelHasTheSlopesOfItsRobot) {
  using M = Model<6, Gravity, RotorInertia, Friction, JointSprings>;
  using S = Scene<Mixed, Gravity, RotorInertia, Friction, JointSprings>;
  M model;
  for (const auto& link : Mixed::chain.links)
    ASSERT_TRUE(model.add(link));
  model.set_gravity(0.5, -1.0, -9.75);
  const auto at = [](const Values& v) { return Joints<M, double>{v[0], v[1], v[2], v[3], v[4], v[5]}; };
  const auto torque = inverse_dynamics_along(model, at(q), at(qd), at(x), {at(dq), at(dqd), at(dx)});
  const auto expected = inverse_dynamics_along<S>(q, qd, x, {dq, dqd, dx});
  const auto driven = forward_dynamics_along(model, at(q), at(qd), at(x), {at(dq), at(dqd), at(dx)});
  const auto expected_driven = forward_dynamics_along<S>(q, qd, x, {dq, dqd, dx});
  EXPECT_TRUE(driven.qdd.status.ok());
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(torque.tau[i], expected.tau[i], 1e-12);
    EXPECT_NEAR(torque.dtau[i], expected.dtau[i], 1e-11);
    EXPECT_NEAR(driven.qdd[i], expected_driven.qdd[i], 1e-10);
    EXPECT_NEAR(driven.dqdd[i], expected_driven.dqdd[i], 1e-9);
  }
}

TEST(Along, ABatchHasWhatEachOfItsStatesHas) {
  using B = Batch<double, 2>;
  using S = Scene<Mixed, Gravity, RotorInertia, Friction>;
  const auto lanes = [](const Values& v) {
    Joints<Mixed, B> both{};
    for (int i = 0; i < 6; ++i)
      both[i] = B::of([&](int lane) { return (lane == 0 ? v : reversed(v))[i]; });
    return both;
  };
  const auto torque = inverse_dynamics_along<S>(lanes(q), lanes(qd), lanes(x), {lanes(dq), lanes(dqd), lanes(dx)});
  const auto driven = forward_dynamics_along<S>(lanes(q), lanes(qd), lanes(x), {lanes(dq), lanes(dqd), lanes(dx)});
  for (const int lane : {0, 1}) {
    const auto of = [&](const Values& v) { return lane == 0 ? v : reversed(v); };
    const auto one = inverse_dynamics_along<S>(of(q), of(qd), of(x), {of(dq), of(dqd), of(dx)});
    const auto one_driven = forward_dynamics_along<S>(of(q), of(qd), of(x), {of(dq), of(dqd), of(dx)});
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(torque.dtau[i][lane], one.dtau[i], 1e-12);
      EXPECT_NEAR(driven.dqdd[i][lane], one_driven.dqdd[i], 1e-9);
    }
  }
}

TEST(Along, DryFrictionAtRestHasNoSlope) {
  using S = Scene<Mixed, Friction>;
  const Values rest{}, turning{1, 1, 1, 1, 1, 1};
  const auto along = inverse_dynamics_along<S>(rest, rest, rest, {rest, turning, rest});
  EXPECT_EQ(along.dtau[3], 0.25) << "viscous";
  EXPECT_EQ(along.dtau[1], 0.0) << "a jump has no slope";
}

TEST(Along, WhatIsNoNumberHasAStatus) {
  Values bad = q;
  bad[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(forward_dynamics_along<Mixed>(bad, qd, x, {dq, dqd, dx}).qdd.status.code, Status::Code::not_finite);
}

TEST(Along, NoDirectionIsNoChange) {
  const auto along = inverse_dynamics_along<Mixed>(q, qd, x, {});
  const auto driven = forward_dynamics_along<Mixed>(q, qd, x, {});
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(along.dtau[i], 0.0);
    EXPECT_EQ(driven.dqdd[i], 0.0);
  }
}

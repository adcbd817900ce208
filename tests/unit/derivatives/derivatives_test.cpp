// Derivatives of inverse and forward dynamics: against closed forms, and against differences of what they are of.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>
#include <cstring>
#include <new>
#include <robots/two_arm.hpp>

using namespace axial;

namespace {

constexpr double g = 9.8125, m1 = 2.0, m2 = 1.5, l1 = 0.5, l2 = 0.75, rotor = 0.0625;

struct Planar {  // two point masses in a vertical plane, y upwards
  static constexpr auto chain = axial::chain(gravity(0, -g, 0), revolute().mass(m1).com(l1, 0, 0),
                                             revolute().a(l1).mass(m2).com(l2, 0, 0).rotor_inertia(rotor, 2));
};

// Everything at once: both kinds of joints, twists of any angle, full inertias.
constexpr auto body(const Link& joint, double of) {
  return joint.mass(1.0 + of)
      .com(0.1 * of, -0.07, 0.05 + 0.02 * of)
      .inertia_com(0.05, 0.06, 0.07, 0.01, -0.008, 0.004)
      .rotor_inertia(1e-3, 10);
}
struct Mixed {
  static constexpr auto chain = axial::chain(
      gravity(0.5, -1.0, -9.75), body(revolute().d(0.3), 0.5), body(revolute().alpha_deg(37).a(0.2).d(0.1), 1.0),
      body(prismatic().alpha_deg(-64).a(0.15).theta_deg(28), 0.25), body(revolute().alpha_deg(90).a(0.05).d(0.2), 0.75),
      body(prismatic().alpha_deg(53).a(0.1), 0.5), body(revolute().alpha_deg(-37).d(0.1), 0.3));
};

struct Bead {  // joint 2 slides along the rod that joint 1 turns; a third joint turns the bead
  static constexpr auto chain =
      axial::chain(gravity(0, 0, -g), revolute().alpha_deg(90).rotor_inertia(rotor), prismatic().alpha_deg(90).mass(m2),
                   revolute().alpha_deg(40).mass(m1).com(0.1, 0.05, 0.02));
};

struct Drives {
  static constexpr auto chain = axial::chain(
      revolute().viscous(0.5), revolute().coulomb(2.0, -1.0), revolute().coulomb(2.0, -1.0).stribeck(3.0, 0.25),
      revolute().coulomb(2.0, -1.0).smooth_speed(0.5),
      revolute().viscous(0.5).coulomb(2.0, -1.0).stribeck(3.0, 0.25).smooth_speed(0.5), revolute().spring(4.0, 0.75));
};

// Entries of `slopes` against differences of f(q, qd) of fourth order: by positions, or by speeds.
template <class R, class F, class M>
void expect_slopes(Joints<R, double> q, Joints<R, double> qd, bool by_position, const F& f, const M& slopes,
                   double most) {
  constexpr double h = 1e-3;
  for (int j = 0; j < joint_count<R>; ++j) {
    const auto at = [&](double step) {
      auto p = q, v = qd;
      (by_position ? p : v)[j] += step;
      return f(p, v);
    };
    const auto a = at(h), b = at(-h), c = at(2 * h), d = at(-2 * h);
    for (int i = 0; i < joint_count<R>; ++i)
      EXPECT_NEAR(slopes(i, j), (8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * h), most) << i << " by " << j;
  }
}

template <class S>
void expect_mixed() {
  const Joints<Mixed, double> q{0.4, -1.1, 0.3, 0.8, -0.2, 1.3}, qd{0.7, -0.9, 0.5, 1.1, 0.4, -0.6},
      qdd{1.0, -2.0, 0.5, 1.5, -1.0, 2.0};
  const auto d = inverse_dynamics_derivatives<S>(q, qd, qdd);
  const auto torque = [&](const auto& p, const auto& v) { return inverse_dynamics<S>(p, v, qdd); };
  expect_slopes<Mixed>(q, qd, true, torque, d.dtau_dq, 1e-8);
  expect_slopes<Mixed>(q, qd, false, torque, d.dtau_dqd, 1e-8);
  const auto m = mass_matrix<S>(q);
  const auto tau = inverse_dynamics<S>(q, qd, qdd);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(d.tau[i], tau[i], 1e-13);
    for (int j = 0; j < 6; ++j)
      EXPECT_NEAR(d.M(i, j), m(i, j), 1e-14);
  }
  const auto forward = forward_dynamics_derivatives<S>(q, qd, tau);
  const auto acceleration = [&](const auto& p, const auto& v) { return forward_dynamics<S>(p, v, tau); };
  expect_slopes<Mixed>(q, qd, true, acceleration, forward.dqdd_dq, 1e-6);
  expect_slopes<Mixed>(q, qd, false, acceleration, forward.dqdd_dqd, 1e-6);
  EXPECT_TRUE(forward.qdd.status.ok());
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(forward.qdd[i], qdd[i], 1e-11);
    for (int j = 0; j < 6; ++j) {
      double product = i == j ? -1 : 0;
      for (int k = 0; k < 6; ++k)
        product += m(i, k) * forward.M_inverse(k, j);
      EXPECT_NEAR(product, 0, 1e-12) << i << " " << j;
    }
  }
}

}  // namespace

TEST(Derivatives, OfTwoMassesAreTheClosedForm) {
  const double q1 = 0.4, q2 = -1.1, w1 = 0.7, w2 = -0.9, a1 = 1.25, a2 = -0.5;
  const auto d = inverse_dynamics_derivatives<Planar>(Joints<Planar, double>{q1, q2}, Joints<Planar, double>{w1, w2},
                                                      Joints<Planar, double>{a1, a2});
  const double c = m2 * l1 * l2 * std::cos(q2), s = m2 * l1 * l2 * std::sin(q2);
  const double s1 = (m1 + m2) * g * l1 * std::sin(q1), s12 = m2 * g * l2 * std::sin(q1 + q2);
  EXPECT_NEAR(d.dtau_dq(0, 0), -s1 - s12, 1e-13);
  EXPECT_NEAR(d.dtau_dq(0, 1), -s * (2 * a1 + a2) - c * (2 * w1 * w2 + w2 * w2) - s12, 1e-13);
  EXPECT_NEAR(d.dtau_dq(1, 0), -s12, 1e-13);
  EXPECT_NEAR(d.dtau_dq(1, 1), -s * a1 + c * w1 * w1 - s12, 1e-13);
  EXPECT_NEAR(d.dtau_dqd(0, 0), -2 * s * w2, 1e-13);
  EXPECT_NEAR(d.dtau_dqd(0, 1), -2 * s * (w1 + w2), 1e-13);
  EXPECT_NEAR(d.dtau_dqd(1, 0), 2 * s * w1, 1e-13);
  EXPECT_NEAR(d.dtau_dqd(1, 1), 0, 1e-13);
  EXPECT_NEAR(d.M(1, 1), m2 * l2 * l2 + 4 * rotor, 1e-14);
}

namespace {
// Seven joints: columns and the inverse come out of loops, whose first joint is a slide.
struct Longer {
  static constexpr auto chain = axial::chain(
      gravity(0.5, -1.0, -9.75), body(revolute().d(0.3), 0.5), body(revolute().alpha_deg(37).a(0.2).d(0.1), 1.0),
      body(prismatic().alpha_deg(-64).a(0.15).theta_deg(28), 0.25), body(revolute().alpha_deg(90).a(0.05).d(0.2), 0.75),
      body(prismatic().alpha_deg(53).a(0.1), 0.5), body(revolute().alpha_deg(-37).d(0.1), 0.3),
      body(revolute().alpha_deg(71).a(-0.1), 0.4));
};
}  // namespace
TEST(Derivatives, OfForwardDynamicsOfALongerChainAreSlopes) {
  using S = Scene<Longer, Gravity, RotorInertia, CompositeBody>;
  const Joints<Longer, double> q{0.4, -1.1, 0.3, 0.8, -0.2, 1.3, -0.7}, qd{0.7, -0.9, 0.5, 1.1, 0.4, -0.6, 0.8},
      tau{3.0, -2.0, 12.0, 4.0, -5.0, 1.0, 0.5};
  const auto d = forward_dynamics_derivatives<S>(q, qd, tau);
  const auto acceleration = [&](const auto& p, const auto& v) { return forward_dynamics<S>(p, v, tau); };
  EXPECT_TRUE(d.qdd.status.ok());
  expect_slopes<Longer>(q, qd, true, acceleration, d.dqdd_dq, 1e-6);
  expect_slopes<Longer>(q, qd, false, acceleration, d.dqdd_dqd, 1e-6);
  for (int j = 0; j < 7; ++j) {
    auto more = tau;
    more[j] += 1;
    const auto a = forward_dynamics<S>(q, qd, tau), b = forward_dynamics<S>(q, qd, more);
    for (int i = 0; i < 7; ++i)
      EXPECT_NEAR(d.M_inverse(i, j), b[i] - a[i], 1e-9) << i << " " << j;
  }
  const auto alone = forward_dynamics_derivatives<S, with_acceleration_by_velocity>(q, qd, tau);
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j)
      EXPECT_EQ(alone.dqdd_dqd(i, j), d.dqdd_dqd(i, j)) << "without the inverse: " << i << " " << j;
}
TEST(Derivatives, OfAMixedChainAreSlopes) { expect_mixed<Scene<Mixed, Gravity, RotorInertia, CompositeBody>>(); }
TEST(Derivatives, OfAMixedChainInTheLoopedFormToo) {
  expect_mixed<Scene<Mixed, Gravity, RotorInertia, CompositeBody, Looped>>();
}

TEST(Derivatives, OfABeadOnATurningRodAreSlopes) {
  const Joints<Bead, double> q{0.4, 0.6, -0.3}, qd{1.25, -0.5, 0.75}, qdd{0.5, 1.0, -2.0};
  const auto d = inverse_dynamics_derivatives<Bead>(q, qd, qdd);
  const auto torque = [&](const auto& p, const auto& v) { return inverse_dynamics<Bead>(p, v, qdd); };
  expect_slopes<Bead>(q, qd, true, torque, d.dtau_dq, 1e-9);
  expect_slopes<Bead>(q, qd, false, torque, d.dtau_dqd, 1e-9);
}

// A chain whose first joints the compiler knows, and whose velocities it takes relative to where link 1 is.
template <class R>
void expect_on_moving_base(const Joints<R, double>& q, const Joints<R, double>& qd, const Joints<R, double>& qdd) {
  using S = Scene<R, Gravity, RotorInertia, BaseMotion, CompositeBody>;
  Inputs<S, double> in;
  in.base_motion = {{0.75, -1.25, 0.5}, {-2, 1.5, 3}, {4, -1, 2.5}};
  const auto d = inverse_dynamics_derivatives<S>(q, qd, qdd, in);
  const auto torque = [&](const auto& p, const auto& v) { return inverse_dynamics<S>(p, v, qdd, in); };
  expect_slopes<R>(q, qd, true, torque, d.dtau_dq, 1e-8);
  expect_slopes<R>(q, qd, false, torque, d.dtau_dqd, 1e-8);
  const auto forward = forward_dynamics_derivatives<S>(q, qd, d.tau, in);
  const auto acceleration = [&](const auto& p, const auto& v) { return forward_dynamics<S>(p, v, d.tau, in); };
  EXPECT_TRUE(forward.qdd.status.ok());
  expect_slopes<R>(q, qd, true, acceleration, forward.dqdd_dq, 1e-6);
  expect_slopes<R>(q, qd, false, acceleration, forward.dqdd_dqd, 1e-6);
}
TEST(Derivatives, OnABaseThatMovesAreSlopes) {
  expect_on_moving_base<Mixed>({0.4, -1.1, 0.3, 0.8, -0.2, 1.3}, {0.7, -0.9, 0.5, 1.1, 0.4, -0.6},
                               {1.0, -2.0, 0.5, 1.5, -1.0, 2.0});
  expect_on_moving_base<Bead>({0.4, 0.6, -0.3}, {1.25, -0.5, 0.75}, {0.5, 1.0, -2.0});
  expect_on_moving_base<Planar>({0.4, -1.1}, {0.7, -0.9}, {1.25, -0.5});
}

// Two turns about the vertical and a slide along it: most entries are zero, and elimination fills some of them.
struct Selective {
  static constexpr auto chain = axial::chain(gravity(0, 0, -g), revolute().mass(m1).com(l1, 0, 0).spring(3.0),
                                             revolute().a(l1).mass(m1).com(l2, 0.1, 0).spring(4.0, 0.75),
                                             prismatic().a(l2).mass(m2).com(0.05, 0, 0.1).spring(200.0));
};
TEST(Derivatives, OfForwardDynamicsAreSlopesWhereMostEntriesAreZero) {
  using S = Scene<Selective, Gravity, JointSprings, CompositeBody>;
  const Joints<Selective, double> q{0.4, -1.1, 0.3}, qd{0.7, -0.9, 0.5}, tau{3.0, -2.0, 12.0};
  const auto d = forward_dynamics_derivatives<S>(q, qd, tau);
  const auto acceleration = [&](const auto& p, const auto& v) { return forward_dynamics<S>(p, v, tau); };
  expect_slopes<Selective>(q, qd, true, acceleration, d.dqdd_dq, 1e-8);
  expect_slopes<Selective>(q, qd, false, acceleration, d.dqdd_dqd, 1e-8);
  EXPECT_EQ(d.M_inverse(0, 2), 0.0);
}

TEST(Derivatives, OfFrictionAndSpringsAreSlopes) {
  using U = Scene<Drives, Friction, JointSprings>;
  using L = Scene<Drives, Friction, JointSprings, Looped>;
  for (const double speed : {0.125, -0.1875, 0.4375, -0.75, 2.0}) {
    SCOPED_TRACE(speed);
    Joints<Drives, double> q{}, qd{};
    for (int i = 0; i < 6; ++i)
      qd[i] = speed;
    const auto torque = [&](const auto& p, const auto& v) { return bias_torque<U>(p, v); };
    const auto d = inverse_dynamics_derivatives<U>(q, qd, {});
    expect_slopes<Drives>(q, qd, true, torque, d.dtau_dq, 1e-9);
    expect_slopes<Drives>(q, qd, false, torque, d.dtau_dqd, 1e-6);
    const auto looped = inverse_dynamics_derivatives<L>(q, qd, {});
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(looped.dtau_dqd(i, i), d.dtau_dqd(i, i), 1e-14) << i;
  }
}
TEST(Derivatives, OfFrictionAtRestAreFinite) {
  const auto d = inverse_dynamics_derivatives<Scene<Drives, Friction, JointSprings>>(
      Joints<Drives, double>{}, Joints<Drives, double>{}, Joints<Drives, double>{});
  EXPECT_EQ(d.dtau_dqd(0, 0), 0.5) << "viscous";
  EXPECT_EQ(d.dtau_dqd(1, 1), 0.0) << "a jump has no slope";
  EXPECT_EQ(d.dtau_dqd(2, 2), 0.0);
  EXPECT_NEAR(d.dtau_dqd(3, 3), 0.0, 1e-15) << "neither direction's effort, at rest";
  EXPECT_EQ(d.dtau_dq(5, 5), 4.0) << "the spring";
}

namespace {
// What `make` returns, in room whose bytes were all `byte` before.
template <class Make>
auto made_in_room_of(int byte, const Make& make) {
  using Result = decltype(make());
  alignas(Result) unsigned char room[sizeof(Result)];
  std::memset(room, byte, sizeof room);
  asm volatile("" : : "r"(room) : "memory");  // else the compiler may leave out what nobody reads
  return Result(*::new (static_cast<void*>(room)) Result(make()));
}
template <class V>
void expect_same_entries(const V& a, const V& b) {
  for (std::size_t k = 0; k < sizeof a.values / sizeof a.values[0]; ++k)
    EXPECT_EQ(a.values[k], b.values[k]) << k;
}
template <class S, int n = joint_count<S>>
void expect_every_entry_written() {
  Joints<robot_of<S>, double> q{}, qd{}, x{};
  for (int i = 0; i < n; ++i)
    q[i] = 0.3 + 0.1 * i, qd[i] = 0.7 - 0.2 * i, x[i] = 1.0 + 0.5 * i;
  const auto inverse = [&] { return inverse_dynamics_derivatives<S>(q, qd, x); };
  const auto a = made_in_room_of(0, inverse), b = made_in_room_of(0xff, inverse);
  expect_same_entries(a.tau, b.tau), expect_same_entries(a.M, b.M);
  expect_same_entries(a.dtau_dq, b.dtau_dq), expect_same_entries(a.dtau_dqd, b.dtau_dqd);
  const auto forward = [&] { return forward_dynamics_derivatives<S>(q, qd, x); };
  const auto c = made_in_room_of(0, forward), d = made_in_room_of(0xff, forward);
  expect_same_entries(c.qdd, d.qdd), expect_same_entries(c.M_inverse, d.M_inverse);
  expect_same_entries(c.dqdd_dq, d.dqdd_dq), expect_same_entries(c.dqdd_dqd, d.dqdd_dqd);
}
}  // namespace

TEST(Derivatives, OfNoEntryKeepWhatWasInMemoryBefore) {
  expect_every_entry_written<Selective>();
  expect_every_entry_written<Mixed>();
  expect_every_entry_written<Longer>();
  expect_every_entry_written<robots::TwoArm>();
  expect_every_entry_written<Scene<robots::TwoArm, Gravity, RotorInertia, Looped>>();
}

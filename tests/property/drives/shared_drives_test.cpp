// Joints that share drives, against Lagrange's equations of all joints with their couplings as constraints, multipliers
// and all, in 113 bits; against a closed form; power on either side of random couplings.
#include <axial/batch.hpp>
#include <host_sim/robots/robots/driven_robot.hpp>
#include <utility>

#include "constrained.hpp"
#include "driven_robots.hpp"

namespace {

using namespace constrained;

template <class R, class T, class... Features>
void expect_constrained(const oracle::Load<quad>& load, unsigned seed, int states) {
  using S = Scene<R, Features...>;
  const auto exact = Constrained::of<R>(load);
  const int m = exact.drives();
  ASSERT_EQ(m, joint_count<S>);
  oracle::RandomChains random(seed);
  Inputs<S, T> in{};
  if constexpr (S::template has<TipWrench>) in.tip_wrench = {{T(0.5), T(-0.25), T(0.75)}, {T(3), T(-2), T(5)}};
  for (int state = 0; state < states; ++state) {
    const auto x = motion<R>(random, exact.owner());
    const auto u = property::joints<R, T>(x.u), ud = property::joints<R, T>(x.ud), udd = property::joints<R, T>(x.udd);
    const auto at = convert<quad>(x.u), speed = convert<quad>(x.ud), turn = convert<quad>(x.udd);
    const auto tau = inverse_dynamics<S>(u, ud, udd, in);
    const auto efforts = exact.inverse(at, speed, turn);
    const double size = oracle::largest(efforts);
    const auto expect = [&](const auto& found, const Vector<quad>& value) {
      EXPECT_LE(error_in(value, size, convert<quad>(property::vector(found))), tolerance<T>) << state;
    };
    const Vector<quad> rest(std::size_t(m), quad(0));
    expect(tau, efforts);
    expect(bias_torque<S>(u, ud, in), exact.inverse(at, speed, rest));
    expect(gravity_torque<S>(u, in), exact.inverse(at, rest, rest));
    EXPECT_LE(oracle::relative_error(oracle::elements(property::matrix(mass_matrix<S>(u, in))),
                                     oracle::elements(exact.mass(at))),
              tolerance<T>);
    const auto answer = forward_dynamics<S>(u, ud, tau, in);
    EXPECT_TRUE(answer.status.ok()) << int(answer.status.code);
    Joints<R, T> found{};
    for (int k = 0; k < m; ++k)
      found[k] = answer[k];
    // Of the efforts as they were rounded.
    EXPECT_LE(
        oracle::relative_error(property::vector(found), exact.forward(at, speed, convert<quad>(property::vector(tau)))),
        tolerance<T>)
        << state;
  }
}

/// The tools' reference takes the library's G, which is in double: against matrices written by hand and multipliers.
template <class R>
void expect_reference(unsigned seed) {
  const auto exact = Constrained::of<R>();
  const auto reference = host_sim::driven_robot<quad, R>();
  oracle::RandomChains random(seed);
  for (int state = 0; state < 10; ++state) {
    const auto x = motion<R>(random, exact.owner());
    const auto u = convert<quad>(x.u), ud = convert<quad>(x.ud), udd = convert<quad>(x.udd);
    const auto expect = [&](const Vector<quad>& found, const Vector<quad>& wanted) {
      EXPECT_LE(error_in(wanted, oracle::largest(wanted), found), 1e-14) << state;
    };
    const auto tau = exact.inverse(u, ud, udd);
    expect(reference.inverse_dynamics(u, ud, udd), tau);
    expect(reference.forward_dynamics(u, ud, tau), exact.forward(u, ud, tau));
    expect(oracle::elements(reference.mass_matrix(u)), oracle::elements(exact.mass(u)));
    const auto twist = oracle::tool_jacobian(exact.chain(), exact.positions(u)).linear * (exact.g() * ud);
    expect(reference.tool_jacobian(u).linear * ud, twist);
  }
}

template <class R, class T>
void expect_plain(unsigned seed) {
  expect_constrained<R, T, Gravity, RotorInertia>({}, seed, 40);
}

/// What no robot says: which matrix, from numbers alone.
template <int Number>
struct RandomCoupling {
  static constexpr int n = 2 + Number % 3;
  static constexpr double number(int k) { return property::drawn_number(Number, k); }
  /// Triangular, so that it is regular; a zero here and there.
  static constexpr double ratio(int i, int k) {
    if (i == k) return 0.5 + 2.0 * number(i) * number(i);
    return i > k && number(7 * i + k) > -0.5 ? 2.0 * number(100 + 7 * i + k) : 0.0;
  }
  static constexpr auto body = revolute().a(0.25).mass(1).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01);
  static constexpr auto chain = [] {
    double rows[n][n] = {};
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k)
        rows[i][k] = ratio(i, k);
    if constexpr (n == 2)
      return axial::chain(body, body, drive_ratios<2>(rows));
    else if constexpr (n == 3)
      return axial::chain(body, body, body, drive_ratios<3>(rows));
    else
      return axial::chain(body, body, body, body, drive_ratios<4>(rows));
  }();
};

template <int Number>
void expect_power() {
  using R = RandomCoupling<Number>;
  constexpr int n = R::n;
  oracle::RandomChains random(7U + static_cast<unsigned>(Number));
  const auto ud = property::joints<R, double>(random.vector(n, 3));
  const auto tau_q = property::joints<JointCoordinates<R>, double>(random.vector(n, 50));
  const auto qd = joint_rates<R>(ud);
  const auto tau_u = drive_efforts<R>(tau_q);
  double difference = 0.0, size = 0.0;
  for (int i = 0; i < n; ++i) {
    difference += qd[i] * tau_q[i] - ud[i] * tau_u[i];
    size += std::abs(qd[i] * tau_q[i]) + std::abs(ud[i] * tau_u[i]);
    double sum = 0.0, terms = 0.0;
    for (int k = 0; k < n; ++k)
      sum += R::ratio(i, k) * ud[k], terms += std::abs(R::ratio(i, k) * ud[k]);
    EXPECT_NEAR(qd[i], sum, 4e-16 * terms) << Number;
  }
  EXPECT_LE(std::abs(difference), 10 * std::numeric_limits<double>::epsilon() * size) << Number;
}
template <int... Number>
void expect_powers(std::integer_sequence<int, Number...>) {
  (expect_power<Number>(), ...);
}

}  // namespace

TEST(SharedDrives, AreConstraintsWithMultipliersInDouble) {
  expect_plain<robots::ScaraQuill, double>(1);
  expect_plain<robots::Palletiser, double>(2);
  expect_plain<robots::WristArm, double>(3);
  expect_plain<robots::Gripper, double>(4);
  expect_plain<Followers, double>(5);
}
TEST(SharedDrives, AreConstraintsWithMultipliersInFloat) {
  expect_plain<robots::ScaraQuill, float>(11);
  expect_plain<robots::Palletiser, float>(12);
  expect_plain<robots::WristArm, float>(13);
  expect_plain<robots::Gripper, float>(14);
  expect_plain<Followers, float>(15);
}
TEST(SharedDrives, OfTheToolsReferenceAreConstraintsWithMultipliers) {
  expect_reference<robots::ScaraQuill>(41);
  expect_reference<robots::Palletiser>(42);
  expect_reference<robots::WristArm>(43);
  expect_reference<robots::Gripper>(44);
  expect_reference<Followers>(45);
}
TEST(SharedDrives, CarryFrictionOfDrivesSpringsOfJointsAndWrenches) {
  oracle::Load<quad> load;
  load.friction = load.springs = true;
  load.tip = {{quad(3), quad(-2), quad(5)}, {quad(0.5), quad(-0.25), quad(0.75)}};
  expect_constrained<Followers, double, Gravity, RotorInertia, Friction, JointSprings, TipWrench>(load, 21, 40);
  load.springs = false;
  expect_constrained<robots::WristArm, double, Gravity, RotorInertia, Friction, TipWrench>(load, 22, 40);
}
TEST(SharedDrives, LoopedAndWithBaseParametersAreTheSame) {
  expect_constrained<Followers, double, Gravity, RotorInertia, Looped>({}, 31, 20);
  expect_constrained<robots::Palletiser, double, Gravity, RotorInertia, BaseParameters>({}, 32, 20);
  expect_constrained<robots::WristArm, double, Gravity, RotorInertia, FullParameters, CompositeBody>({}, 33, 20);
}
TEST(SharedDrives, KeepPowerOnTwoHundredRandomCouplings) { expect_powers(std::make_integer_sequence<int, 200>{}); }

TEST(SharedDrives, MoveFramesAndToolAsTheirJointsDo) {
  using R = Followers;
  const auto exact = Constrained::of<R>();
  oracle::RandomChains random(41);
  for (int state = 0; state < 50; ++state) {
    const auto values = random.vector(3, 2);
    const auto u = property::joints<R, double>(values);
    const auto q = exact.positions(convert<quad>(values));
    const auto poses = oracle::link_poses(exact.chain(), q);
    const auto tool = oracle::tool_pose(exact.chain(), q);
    const auto by_joints = oracle::tool_jacobian(exact.chain(), q);
    const auto answer = forward_kinematics<R>(u);
    const auto jac = jacobian<R>(u);
    ASSERT_TRUE(answer.status.ok() && jac.status.ok());
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(answer.frames[i].position.x, double(poses[std::size_t(i)].position.x), 1e-14);
    EXPECT_NEAR(answer.tool.position.z, double(tool.position.z), 1e-14);
    for (int k = 0; k < 3; ++k) {
      quad linear[3] = {}, angular[3] = {};
      for (int i = 0; i < 5; ++i)
        for (int axis = 0; axis < 3; ++axis) {
          linear[axis] += by_joints.linear(axis, i) * exact.g()(i, k);
          angular[axis] += by_joints.angular(axis, i) * exact.g()(i, k);
        }
      EXPECT_NEAR(jac[k].linear.x, double(linear[0]), 1e-14);
      EXPECT_NEAR(jac[k].linear.y, double(linear[1]), 1e-14);
      EXPECT_NEAR(jac[k].linear.z, double(linear[2]), 1e-14);
      EXPECT_NEAR(jac[k].angular.x, double(angular[0]), 1e-14);
      EXPECT_NEAR(jac[k].angular.y, double(angular[1]), 1e-14);
      EXPECT_NEAR(jac[k].angular.z, double(angular[2]), 1e-14);
    }
  }
}

namespace {

/// The palletiser in its vertical plane, the column at rest. Each body's centre of mass stands at
/// a e(u1) + b n(u1) + c e(u2) + d n(u2) from a fixed point, e the direction at an angle and n its left-hand normal; it
/// turns with u1, u2 or not at all.
struct Body {
  double mass, inertia, a, b, c, d;
  int turns_with;
};
constexpr Body palletiser_bodies[] = {
    {70.0, 6.8, 0.42, 0, 0, 0, 1},     // upper arm
    {18.0, 0.35, 0, 0, -0.1, 0, 2},    // crank
    {9.0, 0.8, 0.48, 0, -0.3, 0, 1},   // its rod
    {55.0, 6.2, 0.96, 0, 0.45, 0, 2},  // forearm
    {6.0, 0.5, 0.48, 0, 0, 0, 1},      // rod beside the upper arm
    {8.0, 0.09, 0.96, 0, 0, 0, 0},     // corner
    {6.0, 0.6, 0.96, 0, 0.5, 0, 2},    // rod beside the forearm
    {16.0, 0.2, 0.96, 0, 1.05, 0, 0},  // flange
    {10.0, 0.2, 0.96, 0, 1.05, 0, 0},  // gripper
};
struct Planar {
  double tau1 = 0, tau2 = 0;
};
Planar palletiser_efforts(double u1, double u2, double v1, double v2, double a1, double a2) {
  const double rotor = 1.4e-3 * 140.0 * 140.0, s = std::sin(u1 - u2), c = std::cos(u1 - u2);
  double m11 = rotor, m22 = rotor, m12 = 0, slope = 0, g1 = 0, g2 = 0;
  for (const Body& p : palletiser_bodies) {
    m11 += p.mass * (p.a * p.a + p.b * p.b) + (p.turns_with == 1 ? p.inertia : 0.0);
    m22 += p.mass * (p.c * p.c + p.d * p.d) + (p.turns_with == 2 ? p.inertia : 0.0);
    const double along = p.a * p.c + p.b * p.d, across = p.a * p.d - p.b * p.c;
    m12 += p.mass * (along * c + across * s), slope += p.mass * (across * c - along * s);
    g1 += p.mass * 9.81 * (p.a * std::cos(u1) - p.b * std::sin(u1));
    g2 += p.mass * 9.81 * (p.c * std::cos(u2) - p.d * std::sin(u2));
  }
  return {m11 * a1 + m12 * a2 - slope * v2 * v2 + g1, m12 * a1 + m22 * a2 + slope * v1 * v1 + g2};
}

}  // namespace

TEST(Palletiser, IsItsClosedForm) {
  using R = robots::Palletiser;
  oracle::RandomChains random(51);
  for (int state = 0; state < 200; ++state) {
    const auto x = motion<R>(random, {0, 1, 2, 9});
    const auto exact = palletiser_efforts(x.u[1], x.u[2], x.ud[1], x.ud[2], x.udd[1], x.udd[2]);
    const Joints<R, double> u{x.u[0], x.u[1], x.u[2], x.u[3]}, ud{0, x.ud[1], x.ud[2], 0},
        udd{0, x.udd[1], x.udd[2], 0};
    const auto tau = inverse_dynamics<R>(u, ud, udd);
    const double size = std::abs(exact.tau1) + std::abs(exact.tau2);
    EXPECT_NEAR(tau[1], exact.tau1, 1e-14 * size);
    EXPECT_NEAR(tau[2], exact.tau2, 1e-14 * size);
  }
}
TEST(Palletiser, KeepsItsFlangeLevel) {
  using R = robots::Palletiser;
  oracle::RandomChains random(52);
  for (int state = 0; state < 50; ++state) {
    const auto values = random.vector(4, 2);
    const auto answer = forward_kinematics<R>(property::joints<R, double>(values));
    EXPECT_NEAR(answer.tool.rotation.z.z, 1.0, 1e-14);
  }
}
TEST(SharedDrives, ABatchHasWhatEachOfItsStatesHas) {
  using R = robots::WristArm;
  using V = Batch<double, 2>;
  Joints<R, V> u{}, ud{}, udd{};
  Joints<R, double> lanes[3][2] = {};
  oracle::RandomChains random(61);
  for (int lane = 0; lane < 2; ++lane)
    for (int k = 0; k < 5; ++k)
      for (auto& quantity : lanes)
        quantity[lane][k] = random.uniform(-2, 2);
  for (int k = 0; k < 5; ++k) {
    u[k] = V::of([&](int lane) { return lanes[0][lane][k]; });
    ud[k] = V::of([&](int lane) { return lanes[1][lane][k]; });
    udd[k] = V::of([&](int lane) { return lanes[2][lane][k]; });
  }
  const auto tau = inverse_dynamics<R>(u, ud, udd);
  const auto answer = forward_dynamics<R>(u, ud, tau);
  for (int lane = 0; lane < 2; ++lane) {
    const auto alone = inverse_dynamics<R>(lanes[0][lane], lanes[1][lane], lanes[2][lane]);
    for (int k = 0; k < 5; ++k) {
      EXPECT_NEAR(tau[k][lane], alone[k], 1e-13);
      EXPECT_NEAR(answer[k][lane], lanes[2][lane][k], 1e-11);
    }
  }
}

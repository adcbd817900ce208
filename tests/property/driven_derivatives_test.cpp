// Derivatives in values of drives that joints share, against differences of constraints with multipliers in 113 bits.
#include <axial/batch.hpp>

#include "constrained.hpp"
#include "driven_robots.hpp"

namespace {

using namespace constrained;

template <class M>
Matrix<quad> entries(const M& matrix, int n) {
  Matrix<quad> all(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      all(i, j) = quad(matrix(i, j));
  return all;
}
/// d f / d x column by column: exact to some 20 digits.
template <class F>
Matrix<quad> slopes(const Vector<quad>& x, const F& f) {
  const quad h = quad(1) / quad(1LL << 36);
  const int n = int(x.size());
  Matrix<quad> all(n, n);
  for (int j = 0; j < n; ++j) {
    auto above = x, below = x;
    above[std::size_t(j)] += h, below[std::size_t(j)] -= h;
    const auto high = f(above), low = f(below);
    for (int i = 0; i < n; ++i)
      all(i, j) = (high[std::size_t(i)] - low[std::size_t(i)]) / (h + h);
  }
  return all;
}
/// Largest difference over the largest entry.
double block_error(const Matrix<quad>& exact, const Matrix<quad>& found) {
  const auto values = oracle::elements(exact);
  return error_in(values, oracle::largest(values), oracle::elements(found));
}

/// A state of drives in both arithmetics, away from rest.
template <class S, class T>
struct At {
  At(const Vector<double>& u_, const Vector<double>& ud_, const Vector<double>& udd_)
      : u(property::joints<S, T>(u_)),
        ud(property::joints<S, T>(ud_)),
        udd(property::joints<S, T>(udd_)),
        exact_u(convert<quad>(property::vector(u, int(u_.size())))),
        exact_ud(convert<quad>(property::vector(ud, int(u_.size())))),
        exact_udd(convert<quad>(property::vector(udd, int(u_.size())))) {}
  Joints<S, T> u, ud, udd;
  Vector<quad> exact_u, exact_ud, exact_udd;
};

template <class T, class S, class D>
void expect_inverse(const Constrained& exact, const At<S, T>& at, const D& d) {
  const int n = exact.drives();
  const auto efforts = exact.inverse(at.exact_u, at.exact_ud, at.exact_udd);
  EXPECT_LE(error_in(efforts, oracle::largest(efforts), convert<quad>(property::vector(d.tau, n))), tolerance<T>);
  EXPECT_LE(block_error(exact.mass(at.exact_u), entries(d.M, n)), tolerance<T>);
  const auto by_u = slopes(at.exact_u, [&](const auto& u) { return exact.inverse(u, at.exact_ud, at.exact_udd); });
  const auto by_ud = slopes(at.exact_ud, [&](const auto& ud) { return exact.inverse(at.exact_u, ud, at.exact_udd); });
  EXPECT_LE(block_error(by_u, entries(d.dtau_dq, n)), tolerance<T>);
  EXPECT_LE(block_error(by_ud, entries(d.dtau_dqd, n)), tolerance<T>);
}
template <class T, class S, class D>
void expect_forward(const Constrained& exact, const At<S, T>& at, const Joints<S, T>& tau, const D& d) {
  const int n = exact.drives();
  const auto efforts = convert<quad>(property::vector(tau, n));
  const auto of = [&](const auto& u, const auto& ud, const auto& t) { return exact.forward(u, ud, t); };
  const auto answer = of(at.exact_u, at.exact_ud, efforts);
  const auto by_u = slopes(at.exact_u, [&](const auto& u) { return of(u, at.exact_ud, efforts); });
  const auto by_ud = slopes(at.exact_ud, [&](const auto& ud) { return of(at.exact_u, ud, efforts); });
  const auto by_tau = slopes(efforts, [&](const auto& t) { return of(at.exact_u, at.exact_ud, t); });
  EXPECT_TRUE(d.qdd.status.ok());
  EXPECT_LE(error_in(answer, oracle::largest(answer), convert<quad>(property::vector<S, T>(d.qdd, n))), tolerance<T>);
  EXPECT_LE(block_error(by_tau, entries(d.M_inverse, n)), tolerance<T>);
  EXPECT_LE(block_error(by_u, entries(d.dqdd_dq, n)), tolerance<T>);
  EXPECT_LE(block_error(by_ud, entries(d.dqdd_dqd, n)), tolerance<T>);
}
/// Products with a direction, against the matrices' entries that stand beside them.
template <class T, class S, class I, class F, class AlongI, class AlongF>
void expect_along(int n, const MotionDirection<S, T>& by, const I& inverse, const AlongI& along, const F& forward,
                  const AlongF& forward_along) {
  Vector<quad> dtau(std::size_t(n), quad(0)), dudd = dtau;
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < n; ++l) {
      dtau[std::size_t(k)] += quad(inverse.dtau_dq(k, l)) * quad(by.dq[l]) +
                              quad(inverse.dtau_dqd(k, l)) * quad(by.dqd[l]) + quad(inverse.M(k, l)) * quad(by.dqdd[l]);
      dudd[std::size_t(k)] += quad(forward.dqdd_dq(k, l)) * quad(by.dq[l]) +
                              quad(forward.dqdd_dqd(k, l)) * quad(by.dqd[l]) +
                              quad(forward.M_inverse(k, l)) * quad(by.dqdd[l]);
    }
  EXPECT_TRUE(forward_along.qdd.status.ok());
  EXPECT_LE(error_in(dtau, oracle::largest(dtau), convert<quad>(property::vector(along.dtau, n))), 4 * tolerance<T>);
  EXPECT_LE(error_in(dudd, oracle::largest(dudd), convert<quad>(property::vector(forward_along.dqdd, n))),
            4 * tolerance<T>);
}

template <class S, class T>
Inputs<S, T> inputs() {
  Inputs<S, T> in{};
  if constexpr (S::template has<TipWrench>) in.tip_wrench = {{T(0.5), T(-0.25), T(0.75)}, {T(3), T(-2), T(5)}};
  return in;
}
template <class R, class T, class... Features>
void expect_slopes(const oracle::Load<quad>& load, unsigned seed, int states) {
  using S = Scene<R, Features...>;
  const auto exact = Constrained::of<R>(load);
  ASSERT_EQ(exact.drives(), joint_count<S>);
  oracle::RandomChains random(seed);
  const auto in = inputs<S, T>();
  for (int state = 0; state < states; ++state) {
    SCOPED_TRACE(state);
    const auto x = motion<R>(random, exact.owner());
    const At<R, T> at(x.u, x.ud, x.udd);
    const auto inverse = inverse_dynamics_derivatives<S>(at.u, at.ud, at.udd, in);
    expect_inverse(exact, at, inverse);
    const Joints<R, T> tau = inverse.tau;
    const auto forward = forward_dynamics_derivatives<S>(at.u, at.ud, tau, in);
    expect_forward(exact, at, tau, forward);
    const int n = exact.drives();
    const auto any = [&](double size) { return property::joints<R, T>(random.vector(n, size)); };
    const MotionDirection<R, T> by{any(1.0), any(2.0), any(4.0)};
    expect_along(n, by, inverse, inverse_dynamics_along<S>(at.u, at.ud, at.udd, by, in), forward,
                 forward_dynamics_along<S>(at.u, at.ud, tau, {by.dq, by.dqd, by.dqdd}, in));
  }
}
template <class R, class T>
void expect_plain(unsigned seed, int states = 10) {
  expect_slopes<R, T, Gravity, RotorInertia>({}, seed, states);
}

/// G of a drawn robot as its numbers have it, without the library's matrix.
template <int Number>
Couplings drawn_couplings() {
  using R = property::Coupled<Number>;
  Couplings c{Matrix<quad>(R::n, R::n), Vector<quad>(std::size_t(R::n), quad(0)), {}};
  for (int i = 0; i < R::n; ++i) {
    c.owner.push_back(i);
    c.g(i, i) = R::number(50 * i + 40) > 0.0 ? 0.7 : -1.3;
    for (int k = 0; k < i; ++k)
      if (R::number(50 * i + 20 + k) > -0.3) c.g(i, k) = 1.5 * R::number(50 * i + 30 + k);
  }
  return c;
}
using DrawnModel = Model<4, Gravity, RotorInertia, Friction, SharedDrives>;
/// A drawn robot, in both descriptions, and a motion of its drives.
struct Drawn {
  Constrained exact;
  DrawnModel model;
  Motion x;
};
template <int Number>
Drawn drawn() {
  using R = property::Coupled<Number>;
  oracle::Load<quad> load;
  load.friction = true;
  Drawn robot{Constrained::of<R>(drawn_couplings<Number>(), load), {}, {}};
  robot.model.set_gravity(R::chain.gravity.x, R::chain.gravity.y, R::chain.gravity.z);
  for (const LinkParameters& link : R::chain.links)
    EXPECT_TRUE(robot.model.add(link));
  oracle::RandomChains random(1000U + unsigned(Number));
  robot.x = motion<R>(random, robot.exact.owner());
  return robot;
}
/// One looped kernel for all of them.
void expect_at_run_time(int number, const Drawn& robot) {
  SCOPED_TRACE(number);
  const At<DrawnModel, double> at(robot.x.u, robot.x.ud, robot.x.udd);
  const auto inverse = inverse_dynamics_derivatives(robot.model, at.u, at.ud, at.udd);
  expect_inverse(robot.exact, at, inverse);
  const auto forward = forward_dynamics_derivatives(robot.model, at.u, at.ud, inverse.tau);
  expect_forward(robot.exact, at, inverse.tau, forward);
  const MotionDirection<DrawnModel, double> by{at.ud, at.udd, at.u};
  expect_along(robot.exact.drives(), by, inverse, inverse_dynamics_along(robot.model, at.u, at.ud, at.udd, by), forward,
               forward_dynamics_along(robot.model, at.u, at.ud, inverse.tau, {by.dq, by.dqd, by.dqdd}));
}
template <int Number>
void expect_drawn_unrolled() {
  SCOPED_TRACE(Number);
  using R = property::Coupled<Number>;
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  const auto robot = drawn<Number>();
  const At<R, double> at(robot.x.u, robot.x.ud, robot.x.udd);
  const auto inverse = inverse_dynamics_derivatives<S>(at.u, at.ud, at.udd);
  expect_inverse(robot.exact, at, inverse);
  expect_forward(robot.exact, at, inverse.tau, forward_dynamics_derivatives<S>(at.u, at.ud, inverse.tau));
}
template <int... Number>
void expect_all_drawn_at_run_time(std::integer_sequence<int, Number...>) {
  (expect_at_run_time(Number, drawn<Number>()), ...);
}
template <int... Number>
void expect_all_drawn_unrolled(std::integer_sequence<int, Number...>) {
  (expect_drawn_unrolled<Number>(), ...);
}

}  // namespace

TEST(DrivenDerivatives, AreSlopesOfConstraintsInDouble) {
  expect_plain<robots::ScaraQuill, double>(1);
  expect_plain<robots::Palletiser, double>(2, 3);
  expect_plain<robots::WristArm, double>(3);
  expect_plain<robots::Gripper, double>(4);
  expect_plain<Followers, double>(5);
}
TEST(DrivenDerivatives, AreSlopesOfConstraintsInFloat) {
  expect_plain<robots::ScaraQuill, float>(11);
  expect_plain<robots::Palletiser, float>(12, 3);
  expect_plain<robots::WristArm, float>(13);
  expect_plain<robots::Gripper, float>(14);
  expect_plain<Followers, float>(15);
}
TEST(DrivenDerivatives, CarryFrictionOfDrivesSpringsOfJointsAndWrenches) {
  oracle::Load<quad> load;
  load.friction = load.springs = true;
  load.tip = {{quad(3), quad(-2), quad(5)}, {quad(0.5), quad(-0.25), quad(0.75)}};
  expect_slopes<Followers, double, Gravity, RotorInertia, Friction, JointSprings, TipWrench>(load, 21, 10);
  expect_slopes<Followers, double, Gravity, RotorInertia, Friction, JointSprings, TipWrench, Looped>(load, 22, 10);
  load.springs = false;
  expect_slopes<robots::WristArm, double, Gravity, RotorInertia, Friction, TipWrench>(load, 23, 10);
}
TEST(DrivenDerivatives, LoopedAndWithFullParametersAreTheSame) {
  expect_slopes<Followers, double, Gravity, RotorInertia, Looped>({}, 31, 5);
  expect_slopes<robots::Palletiser, double, Gravity, RotorInertia, Looped>({}, 32, 2);
  expect_slopes<robots::WristArm, double, Gravity, RotorInertia, FullParameters>({}, 33, 5);
}
TEST(DrivenDerivatives, AreThoseOfTwoHundredDrawnRobotsAtRunTime) {
  expect_all_drawn_at_run_time(std::make_integer_sequence<int, 200>{});
}
TEST(DrivenDerivatives, AreThoseOfDrawnRobotsUnrolled) {
  expect_all_drawn_unrolled(std::make_integer_sequence<int, 8>{});
}
template <class R, class S>
void expect_rates(unsigned seed) {
  const auto exact = Constrained::of<R>();
  oracle::RandomChains random(seed);
  const auto x = motion<R>(random, exact.owner());
  const int n = exact.drives();
  const At<R, double> at(x.u, x.ud, x.udd);
  const auto jerk = random.vector(n, 20.0), snap = random.vector(n, 100.0);
  const auto third = convert<quad>(jerk), fourth = convert<quad>(snap);
  const auto tau_at = [&](quad t) {
    Vector<quad> u = at.exact_u, ud = at.exact_ud, udd = at.exact_udd;
    for (std::size_t k = 0; k < u.size(); ++k) {
      const quad p = third[k], s = fourth[k];
      u[k] += t * (at.exact_ud[k] + t / 2 * (at.exact_udd[k] + t / 3 * (p + t / 4 * s)));
      ud[k] += t * (at.exact_udd[k] + t / 2 * (p + t / 3 * s)), udd[k] += t * (p + t / 2 * s);
    }
    return exact.inverse(u, ud, udd);
  };
  const quad h = quad(1) / quad(1LL << 26);
  const auto before = tau_at(-h), here = tau_at(quad(0)), after = tau_at(h);
  Vector<quad> rate, curve;
  for (std::size_t k = 0; k < here.size(); ++k) {
    rate.push_back((after[k] - before[k]) / (h + h));
    curve.push_back((after[k] - here[k] - here[k] + before[k]) / (h * h));
  }
  const auto q3 = property::joints<R, double>(jerk), q4 = property::joints<R, double>(snap);
  const auto first = torque_rates<S>(at.u, at.ud, at.udd, q3);
  const auto both = torque_rates<S>(at.u, at.ud, at.udd, q3, q4);
  const auto expect = [&](const Vector<quad>& wanted, const auto& found) {
    EXPECT_LE(error_in(wanted, oracle::largest(wanted), convert<quad>(property::vector(found, n))), 1e-11) << seed;
  };
  expect(here, first.tau), expect(rate, first.taud);
  expect(here, both.tau), expect(rate, both.taud), expect(curve, both.taudd);
}
TEST(DrivenDerivatives, InTimeAreSlopesOfEffortsAlongAMotion) {
  expect_rates<robots::WristArm, robots::WristArm>(71);
  expect_rates<robots::ScaraQuill, robots::ScaraQuill>(72);
  expect_rates<Followers, Scene<Followers, Gravity, RotorInertia, Looped>>(73);
}
TEST(DrivenDerivatives, OfDryFrictionAtRestAreThoseOfViscousFriction) {
  using R = Followers;
  const Joints<R, double> u{0.3, -0.5, 0.7}, rest{};
  const auto with = inverse_dynamics_derivatives<Scene<R, Gravity, RotorInertia, Friction>>(u, rest, rest);
  const double viscous[] = {0.5, 0.125, 0.0};
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l)
      EXPECT_NEAR(with.dtau_dqd(k, l), k == l ? viscous[k] : 0.0, 1e-15) << k << l;
}
/// Two slides along one line, the second by half as much again: nothing but friction depends on the speed.
struct Slides {
  static constexpr auto chain = axial::chain(prismatic().mass(2.0).viscous(3.0), prismatic().mass(1.0).mimic(0, 0.5));
};
TEST(DrivenDerivatives, OfFrictionAloneAreSolvedFor) {
  const Joints<Slides, double> u{0.1}, ud{0.2}, tau{4.0};
  const auto d = forward_dynamics_derivatives<Scene<Slides, Friction>>(u, ud, tau);
  EXPECT_DOUBLE_EQ(d.M_inverse(0, 0), 1.0 / 4.25);
  EXPECT_DOUBLE_EQ(d.dqdd_dqd(0, 0), -3.0 / 4.25);
  EXPECT_EQ(d.dqdd_dq(0, 0), 0.0);
}
TEST(DrivenDerivatives, AreKnownToTheCompilerAndWhatIsAskedForAlone) {
  using R = robots::Gripper;
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  constexpr Joints<R, double> u{0.2, 0.01}, ud{1.0, -0.05}, udd{2.0, 0.3};
  constexpr auto all = inverse_dynamics_derivatives<S>(u, ud, udd);
  constexpr auto slope = inverse_dynamics_derivatives<S, with_velocity_jacobian>(u, ud, udd);
  static_assert(sizeof(slope) == 4 * sizeof(double));
  const auto again = inverse_dynamics_derivatives<S>(u, ud, udd);
  for (int k = 0; k < 2; ++k)
    for (int l = 0; l < 2; ++l) {
      EXPECT_DOUBLE_EQ(slope.dtau_dqd(k, l), all.dtau_dqd(k, l));
      EXPECT_NEAR(again.dtau_dq(k, l), all.dtau_dq(k, l), 1e-14);
    }
}
TEST(DrivenDerivatives, ABatchHasWhatEachOfItsStatesHas) {
  using R = robots::WristArm;
  using V = Batch<double, 2>;
  Joints<R, V> x[3] = {};
  Joints<R, double> lanes[2][3] = {};
  oracle::RandomChains random(61);
  for (auto& lane : lanes)
    for (auto& quantity : lane)
      quantity = property::joints<R, double>(random.vector(5, 2.0));
  for (int quantity = 0; quantity < 3; ++quantity)
    for (int k = 0; k < 5; ++k)
      x[quantity][k] = V::of([&](int lane) { return lanes[lane][quantity][k]; });
  const auto together = inverse_dynamics_derivatives<R>(x[0], x[1], x[2]);
  const auto solved = forward_dynamics_derivatives<R>(x[0], x[1], together.tau);
  for (int lane = 0; lane < 2; ++lane) {
    const auto alone = inverse_dynamics_derivatives<R>(lanes[lane][0], lanes[lane][1], lanes[lane][2]);
    const auto solved_alone = forward_dynamics_derivatives<R>(lanes[lane][0], lanes[lane][1], alone.tau);
    for (int k = 0; k < 5; ++k)
      for (int l = 0; l < 5; ++l) {
        EXPECT_NEAR(solved.dqdd_dq(k, l)[lane], solved_alone.dqdd_dq(k, l), 1e-9);
        EXPECT_NEAR(solved.dqdd_dqd(k, l)[lane], solved_alone.dqdd_dqd(k, l), 1e-9);
        EXPECT_NEAR(together.dtau_dq(k, l)[lane], alone.dtau_dq(k, l), 1e-12);
        EXPECT_NEAR(together.dtau_dqd(k, l)[lane], alone.dtau_dqd(k, l), 1e-12);
        EXPECT_NEAR(together.M(k, l)[lane], alone.M(k, l), 1e-12);
      }
  }
}

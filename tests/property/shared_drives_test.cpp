// Joints that share drives, against Lagrange's equations of all joints with their couplings as constraints, multipliers
// and all, in 113 bits; against a closed form; power on either side of random couplings.
#include <axial/batch.hpp>
#include <robots/robots.hpp>
#include <utility>

#include "support.hpp"

namespace {

using namespace axial;
using oracle::convert;
using oracle::Matrix;
using oracle::quad;
using oracle::Vector;

/// q = G u + q0 written by hand, and which link each drive's rotor and friction stand at.
struct Couplings {
  Matrix<quad> g;
  Vector<quad> q0;
  std::vector<int> owner;
};
Couplings couplings(int joints, const std::vector<int>& owner, const std::vector<std::vector<double>>& rows) {
  Couplings c{Matrix<quad>(joints, int(owner.size())), Vector<quad>(std::size_t(joints), quad(0)), owner};
  for (int i = 0; i < joints; ++i)
    for (int k = 0; k < int(owner.size()); ++k)
      c.g(i, k) = rows[std::size_t(i)][std::size_t(k)];
  return c;
}

/// A tree whose joints follow each other: a belt with a ratio that no float holds, offsets, a slide that follows a
/// turn.
struct Followers {
  // A line a group of values.
  // clang-format off
  static constexpr auto chain = axial::chain(axial::gravity(1.0, -2.0, -9.0), axial::tool(0.1, 0.05, 0.2),
      revolute().mass(4).com(0.1, 0.02, 0.05).inertia_com(0.2, 0.25, 0.3, 0.01, 0.0, 0.02)
          .rotor_inertia(5e-4, 20).viscous(0.5).coulomb(0.25),
      revolute().alpha_deg(-90).a(0.2).mass(2).com(0.1, 0, 0.01).inertia_com(0.05, 0.06, 0.07).mimic(0, -0.3, 0.25)
          .spring(3.0, 0.125),
      prismatic().alpha(0.7).d(0.1).mass(1.5).com(0.02, 0.1, 0).inertia_com(0.02, 0.03, 0.04).mimic(1, 0.125, -0.5),
      revolute().parent(0).alpha_deg(90).a(0.3).mass(1).com(0.1, 0.01, 0.05).inertia_com(0.01, 0.01, 0.005)
          .rotor_inertia(1e-4, 40).viscous(0.125).driven_by(0, 0.75).driven_by(3, 2.0).driven_by(4, -1.0),
      revolute().alpha(-1.3).mass(0.5).com(0.05, 0, 0.02).inertia_com(0.002, 0.003, 0.002).rotor_inertia(1e-4, 15));
  // clang-format on
};

template <class R>
Couplings by_hand();
template <>
Couplings by_hand<robots::ScaraQuill>() {
  auto c = couplings(4, {0, 1, 2, 3}, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}});
  c.g(2, 2) = quad(0.020) / (4 * oracle::right_angle<quad>());
  c.g(2, 3) = -c.g(2, 2);
  return c;
}
template <>
Couplings by_hand<robots::Palletiser>() {
  return couplings(10, {0, 1, 2, 9},
                   {{1, 0, 0, 0},
                    {0, 1, 0, 0},
                    {0, 0, 1, 0},
                    {0, 1, -1, 0},
                    {0, -1, 1, 0},
                    {0, 1, 0, 0},
                    {0, -1, 0, 0},
                    {0, 0, 1, 0},
                    {0, 0, -1, 0},
                    {0, 0, 0, 1}});
}
template <>
Couplings by_hand<robots::WristArm>() {
  return couplings(5, {0, 1, 2, 3, 4},
                   {{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, -1, 1, 0, 0}, {0, 0, 0, 0.5, 0.5}, {0, 0, 0, 0.5, -0.5}});
}
template <>
Couplings by_hand<robots::Gripper>() {
  return couplings(3, {0, 1}, {{1, 0}, {0, 1}, {0, 1}});
}
template <>
Couplings by_hand<Followers>() {
  auto c = couplings(5, {0, 3, 4}, {{1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0.75, 2, -1}, {0, 0, 1}});
  c.g(1, 0) = quad(-0.3), c.q0[1] = quad(0.25);
  c.g(2, 0) = quad(0.125) * quad(-0.3), c.q0[2] = quad(0.125) * quad(0.25) - quad(0.5);
  return c;
}

/// x of A x = b by Gauss' elimination with pivots of rows: A has no definite sign.
Vector<quad> solve_any(Matrix<quad> A, Vector<quad> b) {
  const int n = A.rows();
  const auto at = [](int i) { return std::size_t(i); };
  for (int j = 0; j < n; ++j) {
    int best = j;
    for (int i = j; i < n; ++i)
      if (oracle::abs(A(i, j)) > oracle::abs(A(best, j))) best = i;
    for (int k = 0; k < n; ++k)
      std::swap(A(j, k), A(best, k));
    std::swap(b[at(j)], b[at(best)]);
    for (int i = j + 1; i < n; ++i) {
      const quad l = A(i, j) / A(j, j);
      for (int k = j; k < n; ++k)
        A(i, k) -= l * A(j, k);
      b[at(i)] -= l * b[at(j)];
    }
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k)
      b[at(i)] -= A(i, k) * b[at(k)];
    b[at(i)] /= A(i, i);
  }
  return b;
}

/// Joints q and drives u as free coordinates, q - G u - q0 = 0 between them with a multiplier a joint.
class Constrained {
 public:
  template <class R>
  static Constrained of(const oracle::Load<quad>& load = {}) {
    Constrained c;
    c.chain_ = oracle::of_robot<quad, R>();
    c.drives_ = c.chain_.links;
    for (auto& link : c.chain_.links)
      link.rotor_inertia = link.viscous = link.coulomb_forward = link.coulomb_backward = quad(0);
    c.couplings_ = by_hand<R>();
    c.load_ = load;
    return c;
  }
  int joints() const { return chain_.size(); }
  int drives() const { return int(couplings_.owner.size()); }
  const std::vector<int>& owner() const { return couplings_.owner; }
  const oracle::Chain<quad>& chain() const { return chain_; }
  const Matrix<quad>& g() const { return couplings_.g; }
  Vector<quad> positions(const Vector<quad>& u) const {
    Vector<quad> q = couplings_.g * u;
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] += couplings_.q0[i];
    return q;
  }

  /// Accelerations of the drives under efforts of theirs.
  Vector<quad> forward(const Vector<quad>& u, const Vector<quad>& ud, const Vector<quad>& tau) const {
    const int n = joints(), m = drives();
    Matrix<quad> A = equations(u);  // of qdd, lambda, udd
    Vector<quad> b = forces(u, ud);
    for (int k = 0; k < m; ++k)
      A(n + k, 2 * n + k) = rotor(k), b[std::size_t(n + k)] += tau[std::size_t(k)];
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < m; ++k)
        A(n + m + i, 2 * n + k) = -g()(i, k);
    return tail(solve_any(A, b));
  }
  /// Efforts of the drives that give them accelerations.
  Vector<quad> inverse(const Vector<quad>& u, const Vector<quad>& ud, const Vector<quad>& udd) const {
    const int n = joints(), m = drives();
    Matrix<quad> A = equations(u);  // of qdd, lambda, tau
    Vector<quad> b = forces(u, ud);
    for (int k = 0; k < m; ++k)
      A(n + k, 2 * n + k) = quad(-1), b[std::size_t(n + k)] -= rotor(k) * udd[std::size_t(k)];
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < m; ++k)
        b[std::size_t(n + m + i)] += g()(i, k) * udd[std::size_t(k)];
    return tail(solve_any(A, b));
  }
  Matrix<quad> mass(const Vector<quad>& u) const {
    const int m = drives();
    const Vector<quad> rest(std::size_t(m), quad(0));
    const auto held = inverse(u, rest, rest);
    Matrix<quad> M(m, m);
    for (int k = 0; k < m; ++k) {
      auto one = rest;
      one[std::size_t(k)] = 1;
      const auto column = inverse(u, rest, one);
      for (int i = 0; i < m; ++i)
        M(i, k) = column[std::size_t(i)] - held[std::size_t(i)];
    }
    return M;
  }

 private:
  const oracle::Link<quad>& drive(int k) const { return drives_[std::size_t(couplings_.owner[std::size_t(k)])]; }
  quad rotor(int k) const { return drive(k).gear * drive(k).gear * drive(k).rotor_inertia; }
  quad friction(int k, quad ud) const {
    if (!load_.friction) return 0;
    return drive(k).viscous * ud + (ud > 0 ? drive(k).coulomb_forward : ud < 0 ? drive(k).coulomb_backward : quad(0));
  }
  /// The columns that both problems share: M qdd - lambda; G^T lambda; qdd.
  Matrix<quad> equations(const Vector<quad>& u) const {
    const int n = joints(), m = drives();
    Matrix<quad> A(2 * n + m, 2 * n + m);
    const auto M = oracle::mass_matrix(chain_, positions(u));
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j)
        A(i, j) = M(i, j);
      A(i, n + i) = -1, A(n + m + i, i) = 1;
      for (int k = 0; k < m; ++k)
        A(n + k, n + i) = g()(i, k);
    }
    return A;
  }
  Vector<quad> forces(const Vector<quad>& u, const Vector<quad>& ud) const {
    const int n = joints(), m = drives();
    oracle::Load<quad> of_joints = load_;
    of_joints.friction = false;
    const auto c =
        oracle::inverse_dynamics(chain_, positions(u), g() * ud, Vector<quad>(std::size_t(n), quad(0)), of_joints);
    Vector<quad> b(std::size_t(2 * n + m), quad(0));
    for (int i = 0; i < n; ++i)
      b[std::size_t(i)] = -c[std::size_t(i)];
    for (int k = 0; k < m; ++k)
      b[std::size_t(n + k)] = -friction(k, ud[std::size_t(k)]);
    return b;
  }
  Vector<quad> tail(const Vector<quad>& x) const { return Vector<quad>(x.end() - drives(), x.end()); }

  oracle::Chain<quad> chain_;
  std::vector<oracle::Link<quad>> drives_;
  Couplings couplings_;
  oracle::Load<quad> load_;
};

template <class T>
constexpr double tolerance = std::is_same_v<T, double> ? 1e-12 : 5e-6;

struct Motion {
  Vector<double> u, ud, udd;
};
/// As fast as the drives may: a nut turns a thousand times as fast as an arm.
template <class R>
Motion motion(oracle::RandomChains& random, const std::vector<int>& owner) {
  const auto within = [&](double limit, double otherwise) {
    const double size = limit < 1e6 ? limit : otherwise;
    return random.uniform(-size, size);
  };
  Motion x;
  for (const int i : owner) {
    const LinkParameters& link = R::chain.links[i];
    x.u.push_back(random.uniform(-2, 2));
    x.ud.push_back(within(link.drive_speed_limit, 3));
    x.udd.push_back(within(link.drive_acceleration_limit, 10));
  }
  return x;
}
/// Largest error in units of the largest effort of the motion, of which a part may nearly vanish.
double error_in(const Vector<quad>& exact, double size, const Vector<quad>& found) {
  double worst = 0.0;
  for (std::size_t k = 0; k < exact.size(); ++k)
    worst = std::fmax(worst, double(oracle::abs(exact[k] - found[k])));
  return worst / size;
}

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

template <class R, class T>
void expect_plain(unsigned seed) {
  expect_constrained<R, T, Gravity, RotorInertia>({}, seed, 40);
}

/// What no robot says: which matrix, from numbers alone.
template <int Number>
struct RandomCoupling {
  static constexpr int n = 2 + Number % 3;
  static constexpr double number(int k) {
    std::uint32_t x = std::uint32_t(Number) * 2654435761U + std::uint32_t(k) * 40503U + 12345U;
    for (int i = 0; i < 4; ++i)
      x = (x ^ (x >> 15)) * 2246822519U;
    return double(x >> 8) / 8388608.0 - 1.0;
  }
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

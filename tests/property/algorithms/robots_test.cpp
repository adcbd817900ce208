// Properties that physics demands, on every robot of robots/, unrolled, in double and float.
#include <robots/robots.hpp>

#include <cmath>

#include <property/support.hpp>

namespace {

using oracle::quad;
using property::joints;
using property::random_state;

constexpr int states = 2000;
constexpr unsigned seed = 560;

template <class T>
constexpr double aba_tolerance = std::is_same_v<T, double> ? 1e-11 : 1e-4;
template <class T>
constexpr double torque_tolerance = std::is_same_v<T, double> ? 1e-12 : 2e-6;

template <class R>
class Robot : public testing::Test {
 public:
  using Type = R;
};
using Robots =
    testing::Types<robots::Scara, robots::ScaraRrpr, robots::Puma560, robots::Panda, robots::Planar2r, robots::TwoArm>;
TYPED_TEST_SUITE(Robot, Robots);

template <class S, class T>
void expect_forward_undoes_inverse(const char* route) {
  using R = axial::robot_of<S>;
  oracle::RandomChains random(seed);
  double worst = 0.0;
  for (int k = 0; k < states; ++k) {
    auto state = random_state<R>(random);
    if (oracle::largest(state.qdd) < 1.0) state.qdd[0] = 1.0;
    const auto q = joints<R, T>(state.q), qd = joints<R, T>(state.qd), qdd = joints<R, T>(state.qdd);
    const auto result = axial::forward_dynamics<S>(q, qd, axial::inverse_dynamics<R>(q, qd, qdd));
    EXPECT_TRUE(result.status.ok()) << result.status.joint;
    worst = std::fmax(
        worst, oracle::relative_error(oracle::Vector<T>(result.values, result.values + R::chain.size), state.qdd));
  }
  EXPECT_LE(worst, aba_tolerance<T>);
  std::printf("worst relative error after RNEA, %s: %.1e\n", route, worst);
}
template <class R, class T>
void expect_every_route_undoes_rnea() {
  using namespace axial;
  expect_forward_undoes_inverse<Scene<R, Gravity, RotorInertia, ArticulatedBody>, T>("articulated body");
  expect_forward_undoes_inverse<Scene<R, Gravity, RotorInertia, SplitArticulatedBody>, T>("split");
  expect_forward_undoes_inverse<Scene<R, Gravity, RotorInertia, CompositeBody>, T>("composite body");
}

// Relative to the largest torque of each joint over all states.
template <class S, class T, class Load>
void expect_oracle_torque(const axial::Inputs<S, T>& in, const Load& load) {
  using R = axial::robot_of<S>;
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(seed);
  oracle::Vector<double> error(R::chain.size, 0.0), largest(R::chain.size, 0.0);
  for (int k = 0; k < 100; ++k) {
    const auto state = random_state<R>(random);
    const auto tau =
        axial::inverse_dynamics<S>(joints<R, T>(state.q), joints<R, T>(state.qd), joints<R, T>(state.qdd), in);
    const auto reference =
        oracle::inverse_dynamics(load(chain), oracle::convert<quad>(state.q), oracle::convert<quad>(state.qd),
                                 oracle::convert<quad>(state.qdd), load.load);
    for (std::size_t i = 0; i < error.size(); ++i) {
      error[i] = std::fmax(error[i], static_cast<double>(oracle::abs(quad(tau[static_cast<int>(i)]) - reference[i])));
      largest[i] = std::fmax(largest[i], static_cast<double>(oracle::abs(reference[i])));
    }
  }
  for (std::size_t i = 0; i < error.size(); ++i)
    EXPECT_LE(error[i], torque_tolerance<T> * largest[i]) << "joint " << i;
}

struct Unloaded {
  oracle::Load<quad> load;
  const oracle::Chain<quad>& operator()(const oracle::Chain<quad>& chain) const { return chain; }
};
struct Bare : Unloaded {};
struct Rubbing : Unloaded {
  Rubbing() { load.friction = true; }
};

// The payload as the oracle sees it: the last link with two bodies, combined by the textbook.
struct Loaded : Unloaded {
  static constexpr double mass = 1.5, x = 0.03125, y = -0.0625, z = 0.125,
                          inertia[3] = {0.0078125, 0.00390625, 0.005859375};
  oracle::Chain<quad> operator()(oracle::Chain<quad> chain) const {
    auto& link = chain.links.back();
    const oracle::Vec3<quad> c{quad(x), quad(y), quad(z)};
    const quad total = link.mass + quad(mass);
    const auto com = (quad(1) / total) * (link.mass * link.com + quad(mass) * c);
    const auto about = [&](const oracle::Vec3<quad>& at, quad m) {
      const auto r = at - com;
      const quad s = dot(r, r);
      return oracle::symmetric<quad>(m * (s - r.x * r.x), m * (s - r.y * r.y), m * (s - r.z * r.z), -m * r.x * r.y,
                                     -m * r.x * r.z, -m * r.y * r.z);
    };
    const auto own = oracle::symmetric<quad>(quad(inertia[0]), quad(inertia[1]), quad(inertia[2]), 0, 0, 0);
    link.inertia = link.inertia + own + about(link.com, link.mass) + about(c, quad(mass));
    link.com = com, link.mass = total;
    return chain;
  }
};
struct Pushed : Unloaded {
  Pushed() { load.tip = {{quad(3), quad(-2), quad(5)}, {quad(0.5), quad(-0.25), quad(0.75)}}; }
};

template <class R, class T>
void expect_oracle_torques() {
  using namespace axial;
  expect_oracle_torque<R, T>({}, Bare{});
  expect_oracle_torque<Scene<R, Gravity, RotorInertia, Friction>, T>({}, Rubbing{});
  Inputs<Scene<R, Gravity, RotorInertia, Payload>, T> carrying;
  carrying.payload = {T(Loaded::mass),
                      {T(Loaded::x), T(Loaded::y), T(Loaded::z)},
                      {T(Loaded::inertia[0]), T(Loaded::inertia[1]), T(Loaded::inertia[2])}};
  expect_oracle_torque<Scene<R, Gravity, RotorInertia, Payload>, T>(carrying, Loaded{});
  Inputs<Scene<R, Gravity, RotorInertia, TipWrench>, T> pushed;
  pushed.tip_wrench = {{T(0.5), T(-0.25), T(0.75)}, {T(3), T(-2), T(5)}};
  expect_oracle_torque<Scene<R, Gravity, RotorInertia, TipWrench>, T>(pushed, Pushed{});
}

}  // namespace

TYPED_TEST(Robot, EveryRouteUndoesRneaInDouble) { expect_every_route_undoes_rnea<TypeParam, double>(); }
TYPED_TEST(Robot, EveryRouteUndoesRneaInFloat) { expect_every_route_undoes_rnea<TypeParam, float>(); }

// Bare, with friction, with a payload, with a tip wrench.
TYPED_TEST(Robot, TorqueIsTheOraclesInDouble) { expect_oracle_torques<TypeParam, double>(); }
TYPED_TEST(Robot, TorqueIsTheOraclesInFloat) { expect_oracle_torques<TypeParam, float>(); }

// The same loads in forward dynamics: it undoes inverse dynamics with everything named.
TYPED_TEST(Robot, AbaUndoesRneaWithEveryFeature) {
  using namespace axial;
  using R = TypeParam;
  using S = Scene<R, Gravity, RotorInertia, Friction, Payload, TipWrench>;
  Inputs<S, double> in;
  in.payload = {1.5, {0.03, -0.06, 0.12}, {0.008, 0.004, 0.006, 0.001, 0.0, 0.0}};
  in.tip_wrench = {{0.5, -0.2, 0.7}, {3.0, -2.0, 5.0}};
  oracle::RandomChains random(seed);
  for (int k = 0; k < 200; ++k) {
    const auto state = random_state<R>(random);
    const auto q = joints<R, double>(state.q), qd = joints<R, double>(state.qd);
    const auto tau = inverse_dynamics<S>(q, qd, joints<R, double>(state.qdd), in);
    const auto qdd = forward_dynamics<S>(q, qd, tau, in);
    EXPECT_LE(oracle::relative_error(oracle::Vector<double>(qdd.values, qdd.values + R::chain.size), state.qdd), 1e-11);
  }
}

TYPED_TEST(Robot, LoopedEqualsUnrolled) {
  using namespace axial;
  using R = TypeParam;
  using L = Scene<R, Gravity, RotorInertia, Looped>;
  oracle::RandomChains random(seed);
  for (int k = 0; k < 200; ++k) {
    const auto state = random_state<R>(random);
    const auto q = joints<R, double>(state.q), qd = joints<R, double>(state.qd), qdd = joints<R, double>(state.qdd);
    const auto tau = inverse_dynamics<R>(q, qd, qdd);
    EXPECT_LE(oracle::relative_error(property::vector(inverse_dynamics<L>(q, qd, qdd)), property::vector(tau)), 1e-13);
    EXPECT_LE(oracle::relative_error(property::matrix(mass_matrix<L>(q)), property::matrix(mass_matrix<R>(q))), 1e-14);
    const auto looped = forward_dynamics<L>(q, qd, tau), unrolled = forward_dynamics<R>(q, qd, tau);
    EXPECT_LE(oracle::relative_error(oracle::Vector<double>(looped.values, looped.values + R::chain.size),
                                     oracle::Vector<double>(unrolled.values, unrolled.values + R::chain.size)),
              1e-12);
  }
}

// Regrouping moves inertia between links; no joint feels it.
TYPED_TEST(Robot, BaseParametersGiveTheSameTorquesAndAccelerations) {
  using namespace axial;
  using R = TypeParam;
  using FullSet = Scene<R, Gravity, RotorInertia, FullParameters>;
  using BaseSet = Scene<R, Gravity, RotorInertia, BaseParameters>;
  oracle::RandomChains random(seed);
  for (int k = 0; k < 200; ++k) {
    const auto state = random_state<R>(random);
    const auto q = joints<R, double>(state.q), qd = joints<R, double>(state.qd), qdd = joints<R, double>(state.qdd);
    const auto tau = inverse_dynamics<FullSet>(q, qd, qdd);
    EXPECT_LE(oracle::relative_error(property::vector(inverse_dynamics<BaseSet>(q, qd, qdd)), property::vector(tau)),
              1e-13);
    EXPECT_LE(
        oracle::relative_error(property::matrix(mass_matrix<BaseSet>(q)), property::matrix(mass_matrix<FullSet>(q))),
        1e-13);
    const auto base = forward_dynamics<BaseSet>(q, qd, tau);
    EXPECT_LE(oracle::relative_error(oracle::Vector<double>(base.values, base.values + R::chain.size), state.qdd),
              1e-10);
  }
}

TYPED_TEST(Robot, MassMatrixIsPositiveDefinite) {
  using R = TypeParam;
  oracle::RandomChains random(seed);
  for (int k = 0; k < 200; ++k) {
    auto m = property::matrix(axial::mass_matrix<R>(joints<R, double>(random_state<R>(random).q)));
    for (int i = 0; i < m.rows(); ++i) {  // Gaussian elimination: every pivot is positive
      EXPECT_GT(m(i, i), 0.0) << i;
      for (int r = i + 1; r < m.rows(); ++r)
        for (int c = i + 1; c < m.rows(); ++c)
          m(r, c) -= m(r, i) * m(i, c) / m(i, i);
    }
  }
}

// The power of the torques is the rate of the energy, which the oracle differentiates along the motion in quad.
TYPED_TEST(Robot, TorquesBalanceThePower) {
  using R = TypeParam;
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(seed);
  for (int k = 0; k < 50; ++k) {
    const auto state = random_state<R>(random);
    const auto energy = [&](quad t) {
      oracle::Vector<quad> q, qd;
      for (std::size_t i = 0; i < state.q.size(); ++i) {
        q.push_back(quad(state.q[i]) + t * quad(state.qd[i]) + t * t * quad(state.qdd[i]) / 2);
        qd.push_back(quad(state.qd[i]) + t * quad(state.qdd[i]));
      }
      return oracle::kinetic_energy(chain, q, qd) + oracle::potential_energy(chain, q);
    };
    const quad h = quad(1e-9);
    const double rate = static_cast<double>((energy(h) - energy(-h)) / (2 * h));
    const auto tau = axial::inverse_dynamics<R>(joints<R, double>(state.q), joints<R, double>(state.qd),
                                                joints<R, double>(state.qdd));
    double power = 0.0, scale = 0.0;
    for (int i = 0; i < R::chain.size; ++i) {
      power += tau[i] * state.qd[static_cast<std::size_t>(i)];
      scale += std::fabs(tau[i] * state.qd[static_cast<std::size_t>(i)]);
    }
    EXPECT_NEAR(power, rate, 1e-12 * scale);
  }
}

// C(q, qd) from the library's velocity torques by polarisation (Christoffel symbols); dM/dt - 2C must be skew.
TYPED_TEST(Robot, RateOfMassMatrixMinusTwiceCoriolisIsSkew) {
  using namespace axial;
  using R = TypeParam;
  using S = Scene<R, RotorInertia>;  // no gravity: bias is c(q, qd)
  constexpr int n = R::chain.size;
  oracle::RandomChains random(seed);
  for (int sample = 0; sample < 20; ++sample) {
    const auto state = random_state<R>(random);
    const auto q = joints<R, double>(state.q), qd = joints<R, double>(state.qd);
    const auto velocity_torque = [&](int j, int k) {
      Joints<R, double> v{};
      v[j] += 1.0;
      if (k != j) v[k] += 1.0;
      return bias_torque<S>(q, v);
    };
    double coriolis[n][n] = {};
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const auto both = velocity_torque(j, k), first = velocity_torque(j, j), second = velocity_torque(k, k);
        for (int i = 0; i < n; ++i)
          coriolis[i][j] += (j == k ? first[i] : 0.5 * (both[i] - first[i] - second[i])) * qd[k];
      }
    const auto at = [&](double t) {
      auto moved = q;
      for (int i = 0; i < n; ++i)
        moved[i] += t * qd[i];
      return mass_matrix<R>(moved);
    };
    const double h = 1e-4;
    const auto a = at(-2 * h), b = at(-h), c = at(h), d = at(2 * h);
    double largest = 0.0, skew[n][n];
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double rate = (a(i, j) - 8 * b(i, j) + 8 * c(i, j) - d(i, j)) / (12 * h);
        skew[i][j] = rate - 2 * coriolis[i][j];
        largest = std::fmax(largest, std::fabs(rate) + std::fabs(coriolis[i][j]));
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        EXPECT_NEAR(skew[i][j], -skew[j][i], 1e-9 * largest) << i << ' ' << j;
  }
}

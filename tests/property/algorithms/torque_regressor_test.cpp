// The torque regressor, entry by entry, against the oracle's torques of unit parameters in 113-bit arithmetic.
#include <cases/to_axial.hpp>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include "random_models.hpp"
#include "scene_robot.hpp"

namespace {

using namespace axial;
using oracle::quad;
using property::Everything;
using property::Fill;
using property::joints;
using QuadChain = oracle::Chain<quad>;
using QuadVector = oracle::Vector<quad>;

// Inertia with one where either index pair says so.
oracle::Mat3<quad> unit_inertia(int row, int column) {
  oracle::Mat3<quad> m{{}, {}, {}};
  oracle::Vec3<quad>* const columns[] = {&m.c0, &m.c1, &m.c2};
  const auto element = [&](int i, int j) -> quad& {
    auto& of = *columns[j];
    return i == 0 ? of.x : i == 1 ? of.y : of.z;
  };
  element(row, column) = element(column, row) = 1;
  return m;
}

QuadChain without_parameters(QuadChain chain) {
  for (auto& link : chain.links) {
    link.mass = link.rotor_inertia = link.viscous = link.coulomb_forward = link.coulomb_backward = 0;
    link.gear = 1, link.com = {}, link.inertia = {{}, {}, {}};
  }
  return chain;
}

// Columns of link k by torques of unit parameters, in the order of InertialParameter; those of its drive behind.
template <class Torque>
std::vector<QuadVector> reference(const QuadChain& chain, int k, const Torque& torque) {
  const QuadChain bare = without_parameters(chain);
  const QuadVector known = torque(bare);
  const auto minus = [](QuadVector from, const QuadVector& other) {
    for (std::size_t i = 0; i < from.size(); ++i)
      from[i] -= other[i];
    return from;
  };
  const auto of = [&](const auto& change) {
    QuadChain one = bare;
    change(one.links[static_cast<std::size_t>(k)]);
    return minus(torque(one), known);
  };
  const auto mass = of([](auto& link) { link.mass = 1; });
  std::vector<QuadVector> inertia;
  for (const auto& [row, column] : {std::pair{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}})
    inertia.push_back(of([row = row, column = column](auto& link) { link.inertia = unit_inertia(row, column); }));
  // A point mass at 1 m has its mass and its moments of inertia besides.
  const auto moment = [&](const oracle::Vec3<quad>& com, std::size_t one, std::size_t other) {
    const auto point = of([&](auto& link) { link.mass = 1, link.com = com; });
    return minus(minus(minus(point, mass), inertia[one]), inertia[other]);
  };
  std::vector<QuadVector> all{mass, moment({1, 0, 0}, 1, 2), moment({0, 1, 0}, 0, 2), moment({0, 0, 1}, 0, 1)};
  all.insert(all.end(), inertia.begin(), inertia.end());
  all.push_back(of([](auto& link) { link.rotor_inertia = 1; }));
  all.push_back(of([](auto& link) { link.viscous = 1; }));
  all.push_back(of([](auto& link) { link.coulomb_forward = 1; }));
  all.push_back(of([](auto& link) { link.coulomb_backward = 1; }));
  return all;
}

// d tau_i by parameter p of link k, those of its drive behind.
template <class S, class T>
T entry(const TorqueRegressor<S, T>& y, int i, int k, int p) {
  constexpr int links_own = TorqueRegressor<S, T>::parameters;
  if (p < links_own) return y(i, links_own * k + p);
  if constexpr (scene_of<S>::template has<Friction> && scene_of<S>::template has<RotorInertia>) {
    const T of_drive[] = {y.rotor[k], y.viscous[k], y.coulomb_forward[k], y.coulomb_backward[k]};
    return i == k ? of_drive[p - links_own] : T(0);
  }
  return T(0);
}

// All entries, relative to the largest one.
template <class S, class T, class Torque>
void expect_entries(const TorqueRegressor<S, T>& y, const QuadChain& chain, double most, const Torque& torque) {
  constexpr bool drives = scene_of<S>::template has<Friction>;
  quad worst = 0, largest = 1;
  for (int k = 0; k < chain.size(); ++k) {
    const auto exact = reference(chain, k, torque);
    for (int p = 0; p < (drives ? 14 : 10); ++p) {
      for (int i = 0; i < chain.size(); ++i) {
        const quad e = exact[static_cast<std::size_t>(p)][static_cast<std::size_t>(i)];
        worst = std::max(worst, oracle::abs(quad(entry(y, i, k, p)) - e));
        largest = std::max(largest, oracle::abs(e));
      }
    }
  }
  EXPECT_LE(static_cast<double>(worst / largest), most);
}

template <class R, class T>
struct State {
  Joints<R, T> q, qd, qdd;
  int n = joint_count<R>;
  QuadVector exact(const Joints<R, T>& values) const { return oracle::convert<quad>(property::vector(values, n)); }
};
template <class R, class T>
State<R, T> random_state(oracle::RandomChains& random, int n = joint_count<R>) {
  const auto values = [&](double most) { return joints<R, T>(random.vector(n, most)); };
  return {values(3.0), values(1.0), values(4.0), n};
}

template <class... F>
struct Named {
  using Unrolled = Scene<Everything, F...>;
  using Compact = Scene<Everything, F..., Looped>;
};
template <class S>
void expect_scene(oracle::RandomChains& random) {
  const auto s = random_state<Everything, double>(random);
  const auto y = torque_regressor<S>(s.q, s.qd, s.qdd, Fill::inputs<S, double>(s.q));
  const auto load = Fill::load<S>();
  const auto base = Fill::base_motion<S>();
  expect_entries(y, Fill::chain<S, Everything>(), 1e-14, [&](const QuadChain& chain) {
    const auto q = s.exact(s.q), qd = s.exact(s.qd), qdd = s.exact(s.qdd);
    return S::template has<BaseMotion> ? oracle::inverse_dynamics_on_moving_base(chain, base, q, qd, qdd, load)
                                       : oracle::inverse_dynamics(chain, q, qd, qdd, load);
  });
}
template <class N>
class RegressorOfScenes : public testing::Test {};
using Scenes =
    testing::Types<Named<Gravity>, Named<RuntimeGravity, TipWrench, JointSprings>, Named<Gravity, BaseMotion>,
                   Named<Gravity, RotorInertia, Friction, JointSprings, Payload>>;
TYPED_TEST_SUITE(RegressorOfScenes, Scenes);

template <class R, class T>
void expect_robot(int states, double most) {
  oracle::RandomChains random(23);
  const auto chain = oracle::of_robot<quad, R>();
  for (int k = 0; k < states; ++k) {
    SCOPED_TRACE(k);
    const auto s = random_state<R, T>(random);
    expect_entries(torque_regressor<R>(s.q, s.qd, s.qdd), chain, most, [&](const QuadChain& at) {
      return oracle::inverse_dynamics(at, s.exact(s.q), s.exact(s.qd), s.exact(s.qdd));
    });
  }
}

}  // namespace

TYPED_TEST(RegressorOfScenes, IsTheOraclesInEveryForm) {
  oracle::RandomChains random(35);
  for (int k = 0; k < 4; ++k) {
    SCOPED_TRACE(k);
    expect_scene<typename TypeParam::Unrolled>(random);
    expect_scene<typename TypeParam::Compact>(random);
  }
}

TEST(TorqueRegressor, OfRobotsIsTheOracles) {
  expect_robot<robots::Puma560, double>(3, 1e-14);
  expect_robot<robots::Panda, double>(3, 1e-14);
  expect_robot<robots::Scara, double>(3, 1e-14);
}
TEST(TorqueRegressor, OfRobotsInFloat) {
  expect_robot<robots::Puma560, float>(3, 1e-6);
  expect_robot<robots::Panda, float>(3, 1e-6);
  expect_robot<robots::Scara, float>(3, 1e-6);
}

TEST(TorqueRegressor, OfRandomChainsAndTreesIsTheOracles) {
  using M = Model<12, Gravity, RotorInertia>;
  property::expect_on_random_models<M>(44, 8, 6, [](auto& random, const M& model, const auto& chain, int n) {
    const auto s = random_state<M, double>(random, n);
    expect_entries(torque_regressor(model, s.q, s.qd, s.qdd), chain, 1e-14, [&](const QuadChain& at) {
      return oracle::inverse_dynamics(at, s.exact(s.q), s.exact(s.qd), s.exact(s.qdd));
    });
    return true;
  });
}

// Torque rates, and the feed-forward of elastic joints, against Lagrange's equations along a path in 113-bit
// arithmetic.
#include <axial/batch.hpp>
#include <cases/to_axial.hpp>
#include <oracle/differences.hpp>
#include <robots/indy7.hpp>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>
#include <robots/scara_rrpr.hpp>
#include <robots/two_arm.hpp>

#include "random_models.hpp"
#include "scene_robot.hpp"

namespace {

using namespace axial;
using oracle::quad;
using property::Everything;
using property::Fill;
using property::joints;
using QuadVector = oracle::Vector<quad>;

/// A robot with a stiffness that differs from joint to joint; every third joint stays rigid where `mixed`.
template <class R, bool mixed = false>
struct Sprung {
  static constexpr auto chain = [] {
    auto chain = R::chain;
    for (int i = 0; i < chain.size; ++i)
      if (!mixed || i % 3 != 2) chain.links[i].stiffness = 2048.0 * (1 + i % 4);
    return chain;
  }();
};

// A point of a path, with four derivatives.
template <class R, class T>
struct Path {
  Joints<R, T> q, qd, qdd, q3, q4;
  int n = joint_count<R>;

  oracle::Path exact() const {
    const auto values = [&](const Joints<R, T>& of) { return oracle::convert<quad>(property::vector(of, n)); };
    return {values(q), values(qd), values(qdd), values(q3), values(q4)};
  }
};
template <class R, class T>
Path<R, T> random_path(oracle::RandomChains& random, int n = joint_count<R>) {
  const auto values = [&](double most) { return joints<R, T>(random.vector(n, most)); };
  return {values(3.0), values(2.0), values(4.0), values(8.0), values(16.0), n};
}

/// Torque along a path with both its rates.
template <class P>
oracle::RatesInTime exact_rates(const P& path, const oracle::Chain<quad>& chain, const oracle::Load<quad>& load = {}) {
  return oracle::rates_in_time(path.exact(), [&](const QuadVector& q, const QuadVector& qd, const QuadVector& qdd) {
    return oracle::inverse_dynamics(chain, q, qd, qdd, load);
  });
}

// The largest difference over the largest exact value.
template <class Ours>
double error(const Ours& ours, const QuadVector& exact) {
  quad difference = 0, largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    difference = std::max(difference, oracle::abs(quad(ours[static_cast<int>(i)]) - exact[i]));
    largest = std::max(largest, oracle::abs(exact[i]));
  }
  return static_cast<double>(difference / (largest > 0 ? largest : quad(1)));
}

/// What the motors do, from Spong's equations.
struct Motors {
  QuadVector tau_m, theta, thetad, tau_l;
};
template <class S, class P>
Motors exact_motors(const P& path) {
  using Robot = robot_of<S>;
  const auto motors = Fill::chain<S, Robot>();
  auto load = Fill::load<S>();
  load.friction = false;
  const oracle::RatesInTime link = exact_rates(path, oracle::without_rotors(motors), load);
  const oracle::Path given = path.exact();
  Motors result{link.value, given.q, given.qd, link.value};
  for (std::size_t i = 0; i < link.value.size(); ++i) {
    const double k = Robot::chain.links[i].stiffness;
    const quad c = k < LinkParameters::unlimited ? quad(1) / quad(k) : quad(0);
    const auto& drive = motors.links[i];
    result.theta[i] += c * link.value[i];
    result.thetad[i] += c * link.first[i];
    result.tau_m[i] += drive.gear * drive.gear * drive.rotor_inertia * (given.qdd[i] + c * link.second[i]);
  }
  if (scene_of<S>::template has<Friction>) {
    const QuadVector friction = oracle::friction_torque(motors, result.thetad);
    for (std::size_t i = 0; i < friction.size(); ++i)
      result.tau_m[i] += friction[i];
  }
  return result;
}

template <class S, class P, class T>
void expect_rates(const P& p, const oracle::Chain<quad>& chain, const Inputs<S, T>& in, double most) {
  const oracle::RatesInTime exact = exact_rates(p, chain, Fill::load<S>());
  const auto second = torque_rates<S>(p.q, p.qd, p.qdd, p.q3, p.q4, in);
  const auto first = torque_rates<S>(p.q, p.qd, p.qdd, p.q3, in);
  EXPECT_LE(error(second.tau, exact.value), most);
  EXPECT_LE(error(second.taud, exact.first), most);
  EXPECT_LE(error(second.taudd, exact.second), most);
  EXPECT_LE(error(first.tau, exact.value), most);
  EXPECT_LE(error(first.taud, exact.first), most);
}
template <class S, class P, class T>
void expect_motors(const P& p, const Inputs<S, T>& in, double most) {
  const Motors exact = exact_motors<S>(p);
  const auto ours = elastic_feedforward<S>(p.q, p.qd, p.qdd, p.q3, p.q4, in);
  EXPECT_LE(error(ours.tau_m, exact.tau_m), most);
  EXPECT_LE(error(ours.theta, exact.theta), most);
  EXPECT_LE(error(ours.thetad, exact.thetad), most);
  EXPECT_LE(error(ours.tau_l, exact.tau_l), most);
}

template <class R, class T>
void expect_robot(int count, double most) {
  oracle::RandomChains random(23);
  for (int k = 0; k < count; ++k) {
    SCOPED_TRACE(k);
    const auto p = random_path<R, T>(random);
    const Inputs<R, T> in{};
    expect_rates<R>(p, oracle::of_robot<quad, R>(), in, most);
    expect_motors<R>(p, in, most);
  }
}
template <class T>
void expect_robots(int count, double most) {
  expect_robot<Sprung<robots::Puma560>, T>(count, most);
  expect_robot<Sprung<robots::Panda>, T>(count, most);
  expect_robot<Sprung<robots::Indy7>, T>(count, most);
  expect_robot<Sprung<robots::Scara>, T>(count, most);
  expect_robot<Sprung<robots::ScaraRrpr>, T>(count, most);
  expect_robot<Sprung<robots::TwoArm>, T>(count, most);
  expect_robot<Sprung<robots::Puma560, true>, T>(count, most);
}

template <class... F>
struct Named {
  using Unrolled = Scene<Everything, F...>;
  using Compact = Scene<Everything, F..., Looped>;
};
template <class... F>
struct Elastic {
  using Unrolled = Scene<Sprung<Everything, true>, F..., ElasticJoints>;
  using Compact = Scene<Sprung<Everything, true>, ElasticJoints, F..., Looped>;
};
template <class S>
void expect_rates_of_scene(oracle::RandomChains& random) {
  const auto p = random_path<robot_of<S>, double>(random);
  expect_rates<S>(p, Fill::chain<S, robot_of<S>>(), Fill::inputs<S, double>(p.q), 2e-14);
}
template <class S>
void expect_elastic_scene(oracle::RandomChains& random) {
  const auto p = random_path<robot_of<S>, double>(random);
  expect_motors<S>(p, Fill::inputs<S, double>(p.q), 2e-14);
}

template <class N>
class RateScenes : public testing::Test {};
using Rates = testing::Types<Named<>, Named<Gravity, RotorInertia>, Named<JointSprings, SineCosines>,
                             Named<RuntimeGravity, RotorInertia, JointSprings, TipWrench, ExternalWrenches>>;
TYPED_TEST_SUITE(RateScenes, Rates);
template <class N>
class ElasticScenes : public testing::Test {};
using Elastics = testing::Types<Elastic<>, Elastic<Gravity, RotorInertia>, Elastic<Friction, JointSprings>,
                                Elastic<RuntimeGravity, RotorInertia, Friction, TipWrench, ExternalWrenches>>;
TYPED_TEST_SUITE(ElasticScenes, Elastics);

}  // namespace

TYPED_TEST(RateScenes, AreTheOraclesInEveryForm) {
  oracle::RandomChains random(41);
  for (int k = 0; k < 8; ++k) {
    SCOPED_TRACE(k);
    expect_rates_of_scene<typename TypeParam::Unrolled>(random);
    expect_rates_of_scene<typename TypeParam::Compact>(random);
  }
}
TYPED_TEST(ElasticScenes, AreTheOraclesInEveryForm) {
  oracle::RandomChains random(43);
  for (int k = 0; k < 8; ++k) {
    SCOPED_TRACE(k);
    expect_elastic_scene<typename TypeParam::Unrolled>(random);
    expect_elastic_scene<typename TypeParam::Compact>(random);
  }
}

TEST(ElasticFeedforward, RobotsAreTheOracles) { expect_robots<double>(20, 1e-14); }
TEST(ElasticFeedforward, RobotsInFloat) { expect_robots<float>(40, 2e-6); }

TEST(TorqueRates, RandomChainsAndTreesAreTheOracles) {
  using M = Model<12, Gravity, RotorInertia>;
  property::expect_on_random_models<M>(47, 24, 8, [](auto& random, const M& model, const auto& chain, int n) {
    const auto p = random_path<M, double>(random, n);
    const oracle::RatesInTime exact = exact_rates(p, chain);
    const auto second = torque_rates(model, p.q, p.qd, p.qdd, p.q3, p.q4);
    const auto first = torque_rates(model, p.q, p.qd, p.qdd, p.q3);
    EXPECT_LE(error(second.tau, exact.value), 2e-14);
    EXPECT_LE(error(second.taud, exact.first), 2e-14);
    EXPECT_LE(error(second.taudd, exact.second), 2e-14);
    EXPECT_LE(error(first.taud, exact.first), 2e-14);
    return true;
  });
}

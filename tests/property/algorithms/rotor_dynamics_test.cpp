// Rotors as spinning bodies, against chains in which every rotor is a link of its own: efforts, M(q), accelerations,
// power.
#include <axial/batch.hpp>
#include <cases/to_axial.hpp>
#include <oracle/moving_base.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <property/drives/rotor_axis.hpp>
#include "scene_robot.hpp"

namespace {

using namespace axial;
using oracle::convert;
using oracle::quad;
using oracle::Vector;
using property::joints;

template <class T>
constexpr double effort_tolerance = std::is_same_v<T, double> ? 1e-13 : 5e-6;
template <class T>
constexpr double matrix_tolerance = std::is_same_v<T, double> ? 1e-13 : 2e-6;
template <class T>
constexpr double acceleration_tolerance = std::is_same_v<T, double> ? 1e-10 : 2e-3;

/// A wrist whose motors sit on the forearm, the shoulder and the base, each about an axis of its own.
struct Wrist {
  static constexpr double half = 0.7071067811865476;
  // A line a group of values.
  // clang-format off
  static constexpr auto chain = axial::chain(axial::gravity(0.5, 1.0, -9.5),
      revolute().mass(8).com(0.1, 0.02, 0.05).inertia_com(0.2, 0.25, 0.3, 0.01, 0.0, 0.02)
          .rotor_inertia(5e-4, 20).rotor_axis(1, 2, 3),
      revolute().alpha_deg(-90).a(0.1).mass(5).com(0.2, 0, 0.01).inertia_com(0.1, 0.15, 0.12)
          .rotor_inertia(4e-4, -30).rotor_axis(0, 1, 0, LinkParameters::base),
      revolute().a(0.4).d(0.1).mass(3).com(0.02, 0.1, 0).inertia_com(0.06, 0.05, 0.07, 0.0, 0.004)
          .rotor_inertia(3e-4, 25).rotor_axis(0, 3, 4, 0),
      revolute().alpha_deg(90).d(0.35).mass(1).com(0, 0.01, 0.05).inertia_com(0.01, 0.01, 0.005)
          .rotor_inertia(1e-4, 40).rotor_axis(half, -half, 0),
      revolute().alpha(-1.3).mass(0.5).com(0.01, 0, 0.02).inertia_com(0.002, 0.003, 0.002)
          .rotor_inertia(1e-4, 15).rotor_axis(0.5, 0, 0, 2),
      revolute().alpha_deg(90).branch(0.4, 0.05).mass(0.3).com(0, 0.02, 0.03).inertia_com(0.001, 0.001, 0.0005)
          .rotor_inertia(5e-5, -12));
  // clang-format on
};

/// One joint, whose motor lies on the base.
struct Turntable {
  static constexpr auto chain = axial::chain(
      revolute().mass(2).com(0.1, 0, 0).inertia_com(0.1, 0.1, 0.1).rotor_inertia(1e-4, 50).rotor_axis(1, 1, 0));
};

template <class Robot>
oracle::RotorChain<quad> reference() {
  return {oracle::of_robot<quad, Robot>(), property::rotor_axes<Robot>()};
}

struct Sample {
  Vector<double> q, qd, qdd;
};
Sample sample(oracle::RandomChains& random, int n) {
  return {random.vector(n, 3), random.vector(n, 4), random.vector(n, 20)};
}

template <class T, class Tau>
Vector<T> first(const Tau& tau, int n) {
  return Vector<T>(tau.values, tau.values + n);
}

// Everything that a call answers, of a robot's scene or of a model; `call` holds the algorithms.
template <class T, class R, class Call>
void expect_equal(const oracle::RotorChain<quad>& exact, const Sample& s, const Call& call) {
  const int n = static_cast<int>(s.q.size());
  const auto q = joints<R, T>(s.q), qd = joints<R, T>(s.qd), qdd = joints<R, T>(s.qdd);
  const auto at = convert<quad>(s.q), speed = convert<quad>(s.qd), turn = convert<quad>(s.qdd);
  const Vector<quad> rest(s.q.size(), quad(0));
  const auto tau = call.inverse(q, qd, qdd);
  EXPECT_LE(oracle::relative_error(first<T>(tau, n), exact.efforts(at, speed, turn)), effort_tolerance<T>);
  EXPECT_LE(oracle::relative_error(first<T>(call.bias(q, qd), n), exact.efforts(at, speed, rest)), effort_tolerance<T>);
  EXPECT_LE(oracle::relative_error(first<T>(call.gravity(q), n), exact.efforts(at, rest, rest)), effort_tolerance<T>);
  EXPECT_LE(
      oracle::relative_error(oracle::elements(property::matrix(call.mass(q), n)), oracle::elements(exact.mass(at))),
      matrix_tolerance<T>);
  const auto answer = call.forward(q, qd, tau);
  EXPECT_TRUE(answer.status.ok()) << static_cast<int>(answer.status.code);
  EXPECT_LE(oracle::relative_error(first<T>(answer, n), s.qdd), acceleration_tolerance<T>);
}

template <class S>
struct OfScene {
  template <class J>
  auto inverse(const J& q, const J& qd, const J& qdd) const {
    return inverse_dynamics<S>(q, qd, qdd);
  }
  template <class J>
  auto bias(const J& q, const J& qd) const {
    return bias_torque<S>(q, qd);
  }
  template <class J>
  auto gravity(const J& q) const {
    return gravity_torque<S>(q);
  }
  template <class J>
  auto mass(const J& q) const {
    return mass_matrix<S>(q);
  }
  template <class J>
  auto forward(const J& q, const J& qd, const J& tau) const {
    return forward_dynamics<S>(q, qd, tau);
  }
};
template <class M>
struct OfModel {
  const M& model;
  template <class J>
  auto inverse(const J& q, const J& qd, const J& qdd) const {
    return inverse_dynamics(model, q, qd, qdd);
  }
  template <class J>
  auto bias(const J& q, const J& qd) const {
    return bias_torque(model, q, qd);
  }
  template <class J>
  auto gravity(const J& q) const {
    return gravity_torque(model, q);
  }
  template <class J>
  auto mass(const J& q) const {
    return mass_matrix(model, q);
  }
  template <class J>
  auto forward(const J& q, const J& qd, const J& tau) const {
    return forward_dynamics(model, q, qd, tau);
  }
};

template <class Robot>
class RotorDynamicsOf : public testing::Test {};
using Robots = testing::Types<Wrist, property::Everything, robots::Puma560, robots::Scara>;
TYPED_TEST_SUITE(RotorDynamicsOf, Robots);

}  // namespace

TYPED_TEST(RotorDynamicsOf, EqualsAChainWithTheRotorsAsLinks) {
  using S = Scene<TypeParam, Gravity, RotorInertia, RotorDynamics>;
  using Compact = Scene<TypeParam, Gravity, RotorInertia, RotorDynamics, Looped>;
  using Full = Scene<TypeParam, Gravity, RotorInertia, RotorDynamics, FullParameters>;
  const auto exact = reference<TypeParam>();
  oracle::RandomChains random(31);
  for (int k = 0; k < 25; ++k) {
    SCOPED_TRACE(k);
    const Sample s = sample(random, TypeParam::chain.size);
    expect_equal<double, TypeParam>(exact, s, OfScene<S>{});
    expect_equal<double, TypeParam>(exact, s, OfScene<Compact>{});
    expect_equal<double, TypeParam>(exact, s, OfScene<Full>{});
    expect_equal<float, TypeParam>(exact, s, OfScene<S>{});
  }
}

// Random chains and trees, rotors on the parent's axis or about any axis of any link inboard.
TEST(RotorDynamicsOfModels, EqualsAChainWithTheRotorsAsLinks) {
  using M = Model<8, Gravity, RotorInertia, RotorDynamics>;
  oracle::RandomChains random(32);
  for (int k = 0; k < 120; ++k) {
    SCOPED_TRACE(k);
    const int n = 1 + random.below(8);
    auto chain = k % 2 == 0 ? random.chain(n) : random.branched_tree(n);
    Vector<oracle::RotorAxis<quad>> axes;
    M model;
    for (int i = 0; i < n; ++i) {
      auto& link = chain.links[std::size_t(i)];
      link.rotor_inertia = random.uniform(1e-4, 2e-3),
      link.gear = random.uniform(5, 50) * (random.below(2) == 0 ? 1 : -1);
      auto p = cases::to_axial(link);
      if (random.below(3) > 0) {
        p.rotor_carrier = link.parent;
        while (p.rotor_carrier >= 0 && random.below(3) == 0)
          p.rotor_carrier = chain[p.rotor_carrier].parent;
        for (double& x : p.rotor_axis)
          x = random.uniform(-2, 2);
      }
      axes.push_back(property::rotor_axis(p, link.parent));
      ASSERT_TRUE(model.add(p));
    }
    model.set_gravity(chain.gravity.x, chain.gravity.y, chain.gravity.z);
    const oracle::RotorChain<quad> exact(convert<quad>(chain), axes);
    expect_equal<double, M>(exact, sample(random, n), OfModel<M>{model});
  }
}

TEST(RotorDynamicsOfModels, ACarrierThatIsNotInboardIsRefused) {
  Model<4, Gravity, RotorInertia, RotorDynamics> model;
  const auto link = revolute().mass(1).inertia_com(0.1, 0.1, 0.1).rotor_inertia(1e-4, 50);
  ASSERT_TRUE(model.add(link));
  ASSERT_TRUE(model.add(link.parent(LinkParameters::base)));
  EXPECT_FALSE(model.add(link.parent(1).rotor_axis(0, 0, 1, 0))) << "on another branch";
  EXPECT_FALSE(model.add(link.parent(1).rotor_axis(0, 0, 1, 2))) << "on the link that it drives";
  EXPECT_TRUE(model.add(link.parent(1).rotor_axis(0, 0, 1, LinkParameters::base)));
}

// d(kinetic energy)/dt = qd . tau, the energy being 1/2 qd . M qd along any motion.
TEST(RotorDynamicsOfARobot, PowerIsWhatTheKineticEnergyGains) {
  using S = Scene<Wrist, RotorInertia, RotorDynamics>;
  oracle::RandomChains random(33);
  for (int k = 0; k < 50; ++k) {
    const Sample s = sample(random, 6);
    const auto energy = [&](double t) {
      Joints<Wrist, double> q{}, qd{};
      for (int i = 0; i < 6; ++i) {
        const auto j = std::size_t(i);
        q[i] = s.q[j] + t * (s.qd[j] + 0.5 * t * s.qdd[j]), qd[i] = s.qd[j] + t * s.qdd[j];
      }
      const auto m = mass_matrix<S>(q);
      double sum = 0.0;
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
          sum += 0.5 * qd[i] * m(i, j) * qd[j];
      return sum;
    };
    const auto tau =
        inverse_dynamics<S>(joints<Wrist, double>(s.q), joints<Wrist, double>(s.qd), joints<Wrist, double>(s.qdd));
    double power = 0.0, scale = 0.0;
    for (int i = 0; i < 6; ++i)
      power += s.qd[std::size_t(i)] * tau[i], scale += std::fabs(s.qd[std::size_t(i)] * tau[i]);
    const double h = 1e-4;  // a difference of fourth order
    const double gained = (8.0 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12.0 * h);
    EXPECT_NEAR(gained, power, 1e-8 * scale);
  }
}

TEST(RotorDynamicsOfARobot, ABaseThatMovesTurnsItsRotorsToo) {
  using S = Scene<Wrist, RuntimeGravity, BaseMotion, RotorInertia, RotorDynamics>;
  using Compact = Scene<Wrist, RuntimeGravity, BaseMotion, RotorInertia, RotorDynamics, Looped>;
  const auto exact = reference<Wrist>();
  oracle::RandomChains random(34);
  for (int k = 0; k < 20; ++k) {
    const Sample s = sample(random, 6);
    const auto q = joints<Wrist, double>(s.q), qd = joints<Wrist, double>(s.qd), qdd = joints<Wrist, double>(s.qdd);
    auto bodies = exact.bodies();
    bodies.gravity = {quad(-3), quad(2.5), quad(8)};
    const auto wanted = exact.drives(
        oracle::inverse_dynamics_on_moving_base(bodies, property::Fill::base_motion<S>(), exact.all(convert<quad>(s.q)),
                                                exact.all(convert<quad>(s.qd)), exact.all(convert<quad>(s.qdd)), {}));
    const auto tau = inverse_dynamics<S>(q, qd, qdd, property::Fill::inputs<S, double>(q));
    EXPECT_LE(oracle::relative_error(property::vector(tau), wanted), 1e-13);
    const auto looped = inverse_dynamics<Compact>(q, qd, qdd, property::Fill::inputs<Compact, double>(q));
    EXPECT_LE(oracle::relative_error(property::vector(looped), wanted), 1e-13);
  }
}

// A rotor on the base about an axis that the base's rest keeps: nothing but gear^2 J.
TEST(RotorDynamicsOfARobot, ARotorOnABaseAtRestIsItsInertiaAlone) {
  const Joints<Turntable, double> q{0.3}, qd{5.0}, qdd{7.0};
  using S = Scene<Turntable, RotorInertia, RotorDynamics>;
  EXPECT_EQ(inverse_dynamics<S>(q, qd, qdd)[0], (inverse_dynamics<Scene<Turntable, RotorInertia>>(q, qd, qdd)[0]));
}

TEST(RotorDynamicsOfARobot, EffortsAlongADirectionAreItsDerivatives) {
  using S = Scene<Wrist, Gravity, RotorInertia, RotorDynamics>;
  using Compact = Scene<Wrist, Gravity, RotorInertia, RotorDynamics, Looped>;
  oracle::RandomChains random(35);
  for (int k = 0; k < 20; ++k) {
    const Sample s = sample(random, 6), by = sample(random, 6);
    const auto at = [&](double t) {
      Joints<Wrist, double> x[3] = {};
      for (int i = 0; i < 6; ++i) {
        const auto j = std::size_t(i);
        x[0][i] = s.q[j] + t * by.q[j], x[1][i] = s.qd[j] + t * by.qd[j], x[2][i] = s.qdd[j] + t * by.qdd[j];
      }
      return inverse_dynamics<S>(x[0], x[1], x[2]);
    };
    const MotionDirection<Wrist, double> direction{joints<Wrist, double>(by.q), joints<Wrist, double>(by.qd),
                                                   joints<Wrist, double>(by.qdd)};
    const auto q = joints<Wrist, double>(s.q), qd = joints<Wrist, double>(s.qd), qdd = joints<Wrist, double>(s.qdd);
    const auto found = inverse_dynamics_along<S>(q, qd, qdd, direction);
    const auto looped = inverse_dynamics_along<Compact>(q, qd, qdd, direction);
    const double h = 1e-4;
    const auto a = at(h), b = at(-h), c = at(2 * h), d = at(-2 * h);
    Vector<double> slope;
    for (int i = 0; i < 6; ++i)
      slope.push_back((8.0 * (a[i] - b[i]) - (c[i] - d[i])) / (12.0 * h));
    EXPECT_LE(oracle::relative_error(property::vector(found.dtau), slope), 1e-8);
    EXPECT_LE(oracle::relative_error(property::vector(looped.dtau), slope), 1e-8);
  }
}

TEST(RotorDynamicsOfARobot, ABatchAnswersAsItsStates) {
  using S = Scene<Wrist, Gravity, RotorInertia, RotorDynamics>;
  using Compact = Scene<Wrist, Gravity, RotorInertia, RotorDynamics, Looped>;
  using Lanes = Batch<double, 4>;
  oracle::RandomChains random(36);
  const Sample s = sample(random, 6);
  const auto q = joints<Wrist, double>(s.q), qd = joints<Wrist, double>(s.qd), qdd = joints<Wrist, double>(s.qdd);
  Joints<Wrist, Lanes> at{}, speed{}, acceleration{};
  for (int i = 0; i < 6; ++i)
    at[i] = Lanes(q[i]), speed[i] = Lanes(qd[i]), acceleration[i] = Lanes(qdd[i]);
  const auto tau = inverse_dynamics<S>(q, qd, qdd);
  const auto unrolled = inverse_dynamics<S>(at, speed, acceleration);
  const auto looped = inverse_dynamics<Compact>(at, speed, acceleration);
  const auto back = forward_dynamics<S>(at, speed, unrolled);
  Vector<double> found, compact, undone;
  for (int i = 0; i < 6; ++i)
    found.push_back(unrolled[i][1]), compact.push_back(looped[i][3]), undone.push_back(back[i][2]);
  EXPECT_LE(oracle::relative_error(found, property::vector(tau)), 1e-14);
  EXPECT_LE(oracle::relative_error(compact, property::vector(tau)), 1e-14);
  EXPECT_LE(oracle::relative_error(undone, s.qdd), 1e-10);
}

TEST(RotorDynamicsOfARobot, TheEffortOfOneJointIsThatOfAll) {
  using S = Scene<Wrist, Gravity, RotorInertia, RotorDynamics>;
  using Compact = Scene<Wrist, Gravity, RotorInertia, RotorDynamics, Looped>;
  oracle::RandomChains random(37);
  const Sample s = sample(random, 6);
  const auto q = joints<Wrist, double>(s.q), qd = joints<Wrist, double>(s.qd), qdd = joints<Wrist, double>(s.qdd);
  const auto tau = inverse_dynamics<S>(q, qd, qdd);
  const double scale = oracle::largest(property::vector(tau));
  EXPECT_NEAR((joint_torque<S, 0>(q, qd, qdd)), tau[0], 1e-14 * scale);
  EXPECT_NEAR((joint_torque<S, 2>(q, qd, qdd)), tau[2], 1e-14 * scale);
  EXPECT_NEAR((joint_torque<S, 5>(q, qd, qdd)), tau[5], 1e-14 * scale);
  EXPECT_NEAR((joint_torque<Compact, 0>(q, qd, qdd)), tau[0], 1e-14 * scale);
  EXPECT_NEAR((joint_torque<Compact, 3>(q, qd, qdd)), tau[3], 1e-14 * scale);
  EXPECT_NEAR((gravity_torque<S, 1>(q)), gravity_torque<S>(q)[1], 1e-14 * scale);
}

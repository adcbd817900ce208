// Ten seconds of free motion: momentum and energy stay what they were. Both are taken from the oracle's Jacobians.
#include <oracle/floating_base.hpp>
#include <oracle/submerged.hpp>
#include <robots/puma560.hpp>

#include <property/support.hpp>
#include "free_motion.hpp"

namespace {

using namespace axial;

/// Two unequal links on a body that they can turn: the joints' axes cross at a right angle.
struct TwoLinks {
  static constexpr auto chain =
      axial::chain(base_body().mass(8.0).com(0.05, -0.02, 0.1).inertia_com(0.5, 0.75, 0.625, 0.05, -0.03, 0.02),
                   revolute().a(0.2).d(0.1).mass(3.0).com(0.25, 0.01, 0.02).inertia_com(0.02, 0.0625, 0.05),
                   revolute().a(0.5).alpha_deg(90).mass(1.5).com(0.2, 0.0, -0.03).inertia_com(0.01, 0.03, 0.025));
};
/// The Puma's links on a body of the weight of its own base.
struct FreePuma {
  static constexpr auto chain = [] {
    auto chain = robots::Puma560::chain;
    chain.base_body =
        base_body().mass(30.0).com(0.02, 0.01, -0.3).inertia_com(1.2, 1.4, 0.9, 0.1, 0.05, -0.02).parameters();
    chain.has_base_body = true;
    return chain;
  }();
};

/// The same arm and body in water that they do not displace: unequal added masses, no drag.
struct Vessel {
  static constexpr auto chain = [] {
    auto chain = TwoLinks::chain;
    chain.base_body.water =
        revolute().added_mass(1.5, 9.0, 12.0, 0.1, 0.9, 0.7).buoyancy(0, 0.1, 0.02, -0.05).parameters().water;
    for (auto& link : chain.links)
      link.water =
          revolute().added_mass(0.25, 2.5, 1.75, 0.01, 0.06, 0.05).buoyancy(0, 0.2, 0.01, 0).parameters().water;
    return chain;
  }();
};

template <class R>
oracle::Chain<double> chain_of(bool rotors, const oracle::Vec3<double>& gravity) {
  auto chain = oracle::of_robot<double, R>();
  if (!rotors) chain = oracle::without_rotors(chain);
  chain.gravity = gravity;
  return chain;
}

/// Mechanical energy and momentum of a state, in the world: from the oracle, not from the library.
template <class S>
struct Invariants {
  using R = robot_of<S>;
  static constexpr bool rotors = S::template has<RotorInertia>;

  static oracle::Vector<oracle::Water<double>> waters() {
    oracle::Vector<oracle::Water<double>> all(6);
    all[5] = oracle::water_from_axial<double>(R::chain.base_body.water);
    for (const auto& link : R::chain.links)
      all.push_back(oracle::water_from_axial<double>(link.water));
    return all;
  }
  static property::Totals of(const property::FlightState<R>& x, const oracle::Vec3<double>& gravity, double time) {
    const auto R_wb = property::rotation(x);
    const oracle::FloatingChain<double> floating(chain_of<R>(rotors, oracle::transpose(R_wb) * gravity),
                                                 oracle::link_from_axial<double>(R::chain.base_body, -1));
    const oracle::BaseTwist<double> velocity{x.angular_velocity, oracle::transpose(R_wb) * x.velocity};
    const auto q = floating.positions(property::vector(x.q));
    const auto qd = floating.rates(velocity, property::vector(x.qd));
    auto momentum = oracle::mass_matrix(floating.whole(), q) * qd;
    double water_energy = 0.0;
    if constexpr (S::template has<Underwater>) {
      const oracle::SubmergedChain<double> wet(floating.whole(), waters());
      const auto impulse = wet.added_mass(q) * qd;
      for (std::size_t i = 0; i < momentum.size(); ++i)
        momentum[i] += impulse[i];
      water_energy = wet.kinetic_energy(q, qd);
    }
    const auto at_base = floating.wrench(momentum);
    double mass = R::chain.base_body.mass;
    for (const auto& link : R::chain.links)
      mass += link.mass;
    property::Totals totals;
    // The height is that of frame 0 and, above it, of the centre of mass.
    totals.energy = water_energy + oracle::kinetic_energy(floating.whole(), q, qd) +
                    oracle::potential_energy(floating.whole(), q) - mass * oracle::dot(gravity, x.position);
    totals.linear = R_wb * at_base.linear - (mass * time) * gravity;
    totals.angular = R_wb * at_base.angular + oracle::cross(x.position, R_wb * at_base.linear);
    return totals;
  }
};

template <class S>
property::FlightState<robot_of<S>> thrown() {
  property::FlightState<robot_of<S>> x;
  x.velocity = {0.5, -0.25, 1.0};
  x.angular_velocity = {0.4, -0.7, 0.55};
  for (int i = 0; i < joint_count<S>; ++i) {
    x.q[i] = 0.3 - 0.4 * i;
    x.qd[i] = i % 2 == 0 ? 1.2 : -0.9;
  }
  return x;
}

constexpr double kept = 1e-9, seconds = 10.0;

template <class S>
void expect_conserved(const oracle::Vec3<double>& gravity, double step) {
  auto x = thrown<S>();
  const auto start = Invariants<S>::of(x, gravity, 0.0);
  const int steps = static_cast<int>(seconds / step + 0.5);
  double energy = 0.0, linear = 0.0, angular = 0.0, moved = 0.0;
  const double turned_before = x.q[1];
  for (int k = 1; k <= steps; ++k) {
    x = property::rk4<S>(x, gravity, step);
    if (k % (steps / 50) != 0) continue;
    const auto now = Invariants<S>::of(x, gravity, k * step);
    energy = std::fmax(energy, std::fabs(now.energy - start.energy) / start.energy);
    linear = std::fmax(linear, property::distance(now.linear, start.linear));
    moved = std::fmax(moved, std::fabs(x.q[1] - turned_before));
    angular = std::fmax(angular, property::distance(now.angular, start.angular));
  }
  std::printf("energy %.1e, momentum %.1e", energy, linear);
  EXPECT_LE(energy, kept);
  EXPECT_LE(linear, kept);
  if (gravity.z == 0.0) {  // else gravity has a moment about the world's origin
    std::printf(", angular momentum %.1e", angular);
    EXPECT_LE(angular, kept);
  }
  std::printf(" of their start\n");
  EXPECT_GT(moved, 0.5) << "nothing moved, so nothing was tested";
}

}  // namespace

TEST(FreeMotion, OfTwoLinksOnABodyConservesMomentumAndEnergy) {
  expect_conserved<Scene<TwoLinks, FloatingBase>>({}, 5e-4);
}
TEST(FreeMotion, OfAPumaOnABodyConservesMomentumAndEnergy) {
  expect_conserved<Scene<FreePuma, FloatingBase, RotorInertia>>({}, 5e-4);
}
TEST(FreeMotion, InFreeFallConservesEnergyAndGainsTheWeightsImpulse) {
  expect_conserved<Scene<TwoLinks, FloatingBase, RuntimeGravity, Looped>>({0.0, 0.0, -9.81}, 5e-4);
}
// Kirchhoff: the impulse of body, arm and water together is what is conserved, not the momentum of the bodies.
TEST(FreeMotion, UnderwaterConservesImpulseAndEnergy) {
  expect_conserved<Scene<Vessel, FloatingBase, Underwater, VelocityThroughWater>>({}, 5e-4);
}

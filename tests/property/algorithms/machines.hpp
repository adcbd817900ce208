// A machine of robots/gallery: inverse dynamics, the mass matrix and forward dynamics in float and double against
// Lagrange's equations in 113 bits, and inverse dynamics in 32 bits against its certified error.
#pragma once

#include <axial/fixed.hpp>
#include <host_sim/figures/exhaustive/fixed_search.hpp>
#include <robots/gallery/gallery.hpp>

#include <property/drives/constrained.hpp>
#include <property/drives/driven_states.hpp>
#include <property/fixed/fixed_robots.hpp>

namespace constrained {

/// Both fingers turn by their knuckles' angle, the tips back by it.
template <>
inline Couplings by_hand<robots::Robotiq2f85>() {
  return couplings(6, {0}, {{1}, {-1}, {-1}, {1}, {1}, {-1}});
}
/// Two parallelograms: rods stand as the upper arm does, or as the forearm.
template <>
inline Couplings by_hand<robots::Mg400>() {
  return couplings(9, {0, 1, 2, 5},
                   {{1, 0, 0, 0},
                    {0, 1, 0, 0},
                    {0, 0, 1, 0},
                    {0, -1, 0, 0},
                    {0, 0, -1, 0},
                    {0, 0, 0, 1},
                    {0, 1, 0, 0},
                    {0, -1, 0, 0},
                    {0, 0, 1, 0}});
}

}  // namespace constrained

namespace property {

template <class Robot>
inline constexpr bool shares_drives = axial::joint_count<Robot> != axial::link_count<Robot>;

/// Lagrange's equations of a machine, by values of its drives.
template <class Robot, bool = shares_drives<Robot>>
struct Lagrange {
  using Values = oracle::Vector<oracle::quad>;
  oracle::Chain<oracle::quad> chain = oracle::of_robot<oracle::quad, Robot>();
  Values inverse(const Values& q, const Values& qd, const Values& qdd) const {
    return oracle::inverse_dynamics(chain, q, qd, qdd);
  }
  oracle::Matrix<oracle::quad> mass(const Values& q) const { return oracle::mass_matrix(chain, q); }
};
template <class Robot>
struct Lagrange<Robot, true> : constrained::Constrained {
  Lagrange() : Constrained(Constrained::of<Robot>()) {}
};

template <class Robot>
class AgainstLagrange {
  using quad = oracle::quad;
  using Values = oracle::Vector<quad>;
  /// The robot whose joints are the drives.
  using Drives = typename axial::scene_of<Robot>::Robot;
  static constexpr int n = axial::joint_count<Robot>;

 public:
  AgainstLagrange() {
    oracle::RandomChains random(41);
    for (int k = 0; k < 50; ++k) {
      State s;
      for (int i = 0; i < n; ++i) {
        const auto& l = Drives::chain.links[i];
        s.q.push_back(random.uniform(l.position_min, l.position_max));
        s.qd.push_back(random.uniform(-l.speed_limit, l.speed_limit));
        s.qdd.push_back(random.uniform(-l.acceleration_limit, l.acceleration_limit));
      }
      states_.push_back(s);
      torques_.push_back(
          lagrange_.inverse(oracle::convert<quad>(s.q), oracle::convert<quad>(s.qd), oracle::convert<quad>(s.qdd)));
      masses_.push_back(oracle::elements(lagrange_.mass(oracle::convert<quad>(s.q))));
    }
  }

  /// Ten times what any of the machines had at most; solving loses what the condition of M takes.
  template <class T>
  void expect(double torque, double solved) const {
    Error of_torques, of_masses, of_accelerations;
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const auto& s = states_[k];
      const auto q = joints<Robot, T>(s.q), qd = joints<Robot, T>(s.qd);
      const auto tau = axial::inverse_dynamics<Robot>(q, qd, joints<Robot, T>(s.qdd));
      of_torques.see(vector(tau), torques_[k]);
      of_masses.see(oracle::elements(matrix(axial::mass_matrix<Robot>(q))), masses_[k]);
      const auto answer = axial::forward_dynamics<Robot>(q, qd, joints<Robot, T>(oracle::convert<double>(torques_[k])));
      EXPECT_TRUE(answer.status.ok());
      of_accelerations.see(oracle::Vector<T>(answer.values, answer.values + n), oracle::convert<quad>(s.qdd));
    }
    std::printf("%s: of the largest %.1e of torques, %.1e of masses, %.1e of accelerations\n", Robot::name,
                of_torques.share(), of_masses.share(), of_accelerations.share());
    EXPECT_LE(of_torques.share(), torque);
    EXPECT_LE(of_masses.share(), torque);
    EXPECT_LE(of_accelerations.share(), solved);
  }

 private:
  /// The largest error of values of all states over the largest of them.
  struct Error {
    double error = 0.0, largest = 0.0;
    template <class T>
    void see(const oracle::Vector<T>& got, const Values& exact) {
      for (std::size_t i = 0; i < exact.size(); ++i) {
        error = std::fmax(error, static_cast<double>(oracle::abs(quad(got[i]) - exact[i])));
        largest = std::fmax(largest, static_cast<double>(oracle::abs(exact[i])));
      }
    }
    double share() const { return largest > 0.0 ? error / largest : HUGE_VAL; }
  };

  Lagrange<Robot> lagrange_;
  std::vector<State> states_;
  std::vector<Values> torques_, masses_;
};

/// Of each effort the largest error over the one that is certified, in so many states inside the limits.
template <class Robot>
std::array<double, axial::joint_count<Robot>> shares_of_certified_errors(int states) {
  using State = exhaustive::FixedState<Robot, axial::Fixed32>;
  constexpr int n = axial::joint_count<Robot>;
  constexpr auto bound = axial::error_bound<Robot, axial::Fixed32>(axial::algorithm::inverse_dynamics);
  exhaustive::Random random(7);
  std::array<double, n> share{};
  for (int k = 0; k < states; ++k) {
    auto state = exhaustive::next_state<State>(random, 0);
    axial::Joints<Robot, double> q{}, qd{}, qdd{};
    if constexpr (shares_drives<Robot>) hold_joints<Robot>(state, true);
    for (int i = 0; i < n; ++i)
      q[i] = real(state.q, i), qd[i] = real(state.qd, i), qdd[i] = real(state.qdd, i);
    if constexpr (!shares_drives<Robot>) q = exhaustive::in_double<Robot, axial::Fixed32>(state.q);  // shares of a turn
    const auto exact = axial::inverse_dynamics<Robot>(q, qd, qdd);
    const auto got = axial::inverse_dynamics<Robot>(state.q, state.qd, state.qdd);
    for (int i = 0; i < n; ++i) {
      auto& worst = share[static_cast<std::size_t>(i)];
      worst = std::fmax(worst, std::fabs(real(got, i) - exact[i]) / bound[i]);
    }
  }
  return share;
}

template <class Robot>
class Machine : public testing::Test {};
TYPED_TEST_SUITE_P(Machine);
TYPED_TEST_P(Machine, MovesAsByLagrange) {
  const AgainstLagrange<TypeParam> machine;
  machine.template expect<float>(2e-6, 7e-4);
  machine.template expect<double>(5e-15, 1.5e-12);
}
TYPED_TEST_P(Machine, StaysInsideItsCertifiedErrorsInFixedPoint) {
  for (const double share : shares_of_certified_errors<TypeParam>(2000)) {
    EXPECT_LE(share, 1.0);
    EXPECT_GT(share, 0.001) << "a bound as loose as this certifies little";
  }
}
REGISTER_TYPED_TEST_SUITE_P(Machine, MovesAsByLagrange, StaysInsideItsCertifiedErrorsInFixedPoint);

}  // namespace property

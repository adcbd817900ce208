// Separated terms of joints that share drives in fixed point, and the torques that are made of them: nothing overflows
// and no certified error is exceeded, at corners of both kinds of limits and where searches climb; against Lagrange's
// equations of all joints with a multiplier each in 113 bits.
#include <gtest/gtest.h>
#include <robots/robots.hpp>

#include "constrained.hpp"
#include "driven_robots.hpp"
#include "driven_states.hpp"

namespace {

using namespace axial;
using constrained::quad;
using constrained::Vector;
using property::real;

double value(int raw, int exponent) { return raw * detail::power_of_two(-exponent); }

template <class R, class T, class... Features>
class DrivenSeparation {
 public:
  using Checked = Scene<R, Gravity, RotorInertia, Friction, RangeCheck, Features...>;
  using Exact = Scene<R, Gravity, RotorInertia, Friction>;
  using Format = SeparatedExponents<Checked, T>;
  using State = exhaustive::FixedState<Checked, T>;
  using Values = Joints<R, double>;
  static constexpr int drives = joint_count<R>;
  static constexpr auto bound = error_bound<Checked, T>(algorithm::separation);
  static constexpr auto torque_bound = error_bound<Checked, T>(algorithm::separated_torque);

  enum Part { A, B, C, G, efforts, parts };
  static constexpr const char* names[parts] = {"A", "B", "C", "G", "torque"};
  double nearest[parts] = {}, share[parts] = {};
  std::uint64_t overflows = 0;

  /// One state against double.
  void see(State state) {
    property::hold_joints<R>(state);
    Values u{}, ud{}, udd{};
    for (int k = 0; k < drives; ++k)
      u[k] = real(state.q, k), ud[k] = real(state.qd, k), udd[k] = real(state.qdd, k);
    const std::uint64_t before = range_overflows;
    const auto got = separate<Checked>(state.q);
    const auto tau = torque(got, state.qd, state.qdd);
    overflows += range_overflows - before;
    for (double& own : share)
      own = 0.0;
    compare(got, separate<Exact>(u));
    const auto exact = inverse_dynamics<Exact>(u, ud, udd);
    for (int k = 0; k < drives; ++k)
      see(efforts, real(tau, k) - exact[k], torque_bound[k], std::fabs(exact[k]));
  }
  /// Words of terms against exact ones.
  template <class Terms>
  void compare(const Separated<Checked, T>& got, const Terms& exact) {
    for (int d = 0; d < drives; ++d) {
      see(G, value(got.G[d].raw, Format::rest(d)) - exact.G[d], bound.G[d], 1.0);
      for (int k = 0; k < drives; ++k) {
        see(A, value(got.A[d][k].raw, Format::inertia(d, k)) - exact.A[d][k], bound.A[d][k], 1.0);
        see(C, value(got.C[d][k].raw, Format::square(d, k)) - exact.C[d][k], bound.C[d][k], 1.0);
        for (int l = k + 1; l < drives; ++l) {
          const int pair = got.pair(k, l);
          see(B, value(got.B[d][pair].raw, Format::product(d, k, l)) - exact.B[d][pair], bound.B[d][pair], 1.0);
        }
      }
    }
  }

 private:
  void see(Part part, double off, double most, double size) {
    const double own = most > 0.0 ? std::fabs(off) / most : std::fabs(off) > 1e-12 * size ? HUGE_VAL : 0.0;
    share[part] = std::fmax(share[part], own), nearest[part] = std::fmax(nearest[part], own);
  }
};

template <class R, class T, class... Features>
void expect_inside() {
  DrivenSeparation<R, T, Features...> robot;
  using State = typename DrivenSeparation<R, T, Features...>::State;
  property::search_bounds<State>(R::name, robot, property::states_asked(4000), 7, 30);
  EXPECT_GT(robot.nearest[robot.efforts], 0.02) << R::name << ": a bound as loose as this says little";
  EXPECT_GT(robot.nearest[robot.A], 0.02) << R::name;
}

/// Terms as differences of the multipliers' efforts at unit rates: exact, for efforts are quadratic in them.
template <class R>
Separated<R, double> of_multipliers(const constrained::Constrained& exact, const Vector<quad>& u) {
  constexpr int n = joint_count<R>;
  const Vector<quad> rest(std::size_t(n), quad(0));
  const auto at = [&](int k, int l) {
    auto rates = rest;
    if (k >= 0) rates[std::size_t(k)] += 1;
    if (l >= 0) rates[std::size_t(l)] += 1;
    return exact.inverse(u, rates, rest);
  };
  const auto held = at(-1, -1);
  const auto M = exact.mass(u);
  Separated<R, double> terms{};
  for (int k = 0; k < n; ++k) {
    const auto one = at(k, -1);
    for (int d = 0; d < n; ++d) {
      const auto i = std::size_t(d);
      terms.G[d] = double(held[i]), terms.A[d][k] = double(M(d, k)), terms.C[d][k] = double(one[i] - held[i]);
    }
    for (int l = k + 1; l < n; ++l) {
      const auto both = at(k, l), other = at(l, -1);
      for (int d = 0; d < n; ++d) {
        const auto i = std::size_t(d);
        terms.B[d][terms.pair(k, l)] = double(both[i] - one[i] - other[i] + held[i]);
      }
    }
  }
  return terms;
}
template <class R>
[[maybe_unused]] void expect_multipliers(const constrained::Constrained& exact, unsigned seed) {
  DrivenSeparation<R, Fixed32> robot;
  using Checked = typename DrivenSeparation<R, Fixed32>::Checked;
  using State = typename DrivenSeparation<R, Fixed32>::State;
  exhaustive::Random random(seed);
  for (int k = 0; k < 24; ++k) {
    auto state = exhaustive::next_state<State>(random, static_cast<std::uint64_t>(k % 4));
    property::hold_joints<R>(state);
    Vector<quad> u;
    for (int i = 0; i < joint_count<R>; ++i)
      u.push_back(real(state.q, i));
    robot.compare(separate<Checked>(state.q), of_multipliers<R>(exact, u));
  }
  for (int part = 0; part < robot.efforts; ++part)
    EXPECT_LE(robot.nearest[part], 1.0) << R::name << " " << robot.names[part];
  EXPECT_GT(robot.nearest[robot.A], 0.01) << R::name;
}
/// G of numbers alone, as its robot says it.
template <int Number>
[[maybe_unused]] constrained::Couplings drawn_couplings() {
  using R = property::Coupled<Number>;
  std::vector<std::vector<double>> rows;
  std::vector<int> owner;
  for (int i = 0; i < R::n; ++i) {
    std::vector<double> row(std::size_t(R::n), 0.0);
    for (int k = 0; k < i; ++k)
      if (R::number(50 * i + 20 + k) > -0.3) row[std::size_t(k)] = 1.5 * R::number(50 * i + 30 + k);
    row[std::size_t(i)] = R::number(50 * i + 40) > 0.0 ? 0.7 : -1.3;
    rows.push_back(row), owner.push_back(i);
  }
  return constrained::couplings(R::n, owner, rows);
}

}  // namespace

TEST(SeparatedTermsOfDrives, StayInsideTheirBounds) {
  expect_inside<robots::Palletiser, Fixed32>();
  expect_inside<robots::Gripper, Fixed32>();
#ifndef AXIAL_FEW_ROBOTS
  expect_inside<robots::WristArm, Fixed32>();
  expect_inside<robots::ScaraQuill, Fixed32>();
#endif
}
#ifndef AXIAL_FEW_ROBOTS
TEST(SeparatedTermsOfDrives, StayInsideThemWithRandomCouplingsAndOtherRounding) {
  expect_inside<property::Followers, Fixed32>();
  expect_inside<property::Followers, Fixed32, HighWord>();
  expect_inside<property::Coupled<0>, Fixed32, RoundDown>();
  expect_inside<property::Coupled<1>, Fixed32>();
  expect_inside<property::Coupled<2>, Fixed32>();
  expect_inside<robots::Gripper, Fixed16>();
}
TEST(SeparatedTermsOfDrives, AreConstraintsWithMultipliers) {
  using constrained::Constrained;
  expect_multipliers<robots::WristArm>(Constrained::of<robots::WristArm>(), 1);
  expect_multipliers<robots::ScaraQuill>(Constrained::of<robots::ScaraQuill>(), 2);
  expect_multipliers<robots::Palletiser>(Constrained::of<robots::Palletiser>(), 3);
  expect_multipliers<robots::Gripper>(Constrained::of<robots::Gripper>(), 4);
  expect_multipliers<property::Coupled<1>>(Constrained::of<property::Coupled<1>>(drawn_couplings<1>()), 5);
}
// Each term alone is the same word; a slide that a drive takes beyond its limits has a status.
TEST(SeparatedTermsOfDrives, StandAloneAndNameLimits) {
  using R = robots::ScaraQuill;
  using T = Fixed32;
  const auto at = to_fixed<Positions<R, T>>(Joints<R, double>{0.4, -0.7, 20.0, 1.5}).values;
  const auto all = separate<R>(at);
  EXPECT_TRUE(all.status.ok());
  const auto a = separate_A<R>(at);
  const auto b = separate_B<R>(at);
  const auto c = separate_C<R>(at);
  const auto g = separate_G<R>(at);
  for (int d = 0; d < joint_count<R>; ++d) {
    EXPECT_EQ(all.G[d].raw, g.G[d].raw);
    for (int k = 0; k < joint_count<R>; ++k) {
      EXPECT_EQ(all.A[d][k].raw, a.A[d][k].raw);
      EXPECT_EQ(all.C[d][k].raw, c.C[d][k].raw);
    }
    for (int pair = 0; pair < all.pairs; ++pair)
      EXPECT_EQ(all.B[d][pair].raw, b.B[d][pair].raw);
  }
  EXPECT_NE(all.B[0][all.pair(0, 1)].raw, 0);
  const auto beyond = to_fixed<Positions<R, T>>(Joints<R, double>{0, 0, 69.0, 0.0}).values;  // 0.2196 m of 0.2
  EXPECT_EQ(separate<R>(beyond).status.code, Status::Code::position_limit);
  EXPECT_EQ(separate<R>(beyond).status.joint, 2);
}
#endif

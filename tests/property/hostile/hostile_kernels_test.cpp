// Any words given to the kernels of fixed point that have no status, and to what control makes of them: nothing is
// undefined, and what is inside the limits, or answered with ok, is right.
#include <axial/closed_form/scara.hpp>
#include <axial/fixed.hpp>

#include <property/fixed/fixed_robots.hpp>
#include "hostile_fixed.hpp"

namespace {

using namespace axial;
using property::Fixed;
using property::HostileState;
using property::Wrong;
constexpr std::uint64_t tests = 24;

template <class R>
class HostileKernels : public testing::Test {
 protected:
  using S = Fixed<R>;
  template <class Check>
  void run(std::uint64_t few, const Check& check) {
    exhaustive::Random random(property::hostile_seed);
    const std::uint64_t states = property::hostile_states(few, tests);
    for (std::uint64_t k = 0; k < states; ++k) {
      const auto state = property::hostile_state<HostileState<S>>(random, k);
      check(state, property::Expected<S>(state), k);
    }
    EXPECT_EQ(wrong.count, 0U) << wrong.first;
  }
  Wrong wrong;
};
#ifdef AXIAL_FEW_ROBOTS
using Robots = testing::Types<property::SlidingTree, robots::Scara>;
#else
using Robots = testing::Types<property::SlidingTree, robots::Scara, robots::Puma560, robots::Panda>;
#endif
TYPED_TEST_SUITE(HostileKernels, Robots, property::RobotName);

struct Tuning {
  static constexpr double period = 1e-3, gain = 50.0;
  static constexpr double fraction = 0.1, uncertainty = 0.5, release = 0.5;
  static constexpr int confirm = 3, calm = 5;
  static constexpr double deviation = 0.01, memory = 0.512, mass_deviation = 0.02, moment_deviation = 0.01;
};

/// A residual of the observer as a number, and the largest that its format holds.
template <class S>
double residual_of(const Residuals<S, Fixed32, Tuning>& residual, int i) {
  return residual[i].raw * detail::power_of_two(-residual.exponent(i));
}

}  // namespace

TYPED_TEST(HostileKernels, MassMatrixPosesAndJacobianAreRightInsideTheLimits) {
  using R = TypeParam;
  using S = Fixed<R>;
  constexpr auto row_bound = error_bound<S>(algorithm::mass_matrix);
  constexpr auto length_bound = error_bound<S>(algorithm::forward_kinematics);
  constexpr double metre = detail::power_of_two(-length_exponent<S, Fixed32>), direction = 0x1p-30;
  this->run(4000, [&](const auto& state, const auto& expected, std::uint64_t k) {
    const auto m = mass_matrix<S>(state.q);
    const auto poses = forward_kinematics<S>(state.q);
    const auto columns = jacobian<S>(state.q);
    if (expected.may_wrap || expected.doubtful) return;
    const auto q = exhaustive::in_double<R>(state.q);
    const auto exact_m = mass_matrix<S>(q);
    const auto exact_poses = forward_kinematics<S>(q);
    const auto exact_columns = jacobian<S>(q);
    for (int i = 0; i < R::chain.size; ++i) {
      for (int j = 0; j <= i; ++j) {
        const double unit = detail::power_of_two(-m.exponent(i, j)), seen = m(i, j).raw * unit;
        this->wrong.note(std::fabs(seen - exact_m(i, j)) <= row_bound[i] + unit, "M(q)", k, seen, exact_m(i, j));
      }
      const auto& at = poses.frames[i].position;
      const auto& should = exact_poses.frames[i].position;
      const double most = length_bound[i] + metre;
      this->wrong.note(std::fabs(at.x.raw * metre - should.x) <= most, "a position", k, at.x.raw * metre, should.x);
      this->wrong.note(std::fabs(at.y.raw * metre - should.y) <= most, "a position", k, at.y.raw * metre, should.y);
      this->wrong.note(std::fabs(at.z.raw * metre - should.z) <= most, "a position", k, at.z.raw * metre, should.z);
      const double turn = columns[i].angular.z.raw * direction, way = columns[i].linear.x.raw * metre;
      this->wrong.note(std::fabs(turn - exact_columns[i].angular.z) <= 1e-7, "an axis", k, turn,
                       exact_columns[i].angular.z);
      this->wrong.note(std::fabs(way - exact_columns[i].linear.x) <= 1e-6, "a column", k, way,
                       exact_columns[i].linear.x);
    }
  });
}

TYPED_TEST(HostileKernels, TwoRatesAreRightOrSayOtherwise) {
  using R = TypeParam;
  using S = Fixed<R>;
  TwoRateState<S, Fixed32> two_rate{};
  bool told = false;
  this->run(4000, [&](const auto& state, const auto& expected, std::uint64_t k) {
    const bool met = refresh<S>(two_rate, state.q).ok();
    told = told || met;
    const auto answer = two_rate_feedforward<S>(two_rate, state.qd, state.qdd);
    if (!expected.doubtful && expected.may_wrap)
      this->wrong.note(!(met && answer.status.ok()), "a status", k, 0.0, 1.0);
    if (!told) this->wrong.note(answer.status.code == Status::Code::not_ready, "a status", k, 0.0, 8.0);
    if (!met || !(answer.status.ok() || answer.status.code == Status::Code::effort_limit)) return;
    const auto exact = inverse_dynamics<S>(exhaustive::in_double<R>(state.q), exhaustive::in_double<R>(state.qd),
                                           exhaustive::in_double<R>(state.qdd));
    const auto seen = exhaustive::in_double<R>(answer.tau);
    for (int i = 0; i < R::chain.size; ++i) {
      const double most = R::chain.links[i].effort_limit, held = std::fmax(std::fmin(exact[i], most), -most);
      this->wrong.note(std::fabs(seen[i] - held) <= 3e-5, "an effort", k, seen[i], held);
    }
  });
}

TYPED_TEST(HostileKernels, AnObserverForgetsNothingThatItRefused) {
  using R = TypeParam;
  using S = Fixed<R>;
  ObserverState<S, Fixed32, Tuning> observer{};
  ObserverState<S, double, Tuning> exact{};
  CollisionState detector{};
  PayloadState<S, Fixed32> load{};
  std::uint64_t met = 0;
  this->run(4000, [&](const auto& state, const auto&, std::uint64_t k) {
    const auto before = observer;
    const Status status = observe<S, Fixed32, Tuning>(observer, state.q, state.qd, state.tau);
    if (status.ok()) {
      ++met;
      const auto q = exhaustive::in_double<R>(state.q), qd = exhaustive::in_double<R>(state.qd);
      exact.ready = before.ready;
      static_cast<void>(
          detail::update<S, double, Tuning>(exact, momentum_terms<S>(q, qd), exhaustive::in_double<R>(state.tau)));
    }
    int outermost = -1;
    for (int i = 0; i < R::chain.size; ++i) {
      const double seen = residual_of<S>(observer.residual, i), should = exact.residual[i];
      const double range = 0x1p31 * detail::power_of_two(-observer.residual.exponent(i));
      if (!status.ok())
        this->wrong.note(observer.residual[i].raw == before.residual[i].raw, "a refused sample", k, seen, should);
      this->wrong.note(std::fabs(seen - should) <= 1e-6 * range, "a residual", k, seen, should);
      if (observer.residual[i].raw > collision_thresholds_of<S, Fixed32, Tuning>.enter[i].raw ||
          -std::int64_t{observer.residual[i].raw} > collision_thresholds_of<S, Fixed32, Tuning>.enter[i].raw)
        outermost = i;
    }
    this->wrong.note(detect(detector, observer.residual).joint == outermost, "a contact's joint", k, 0.0, outermost);
    static_cast<void>(update_payload<S, Fixed32, Tuning>(load, state.q, state.qd, observer.residual));
    const auto found = estimate<Tuning>(load);
    const auto words = payload_words<S>(found);
    const double kg = words.mass.raw * detail::power_of_two(-words.mass_exponent);
    if (words.status.ok())
      this->wrong.note(std::fabs(kg - to_real<double>(found.mass)) <= 1e-6, "a mass", k, kg,
                       to_real<double>(found.mass));
  });
  EXPECT_GT(met, 300U);
}

namespace {

template <class Values, class T>
void check_border(exhaustive::Random& random, std::uint64_t k, Wrong& wrong) {
  using R = robot_of<typename detail::RoleTraits<Values>::S>;
  Joints<R, T> real{};
  for (int i = 0; i < R::chain.size; ++i)
    real[i] = property::hostile_number<T>(random);
  const auto fixed = to_fixed<Values>(real);
  const auto back = to_real<double>(fixed.values);
  for (int i = 0; i < R::chain.size; ++i) {
    const bool kept = fixed.status.ok() || i < fixed.status.joint;  // the first that was not is named
    const double x = static_cast<double>(real[i]),
                 unit = detail::is_angle<Values>(i) ? 1.5e-9 : detail::power_of_two(-Values::exponent(i));
    double off = back[i] - x;
    if (detail::is_angle<Values>(i)) off -= 6.283185307179586 * std::round(off / 6.283185307179586);
    wrong.note(!kept || std::fabs(off) <= unit, "a number at the border", k, back[i], x);
    wrong.note(std::isfinite(x) || !fixed.status.ok(), "a status at the border", k, back[i], x);
  }
}

}  // namespace

TYPED_TEST(HostileKernels, TheBorderKeepsANumberOrSaysOtherwise) {
  using R = TypeParam;
  exhaustive::Random random(property::hostile_seed);
  this->run(4000, [&](const auto&, const auto&, std::uint64_t k) {
    check_border<Positions<R, Fixed32>, float>(random, k, this->wrong);
    check_border<Velocities<R, Fixed32>, double>(random, k, this->wrong);
    check_border<Accelerations<R, Fixed32>, float>(random, k, this->wrong);
    check_border<EffortsOf<Fixed<R>, Fixed32>, double>(random, k, this->wrong);
  });
}

TEST(HostileClosedForm, IsRightInsideTheLimits) {
  using R = robots::Scara;
  using S = Fixed<R>;
  constexpr auto bound = error_bound<S>(algorithm::closed_form);
  exhaustive::Random random(property::hostile_seed);
  Wrong wrong;
  for (std::uint64_t k = 0; k < property::hostile_states(20000, tests); ++k) {
    const auto state = property::hostile_state<HostileState<S>>(random, k);
    const auto seen = exhaustive::in_double<R>(closed_form::scara_torque<S>(state.q, state.qd, state.qdd));
    if (!check_request<S>(state.q, state.qd, state.qdd).ok()) continue;
    const auto exact = closed_form::scara_torque<R>(
        exhaustive::in_double<R>(state.q), exhaustive::in_double<R>(state.qd), exhaustive::in_double<R>(state.qdd));
    for (int i = 0; i < 3; ++i)
      wrong.note(std::fabs(seen[i] - exact[i]) <= bound[i] + 1e-12, "the closed form", k, seen[i], exact[i]);
  }
  EXPECT_EQ(wrong.count, 0U) << wrong.first;
}

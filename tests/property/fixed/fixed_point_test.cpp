// Fixed point against double precision, on states inside the declared limits: what fits its format, and how exact it
// is. Inverse dynamics and the closed form have a test of their own (ranges_test.cpp).
#include <robots/robots.hpp>

#include "fixed_state.hpp"

namespace {

using namespace axial;
using property::FixedState;
using property::put;
using property::real;
using property::word;

template <class R>
class FixedPoint : public testing::Test {
 protected:
  using Checked = Scene<R, Gravity, RotorInertia, RangeCheck>;
  static constexpr int size = joint_count<R>;

  FixedPoint() { range_overflows = 0; }
  ~FixedPoint() override { EXPECT_EQ(range_overflows, 0U); }

  std::mt19937_64 generator{7};
};
#ifdef AXIAL_FEW_ROBOTS
using Robots = testing::Types<robots::Puma560, robots::Scara>;
#else
using Robots = testing::Types<robots::Puma560, robots::Panda, robots::Scara, robots::ScaraRrpr, robots::Indy7>;
#endif
TYPED_TEST_SUITE(FixedPoint, Robots);

// A robot and how it is computed.
template <class R, class... Tags>
struct Form {
  using Robot = R;
  using Checked = Scene<R, Gravity, RotorInertia, RangeCheck, Tags...>;
};
template <class F>
class FixedForms : public testing::Test {
 protected:
  static constexpr int size = joint_count<typename F::Robot>;

  FixedForms() { range_overflows = 0; }
  ~FixedForms() override { EXPECT_EQ(range_overflows, 0U); }

  std::mt19937_64 generator{7};
};
#ifdef AXIAL_FEW_ROBOTS
using Forms =
    testing::Types<Form<robots::Puma560>, Form<robots::ScaraRrpr, Looped>, Form<robots::Puma560, Looped, HighWord>>;
#else
using Forms = testing::Types<Form<robots::Puma560>, Form<robots::Panda>, Form<robots::Scara>, Form<robots::ScaraRrpr>,
                             Form<robots::Indy7>, Form<robots::Puma560, Looped>, Form<robots::Panda, Looped, HighWord>,
                             Form<robots::ScaraRrpr, Looped>, Form<robots::Indy7, Looped, RoundDown>>;
#endif
TYPED_TEST_SUITE(FixedForms, Forms);

}  // namespace

TYPED_TEST(FixedForms, PosesAndJacobiansStayInsideTheirBound) {
  using Checked = typename TypeParam::Checked;
  using Robot = typename TypeParam::Robot;
  constexpr auto bound = error_bound<Checked>(algorithm::forward_kinematics);
  constexpr auto column_bound = error_bound<Checked>(algorithm::jacobian);
  double nearest = 0.0;
  constexpr int length = length_exponent<Checked, Fixed32>;
  constexpr bool coarse = Checked::template has<HighWord> || Checked::template has<RoundDown>;
  constexpr double direction = coarse ? 2e-8 : 1e-8;
  for (int k = 0; k < 300; ++k) {
    const FixedState<Robot> state(this->generator);
    const auto fixed = forward_kinematics<Checked>(state.q);
    const auto exact = forward_kinematics<Robot>(state.q_real);
    const auto columns = jacobian<Checked>(state.q);
    const auto exact_columns = jacobian<Robot>(state.q_real);
    for (int i = 0; i < this->size; ++i) {
      EXPECT_NEAR(real(fixed.frames[i].position.x, length), exact.frames[i].position.x, bound[i]);
      EXPECT_NEAR(real(fixed.frames[i].position.z, length), exact.frames[i].position.z, bound[i]);
      EXPECT_NEAR(real(fixed.frames[i].rotation.y.x, direction_exponent<Fixed32>), exact.frames[i].rotation.y.x,
                  direction);
      EXPECT_NEAR(real(columns[i].linear.y, length), exact_columns[i].linear.y, column_bound[i]);
      EXPECT_NEAR(real(columns[i].linear.z, length), exact_columns[i].linear.z, column_bound[i]);
      if (column_bound[i] > 0.0)
        nearest = std::fmax(nearest,
                            std::fabs(real(columns[i].linear.y, length) - exact_columns[i].linear.y) / column_bound[i]);
    }
    EXPECT_NEAR(real(fixed.tool.position.y, length), exact.tool.position.y, 2.0 * bound.worst());
  }
  EXPECT_GT(nearest, 0.02) << "a bound as loose as this says little";
}

TYPED_TEST(FixedForms, MomentaAndTheirDriftsStayInsideTheirBounds) {
  using Checked = typename TypeParam::Checked;
  using Robot = typename TypeParam::Robot;
  constexpr auto momentum_bound = error_bound<Checked>(algorithm::Momentum{});
  constexpr auto drift_bound = error_bound<Checked>(algorithm::MomentumDrift{});
  double nearest_momentum = 0.0, nearest_drift = 0.0;
  for (int k = 0; k < 300; ++k) {
    const FixedState<Robot> state(this->generator);
    const auto fixed = momentum_terms<Checked>(state.q, state.qd);
    const auto exact = momentum_terms<Robot>(state.q_real, state.qd_real);
    for (int i = 0; i < this->size; ++i) {
      const double p = std::fabs(real(fixed.momentum[i], fixed.momentum.exponent(i)) - exact.momentum[i]);
      const double d = std::fabs(real(fixed.drift[i], fixed.drift.exponent(i)) - exact.drift[i]);
      EXPECT_LE(p, momentum_bound[i] + 1e-14) << i;
      EXPECT_LE(d, drift_bound[i] + 1e-14) << i;
      nearest_momentum = std::fmax(nearest_momentum, momentum_bound[i] > 0.0 ? p / momentum_bound[i] : 0.0);
      nearest_drift = std::fmax(nearest_drift, drift_bound[i] > 0.0 ? d / drift_bound[i] : 0.0);
    }
  }
  std::printf("momenta come to %.3f of their bounds, drifts to %.3f\n", nearest_momentum, nearest_drift);
  EXPECT_GT(nearest_momentum, 0.02) << "a bound as loose as this says little";
  EXPECT_GT(nearest_drift, 0.02) << "a bound as loose as this says little";
}

TYPED_TEST(FixedForms, MassMatrixStaysInsideItsBound) {
  using Checked = typename TypeParam::Checked;
  using Robot = typename TypeParam::Robot;
  constexpr auto bound = error_bound<Checked>(algorithm::mass_matrix);
  for (int k = 0; k < 300; ++k) {
    const FixedState<Robot> state(this->generator);
    const auto fixed = mass_matrix<Checked>(state.q);
    const auto exact = mass_matrix<Robot>(state.q_real);
    for (int i = 0; i < this->size; ++i)
      for (int j = 0; j <= i; ++j)
        EXPECT_NEAR(real(fixed(i, j), fixed.exponent(i, j)), exact(i, j), bound[i]) << i << ' ' << j;
  }
}

TYPED_TEST(FixedForms, InverseDynamicsStaysInsideItsBound) {
  using Checked = typename TypeParam::Checked;
  using Robot = typename TypeParam::Robot;
  constexpr auto bound = error_bound<Checked>(algorithm::inverse_dynamics);
  double worst = 0.0;
  for (int k = 0; k < 1000; ++k) {
    const FixedState<Robot> state(this->generator);
    const auto fixed = inverse_dynamics<Checked>(state.q, state.qd, state.qdd);
    const auto exact = inverse_dynamics<Robot>(state.q_real, state.qd_real, state.qdd_real);
    for (int i = 0; i < this->size; ++i)
      worst = std::fmax(worst, std::fabs(real(fixed[i], fixed.exponent(i)) - exact[i]) / bound[i]);
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_GT(worst, 0.0005) << "a bound as loose as this says little";
}

TYPED_TEST(FixedPoint, SeparatedTermsGiveTheTorque) {
  using Checked = typename TestFixture::Checked;
  for (int k = 0; k < 100; ++k) {
    const FixedState<TypeParam> state(this->generator);
    const auto tau = torque(separate<Checked>(state.q), state.qd, state.qdd);
    const auto exact = inverse_dynamics<TypeParam>(state.q_real, state.qd_real, state.qdd_real);
    for (int i = 0; i < this->size; ++i)
      EXPECT_NEAR(real(tau[i], tau.exponent(i)), exact[i], 2e-5) << i;
  }
}

TYPED_TEST(FixedPoint, ForwardDynamicsStaysInsideItsBoundAndUndoesTheTorque) {
  using Checked = typename TestFixture::Checked;
  constexpr auto bound = error_bound<Checked>(algorithm::forward_dynamics);
  for (int k = 0; k < 100; ++k) {
    const FixedState<TypeParam> state(this->generator);
    const auto tau = inverse_dynamics<TypeParam>(state.q_real, state.qd_real, state.qdd_real);
    EffortsOf<Checked, Fixed32> given{};
    Joints<TypeParam, double> given_real{};
    bool declared = true;
    for (int i = 0; i < this->size; ++i) {
      declared = declared && std::abs(tau[i]) <= TypeParam::chain.links[i].effort_limit;
      put(given[i], given_real[i], tau[i], given.exponent(i));
    }
    const auto fixed = forward_dynamics<Checked>(state.q, state.qd, given);
    const auto exact = forward_dynamics<Scene<TypeParam, Gravity, RotorInertia, ArticulatedBody>>(
        state.q_real, state.qd_real, given_real);
    ASSERT_NE(fixed.status.code, Status::Code::saturated);
    for (int i = 0; declared && i < this->size; ++i)
      EXPECT_NEAR(real(fixed[i], fixed.exponent(i)), exact[i], bound[i]) << i;
  }
}

namespace {

constexpr auto strong_chain() {
  auto chain = robots::Scara::chain;
  for (auto& link : chain.links)
    link.effort_limit = 129.0;  // just beyond a power of two: words have room for nearly twice as much
  return chain;
}
/// A SCARA whose drives are stronger than what its motions need.
struct StrongScara : robots::Scara {
  static constexpr auto chain = strong_chain();
};

}  // namespace

TEST(FixedPointForwardDynamics, HalvesEffortsBeyondTheDeclaredOnesAndSaysSo) {
  using S = Scene<StrongScara, Gravity, RotorInertia>;
  Positions<StrongScara, Fixed32> q{};
  Velocities<StrongScara, Fixed32> qd{};
  Joints<StrongScara, double> q_real{}, qd_real{}, tau_real{};
  q[1].raw = 0x40000000;
  q_real[1] = 0.25 * property::two_pi;
  for (int i = 0; i < 2; ++i)
    put(qd[i], qd_real[i], StrongScara::chain.links[i].speed_limit, qd.exponent(i));
  EffortsOf<S, Fixed32> tau{};
  tau[0] = word(129.0, tau.exponent(0));
  EXPECT_EQ(forward_dynamics<S>(q, qd, tau).status.code, Status::Code::ok);
  tau[0].raw = std::numeric_limits<std::int32_t>::max();
  const auto beyond = forward_dynamics<S>(q, qd, tau);
  EXPECT_EQ(beyond.status.code, Status::Code::rescaled);
  tau_real[0] = real(tau[0], tau.exponent(0));
  const auto exact = forward_dynamics<S>(q_real, qd_real, tau_real);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(real(beyond[i], beyond.exponent(i)), exact[i], 1e-3) << i;
}

// What an answer's bound is proved for, the bias of a declared motion: no status is needed there.
TEST(FixedPointForwardDynamics, IsOkWhereEffortsAreWhatABiasMayNeed) {
  using R = robots::Scara;
  using S = Scene<R, Gravity, RotorInertia>;
  Positions<R, Fixed32> q{};
  Velocities<R, Fixed32> qd{};
  EffortsOf<S, Fixed32> tau{};
  tau[0].raw = std::numeric_limits<std::int32_t>::max();
  constexpr auto bound = error_bound<S>(algorithm::forward_dynamics);
  const auto most = forward_dynamics<S>(q, qd, tau);
  EXPECT_EQ(most.status.code, Status::Code::ok);
  Joints<R, double> q_real{}, qd_real{}, tau_real{};
  tau_real[0] = real(tau[0], tau.exponent(0));
  const auto exact = forward_dynamics<S>(q_real, qd_real, tau_real);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(real(most[i], most.exponent(i)), exact[i], bound[i]) << i;
}

namespace {

constexpr auto pushed_chain() {
  auto chain = robots::Puma560::chain;
  chain.tip_wrench_limit = tip_wrench_limit(50.0, 10.0);
  return chain;
}
/// A Puma that declares a tip wrench too.
struct PushedPuma : robots::Puma560 {
  static constexpr auto chain = pushed_chain();
};

}  // namespace

template <class... Tags>
void expect_inputs_inside_the_bound() {
  using R = PushedPuma;
  using Exact = Scene<R, RuntimeGravity, RotorInertia, Payload, TipWrench, Friction>;
  using Checked = Scene<R, RuntimeGravity, RotorInertia, Payload, TipWrench, Friction, RangeCheck, Tags...>;
  using Format = InputFormats<R, Fixed32>;
  constexpr auto bound = error_bound<Checked>(algorithm::inverse_dynamics);
  range_overflows = 0;
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int k = 0; k < 1000; ++k) {
    const FixedState<R> state(generator);
    Inputs<Checked, Fixed32> in{};
    Inputs<Exact, double> exact_in{};
    put(in.payload.mass, exact_in.payload.mass, 2.5 * std::abs(any(generator)), Format::payload_mass);
    put(in.payload.com.x, exact_in.payload.com.x, 0.17 * any(generator), Format::payload_com);
    put(in.payload.com.z, exact_in.payload.com.z, 0.17 * any(generator), Format::payload_com);
    put(in.payload.inertia_com.yy, exact_in.payload.inertia_com.yy, 0.05 * std::abs(any(generator)),
        Format::payload_inertia);
    put(in.tip_wrench.force.y, exact_in.tip_wrench.force.y, 50.0 * any(generator), Format::tip_force);
    put(in.tip_wrench.moment.x, exact_in.tip_wrench.moment.x, 10.0 * any(generator), Format::tip_moment);
    put(in.gravity.x, exact_in.gravity.x, 6.0 * any(generator), Format::gravity);
    put(in.gravity.y, exact_in.gravity.y, 0.0, Format::gravity);
    put(in.gravity.z, exact_in.gravity.z, 7.0 * any(generator), Format::gravity);
    const auto tau = inverse_dynamics<Checked>(state.q, state.qd, state.qdd, in);
    const auto exact = inverse_dynamics<Exact>(state.q_real, state.qd_real, state.qdd_real, exact_in);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(real(tau[i], tau.exponent(i)), exact[i], bound[i]) << i;
  }
  EXPECT_EQ(range_overflows, 0U);
}

TEST(FixedPointInputs, PayloadWrenchGravityAndFrictionStayInsideTheBound) { expect_inputs_inside_the_bound<>(); }
TEST(FixedPointInputs, PayloadWrenchGravityAndFrictionStayInsideTheBoundInALoop) {
  expect_inputs_inside_the_bound<Looped>();
  expect_inputs_inside_the_bound<Looped, HighWord>();
}

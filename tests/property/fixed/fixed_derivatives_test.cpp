// Derivatives in fixed point, in every arithmetic: inside their certified errors, and nothing overflows.
#include <robots/robots.hpp>

#include <property/untuned/untuned_reference.hpp>
#include "fixed_state.hpp"

namespace {

using namespace axial;

// A robot, its word, the features that it is computed with and those of the reference.
template <class R, class Number, class Reference, class... Features>
struct Form {
  using T = Number;
  using Checked = Scene<R, Gravity, RotorInertia, RangeCheck, Features...>;
  using Exact = Reference;
  static constexpr int joints = joint_count<R>;
};
template <class R>
using Plainly = Scene<R, Gravity, RotorInertia>;

template <class F>
class FixedDerivatives : public testing::Test {
 protected:
  using T = typename F::T;
  using State = exhaustive::FixedState<typename F::Checked, T>;
  using Exact = typename F::Exact;
  static constexpr auto bound = error_bound<typename F::Checked, T>(algorithm::inverse_dynamics_derivatives);

  template <class To, class From>
  static To real(const From& from, bool positions) {
    To to{};
    for (int i = 0; i < F::joints; ++i)
      to[i] = positions && State::turns(i) ? from[i].raw / axial::detail::bam_per_radian
                                           : from[i].raw * axial::detail::power_of_two(-from.exponent(i));
    return to;
  }
  static auto exact(const State& state) {
    using R = robot_of<Exact>;
    return inverse_dynamics_derivatives<Exact>(real<Positions<R, double>>(state.q, true),
                                               real<Velocities<R, double>>(state.qd, false),
                                               real<Accelerations<R, double>>(state.qdd, false));
  }
  template <class Words, class Numbers>
  void see(const Words& words, const Numbers& numbers, const Numbers& within) {
    for (int i = 0; i < F::joints; ++i)
      for (int j = 0; j < F::joints; ++j) {
        const double found = words(i, j).raw * axial::detail::power_of_two(-words.exponent(i, j));
        const double error = std::fabs(found - numbers(i, j));
        EXPECT_LE(error, within(i, j) + 1e-12) << i << ' ' << j;
        if (within(i, j) > 0.0) nearest_ = std::fmax(nearest_, error / within(i, j));
      }
  }
  double nearest_ = 0.0;
};
using Forms = testing::Types<
    Form<robots::Scara, Fixed32, Plainly<robots::Scara>, HighWord>,
    Form<robots::RoarmM2, Fixed32, Plainly<robots::RoarmM2>, RoundDown>,
    Form<robots::ScaraRrpr, Fixed16, Plainly<robots::ScaraRrpr>>,
    Form<robots::TwoArm, Fixed32, Plainly<robots::TwoArm>>,
    Form<robots::Scara, Fixed32, Scene<robots::Scara, Gravity, RotorInertia, Friction>, Friction>,
    Form<robots::ScaraRrpr, Fixed32, Plainly<robots::ScaraRrpr>, Looped, HighWord>,
    Form<robots::RoarmM2, Fixed32, Plainly<robots::RoarmM2>, Looped, RoundDown>,
    Form<robots::ScaraRrpr, Fixed16, Plainly<robots::ScaraRrpr>, Looped>,
    Form<robots::TwoArm, Fixed32, Plainly<robots::TwoArm>, Looped, HighWord, RoundDown>,
    Form<robots::Scara, Fixed32, Scene<robots::Scara, Gravity, RotorInertia, Friction>, Friction, Looped>>;
TYPED_TEST_SUITE(FixedDerivatives, Forms);

}  // namespace

TYPED_TEST(FixedDerivatives, StayInsideTheirCertifiedErrors) {
  using Checked = typename TypeParam::Checked;
  using State = typename TestFixture::State;
  exhaustive::Random random(17);
  range_overflows = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const State state = exhaustive::next_state<State>(random, k % 4);
    const auto got = inverse_dynamics_derivatives<Checked>(state.q, state.qd, state.qdd);
    const auto exact = this->exact(state);
    this->see(got.dtau_dq, exact.dtau_dq, this->bound.dtau_dq);
    this->see(got.dtau_dqd, exact.dtau_dqd, this->bound.dtau_dqd);
    this->see(got.M, exact.M, this->bound.M);
    for (int i = 0; i < TypeParam::joints && !Checked::template has<Looped>; ++i)
      EXPECT_EQ(got.tau[i].raw, inverse_dynamics<Checked>(state.q, state.qd, state.qdd)[i].raw);
  }
  EXPECT_EQ(range_overflows, 0U);
  EXPECT_GT(this->nearest_, 0.05) << "a bound as loose as this says little";
}

// What is not asked for has no member, in words too, and what is asked for has the same bits.
TEST(FixedDerivativesAlone, HaveTheBitsOfAll) {
  using R = robots::Puma560;
  const Positions<R, Fixed32> q{{{1 << 28}, {-(1 << 29)}, {3 << 27}, {1 << 30}, {77777777}, {-99999999}}};
  const Velocities<R, Fixed32> qd{{{1 << 28}, {1 << 27}, {-(1 << 28)}, {1 << 28}, {1 << 26}, {-(1 << 28)}}};
  const Accelerations<R, Fixed32> qdd{{{1 << 27}, {-(1 << 27)}, {1 << 27}, {1 << 26}, {1 << 27}, {1 << 27}}};
  const auto all = inverse_dynamics_derivatives<R>(q, qd, qdd);
  const auto alone = inverse_dynamics_derivatives<R, with_velocity_jacobian>(q, qd, qdd);
  static_assert(sizeof alone == 36 * sizeof(Fixed32));
  for (int k = 0; k < 36; ++k)
    EXPECT_EQ(all.dtau_dqd.values[k].raw, alone.dtau_dqd.values[k].raw) << k;
}

namespace {

constexpr auto pushed_chain() {
  auto chain = robots::RoarmM2::chain;
  chain.tip_wrench_limit = tip_wrench_limit(2.0, 0.2);
  return chain;
}
struct PushedArm : robots::RoarmM2 {
  static constexpr auto chain = pushed_chain();
};

}  // namespace

namespace {

template <class... Form>
void expect_inside_under_load() {
  using R = PushedArm;
  using Exact = Scene<R, RuntimeGravity, RotorInertia, TipWrench>;
  using Checked = Scene<R, RuntimeGravity, RotorInertia, TipWrench, RangeCheck, Form...>;
  using Format = InputFormats<R, Fixed32>;
  constexpr auto bound = error_bound<Checked>(algorithm::inverse_dynamics_derivatives);
  range_overflows = 0;
  std::mt19937_64 generator(19);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  double nearest = 0.0;
  for (int k = 0; k < 1000; ++k) {
    const property::FixedState<R> state(generator);
    Inputs<Checked, Fixed32> in{};
    Inputs<Exact, double> exact_in{};
    property::put(in.tip_wrench.force.y, exact_in.tip_wrench.force.y, 2.0 * any(generator), Format::tip_force);
    property::put(in.tip_wrench.moment.x, exact_in.tip_wrench.moment.x, 0.2 * any(generator), Format::tip_moment);
    property::put(in.gravity.x, exact_in.gravity.x, 6.0 * any(generator), Format::gravity);
    property::put(in.gravity.z, exact_in.gravity.z, 7.0 * any(generator), Format::gravity);
    const auto got = inverse_dynamics_derivatives<Checked>(state.q, state.qd, state.qdd, in);
    const auto exact = inverse_dynamics_derivatives<Exact>(state.q_real, state.qd_real, state.qdd_real, exact_in);
    for (int i = 0; i < joint_count<R>; ++i)
      for (int j = 0; j < joint_count<R>; ++j) {
        const double found = property::real(got.dtau_dq(i, j), got.dtau_dq.exponent(i, j));
        const double error = std::fabs(found - exact.dtau_dq(i, j));
        EXPECT_LE(error, bound.dtau_dq(i, j) + 1e-14) << i << ' ' << j;
        if (bound.dtau_dq(i, j) > 0.0) nearest = std::fmax(nearest, error / bound.dtau_dq(i, j));
      }
  }
  EXPECT_EQ(range_overflows, 0U);
  EXPECT_GT(nearest, 0.05) << "a bound as loose as this says little";
}

// A payload of any declared mass, centre and inertia; one in four at the ends of its ranges.
template <class R, class In, class ExactIn>
void put_payload(In& in, ExactIn& exact_in, std::mt19937_64& generator) {
  using Format = InputFormats<R, Fixed32>;
  using property::put;
  constexpr PayloadLimit most = R::chain.payload_limit;
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const bool at_ends = generator() % 4 == 0;
  const auto pick = [&](double largest) {
    const double x = any(generator);
    return at_ends ? std::copysign(largest, x) : largest * x;
  };
  const auto positive = [&](double largest) { return std::fabs(pick(largest)); };
  auto &body = in.payload, &exact = exact_in.payload;
  const double side = most.com_reach / std::sqrt(3.0);
  put(body.mass, exact.mass, positive(most.mass), Format::payload_mass);
  put(body.com.x, exact.com.x, pick(side), Format::payload_com);
  put(body.com.y, exact.com.y, pick(side), Format::payload_com);
  put(body.com.z, exact.com.z, pick(side), Format::payload_com);
  auto &j = body.inertia_com, &e = exact.inertia_com;
  put(j.xx, e.xx, positive(most.inertia), Format::payload_inertia);
  put(j.yy, e.yy, positive(most.inertia), Format::payload_inertia);
  put(j.zz, e.zz, positive(most.inertia), Format::payload_inertia);
  put(j.xy, e.xy, pick(0.5 * most.inertia), Format::payload_inertia);
  put(j.xz, e.xz, pick(0.5 * most.inertia), Format::payload_inertia);
  put(j.yz, e.yz, pick(0.5 * most.inertia), Format::payload_inertia);
}
constexpr int payload_states = 2000;

constexpr auto loaded_chain() {
  auto chain = robots::RoarmM2::chain;
  chain.payload_limit = payload_limit(0.5, 0.1, 0.002);
  return chain;
}
// An arm that turns its payload about all axes.
struct LoadedArm : robots::RoarmM2 {
  static constexpr auto chain = loaded_chain();
};

// The largest share of a certified error.
template <class Words, class Exact, class Bound>
double largest_share(const Words& words, const Exact& exact, const Bound& within, int joints) {
  double share = 0.0;
  for (int i = 0; i < joints; ++i)
    for (int j = 0; j < joints; ++j) {
      const double error = std::fabs(property::real(words(i, j), words.exponent(i, j)) - exact(i, j));
      EXPECT_LE(error, within(i, j) + 1e-12) << i << ' ' << j;
      if (within(i, j) > 0.0) share = std::fmax(share, error / within(i, j));
    }
  return share;
}
template <class R, class... Tags>
void expect_inside_with_payload() {
  using Exact = Scene<R, Gravity, RotorInertia, Payload>;
  using Checked = Scene<R, Gravity, RotorInertia, Payload, RangeCheck, Tags...>;
  constexpr int joints = joint_count<R>;
  constexpr auto bound = error_bound<Checked>(algorithm::inverse_dynamics_derivatives);
  range_overflows = 0;
  std::mt19937_64 generator(23);
  double mass = 0.0, position = 0.0, velocity = 0.0;
  for (int k = 0; k < payload_states; ++k) {
    const property::FixedState<R> state(generator);
    Inputs<Checked, Fixed32> in{};
    Inputs<Exact, double> exact_in{};
    put_payload<R>(in, exact_in, generator);
    const auto got = inverse_dynamics_derivatives<Checked>(state.q, state.qd, state.qdd, in);
    const auto exact = inverse_dynamics_derivatives<Exact>(state.q_real, state.qd_real, state.qdd_real, exact_in);
    mass = std::fmax(mass, largest_share(got.M, exact.M, bound.M, joints));
    position = std::fmax(position, largest_share(got.dtau_dq, exact.dtau_dq, bound.dtau_dq, joints));
    velocity = std::fmax(velocity, largest_share(got.dtau_dqd, exact.dtau_dqd, bound.dtau_dqd, joints));
    for (int i = 0; i < joints; ++i)
      EXPECT_LE(std::fabs(property::real(got.tau[i], got.tau.exponent(i)) - exact.tau[i]), bound.tau[i]) << i;
  }
  EXPECT_EQ(range_overflows, 0U);
  for (const double share : {mass, position, velocity})
    EXPECT_GT(share, 0.05) << "a bound as loose as this says little";
}

}  // namespace

TEST(FixedDerivativesWithPayload, StayInsideTheirCertifiedErrors) {
  expect_inside_with_payload<LoadedArm>();
  expect_inside_with_payload<robots::Scara, HighWord>();
}
TEST(FixedDerivativesWithPayload, LoopedStayInsideTheirCertifiedErrors) {
  expect_inside_with_payload<LoadedArm, Looped>();
  expect_inside_with_payload<robots::Scara, Looped, HighWord>();
}
TEST(FixedDerivativesUnderLoad, StayInsideTheirCertifiedErrors) { expect_inside_under_load<>(); }
TEST(FixedDerivativesUnderLoad, LoopedStayInsideTheirCertifiedErrors) { expect_inside_under_load<Looped>(); }

// The certified errors of separated terms, by the general method and in closed form, and of the torques that are made
// of them: no state exceeds one, none overflows, and some come near.
#include <robots/robots.hpp>

#include "fixed_state.hpp"

namespace {

using namespace axial;
using property::FixedState;
using property::real;

template <class R, class... Tags>
struct Form {
  using Robot = R;
  using Exact = Scene<R, Gravity, RotorInertia, Friction>;
  using Checked = Scene<R, Gravity, RotorInertia, Friction, RangeCheck, Tags...>;
};
template <class F>
class SeparatedErrors : public testing::Test {
 protected:
  SeparatedErrors() { range_overflows = 0; }
  ~SeparatedErrors() override { EXPECT_EQ(range_overflows, 0U); }
  std::mt19937_64 generator{17};
};
#ifdef AXIAL_FEW_ROBOTS
using Forms = testing::Types<Form<robots::ScaraRrpr>>;
#else
using Forms = testing::Types<Form<robots::Puma560>, Form<robots::Panda>, Form<robots::Scara>, Form<robots::ScaraRrpr>,
                             Form<robots::Indy7>, Form<robots::Puma560, RoundDown>, Form<robots::ScaraRrpr, HighWord>>;
#endif
TYPED_TEST_SUITE(SeparatedErrors, Forms);

// How near the errors of one kind of coefficient come to their bounds; those whose bound is 0 are exact.
class Near {
 public:
  void see(double value, double exact, double bound) {
    const double off = std::fabs(value - exact);
    EXPECT_LE(off, bound + 1e-15 * std::fabs(exact));
    if (bound > 0.0) largest_ = std::fmax(largest_, off / bound);
  }
  double largest() const { return largest_; }

 private:
  double largest_ = 0.0;
};
struct Nearest {
  Near A, B, C, G;
};

template <class S>
void compare(const Separated<S, Fixed32>& fixed, const Separated<robot_of<S>, double>& exact,
             const Separated<S, double>& bound, Nearest& near) {
  using Format = SeparatedExponents<S, Fixed32>;
  for (int i = 0; i < joint_count<S>; ++i) {
    near.G.see(real(fixed.G[i], Format::rest(i)), exact.G[i], bound.G[i]);
    for (int j = 0; j < joint_count<S>; ++j) {
      near.A.see(real(fixed.A[i][j], Format::inertia(i, j)), exact.A[i][j], bound.A[i][j]);
      near.C.see(real(fixed.C[i][j], Format::square(i, j)), exact.C[i][j], bound.C[i][j]);
      for (int k = j + 1; k < joint_count<S>; ++k) {
        const int pair = fixed.pair(j, k);
        near.B.see(real(fixed.B[i][pair], Format::product(i, j, k)), exact.B[i][pair], bound.B[i][pair]);
      }
    }
  }
}

/// The closed form's joint 2 off a quarter turn and against joint 1, with limits.
struct TurnedScara {
  static constexpr auto chain = axial::chain(gravity(0, 0, -9.81),
                                             revolute()
                                                 .alpha_deg(180)
                                                 .d(0.4)
                                                 .theta_deg(90)
                                                 .mass(3)
                                                 .com(0.2, 0, 0.05)
                                                 .inertia_com(0.01, 0.05, 0.06)
                                                 .speed_limit(4)
                                                 .acceleration_limit(20)
                                                 .effort_limit(60),
                                             revolute()
                                                 .a(0.35)
                                                 .alpha_deg(180)
                                                 .theta(0.3)
                                                 .mass(2)
                                                 .com(0.12, 0, -0.03)
                                                 .inertia_com(0.01, 0.03, 0.04)
                                                 .speed_limit(5)
                                                 .acceleration_limit(30)
                                                 .effort_limit(40),
                                             prismatic()
                                                 .a(0.3)
                                                 .mass(1.2)
                                                 .com(0.04, 0, -0.1)
                                                 .inertia_com(0.004, 0.005, 0.002)
                                                 .position_limits(-0.2, 0.2)
                                                 .speed_limit(1)
                                                 .acceleration_limit(10)
                                                 .effort_limit(50));
};

template <class S>
void expect_closed_form_inside_its_bounds(double least) {
  using R = robot_of<S>;
  constexpr auto terms = error_bound<S>(algorithm::closed_form_separation);
  constexpr auto torque = error_bound<S>(algorithm::closed_form);
  std::mt19937_64 generator(18);
  Nearest near;
  Near efforts[3];
  range_overflows = 0;
  for (int k = 0; k < 20000; ++k) {
    const FixedState<R> state(generator);
    compare<S>(closed_form::scara<S>(state.q), closed_form::scara<R>(state.q_real), terms, near);
    const auto tau = closed_form::scara_torque<S>(state.q, state.qd, state.qdd);
    const auto wanted = closed_form::scara_torque<R>(state.q_real, state.qd_real, state.qdd_real);
    for (int i = 0; i < 3; ++i)
      efforts[i].see(real(tau[i], tau.exponent(i)), wanted[i], torque[i]);
  }
  EXPECT_EQ(range_overflows, 0U);
  for (const Near* part : {&near.A, &near.B, &near.C, &efforts[0], &efforts[1], &efforts[2]})
    EXPECT_GT(part->largest(), least);
  std::printf("A %.3f B %.3f C %.3f, efforts %.3f %.3f %.3f\n", near.A.largest(), near.B.largest(), near.C.largest(),
              efforts[0].largest(), efforts[1].largest(), efforts[2].largest());
}

}  // namespace

TYPED_TEST(SeparatedErrors, StayInsideTheirBounds) {
  using Checked = typename TypeParam::Checked;
  using Exact = typename TypeParam::Exact;
  using Robot = typename TypeParam::Robot;
  constexpr auto terms = error_bound<Checked>(algorithm::separation);
  constexpr auto efforts = error_bound<Checked>(algorithm::separated_torque);
  Nearest near;
  Near torques;
  for (int k = 0; k < 1000; ++k) {
    const FixedState<Robot> state(this->generator);
    const auto fixed = separate<Checked>(state.q);
    compare<Checked>(fixed, separate<Robot>(state.q_real), terms, near);
    const auto tau = torque(fixed, state.qd, state.qdd);
    const auto exact = inverse_dynamics<Exact>(state.q_real, state.qd_real, state.qdd_real);
    for (int i = 0; i < joint_count<Robot>; ++i)
      torques.see(real(tau[i], tau.exponent(i)), exact[i], efforts[i]);
  }
  for (const Near* part : {&near.A, &near.B, &near.C, &torques})  // G of a SCARA is a constant
    EXPECT_GT(part->largest(), 0.02) << "a bound as loose as this says little";
  std::printf("A %.3f B %.3f C %.3f G %.3f torque %.3f of their bounds\n", near.A.largest(), near.B.largest(),
              near.C.largest(), near.G.largest(), torques.largest());
}

#ifndef AXIAL_FEW_ROBOTS
TEST(SeparatedErrorBounds, HoldWithAPayload) {
  using R = robots::Puma560;
  using Exact = Scene<R, Gravity, RotorInertia, Payload>;
  using Checked = Scene<R, Gravity, RotorInertia, Payload, RangeCheck>;
  using Format = InputFormats<R, Fixed32>;
  constexpr auto bound = error_bound<Checked>(algorithm::separated_torque);
  std::mt19937_64 generator(19);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Near torques;
  range_overflows = 0;
  for (int k = 0; k < 2000; ++k) {
    const FixedState<R> state(generator);
    Inputs<Checked, Fixed32> in{};
    Inputs<Exact, double> exact_in{};
    property::put(in.payload.mass, exact_in.payload.mass, 2.5 * std::abs(any(generator)), Format::payload_mass);
    property::put(in.payload.com.x, exact_in.payload.com.x, 0.17 * any(generator), Format::payload_com);
    property::put(in.payload.com.z, exact_in.payload.com.z, 0.17 * any(generator), Format::payload_com);
    const auto tau = torque(separate<Checked>(state.q, in), state.qd, state.qdd);
    const auto exact = inverse_dynamics<Exact>(state.q_real, state.qd_real, state.qdd_real, exact_in);
    for (int i = 0; i < 6; ++i)
      torques.see(real(tau[i], tau.exponent(i)), exact[i], bound[i]);
  }
  EXPECT_EQ(range_overflows, 0U);
  EXPECT_GT(torques.largest(), 0.02);
}
#endif

TEST(ClosedFormErrors, StayInsideTheirBounds) {
  expect_closed_form_inside_its_bounds<Scene<robots::Scara, Gravity, RotorInertia, RangeCheck>>(0.15);
  expect_closed_form_inside_its_bounds<Scene<robots::Scara, Gravity, RotorInertia, RangeCheck, RoundDown>>(0.15);
  expect_closed_form_inside_its_bounds<Scene<robots::Scara, Gravity, RotorInertia, RangeCheck, HighWord>>(0.1);
}
TEST(ClosedFormErrors, StayInsideTheirBoundsWhereJointTwoHasAnOffset) {
  expect_closed_form_inside_its_bounds<Scene<TurnedScara, Gravity, RotorInertia, RangeCheck>>(0.15);
  expect_closed_form_inside_its_bounds<Scene<TurnedScara, Gravity, RotorInertia, RangeCheck, HighWord>>(0.1);
}

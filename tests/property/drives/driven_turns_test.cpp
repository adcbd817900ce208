// Sines and cosines from the caller, one pair per joint, of robots whose joints share drives; their base as a free
// body: against constraints with multipliers in 113 bits and, in fixed point, certified errors.
#include <axial/fixed.hpp>

#include "constrained.hpp"
#include "driven_robots.hpp"
#include "driven_states.hpp"

namespace {

using namespace constrained;

template <class T, class Found>
void expect_close(const Found& found, int n, const Vector<quad>& wanted, double size) {
  EXPECT_LE(error_in(wanted, size, convert<quad>(Vector<T>(found.values, found.values + n))), tolerance<T>);
}
/// The state that the pairs are of; what is handed in as positions is wrong wherever a joint turns by itself.
template <class R, class T, class... Features>
void expect_turns(unsigned seed) {
  using S = Scene<R, Gravity, RotorInertia, SineCosines, Features...>;
  const auto exact = Constrained::of<R>();
  const int m = exact.drives();
  oracle::RandomChains random(seed);
  for (int state = 0; state < 10; ++state) {
    SCOPED_TRACE(state);
    const auto x = motion<R>(random, exact.owner());
    const auto u = property::joints<R, T>(x.u), ud = property::joints<R, T>(x.ud), udd = property::joints<R, T>(x.udd);
    const auto at = convert<quad>(x.u), speed = convert<quad>(x.ud), turn = convert<quad>(x.udd);
    const Vector<quad> rest(std::size_t(m), quad(0));
    Inputs<S, T> in{};
    in.turns = sine_cosines<JointCoordinates<R>>(joint_positions<R>(u));
    Joints<R, T> given = u;
    for (int k = 0; k < m; ++k) {
      bool slides = false;
      for (int i = 0; i < link_count<R>; ++i)
        slides = slides || (R::chain.links[i].type == JointType::prismatic && exact.g()(i, k) != 0);
      if (!slides) given[k] = T(0);
    }
    const auto efforts = exact.inverse(at, speed, turn);
    const double size = oracle::largest(efforts);
    const auto tau = inverse_dynamics<S>(given, ud, udd, in);
    expect_close<T>(tau, m, efforts, size);
    expect_close<T>(gravity_torque<S>(given, in), m, exact.inverse(at, rest, rest), size);
    EXPECT_LE(oracle::relative_error(oracle::elements(property::matrix(mass_matrix<S>(given, in))),
                                     oracle::elements(exact.mass(at))),
              tolerance<T>);
    const auto answer = forward_dynamics<S>(given, ud, tau, in);
    EXPECT_TRUE(answer.status.ok()) << int(answer.status.code);
    const auto wanted = exact.forward(at, speed, convert<quad>(property::vector(tau)));
    expect_close<T>(answer, m, wanted, oracle::largest(wanted));
    EXPECT_EQ(forward_dynamics<S>(given, ud, tau, {}).status.code, Status::Code::not_finite) << "no pairs given";
  }
}
template <class T>
void expect_turns_of_robots(unsigned seed) {
  expect_turns<robots::ScaraQuill, T>(seed);
  expect_turns<robots::WristArm, T, CompositeBody>(seed + 1);
  expect_turns<robots::WristArm, T, SplitArticulatedBody>(seed + 2);
  expect_turns<robots::Gripper, T>(seed + 3);
  expect_turns<Followers, T>(seed + 4);
  expect_turns<Followers, T, Looped>(seed + 5);
}

/// Words of exact sines and cosines.
template <class R, class... Features>
void expect_certified(unsigned seed) {
  using T = Fixed32;
  using S = Scene<R, Gravity, RotorInertia, SineCosines, Features...>;
  using State = exhaustive::FixedState<Scene<R, Gravity, RotorInertia, RangeCheck>, T>;
  constexpr auto bound = error_bound<S, T>(algorithm::inverse_dynamics);
  exhaustive::Random random(seed);
  double nearest = 0.0;
  for (int n = 0; n < 1000; ++n) {
    auto state = exhaustive::next_state<State>(random, n % 4);
    property::hold_joints<R>(state);
    Joints<R, double> u{}, ud{}, udd{};
    for (int k = 0; k < joint_count<R>; ++k)
      u[k] = property::real(state.q, k), ud[k] = property::real(state.qd, k), udd[k] = property::real(state.qdd, k);
    const auto q = joint_positions<R>(u);
    Inputs<S, T> in{};
    constexpr int exponent = InputFormats<R, T>::sine_cosine;
    const auto word = [](double x) {
      const double most = 2147483647.0, raw = std::nearbyint(x * std::ldexp(1.0, exponent));
      return T{static_cast<std::int32_t>(std::fmin(most, std::fmax(-most, raw)))};
    };
    for (int i = 0; i < link_count<R>; ++i)
      in.turns[i] = {word(std::sin(q[i])), word(std::cos(q[i]))};
    const auto exact = inverse_dynamics<Scene<R, Gravity, RotorInertia>>(u, ud, udd);
    const auto got = inverse_dynamics<S>(state.q, state.qd, state.qdd, in);
    for (int k = 0; k < joint_count<R>; ++k)
      nearest = std::fmax(nearest, std::fabs(property::real(got, k) - exact[k]) / bound[k]);
  }
  EXPECT_LE(nearest, 1.0);
  EXPECT_GT(nearest, 0.005);
  std::printf("%.3f of the certified error\n", nearest);
}

}  // namespace

TEST(DrivenTurns, OfTheCallerAreThoseOfConstraintsInDouble) { expect_turns_of_robots<double>(1); }
TEST(DrivenTurns, OfTheCallerAreThoseOfConstraintsInFloat) { expect_turns_of_robots<float>(11); }
TEST(DrivenTurns, OfTheCallerInFixedPointStayInsideCertifiedErrors) {
  expect_certified<robots::WristArm>(21);
  expect_certified<robots::Palletiser>(22);
  expect_certified<robots::ScaraQuill>(23);
  expect_certified<robots::WristArm, Looped>(24);
}
TEST(DrivenTurns, ThatAreNoneAreNamedInFixedPoint) {
  using R = robots::Palletiser;
  using T = Fixed32;
  using S = Scene<R, Gravity, RotorInertia, SineCosines>;
  Inputs<S, T> in{};
  for (auto& turn : in.turns.values)
    turn = {T{0}, T{1 << InputFormats<R, T>::sine_cosine}};
  const Positions<R, T> u{};
  const Velocities<R, T> ud{};
  EXPECT_NE(forward_dynamics<S>(u, ud, EffortsOf<S, T>{}, in).status.code, Status::Code::input_limit);
  in.turns[link_count<R> - 1].cos.raw /= 2;
  EXPECT_EQ(forward_dynamics<S>(u, ud, EffortsOf<S, T>{}, in).status.code, Status::Code::input_limit);
}

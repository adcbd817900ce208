// The linearly implicit step of a declared stiffness: in double the same as of one told at run time, in words the same
// as in double.
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/declared_stiffness.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace axial;

/// A light joint, a thousandth of a kg m^2, on the tip of an arm; a slide between.
struct Arm {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0),
                                             revolute()
                                                 .mass(2.0)
                                                 .com(0.2, 0.0, 0.0)
                                                 .inertia_com(0.01, 0.03, 0.03)
                                                 .rotor_inertia(1e-4, 50.0)
                                                 .viscous(2.0)
                                                 .speed_limit(6.0)
                                                 .acceleration_limit(60.0)
                                                 .effort_limit(60.0),
                                             prismatic()
                                                 .alpha_deg(90)
                                                 .a(0.3)
                                                 .mass(0.5)
                                                 .inertia_com(0.001, 0.001, 0.001)
                                                 .position_limits(-0.2, 0.2)
                                                 .speed_limit(1.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(40.0),
                                             revolute()
                                                 .alpha_deg(-90)
                                                 .mass(0.1)
                                                 .inertia_com(0.001, 0.001, 0.001)
                                                 .speed_limit(4.9)
                                                 .acceleration_limit(200.0)
                                                 .effort_limit(520.0));
};
using S = Scene<Arm, Gravity, RotorInertia, Friction>;

/// What holds the joints about `rest`: 10^5 N m/rad on the light one.
struct Servo {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[] = {400.0, 0.0, 1e5}, damping[] = {5.0, 30.0, 2.0};
};
constexpr double rest[] = {0.1, 0.02, -0.3};

constexpr auto held = [](const auto& at, auto& tau, auto&) {
  for (int i = 0; i < 3; ++i)
    tau[i] = -Servo::stiffness[i] * (at.q[i] - rest[i]) - Servo::damping[i] * at.qd[i];
};
constexpr auto held_and_told = [](const auto& at, auto& tau, auto& in, auto& stiffness) {
  held(at, tau, in);
  for (int i = 0; i < 3; ++i)
    stiffness.stiffness[i] = Servo::stiffness[i], stiffness.damping[i] = Servo::damping[i];
};
/// The same drive of words, by real numbers as a plant's link has them.
constexpr auto held_in_words = [](const auto& at, auto& tau, auto& in) {
  const auto q = to_real<double>(at.q), qd = to_real<double>(at.qd);
  Joints<Arm, double> effort{};
  held(Instant<S, double>{q, qd, 0.0}, effort, in);
  tau = to_fixed<std::decay_t<decltype(tau)>>(effort).values;
};

Motion<S, double> started() {
  Motion<S, double> x;
  x.q = {0.12, 0.0, -0.299};
  x.qd = {0.2, -0.1, 0.0};
  return x;
}
Motion<S, Fixed32> in_words(const Motion<S, double>& x) {
  Motion<S, Fixed32> words;
  words.q = to_fixed<Positions<Arm, Fixed32>>(x.q).values;
  words.qd = to_fixed<Velocities<Arm, Fixed32>>(x.qd).values;
  return words;
}
template <class Words>
double apart(const Words& words, const Motion<S, double>& x) {
  const auto q = to_real<double>(words.q);
  double most = 0.0;
  for (int i = 0; i < 3; ++i)
    most = std::fmax(most, std::fabs(q[i] - x.q[i]));
  return most;
}

}  // namespace

TEST(LinearlyImplicitFor, IsTheImplicitMethodOfThatStiffness) {
  auto x = started(), y = x;
  for (int k = 0; k < 300; ++k) {
    ASSERT_TRUE(advance<LinearlyImplicitFor<Servo>>(x, held).ok());
    ASSERT_TRUE(advance<LinearlyImplicitEuler>(y, Servo::step, held_and_told).ok());
    for (int i = 0; i < 3; ++i)
      ASSERT_NEAR(x.q[i], y.q[i], 1e-12) << "step " << k;
  }
}

// An explicit step of 1 ms would be thirty times too long.
TEST(LinearlyImplicitFor, MovesWordsAsDouble) {
  auto x = started();
  auto words = in_words(x);
  double most = 0.0;
  for (int k = 0; k < 1000; ++k) {
    ASSERT_TRUE(advance<LinearlyImplicitFor<Servo>>(x, held).ok());
    const Status status = advance<LinearlyImplicitFor<Servo>>(words, held_in_words);
    ASSERT_TRUE(status.ok()) << "step " << k << ", code " << static_cast<int>(status.code) << ", joint "
                             << status.joint;
    most = std::fmax(most, apart(words, x));
  }
  EXPECT_LE(most, 1e-6);
  EXPECT_NEAR(x.q[2], rest[2], 1e-5) << "it is held";
  auto explicitly = in_words(started());
  Status status;
  for (int k = 0; k < 100 && status.code != Status::Code::speed_limit; ++k)
    status = advance<SemiImplicitEuler>(explicitly, Servo::step, held_in_words);
  EXPECT_EQ(status.code, Status::Code::speed_limit) << "then this stiffness tests nothing";
}

// Efforts beyond the declared ones, and h K qd beside them.
TEST(LinearlyImplicitFor, SaysWhereAnEffortDoesNotFit) {
  auto words = in_words(started());
  words.qd = to_fixed<Velocities<Arm, Fixed32>>(Joints<Arm, double>{0.0, 0.0, -4.9}).values;
  Held<S, Fixed32> held;
  const auto status = [&] {
    return LinearlyImplicitFor<Servo>::step(detail::StaticSystem<S>{}, words, FixedStep(Servo::step), held);
  };
  held.tau[2].raw = (std::numeric_limits<std::int32_t>::max)();
  const Status spilt = status();
  EXPECT_EQ(spilt.code, Status::Code::saturated);
  EXPECT_EQ(spilt.joint, 2);
  words = in_words(started()), held.tau[2].raw = 0;
  EXPECT_NE(status().code, Status::Code::saturated);
}

namespace {

/// A payload that declares what it may be.
struct Loaded {
  static constexpr auto chain = axial::chain(payload_limit(2.0, 0.2, 0.1), gravity(0.0, -9.81, 0.0),
                                             revolute()
                                                 .mass(2.0)
                                                 .com(0.2, 0.0, 0.0)
                                                 .inertia_com(0.01, 0.03, 0.03)
                                                 .speed_limit(6.0)
                                                 .acceleration_limit(60.0)
                                                 .effort_limit(60.0));
};
struct Soft {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[] = {400.0}, damping[] = {5.0};
};

}  // namespace

// What a scene is given at run time is the heavier robot's, too.
TEST(LinearlyImplicitFor, CarriesAPayload) {
  using Scene = axial::Scene<Loaded, Gravity, Payload>;
  Motion<Scene, double> x, y;
  Held<Scene, double> held;
  held.in.payload = {1.5, {0.1, 0.0, 0.0}, {0.01, 0.01, 0.01, 0.0, 0.0, 0.0}};
  const auto told = [&](const auto&, auto&, auto& in, auto& stiffness) {
    in = held.in;
    stiffness.stiffness[0] = Soft::stiffness[0], stiffness.damping[0] = Soft::damping[0];
  };
  for (int k = 0; k < 100; ++k) {
    ASSERT_TRUE(advance<LinearlyImplicitFor<Soft>>(x, held).ok());
    ASSERT_TRUE(advance<LinearlyImplicitEuler>(y, Soft::step, told).ok());
  }
  EXPECT_NEAR(x.q[0], y.q[0], 1e-13);
  EXPECT_LT(x.q[0], -1e-3);
}

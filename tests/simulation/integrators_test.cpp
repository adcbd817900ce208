// What each integrator computes: its order, the system it solves, its sums, its status. What becomes of motions is in
// motion_test.cpp.
#include <axial/axial.hpp>
#include <axial/cost.hpp>
#include <axial/simulation/integrators.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <robots/puma560.hpp>

namespace {

using namespace axial;

/// A bit of everything on each joint, and joints of both kinds.
struct Elastic {
  static constexpr auto chain = axial::chain(
      gravity(0.0, 0.0, -9.81),
      revolute()
          .mass(3.0)
          .com(0.2, 0.01, 0.05)
          .inertia_com(0.02, 0.05, 0.04)
          .rotor_inertia(0.001, 10)
          .spring(60.0, 0.1),
      prismatic().alpha_deg(90).a(0.1).d(0.3).mass(2.0).com(0.0, 0.05, -0.1).inertia_com(0.01, 0.02, 0.01).viscous(8.0),
      revolute()
          .alpha_deg(-90)
          .a(0.2)
          .mass(1.0)
          .com(0.15, 0.02, 0.0)
          .inertia_com(0.003, 0.01, 0.009)
          .spring(25.0)
          .viscous(0.4));
};
using Full = Scene<Elastic, Gravity, RotorInertia, JointSprings, Friction>;
using RunTime = Model<3, Gravity, RotorInertia, JointSprings, Friction>;
/// A point mass: 1 kg m^2 about two axes and 0 about the third.
struct Pendulum {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0), revolute().mass(1.0).com(1.0, 0.0, 0.0));
};

struct Rubbing {
  static constexpr auto chain =
      axial::chain(gravity(0.0, 0.0, 0.0), prismatic().mass(1.0).coulomb(10.0).smooth_speed(1e-3));
};

RunTime run_time_elastic() {
  RunTime model;
  for (const auto& link : Elastic::chain.links)
    EXPECT_TRUE(model.add(link));
  model.set_gravity(0.0, 0.0, -9.81);
  return model;
}

template <class S>
Motion<S, double> thrown() {
  Motion<S, double> x;
  x.q = {0.3, 0.1, -0.5};
  x.qd = {0.5, -0.2, 1.0};
  return x;
}

/// An effort that changes with time and speed.
constexpr auto shaken = [](const auto& at, auto& tau, auto&) {
  for (int i = 0; i < 3; ++i)
    tau[i] = (i + 1) * at.time * (1.0 - at.time) - 0.05 * at.qd[i];
};

template <class Method>
Motion<Full, double> after(double seconds, int steps) {
  auto x = thrown<Full>();
  for (int k = 0; k < steps; ++k)
    EXPECT_TRUE(advance<Method>(x, seconds / steps, shaken).ok());
  return x;
}
double distance(const Motion<Full, double>& a, const Motion<Full, double>& b) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
    sum += std::fabs(a.q[i] - b.q[i]) + std::fabs(a.qd[i] - b.qd[i]);
  return sum;
}

/// Errors of two steps against the exact motion fall by 2^order.
template <class Method>
void expect_order(int coarse) {
  const auto exact = after<RungeKutta4>(0.5, 4096);
  const double ratio = distance(after<Method>(0.5, coarse), exact) / distance(after<Method>(0.5, 2 * coarse), exact);
  EXPECT_NEAR(std::log2(ratio), Method::order, 0.15);
}

}  // namespace

TEST(Integrators, AreOfTheirOrder) {
  expect_order<SemiImplicitEuler>(512);
  expect_order<LinearlyImplicitEuler>(512);
  expect_order<RungeKutta4>(256);
}

TEST(Integrators, MoveRunTimeModelsAsTheyMoveTypes) {
  const auto model = run_time_elastic();
  const auto both = [&](auto method) {
    using Method = decltype(method);
    auto x = thrown<Full>();
    auto y = thrown<RunTime>();
    for (int k = 0; k < 100; ++k) {
      ASSERT_TRUE(advance<Method>(x, 1e-3, shaken).ok());
      ASSERT_TRUE(advance<Method>(model, y, 1e-3, shaken).ok());
    }
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(x.q[i], y.q[i], 1e-14);
      EXPECT_NEAR(x.qd[i], y.qd[i], 1e-13);
    }
    EXPECT_EQ(x.steps, y.steps);
  };
  both(SemiImplicitEuler{}), both(RungeKutta4{}), both(LinearlyImplicitEuler{});
}

// By the dense matrices of other algorithms: (M + h D + h^2 K) a + h K qd = tau - (c + g + passive efforts).
TEST(LinearlyImplicitEuler, SolvesWhatItSays) {
  constexpr double h = 0.01;
  const double springs[] = {60.0, 0.0, 25.0}, dampers[] = {0.0, 8.0, 0.4};
  const DriveStiffness<Full, double> drive{{7.0, 300.0, 0.0}, {0.0, 2.0, 1.0}};
  auto x = thrown<Full>();
  const auto before = x;
  const Joints<Elastic, double> tau{1.0, -2.0, 0.5};
  const auto stiff = [&](const auto&, auto& effort, auto&, DriveStiffness<Full, double>& stiffness) {
    effort = tau, stiffness = drive;
  };
  ASSERT_TRUE(advance<LinearlyImplicitEuler>(x, h, stiff).ok());
  const auto mass = mass_matrix<Full>(before.q);
  const auto rest = inverse_dynamics<Full>(before.q, before.qd, Joints<Elastic, double>{});
  for (int i = 0; i < 3; ++i) {
    const double k = springs[i] + drive.stiffness[i], d = dampers[i] + drive.damping[i];
    double left = h * k * before.qd[i];
    for (int j = 0; j < 3; ++j)
      left += (mass(i, j) + (i == j ? h * d + h * h * k : 0.0)) * (x.qd[j] - before.qd[j]) / h;
    EXPECT_NEAR(left, tau[i] - rest[i], 1e-11);
    EXPECT_DOUBLE_EQ(x.q[i], before.q[i] + h * x.qd[i]);
  }
}

TEST(LinearlyImplicitEuler, WithoutSpringsAndDampersIsTheSemiImplicitOne) {
  using Bare = Scene<Elastic, Gravity, RotorInertia, ArticulatedBody>;
  auto x = thrown<Bare>(), y = x;
  const Held<Bare, double> held{{1.0, 2.0, 3.0}, {}};
  for (int k = 0; k < 10; ++k) {
    ASSERT_TRUE(advance<LinearlyImplicitEuler>(x, 1e-3, held).ok());
    ASSERT_TRUE(advance<SemiImplicitEuler>(y, 1e-3, held).ok());
  }
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(x.q[i] == y.q[i] && x.qd[i] == y.qd[i]) << i;
}

// A drop in a smoothed Coulomb friction of 1.5 C / v0 = 15000 1/s: explicit steps of 1 ms would be 7 times too long.
TEST(LinearlyImplicitEuler, TakesSmoothedFriction) {
  using S = Scene<Rubbing, Friction>;
  const auto furthest = [](auto method) {
    Motion<S, double> x;
    x.qd[0] = 0.05;
    double speed = 0.0;
    for (int k = 0; k < 1000; ++k) {
      EXPECT_TRUE(advance<decltype(method)>(x, 1e-3, Held<S, double>{}).ok());
      if (k >= 100) speed = std::fmax(speed, std::fabs(x.qd[0]));
    }
    return speed;
  };
  EXPECT_LE(furthest(LinearlyImplicitEuler{}), 1e-10);
  EXPECT_GE(furthest(SemiImplicitEuler{}), 1e-3) << "then this friction tests nothing";
}

TEST(Integrators, KeepTimeByCounting) {
  Motion<Pendulum, float> x;
  float sum = 0.0F;
  constexpr float h = 0.001F;
  for (; x.steps < 2'000'000; ++x.steps)
    sum += h;
  EXPECT_NEAR(x.time(h), 2000.0F, 2000.0F * 2.0F * std::numeric_limits<float>::epsilon());
  EXPECT_GT(std::fabs(sum - 2000.0F), 30.0F) << "a sum of steps loses time";
}

TEST(CompensatedSums, KeepWhatPlainSumsLose) {
  float plain = 1.0F, sum = 1.0F, rest = 0.0F;
  constexpr float small = 1e-9F;
  for (int k = 0; k < 1'000'000; ++k) {
    plain += small;
    detail::add_exactly(sum, rest, small);
  }
  EXPECT_EQ(plain, 1.0F);
  EXPECT_NEAR(sum, 1.001F, std::numeric_limits<float>::epsilon());
  // A sum that is exact, in whichever order the sizes come.
  float x = 1e-8F, left = 0.0F;
  detail::add_exactly(x, left, 1.0F);
  EXPECT_EQ(static_cast<double>(x) + static_cast<double>(left), 1.0 + static_cast<double>(1e-8F));
}

TEST(Integrators, AreConstantExpressions) {
  constexpr auto x = [] {
    Motion<Pendulum, float> x;
    x.q[0] = 0.5F;
    bool ok = true;
    for (int k = 0; k < 3; ++k)
      ok = advance<RungeKutta4>(x, 0.01F, Held<Pendulum, float>{}).ok() && ok;
    return ok ? x : Motion<Pendulum, float>{};
  }();
  static_assert(x.steps == 3 && x.q[0] < 0.5F && x.qd[0] < 0.0F);
  EXPECT_EQ(sizeof(Motion<Pendulum, float>), 2 * sizeof(float) + sizeof(std::uint64_t));
}

namespace {

/// Operations of one step from any state under held efforts.
template <class S, class Method>
Operations operations_of_a_step() {
  Trace trace;
  const auto symbols = [&](auto& values) {
    for (auto& value : values.values)
      value = Counting(trace);
  };
  Motion<S, Counting> x;
  Held<S, Counting> held;
  symbols(x.q), symbols(x.qd), symbols(held.tau);
  EXPECT_TRUE(advance<Method>(x, Counting(trace), held).ok());
  for (int i = 0; i < joint_count<S>; ++i)
    x.q[i].need(), x.qd[i].need();
  EXPECT_FALSE(trace.overflowed());
  return trace.operations();
}

}  // namespace

// Evaluations of forward dynamics, and sums: two a joint and evaluation, and the mean of four slopes. Nothing asks for
// the angle of a first joint that stands upright, so that three of its sums are not needed.
TEST(Integrators, CostWhatTheyEvaluate) {
  const auto check = [](auto scene) {
    using S = decltype(scene);
    constexpr int n = joint_count<S>;
    const Operations one = cost<S>(algorithm::forward_dynamics);
    const auto times = [&](int k, int mul, int add, int div) {
      return Operations{k * one.mul + mul, k * one.add + add, k * one.div + div, k * one.sincos};
    };
    EXPECT_TRUE((operations_of_a_step<S, SemiImplicitEuler>() == times(1, 2 * n, 2 * n, 0)));
    EXPECT_TRUE((operations_of_a_step<S, RungeKutta4>() == times(4, 1 + 10 * n - 3, 14 * n - 3, 1)));
  };
  check(Scene<Elastic, Gravity, RotorInertia>{});
  check(Scene<robots::Puma560, Gravity, RotorInertia>{});
}

TEST(Integrators, PassOnWhatForwardDynamicsSays) {
  RunTime weightless;
  ASSERT_TRUE(weightless.add(revolute().mass(1.0).com(1.0, 0.0, 0.0)));
  ASSERT_TRUE(weightless.add(revolute().a(1.0)));
  const auto status = [&](auto method) {
    Motion<RunTime, double> x;
    return advance<decltype(method)>(weightless, x, 1e-3, Held<RunTime, double>{});
  };
  for (const Status s : {status(SemiImplicitEuler{}), status(RungeKutta4{}), status(LinearlyImplicitEuler{})}) {
    EXPECT_EQ(s.code, Status::Code::near_singular);
    EXPECT_EQ(s.joint, 1);
  }
}

namespace {

/// A mass on a slide whose solver finds fault with one of its calls.
struct Doubtful {
  using Subject = Rubbing;
  int doubted;
  int broken = 4;
  mutable int calls = 0;
  [[nodiscard]] int size() const { return 1; }
  template <class Q, class V, class Tau, class In>
  auto accelerations(const Q&, const V&, const Tau&, const In&) const {
    ForwardDynamicsOf<Rubbing, double> a{};
    const int call = calls++;
    if (call >= doubted) a.status = {Status::Code::near_singular, call};
    if (call == broken) a.status = {Status::Code::not_finite, -1};
    return a;
  }
};

}  // namespace

TEST(RungeKutta4, TellsTheFirstTroubleOfItsFourSlopes) {
  for (int doubted = 0; doubted <= 4; ++doubted) {
    Motion<Rubbing, double> x;
    const Doubtful system{doubted};
    const Status status = RungeKutta4::step(system, x, 1e-3, Held<Rubbing, double>{});
    EXPECT_EQ(system.calls, 4);
    EXPECT_EQ(status.code, doubted < 4 ? Status::Code::near_singular : Status::Code::ok) << doubted;
    EXPECT_EQ(status.joint, doubted < 4 ? doubted : -1) << "the first";
  }
}

TEST(RungeKutta4, TellsWhatIsNotFiniteBeforeAnythingElse) {
  for (int broken = 0; broken < 4; ++broken) {
    Motion<Rubbing, double> x;
    const Status status = RungeKutta4::step(Doubtful{0, broken}, x, 1e-3, Held<Rubbing, double>{});
    EXPECT_EQ(status.code, Status::Code::not_finite) << broken;
  }
}

namespace {

template <class Method, class X>
void expect_left_alone() {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1.7e308}) {
    X x;
    x.q[0] = 0.25, x.qd[0] = 1e308, x.steps = 7;
    const Status status = advance<Method>(x, 100.0, Held<Rubbing, double>{{bad}, {}});
    EXPECT_EQ(status.code, Status::Code::not_finite) << bad;
    EXPECT_EQ(x.q[0], 0.25);
    EXPECT_EQ(x.qd[0], 1e308);
    EXPECT_EQ(x.steps, 7U);
  }
}

}  // namespace

TEST(Integrators, LeaveAStateAloneThatWouldNotBeFinite) {
  expect_left_alone<SemiImplicitEuler, Motion<Rubbing, double>>();
  expect_left_alone<RungeKutta4, Motion<Rubbing, double>>();
  expect_left_alone<LinearlyImplicitEuler, CompensatedMotion<Rubbing, double>>();
}

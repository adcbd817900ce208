// The step limit is below what is stable, and not far below.
#include <axial/axial.hpp>
#include <axial/simulation/step_limit.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace axial;
using Chain = Model<6, RotorInertia, JointSprings, Friction>;

struct Sampler {
  std::mt19937 engine;
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  }
};

/// A random chain without gravity, sprung about q, each joint with or without a damper.
struct Sprung {
  Chain model;
  Joints<Chain, double> q{};
  int size;

  Sprung(unsigned seed, bool damped) {
    Sampler sample{std::mt19937(seed)};
    size = 1 + static_cast<int>(seed % 6);
    for (int i = 0; i < size; ++i) {
      const double mass = sample(0.1, 4.0), wide = mass * sample(0.005, 0.02);
      q[i] = sample(-1.0, 1.0);
      const double stiffness = std::exp2(sample(4.0, 14.0));
      const double damping = damped && seed % 3 != static_cast<unsigned>(i) ? std::exp2(sample(-2.0, 6.0)) : 0.0;
      const auto dressed = [&](auto joint) {
        return joint.alpha_deg(90.0 * static_cast<int>(sample(-1.0, 2.0)))
            .a(sample(0.0, 0.5))
            .mass(mass)
            .com(sample(-0.2, 0.2), sample(-0.2, 0.2), sample(-0.2, 0.2))
            .inertia_com(wide, 1.5 * wide, 1.2 * wide)
            .spring(stiffness, q[i])
            .viscous(damping);
      };
      EXPECT_TRUE(i % 4 == 2 ? model.add(dressed(prismatic())) : model.add(dressed(revolute())));
    }
  }
};

/// Largest |q - rest| after many steps of a motion that starts within 1e-7 of it.
template <class Method>
double excursion(const Sprung& sprung, double h) {
  Motion<Chain, double> x;
  x.q = sprung.q;
  for (int i = 0; i < sprung.size; ++i)
    x.q[i] += (i % 2 == 0 ? 1e-7 : -0.5e-7);
  double worst = 0.0;
  for (int k = 0; k < 3000 && worst < 1.0; ++k) {
    if (!advance<Method>(sprung.model, x, h, Held<Chain, double>{}).ok()) return 1.0;
    for (int i = 0; i < sprung.size; ++i)
      worst = std::fmax(worst, std::isfinite(x.q[i]) ? std::fabs(x.q[i] - sprung.q[i]) : 1.0);
  }
  return worst;
}

template <class Method>
void expect_guarantee(bool damped, double beyond) {
  int broken = 0;
  for (unsigned seed = 1; seed <= 24; ++seed) {
    const Sprung sprung(seed, damped);
    const double limit = step_limit<Method>(sprung.model, sprung.q);
    EXPECT_LE(excursion<Method>(sprung, 0.999 * limit), 1e-4) << "seed " << seed;
    broken += excursion<Method>(sprung, beyond * limit) >= 1e-2 ? 1 : 0;
  }
  if (beyond > 0.0) {
    EXPECT_GE(broken, 22) << "the limit is far below what is stable";
  }
}

struct Wheel {
  static constexpr auto chain = axial::chain(revolute().mass(1.0).inertia_com(1, 1, 0.25).spring(100.0).viscous(3.0));
};

}  // namespace

TEST(StepLimit, OfOneJointIsTheTextbooks) {
  using Undamped = Scene<Wheel, JointSprings>;
  using Damped = Scene<Wheel, JointSprings, Friction>;
  const Joints<Wheel, double> q{};
  const double w = 20.0, d = 12.0;
  EXPECT_NEAR((step_limit<SemiImplicitEuler, Undamped>(q)), 2.0 / w, 1e-14);
  EXPECT_NEAR((step_limit<RungeKutta4, Undamped>(q)), std::sqrt(8.0) / w, 1e-14);
  const double h = step_limit<SemiImplicitEuler, Damped>(q);
  EXPECT_NEAR(h * h * w * w + 2.0 * h * d, 4.0, 1e-13);
  EXPECT_NEAR((step_limit<SemiImplicitEuler, Damped>(Joints<Wheel, float>{})), h, 1e-7);
  // What the drive adds counts the same.
  const DriveStiffness<Undamped, double> drive{{300.0}, {}};
  EXPECT_NEAR((step_limit<SemiImplicitEuler, Undamped>(q, {}, drive)), 1.0 / w, 1e-14);
}

namespace {

constexpr double l = 0.5, m = 2.0, k1 = 300.0, k2 = 120.0;

struct TwoMasses {
  static constexpr auto chain =
      axial::chain(revolute().mass(m).com(l, 0, 0).spring(k1), revolute().a(l).mass(m).com(l, 0, 0).spring(k2));
};

}  // namespace

// det(K - w^2 M) = 0 of two point masses on a planar arm: the larger root.
TEST(StepLimit, OfTwoJointsIsThatOfTheirStiffestMode) {
  for (const double q2 : {0.0, 0.7, 2.0, 3.0}) {
    const double b = m * l * l * (1.0 + std::cos(q2)), c = m * l * l, a = c + 2.0 * b;
    const double square = a * c - b * b, half = 0.5 * (a * k2 + c * k1);
    const double w = std::sqrt((half + std::sqrt(half * half - square * k1 * k2)) / square);
    const double h = step_limit<SemiImplicitEuler, Scene<TwoMasses, JointSprings>>(Joints<TwoMasses, double>{0.3, q2});
    EXPECT_LE(h, 2.0 / w * (1.0 + 1e-12)) << q2;
    EXPECT_GE(h, 2.0 / w * std::pow(2.0, -1.0 / 64.0)) << q2;
  }
}

namespace {

constexpr double pulled_by = 2.0, damped_by = 6.0;

/// Two carriages on springs, which a differential moves: its drives turn as one for the first, against each other for
/// the second.
struct Carriages {
  static constexpr auto carriage = prismatic().mass(m);
  static constexpr auto chain =
      axial::chain(carriage.spring(k1).viscous(damped_by),
                   carriage.parent(LinkParameters::base).spring(k2).viscous(damped_by), axial::differential());
};

/// A carriage that pulls another, twice as far.
struct Pulled {
  static constexpr auto chain = axial::chain(
      prismatic().mass(m).spring(k1), prismatic().parent(LinkParameters::base).mass(m).spring(k2).mimic(0, pulled_by));
};

template <class S, class Model>
Model modelled() {
  Model model;
  for (const auto& link : robot_of<S>::chain.links)
    EXPECT_TRUE(model.add(link));
  return model;
}

}  // namespace

// Springs are the joints', k of a mass m; dampers the drives', of which each has half of m.
TEST(StepLimit, OfSharedDrivesIsThatOfWhatTheyMove) {
  using Undamped = Scene<Carriages, JointSprings>;
  using Damped = Scene<Carriages, JointSprings, Friction>;
  const Joints<Carriages, double> u{};
  const double w2 = k1 / m, d = damped_by / (0.5 * m), share = std::pow(2.0, -1.0 / 32.0);
  const double undamped = step_limit<SemiImplicitEuler, Undamped>(u);
  EXPECT_LE(undamped, 2.0 / std::sqrt(w2) * (1.0 + 1e-12));
  EXPECT_GE(undamped, 2.0 / std::sqrt(w2) * share);
  const double h = step_limit<SemiImplicitEuler, Damped>(u);
  EXPECT_LE(h * h * w2 + 2.0 * h * d, 4.0 * (1.0 + 1e-12));
  EXPECT_GE(h * h * w2 + 2.0 * h * d, 4.0 * share * share);
  using Shared = Model<2, JointSprings, Friction, SharedDrives>;
  EXPECT_NEAR(step_limit<SemiImplicitEuler>(modelled<Damped, Shared>(), Joints<Shared, double>{}), h, 1e-14);
  // A stiff drive adds to what springs do: to both drives, on half of m each.
  const DriveStiffness<Undamped, double> drive{{500.0, 500.0}, {0.0, 0.0}};
  const double stiff = step_limit<SemiImplicitEuler, Undamped>(u, {}, drive);
  EXPECT_LE(stiff, 2.0 / std::sqrt(w2 + 500.0 / (0.5 * m)) * (1.0 + 1e-12));
  EXPECT_GE(stiff, 2.0 / std::sqrt(w2 + 500.0 / (0.5 * m)) * share);
  // One drive, two joints: the springs of both on the masses of both, as the drive feels them.
  const double both = (k1 + pulled_by * pulled_by * k2) / (m + pulled_by * pulled_by * m);
  EXPECT_NEAR((step_limit<SemiImplicitEuler, Scene<Pulled, JointSprings>>(Joints<Pulled, double>{})),
              2.0 / std::sqrt(both), 1e-14);
  EXPECT_TRUE((std::isinf(step_limit<RungeKutta4, Scene<Carriages>>(u))));
  EXPECT_EQ((step_limit<RungeKutta4, Undamped>(Joints<Carriages, double>{NAN, 0.0}).status.code),
            Status::Code::not_finite);
}

TEST(StepLimit, JudgesSteps) {
  const StepLimit<double> limit{1e-3, {}}, none{0.0, {Status::Code::not_finite, -1}};
  EXPECT_TRUE(limit.judge(1e-3).ok());
  EXPECT_EQ(limit.judge(1.001e-3).code, Status::Code::input_limit);
  EXPECT_EQ(limit.judge(std::nan("")).code, Status::Code::input_limit);
  EXPECT_EQ(none.judge(0.0).code, Status::Code::not_finite);
}

TEST(StepLimit, IsInfiniteWithoutSpringsAndForTheImplicitMethod) {
  EXPECT_TRUE((std::isinf(step_limit<RungeKutta4, Scene<Wheel>>(Joints<Wheel, double>{}))));
  EXPECT_TRUE((std::isinf(step_limit<LinearlyImplicitEuler, Scene<Wheel, JointSprings>>(Joints<Wheel, double>{}))));
}

TEST(StepLimit, BoundsTheLargestEigenvalueClosely) {
  detail::Square<double, 3> a{{{2.0, 1.0, 0.0}, {1.0, 2.0, 1.0}, {0.0, 1.0, 2.0}}};
  const double largest = 2.0 + std::sqrt(2.0), bound = detail::largest_eigenvalue_bound(a, 3);
  EXPECT_GE(bound, largest);
  EXPECT_LE(bound, largest * std::pow(3.0, 1.0 / 32.0));
  const detail::Square<double, 3> equal{{{5.0, 0.0, 0.0}, {0.0, 5.0, 0.0}, {0.0, 0.0, 5.0}}};
  EXPECT_NEAR(detail::largest_eigenvalue_bound(equal, 3), 5.0 * std::pow(3.0, 1.0 / 32.0), 1e-12);
  EXPECT_EQ(detail::largest_eigenvalue_bound(detail::Square<double, 3>{}, 3), 0.0);
}

TEST(StepLimit, HoldsForSpringsAndIsClose) {
  expect_guarantee<SemiImplicitEuler>(false, 1.05);
  expect_guarantee<RungeKutta4>(false, 1.05);
}
TEST(StepLimit, HoldsForSpringsAndDampers) {
  expect_guarantee<SemiImplicitEuler>(true, 0.0);
  expect_guarantee<RungeKutta4>(true, 0.0);
}
TEST(StepLimit, LinearlyImplicitStepsHoldAtAHundredTimesTheExplicitLimit) {
  for (unsigned seed = 1; seed <= 24; ++seed) {
    const Sprung sprung(seed, seed % 2 == 0);
    const double h = 100.0 * step_limit<SemiImplicitEuler>(sprung.model, sprung.q);
    EXPECT_LE(excursion<LinearlyImplicitEuler>(sprung, h), 1e-6) << "seed " << seed;
  }
}

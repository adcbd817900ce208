// The certified error of forward dynamics against what single roundings do to a planar arm, by its closed form: each
// rounding that the kernel makes moves the bound by at least as much as it can move an acceleration.
#include <axial/fixed.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using namespace axial;

// Two links in a plane, weightless. Inertias are about the joints, h is the outer link's first moment.
constexpr double m1 = 2.0, m2 = 1.5, arm = 0.4, centre = 0.25, own1 = 0.08, own2 = 0.03, effort = 10.0;
struct Arm {
  static constexpr auto chain = axial::chain(
      gravity(0, 0, 0),
      revolute().mass(m1).inertia_com(own1, own1, own1).speed_limit(2).acceleration_limit(20).effort_limit(effort),
      revolute()
          .a(arm)
          .mass(m2)
          .com(centre, 0, 0)
          .inertia_com(own2, own2, own2)
          .speed_limit(2)
          .acceleration_limit(20)
          .effort_limit(effort));
};

struct Wheel {
  static constexpr auto chain = axial::chain(
      gravity(0, 0, 0),
      revolute().mass(m1).inertia_com(own1, own1, own1).speed_limit(2).acceleration_limit(20).effort_limit(effort));
};
struct Slide {
  static constexpr auto chain = axial::chain(
      gravity(0, 0, 0),
      prismatic().mass(m1).position_limits(0, 0.5).speed_limit(2).acceleration_limit(20).effort_limit(effort));
};

struct Plane {
  double inner = own1, outer = own2 + m2 * centre * centre, h = m2 * centre, mass = m2;
  double cosine_off = 0.0, pull[2] = {0.0, 0.0};  ///< what cos(q2) is off, and efforts on top

  /// Accelerations under given efforts.
  void solve(double q2, double tau1, double tau2, double (&qdd)[2]) const {
    const double swing = arm * h * (std::cos(q2) + cosine_off);
    const double a = inner + outer + mass * arm * arm + 2.0 * swing, b = outer + swing, c = outer;
    const double x = tau1 + pull[0], y = tau2 + pull[1], det = a * c - b * b;
    qdd[0] = (c * x - b * y) / det, qdd[1] = (a * y - b * x) / det;
  }
};

struct Pair {
  double of[2] = {0.0, 0.0};
};
// What a change makes of each acceleration at most, at the ends of the efforts.
Pair effect(const Plane& changed) {
  Pair most;
  for (int k = 0; k < 64; ++k)
    for (const double tau1 : {-effort, effort})
      for (const double tau2 : {-effort, effort}) {
        double exact[2], off[2];
        const double q2 = 2.0 * M_PI * k / 64.0;
        Plane{}.solve(q2, tau1, tau2, exact), changed.solve(q2, tau1, tau2, off);
        for (int i = 0; i < 2; ++i)
          most.of[i] = std::fmax(most.of[i], std::fabs(off[i] - exact[i]));
      }
  return most;
}

constexpr int fine = 60, coarse = 16;
constexpr double unit = 1.0 / 65536.0, step = 0.5 * unit;

// The certificate where nothing rounds but what `change` says of formats, of the bias and of the arithmetic.
template <int N>
using ChangeOf = std::function<void(Ranges<N>&, Ranges<N>&, WordRounding&)>;
using Change = ChangeOf<2>;
template <class R, class Change, int N = joint_count<R>>
Row<double, N> certified(const Change& change) {
  const auto& m = mechanism_of<Scene<R, Gravity>, FullParameters>;
  WordRounding r{32, true, false, 0.0};
  Ranges<N> motion = newton_euler_ranges(m, r),
            ranges = articulated_at_rest_sizes(m, r, detail::usual_drive(m, r, motion));
  for (int i = 0; i < N; ++i) {
    motion.range[i].joint_effort.error = 0.0;
    for (const auto quantity : all_quantities<int>)
      ranges.format[i].*quantity = fine;
  }
  change(ranges, motion, r);
  const detail::ForwardErrorAnalysis<N> errors(m, r, ranges, motion);
  Row<double, N> all;
  for (int i = 0; i < N; ++i)
    all[i] = errors.of(i);
  return all;
}
void expect_counted(const Change& change, const Pair& least) {
  const auto with = certified<Arm>(change), without = certified<Arm>([](Ranges<2>&, Ranges<2>&, WordRounding&) {});
  for (int i = 0; i < 2; ++i)
    EXPECT_GE(with[i] - without[i], 0.999 * least.of[i]) << "joint " << i;
}
Change coarsened(int LinkFormat::*quantity, int link) {
  return [=](Ranges<2>& ranges, Ranges<2>&, WordRounding&) { ranges.format[link].*quantity = coarse; };
}
Pair effect_of(double Plane::*member, double by) {
  Plane changed;
  changed.*member += by;
  return effect(changed);
}
Pair effect_of_efforts(double inner, double outer) {
  Plane changed;
  changed.pull[0] = inner, changed.pull[1] = outer;
  return effect(changed);
}

}  // namespace

TEST(ForwardError, CountsRoundingsOfInertias) {
  expect_counted(coarsened(&LinkFormat::rotational_inertia, 0), effect_of(&Plane::inner, step));
  expect_counted(coarsened(&LinkFormat::rotational_inertia, 1), effect_of(&Plane::outer, step));
  expect_counted(coarsened(&LinkFormat::first_moment, 1), effect_of(&Plane::h, step));
  expect_counted(coarsened(&LinkFormat::mass, 1), effect_of(&Plane::mass, step));
}
// Nothing but its own rounding is between the inertia of one joint alone and its acceleration, tau / D.
TEST(ForwardError, CountsTheRoundingOfALinkByItself) {
  const auto expect_own = [](auto robot, int LinkFormat::*quantity, double inertia) {
    using R = decltype(robot);
    const auto with =
        certified<R>([=](Ranges<1>& ranges, Ranges<1>&, WordRounding&) { ranges.format[0].*quantity = coarse; });
    const auto without = certified<R>([](Ranges<1>&, Ranges<1>&, WordRounding&) {});
    EXPECT_GE(with[0] - without[0], 0.999 * effort * step / (inertia * (inertia + step)));
  };
  expect_own(Wheel{}, &LinkFormat::rotational_inertia, own1);
  expect_own(Slide{}, &LinkFormat::mass, m1);
}
TEST(ForwardError, CountsRoundingsOfForcesAndEfforts) {
  expect_counted(coarsened(&LinkFormat::moment, 0), effect_of_efforts(step, 0.0));
  expect_counted(coarsened(&LinkFormat::moment, 1), effect_of_efforts(step, 0.0));
  expect_counted(coarsened(&LinkFormat::force, 1), effect_of_efforts(arm * step, 0.0));
  expect_counted(coarsened(&LinkFormat::joint_effort, 0), effect_of_efforts(step, 0.0));
  expect_counted(coarsened(&LinkFormat::joint_effort, 1), effect_of_efforts(0.0, step));
}
TEST(ForwardError, CountsWhatTheBiasIsOff) {
  expect_counted([](Ranges<2>&, Ranges<2>& motion, WordRounding&) { motion.range[0].joint_effort.error = unit; },
                 effect_of_efforts(unit, 0.0));
  expect_counted([](Ranges<2>&, Ranges<2>& motion, WordRounding&) { motion.range[1].joint_effort.error = unit; },
                 effect_of_efforts(0.0, unit));
}
TEST(ForwardError, CountsWhatSinesAndCosinesAreOff) {
  expect_counted([](Ranges<2>&, Ranges<2>&, WordRounding& r) { r.turn_error = 1e-4; },
                 effect_of(&Plane::cosine_off, 1e-4));
}
// qdd2 = u / D - K . a: a and K are the inner link's accelerations and the gains; h / J is the gain of the linear one.
TEST(ForwardError, CountsRoundingsOnTheWayOut) {
  const double gain = Plane{}.h / Plane{}.outer;
  expect_counted(coarsened(&LinkFormat::joint_acceleration, 0), {{step, step}});
  expect_counted(coarsened(&LinkFormat::joint_acceleration, 1), {{0.0, step}});
  expect_counted(coarsened(&LinkFormat::angular_acceleration, 1), {{0.0, step}});
  expect_counted(coarsened(&LinkFormat::linear_acceleration, 1), {{0.0, gain * step}});
}

// Control of robots whose joints share drives: everything a loop asks, in values of drives.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/control/payload_estimator.hpp>
#include <cmath>
#include <limits>
#include <robots/robots.hpp>

using namespace axial;

namespace {

struct Watching {
  static constexpr double period = 1e-3, gain = 50.0;
  static constexpr double fraction = 0.1, uncertainty = 0.05, release = 0.5;
  static constexpr int confirm = 3, calm = 10;
  static constexpr double deviation = 0.001, memory = 100.0, mass_deviation = 0.02, moment_deviation = 0.01;
};
template <class R>
using Whole = Scene<R, Gravity, RotorInertia, Friction>;
template <class R>
using Rigid = Scene<R, Gravity, RotorInertia>;
template <class R>
using Loaded = Scene<R, Gravity, RotorInertia, Payload>;

/// Drives about a place inside all limits, each at its own frequency.
template <class R>
struct Sample {
  Joints<R, double> u{}, ud{}, udd{};
  Sample(const Joints<R, double>& middle, double t) {
    for (int k = 0; k < joint_count<R>; ++k) {
      const double w = 1.0 + 0.3 * k, size = 0.2;
      u[k] = middle[k] + size * std::sin(w * t + 0.5 * k);
      ud[k] = size * w * std::cos(w * t + 0.5 * k), udd[k] = -size * w * w * std::sin(w * t + 0.5 * k);
    }
  }
};
const Joints<robots::WristArm, double> wrist{0.3, 0.9, 0.2, 0.6, -0.5};
const Joints<robots::Palletiser, double> stack{0.2, 1.4, -0.6, 0.5};

/// dp/dt = tau + drift, p by differences along a motion.
template <class R>
void expect_momenta_to_change_as_told(const Joints<R, double>& middle) {
  const double t = 0.7, h = 1e-4;
  const Sample<R> now(middle, t), before(middle, t - h), after(middle, t + h);
  const auto terms = momentum_terms<Whole<R>>(now.u, now.ud);
  const auto earlier = momentum_terms<Whole<R>>(before.u, before.ud),
             later = momentum_terms<Whole<R>>(after.u, after.ud);
  const auto tau = inverse_dynamics<Whole<R>>(now.u, now.ud, now.udd);
  const auto m = mass_matrix<Whole<R>>(now.u);
  for (int k = 0; k < joint_count<R>; ++k) {
    double momentum = 0.0;
    for (int l = 0; l < joint_count<R>; ++l)
      momentum += m(k, l) * now.ud[l];
    EXPECT_NEAR(terms.momentum[k], momentum, 1e-12 * (1.0 + std::fabs(momentum)));
    const double slope = (later.momentum[k] - earlier.momentum[k]) / (2.0 * h);
    EXPECT_NEAR(slope, tau[k] + terms.drift[k], 1e-6 * (1.0 + std::fabs(tau[k]))) << k;
  }
  EXPECT_TRUE(terms.status.ok());
  auto none = now.u;
  none[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(momentum_terms<Whole<R>>(none, now.ud).status.code, Status::Code::not_finite);
}

/// One effort by itself.
template <class R, int K>
void expect_one_effort(const Joints<R, double>& middle) {
  const Sample<R> at(middle, 0.3);
  const auto tau = inverse_dynamics<Whole<R>>(at.u, at.ud, at.udd), held = gravity_torque<Whole<R>>(at.u);
  EXPECT_EQ((joint_torque<Whole<R>, K>(at.u, at.ud, at.udd)), tau[K]);
  EXPECT_EQ((gravity_torque<Whole<R>, K>(at.u)), held[K]);
}

}  // namespace

TEST(SharedDriveMomenta, ChangeByEffortsAndDrift) {
  expect_momenta_to_change_as_told<robots::WristArm>(wrist);
  expect_momenta_to_change_as_told<robots::Palletiser>(stack);
}
TEST(SharedDriveEfforts, OfOneDriveAreThoseOfAll) {
  expect_one_effort<robots::WristArm, 3>(wrist);
  expect_one_effort<robots::WristArm, 1>(wrist);
  expect_one_effort<robots::Palletiser, 2>(stack);
}
TEST(SharedDriveObserver, SeesWhatPushesADriveAndNamesIt) {
  using R = robots::WristArm;
  ObserverState<Whole<R>, double, Watching> state;
  CollisionState collision;
  Collision found;
  for (int k = 0; k < 1000; ++k) {
    const Sample<R> now(wrist, k * 1e-3), middle(wrist, (k - 0.5) * 1e-3);
    auto tau = inverse_dynamics<Whole<R>>(middle.u, middle.ud, middle.udd);
    tau[2] -= k > 500 ? 8.0 : 0.0;  // the environment gives the rest
    ASSERT_TRUE(observe(state, now.u, now.ud, tau).ok());
    found = detect(collision, state.residual);
    if (k == 500) {
      EXPECT_FALSE(found.detected);
    }
  }
  for (int k = 0; k < joint_count<R>; ++k)
    EXPECT_NEAR(state.residual[k], k == 2 ? 8.0 : 0.0, 2e-3) << k;
  EXPECT_TRUE(found.detected);
  EXPECT_EQ(found.joint, 2);
}
TEST(SharedDriveObserver, HoldsSamplesAgainstLimitsOfJoints) {
  using R = robots::WristArm;
  ObserverState<Whole<R>, double, Watching> state;
  auto far = wrist;
  far[3] = 2.2, far[4] = 2.2;  // inside the drives' limits; the pitch stands at 2.2
  const auto status = observe(state, far, Joints<R, double>{}, Joints<R, double>{});
  EXPECT_EQ(status.code, Status::Code::position_limit);
  EXPECT_EQ(status.joint, 3);
}
/// What an estimator finds of a payload that drives carry about the wrist's place.
PayloadEstimate<double> weigh(const PayloadBody<double>& payload) {
  using R = robots::WristArm;
  using S = Rigid<R>;
  ObserverState<S, double, Watching> observer;
  PayloadState<S, double> state;
  Inputs<Loaded<R>, double> in;
  in.payload = payload;
  for (int k = 0; k < 4000; ++k) {
    const Sample<R> now(wrist, k * 1e-3), middle(wrist, (k - 0.5) * 1e-3);
    const auto tau = inverse_dynamics<Loaded<R>>(middle.u, middle.ud, middle.udd, in);
    EXPECT_TRUE(observe(observer, now.u, now.ud, tau).ok());
    EXPECT_TRUE((update_payload<S, double, Watching>(state, now.u, now.ud, observer.residual).ok()));
  }
  return estimate<Watching>(state);
}
TEST(SharedDriveObserver, HasThresholdsOfDrives) {
  using S = Whole<robots::Palletiser>;  // drive 3 is joint 9's
  EXPECT_EQ((collision_thresholds_of<S, double, Watching>.enter[3]), 0.1 * 300.0 + 0.05);
  EXPECT_EQ((detail::residual_deviation<S, Watching>(3)), 0.001 * 300.0);
}
TEST(SharedDrivePayload, IsWeighedThroughTheDifferential) {
  const auto point = weigh({1.2, {}, {}});
  EXPECT_TRUE(point.status.ok());
  EXPECT_NEAR(point.mass, 1.2, 1e-5);
  EXPECT_NEAR(point.first_moment.z, 0.0, 1e-5);
  const auto far = weigh({1.2, {0.02, -0.01, 0.05}, {}});  // its inertia about the tool point is left out
  EXPECT_NEAR(far.mass, 1.2, 2e-3);
  EXPECT_NEAR(far.first_moment.z, 1.2 * 0.05, 2e-3);
  EXPECT_NEAR(far.first_moment.x, 1.2 * 0.02, 2e-3);
}
TEST(SharedDriveTracking, AddsFeedbackOfDrivesAndFallsBackToGravity) {
  using R = robots::WristArm;
  using S = Whole<R>;
  const Sample<R> at(wrist, 0.2);
  SafeLoopState<S, double> state;
  TrackingGains<S, double> gains;
  for (int k = 0; k < joint_count<R>; ++k)
    gains.stiffness[k] = 2.0 + k, gains.damping[k] = 0.1;
  MeasuredMotion<S, double> measured{at.u, at.ud, {}};
  measured.q[4] -= 0.01, measured.qd[3] += 0.5;
  const Request<S, double> desired{at.u, at.ud, at.udd, {}};
  const auto followed = track(state, desired, measured, gains);
  const auto tau = inverse_dynamics<S>(at.u, at.ud, at.udd);
  EXPECT_TRUE(followed.status.ok());
  EXPECT_NEAR(followed.tau[4], tau[4] + 6.0 * 0.01, 1e-12);
  EXPECT_NEAR(followed.tau[3], tau[3] - 0.1 * 0.5, 1e-12);
  auto beyond = desired;
  beyond.q[3] = beyond.q[4] = 3.0;  // the pitch beyond 1.9
  const auto held = track(state, beyond, measured, gains);
  EXPECT_EQ(held.status.code, Status::Code::position_limit);
  const auto gravity = gravity_torque<S>(measured.q);
  SafeLoopState<S, double> guided;
  const auto carried = compensate_gravity(guided, measured.q);
  for (int k = 0; k < joint_count<R>; ++k) {
    EXPECT_EQ(held.tau[k], gravity[k]);
    EXPECT_EQ(carried.tau[k], gravity[k]);
  }
}
TEST(SharedDriveFriction, IsOfTheDriveBesideItsRotor) {
  using R = robots::WristArm;
  const Sample<R> at(wrist, 0.2);
  const auto q = joint_positions<R>(at.u);
  const auto of_links =
      inverse_dynamics<Scene<JointCoordinates<R>, Gravity>>(q, joint_rates<R>(at.ud), joint_rates<R>(at.udd));
  const auto felt = drive_efforts<R>(of_links), tau = inverse_dynamics<Whole<R>>(at.u, at.ud, at.udd);
  for (int k = 0; k < joint_count<R>; ++k) {
    const auto& drive = R::chain.links[k];
    const double rotor = drive.gear * drive.gear * drive.rotor_inertia * at.udd[k];
    const double friction = drive.viscous * at.ud[k] + (at.ud[k] > 0 ? drive.coulomb_forward : drive.coulomb_backward);
    EXPECT_NEAR(tau[k], felt[k] + rotor + friction, 1e-12);
  }
}

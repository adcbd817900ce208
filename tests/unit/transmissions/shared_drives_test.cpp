// Joints that share drives: what a description makes of them, limits on either side, bad numbers, cost.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/cost.hpp>
#include <axial/simulation/integrators.hpp>
#include <cmath>
#include <limits>
#include <robots/robots.hpp>

using namespace axial;

namespace {

constexpr auto body = revolute().a(0.25).mass(1).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01);

struct Named {  // joint 1 follows joint 2, which follows joint 0; joint 3 has no drive of its own
  static constexpr auto chain = axial::chain(body, body.mimic(2, 2.0, 1.0), body.mimic(0, -3.0, 0.5),
                                             body.passive().driven_by(0, 0.25).driven_by(4), body.driven_by(4, 5.0));
};
struct Limited {
  static constexpr auto chain = axial::chain(
      gravity(0, 0, -9.81), body.position_limits(-1, 1).speed_limit(2).acceleration_limit(10).effort_limit(50),
      body.driven_by(0, -1.0)
          .position_limits(-0.5, 0.5)
          .speed_limit(3)
          .acceleration_limit(20)
          .effort_limit(20)
          .drive_limits(-1.25, 1.25, 4.0, 30.0));
};
struct Alone {
  static constexpr auto chain = axial::chain(body, body);
};
struct NamedAlone {
  static constexpr auto chain = axial::chain(body, body, drive_ratios<2>({{1, 0}, {0, 1}}));
};

struct Sprung {
  static constexpr auto chain = axial::chain(gravity(0, 0, -9.81), body.rotor_inertia(1e-4, 10).viscous(0.1),
                                             body.passive().driven_by(0, -1.0).driven_by(2).spring(1e9, 0.25),
                                             body.rotor_inertia(1e-4, 10).viscous(0.1));
};

/// A robot as if its joints had drives of their own.
template <class R>
struct Uncoupled {
  static constexpr auto chain = [] {
    auto chain = R::chain;
    for (auto& link : chain.links)
      link.drives = {}, link.drive_min = -LinkParameters::unlimited,
      link.drive_max = link.drive_speed_limit = link.drive_acceleration_limit = LinkParameters::unlimited;
    return chain;
  }();
};

template <class R>
constexpr int operations() {
  return cost<R>(algorithm::inverse_dynamics).total();
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST(DriveMatrix, IsWhatLinksName) {
  constexpr auto g = drive_matrix_of(Named::chain.links);
  ASSERT_EQ(g.drives, 2);
  EXPECT_EQ(g.owner[0], 0);
  EXPECT_EQ(g.owner[1], 4);
  const double ratio[5][2] = {{1, 0}, {-6, 0}, {-3, 0}, {0.25, 1}, {0, 5}}, offset[5] = {0, 2, 0.5, 0, 0};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(g.offset[i], offset[i]) << i;
    for (int k = 0; k < 2; ++k)
      EXPECT_EQ(g.ratio[i][k], ratio[i][k]) << i << k;
  }
  EXPECT_EQ(joint_count<Named>, 2);
  EXPECT_EQ(link_count<Named>, 5);
  EXPECT_EQ(joint_count<JointCoordinates<Named>>, 5);
  const auto q = joint_positions<Named>(Joints<Named, double>{0.5, 2.0});
  EXPECT_EQ(q[1], -1.0);
  EXPECT_EQ(q[3], 2.125);
  EXPECT_EQ(q[4], 10.0);
}
TEST(DriveMatrix, KnowsDriversThatDoTheSame) {
  constexpr LinkParameters same[2] = {body.passive().driven_by(0).driven_by(1).parameters(),
                                      body.passive().driven_by(0).driven_by(1).parameters()};
  EXPECT_FALSE(drive_matrix_of(same).moves_all());
  constexpr LinkParameters other[2] = {body.passive().driven_by(0).driven_by(1).parameters(),
                                       body.passive().driven_by(0).driven_by(1, -1.0).parameters()};
  EXPECT_TRUE(drive_matrix_of(other).moves_all());
}
TEST(DriveMatrix, OfOnesIsTheRobotItself) {
  const Joints<NamedAlone, double> u{0.5, -1}, v{2, 3}, a{-4, 5};
  const Joints<Alone, double> q{0.5, -1}, qd{2, 3}, qdd{-4, 5};
  const auto driven = inverse_dynamics<NamedAlone>(u, v, a);
  const auto alone = inverse_dynamics<Alone>(q, qd, qdd);
  EXPECT_EQ(driven[0], alone[0]);
  EXPECT_EQ(driven[1], alone[1]);
  EXPECT_EQ(operations<NamedAlone>(), operations<Alone>());
}

TEST(SharedDriveLimits, HoldForDrivesAndForJoints) {
  using R = Limited;
  using J = Joints<R, double>;
  using Code = Status::Code;
  const auto request = [](const J& u, const J& v, const J& a) { return check_request<R>(u, v, a); };
  EXPECT_TRUE(request({0.5, 0.25}, {1, 1}, {1, 1}).ok());
  const auto drive = request({1.0, 1.3}, {}, {});
  EXPECT_EQ(drive.code, Code::position_limit) << "of the drive: its joint stands at 0.3";
  EXPECT_EQ(drive.joint, 1);
  const auto joint = request({-0.5, 0.25}, {}, {});
  EXPECT_EQ(joint.code, Code::position_limit) << "of the joint, which stands at 0.75";
  EXPECT_EQ(joint.joint, 1);
  EXPECT_EQ(request({}, {-1.5, 2}, {}).code, Code::speed_limit);
  EXPECT_EQ(request({}, {}, {-9, 12}).code, Code::acceleration_limit);
  EXPECT_EQ(check_position<R>(J{-0.5, 0.25}).code, Code::position_limit);
  EXPECT_EQ(request({no_number, 0}, {}, {}).code, Code::not_finite);
  EXPECT_EQ(request({0, no_number}, {}, {}).joint, 1);
}
TEST(SharedDriveLimits, FeedForwardClampsEffortsOfDrivesAndFallsBack) {
  using R = Limited;
  FeedforwardState<R, double> state{};
  const auto fine = feedforward<R>(state, Joints<R, double>{0.25, 0.125}, {}, {});
  EXPECT_TRUE(fine.status.ok());
  const auto bad = feedforward<R>(state, Joints<R, double>{-0.5, 0.25}, {}, {});
  EXPECT_EQ(bad.status.code, Status::Code::position_limit);
  EXPECT_EQ(bad.tau[0], fine.tau[0]) << "the last safe torque";
}
TEST(SharedDrives, WhatIsNoNumberIsSeen) {
  using R = robots::WristArm;
  const Joints<R, double> fine{0.1, 0.2, 0.3, 0.4, 0.5};
  for (int k = 0; k < 5; ++k)
    for (const double bad : {no_number, std::numeric_limits<double>::infinity()}) {
      auto none = fine;
      none[k] = bad;
      if (k > 0) {
        EXPECT_FALSE(check_finite(inverse_dynamics<R>(none, fine, fine)).ok()) << k;
      }  // 0: about the vertical
      EXPECT_FALSE(check_finite(inverse_dynamics<R>(fine, none, fine)).ok()) << k;
      EXPECT_FALSE(check_finite(inverse_dynamics<R>(fine, fine, none)).ok()) << k;
      EXPECT_FALSE(forward_dynamics<R>(none, fine, fine).status.ok()) << k;
      EXPECT_FALSE(forward_dynamics<R>(fine, none, fine).status.ok()) << k;
      EXPECT_FALSE(forward_dynamics<R>(fine, fine, none).status.ok()) << k;
      EXPECT_FALSE(forward_kinematics<R>(none).status.ok()) << k;
      EXPECT_FALSE(jacobian<R>(none).status.ok()) << k;
    }
}
TEST(ScrewAndSpline, HoldTheQuillByTheNutAndTheSplineAgainstIt) {
  using R = robots::ScaraQuill;
  const auto held = gravity_torque<R>(Joints<R, double>{0.3, -0.4, 20.0, 1.0});
  const double weight = (0.95 + 0.60) * 9.81, lead = 0.020 / 6.283185307179586;
  EXPECT_NEAR(held[2], -weight * lead, 1e-15);  // down is positive
  EXPECT_NEAR(held[3], weight * lead, 1e-15);
  const auto q = joint_positions<R>(Joints<R, double>{0, 0, 7.0, 7.0});
  EXPECT_NEAR(q[2], 0.0, 1e-17) << "turning both turns the quill alone";
  EXPECT_EQ(q[3], 7.0);
}
TEST(Differential, SharesTorqueAndAddsSpeeds) {
  using R = robots::WristArm;
  const auto qd = joint_rates<R>(Joints<R, double>{0, 1, 0.5, 3, 1});
  EXPECT_EQ(qd[2], -0.5);
  EXPECT_EQ(qd[3], 2.0);
  EXPECT_EQ(qd[4], 1.0);
  const auto tau = drive_efforts<R>(Joints<JointCoordinates<R>, double>{0, 0, 0, 4, 1});
  EXPECT_EQ(tau[3], 2.5);
  EXPECT_EQ(tau[4], 1.5);
}
TEST(SharedDrives, AForceOnEachFingerIsFeltByTheDriveOfBoth) {
  using S = Scene<robots::Gripper, ExternalWrenches>;
  Inputs<S, double> in{};
  static_assert(sizeof(in.wrenches) == 3 * 6 * sizeof(double), "one per link");
  in.wrenches[1].force.z = -20.0, in.wrenches[2].force.z = -5.0;  // against their slides
  const auto held = gravity_torque<S>({0.3, 0.02}, in);
  EXPECT_NEAR(held[1], 25.0, 1e-13);
  EXPECT_NEAR(held[0], 0.0, 1e-13) << "slides across the roll's axis, through it";
}
TEST(SharedDrives, PairsOfTheCallerAreOfTheJoints) {
  using R = robots::WristArm;
  const Joints<R, double> u{0.1, 0.2, 0.3, 0.4, 0.5}, v{1, 2, 3, 4, 5}, somewhere{2, 2, 2, 2, 2};
  Inputs<Scene<R, Gravity, SineCosines>, double> in{};
  in.turns = sine_cosines<JointCoordinates<R>>(joint_positions<R>(u));
  const auto tau = inverse_dynamics<Scene<R, Gravity, SineCosines>>(somewhere, v, v, in);
  const auto wanted = inverse_dynamics<Scene<R, Gravity>>(u, v, v);
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(tau[k], wanted[k], 1e-13) << k;
}
/// Two parallel axes and a third across them; the belt of the second brings the turn of the first back. The rotor of
/// the second's drive stands upright on the first link, that of the third lies there.
struct Spinning {
  static constexpr auto chain = axial::chain(body, body.rotor_inertia(1e-3, 20).rotor_axis(0, 0, 2).driven_by(0, -1.0),
                                             body.alpha_deg(90).rotor_inertia(1e-3, -10).rotor_axis(1, 0, 0, 1));
};
TEST(SharedDrives, RotorsAsBodiesTurnByTheirDrivesOnLinksThatJointsCarry) {
  using Without = Scene<Spinning, RotorInertia>;
  using With = Scene<Spinning, RotorInertia, RotorDynamics>;
  using J = Joints<Spinning, double>;
  const J u{0.3, 0.5, 0.7};
  const auto added = [&](const J& ud, const J& udd) {
    const auto with = inverse_dynamics<With>(u, ud, udd), without = inverse_dynamics<Without>(u, ud, udd);
    return J{with[0] - without[0], with[1] - without[1], with[2] - without[2]};
  };
  const auto expect = [](const J& found, const J& wanted) {
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(found[k], wanted[k], 1e-13) << k;
  };
  // 1/2 J (w + 20 u1')^2 of the second's, w = u0': 0.02 u0' u1' beside what each has alone.
  expect(added({}, {0, 3, 0}), {0.06, 0, 0});
  expect(added({}, {5, 0, 0}), {0, 0.1, 0});
  // The third's lies across all turning of its carrier, the second link, which by its belt turns as u1 alone.
  expect(added({}, {0, 0, 7}), {0, 0, 0});
  expect(added({1, 2, 3}, {}), {0, 0, 0});
  const auto m = mass_matrix<With>(u), alone = mass_matrix<Without>(u);
  EXPECT_NEAR(m(1, 0) - alone(1, 0), 0.02, 1e-14);
  EXPECT_NEAR(m(2, 1) - alone(2, 1), 0.0, 1e-14);
  EXPECT_NEAR(m(0, 0) - alone(0, 0), 0.0, 1e-14);
}
/// A lift in two stages on a turntable: nothing but the upright rotor of its drive couples it to the turn.
struct Lift {
  static constexpr auto slide = prismatic().mass(1).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01);
  static constexpr auto chain = axial::chain(body, slide.rotor_inertia(1e-3, 20), slide.mimic(1));
};
template <class R>
void expect_solved_with_rotors() {
  using S = Scene<R, Gravity, RotorInertia, RotorDynamics>;
  Joints<R, double> u{}, ud{}, udd{};
  for (int k = 0; k < joint_count<R>; ++k)
    u[k] = 0.3 + 0.2 * k, ud[k] = 4.0 - 2.5 * k, udd[k] = 7.0 * (k - 1);
  const auto answer = forward_dynamics<S>(u, ud, inverse_dynamics<S>(u, ud, udd));
  EXPECT_TRUE(answer.status.ok());
  for (int k = 0; k < joint_count<R>; ++k)
    EXPECT_NEAR(answer[k], udd[k], 1e-9) << R::chain.size << ' ' << k;
}
TEST(SharedDrives, RotorsAsBodiesAreSolvedFor) {
  expect_solved_with_rotors<Spinning>();
  expect_solved_with_rotors<Lift>();
  expect_solved_with_rotors<robots::ScaraQuill>();
  expect_solved_with_rotors<robots::WristArm>();
}
TEST(SharedDrives, ForwardDynamicsUndoesInverseDynamicsWithColumnsOfM) {
  using R = robots::WristArm;
  const Joints<R, double> u{0.1, 0.2, 0.3, 0.4, 0.5}, ud{1, -2, 0.5, 3, -1}, udd{4, 3, -2, 1, 8};
  const auto tau = inverse_dynamics<R>(u, ud, udd), bias = bias_torque<R>(u, ud);
  const auto answer = forward_dynamics<R>(u, ud, tau);
  const auto m = mass_matrix<R>(u);
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(answer[k], udd[k], 1e-12);
    double sum = bias[k];
    for (int l = 0; l < 5; ++l)
      sum += m(k, l) * udd[l];
    EXPECT_NEAR(sum, tau[k], 1e-12);
  }
  EXPECT_TRUE(answer.status.ok());
}
TEST(SharedDrives, ExplicitIntegratorsMoveDrives) {
  using R = robots::WristArm;
  using Free = Scene<R, RotorInertia>;
  const auto energy = [](const auto& x) {
    const auto m = mass_matrix<Free>(x.q);
    double twice = 0.0;
    for (int k = 0; k < 5; ++k)
      for (int l = 0; l < 5; ++l)
        twice += m(k, l) * x.qd[k] * x.qd[l];
    return twice / 2;
  };
  CompensatedMotion<Free, double> x{};
  x.q = {0.1, 0.2, 0.3, 0.4, 0.5}, x.qd = {1, -1, 0.5, 2, 1};
  const double before = energy(x);
  for (int i = 0; i < 1000; ++i)
    ASSERT_TRUE(advance<RungeKutta4>(x, 1e-3, [](const auto&, auto&, auto&) {}).ok());
  EXPECT_GT(std::abs(x.q[0] - 0.1), 0.5);
  EXPECT_NEAR(energy(x), before, 1e-9 * before);
}
// A spring of 1e9 across a joint that the drive of another moves, and a drive held as stiffly, at steps of 10 ms; and
// first order towards a step that resolves all.
TEST(SharedDrives, LinearlyImplicitStepsHoldStiffSpringsAndDrives) {
  using S = Scene<Sprung, Gravity, RotorInertia, Friction, JointSprings>;
  Motion<S, double> x{};
  x.q = {0.5, -0.5};
  for (int i = 0; i < 200; ++i)
    ASSERT_TRUE(advance<LinearlyImplicitEuler>(x, 1e-2, [](const auto& at, auto& tau, auto&, auto& drive) {
                  tau[1] = 1e8 * (0.3 - at.q[1]), drive.stiffness[1] = 1e8;
                }).ok());
  EXPECT_NEAR(x.q[1], 0.3, 1e-6);
  EXPECT_NEAR(x.q[1] - x.q[0], 0.25, 1e-6) << "the spring's rest";
}
TEST(SharedDrives, LinearlyImplicitStepsAreOfFirstOrder) {
  using S = Scene<robots::WristArm, Gravity, RotorInertia>;
  const auto end = [](auto method, int steps) {
    Motion<S, double> x{};
    x.q = {0.3, 0.4, 0.5, 0.6, 0.7}, x.qd = {0.5, 0.5, 0.5, 0.5, 0.5};
    for (int i = 0; i < steps; ++i)
      EXPECT_TRUE(advance<decltype(method)>(x, 0.05 / steps, [](const auto& at, auto& tau, auto&, auto& drive) {
                    for (int k = 0; k < 5; ++k) {
                      tau[k] = 100 * (0.5 - at.q[k]) - 4 * at.qd[k];
                      drive.stiffness[k] = 100, drive.damping[k] = 4;
                    }
                  }).ok());
    return x.q;
  };
  const auto exact = end(RungeKutta4{}, 500), once = end(LinearlyImplicitEuler{}, 100),
             twice = end(LinearlyImplicitEuler{}, 200);
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR((once[k] - exact[k]) / (twice[k] - exact[k]), 2.0, 0.15) << k;
}
TEST(SharedDrives, ARunTimeModelOfThemIsTheRobot) {
  using R = robots::Palletiser;
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  using M = Model<12, Gravity, RotorInertia, Friction, SharedDrives>;
  M model;
  for (int i = 0; i < R::chain.size; ++i)
    EXPECT_TRUE(model.add(R::chain.links[i]));
  model.set_gravity(R::chain.gravity.x, R::chain.gravity.y, R::chain.gravity.z);
  ASSERT_EQ(model.size(), 4);
  EXPECT_EQ(model.link_count(), 10);
  EXPECT_TRUE(model.drives_are_sound());
  const Joints<R, double> u{0.3, 1.2, -0.4, 0.6}, ud{1, -0.5, 0.75, 2}, udd{3, 1, -2, 4};
  Joints<M, double> q{}, qd{}, qdd{};
  for (int k = 0; k < 4; ++k)
    q[k] = u[k], qd[k] = ud[k], qdd[k] = udd[k];
  const auto tau = inverse_dynamics<S>(u, ud, udd);
  const auto efforts = inverse_dynamics(model, q, qd, qdd);
  const auto answer = forward_dynamics(model, q, qd, efforts);
  const auto m = mass_matrix<S>(u);
  const auto by_model = mass_matrix(model, q);
  const auto columns = jacobian<S>(u);
  const auto model_columns = jacobian(model, q);
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(efforts[k], tau[k], 1e-11);
    EXPECT_NEAR(answer[k], udd[k], 1e-11);
    EXPECT_NEAR(model_columns[k].linear.z, columns[k].linear.z, 1e-14);
    for (int l = 0; l < 4; ++l)
      EXPECT_NEAR(by_model(k, l), m(k, l), 1e-11);
  }
}
TEST(SharedDrives, SeparatedTermsAreInverseDynamicsWithAOfTheDrives) {
  using R = robots::WristArm;
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  const Joints<R, double> u{0.1, 0.2, 0.3, 0.4, 0.5}, ud{1, -2, 0.5, 3, -1}, udd{4, 3, -2, 1, 8};
  const auto terms = separate<S>(u);
  const auto m = mass_matrix<S>(u);
  const auto tau = inverse_dynamics<S>(u, ud, udd), sum = torque(terms, ud, udd), held = gravity_torque<S>(u);
  const auto b = separate_B<S>(u);
  EXPECT_TRUE(terms.status.ok());
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(sum[k], tau[k], 1e-13);
    EXPECT_NEAR(terms.G[k], held[k], 1e-14);
    for (int l = 0; l < 5; ++l)
      EXPECT_NEAR(terms.A[k][l], m(k, l), 1e-14);
    for (int pair = 0; pair < terms.pairs; ++pair)
      EXPECT_EQ(b.B[k][pair], terms.B[k][pair]);
  }
  const auto by_loops = separate<Scene<R, Gravity, RotorInertia, Friction, Looped>>(u);
  for (int k = 0; k < 5; ++k)
    for (int pair = 0; pair < terms.pairs; ++pair) {
      EXPECT_NEAR(by_loops.B[k][pair], terms.B[k][pair], 1e-14);
      EXPECT_NEAR(by_loops.C[k][pair / 2], terms.C[k][pair / 2], 1e-14);
    }
  // Each coefficient by itself: of one rate, and of two.
  const auto at = [&](const Joints<R, double>& rates) { return bias_torque<Scene<R>>(u, rates); };
  const auto one = at({0, 1, 0, 0, 0}), other = at({0, 0, 0, 1, 0}), both = at({0, 1, 0, 1, 0});
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(terms.C[k][1], one[k], 1e-14);
    EXPECT_NEAR(terms.B[k][terms.pair(1, 3)], both[k] - one[k] - other[k], 1e-14);
  }
}
TEST(SharedDrives, ARunTimeModelTellsDrivesThatAreNotThere) {
  Model<3> without;
  EXPECT_TRUE(without.add(body));
  EXPECT_FALSE(without.add(body.driven_by(0, -1.0))) << "its features do not name SharedDrives";
  Model<3, SharedDrives> model;
  EXPECT_TRUE(model.add(body.driven_by(1, -1.0)));
  EXPECT_FALSE(model.drives_are_sound()) << "joint 1 is not there yet";
  EXPECT_TRUE(model.add(body));
  EXPECT_TRUE(model.drives_are_sound());
}
TEST(SharedDriveLimits, NameTheDriveThatMovesAJointWithoutOne) {
  using R = robots::Palletiser;
  const auto low = check_request<R>(Joints<R, double>{0, 0.4, 0.4, 0}, {}, {});  // the elbow stretched: joint 4 at 0
  EXPECT_EQ(low.code, Status::Code::position_limit);
  EXPECT_EQ(low.joint, 1);
}
TEST(SharedDrives, CostFewOperations) {
  EXPECT_LE(operations<robots::ScaraQuill>(), operations<Uncoupled<robots::ScaraQuill>>() + 8);
  EXPECT_LE(operations<robots::WristArm>(), operations<Uncoupled<robots::WristArm>>() + 26) << "with a belt";
  EXPECT_LE(operations<robots::Gripper>(), operations<Uncoupled<robots::Gripper>>() + 1);
}

// Energy: of bodies whose heights and speeds are known, and that work is what changes it.
#include <axial/axial.hpp>
#include <axial/simulation/energy.hpp>
#include <axial/simulation/integrators.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <robots/palletiser.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

namespace {

using namespace axial;

constexpr double length = 0.8, weight = 2.0, pull = 9.81, spring = 30.0, rested = 0.2, rotor = 3e-4, gear = 20.0;
/// A point mass on a rod that stands at q = 0 along x, under gravity along -y, sprung, geared.
struct Rod {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -pull, 0.0),
                   revolute().mass(weight).com(length, 0.0, 0.0).rotor_inertia(rotor, gear).spring(spring, rested));
};
using Sprung = Scene<Rod, Gravity, RotorInertia, JointSprings>;

/// Work of efforts on a robot's joints in a motion, beside what its energy changes by.
template <class S>
void expect_work_to_be_energy(Motion<S, double> x) {
  constexpr int n = joint_count<S>;
  constexpr double h = 1e-4;
  const auto effort = [](int i, double time) { return (i + 1) * std::cos(3.0 * time + i); };
  const auto driven = [&](const auto& at, auto& tau, auto&) {
    for (int i = 0; i < n; ++i)
      tau[i] = effort(i, at.time);
  };
  const auto power = [&] {
    double sum = 0.0;
    for (int i = 0; i < n; ++i)
      sum += effort(i, x.time(h)) * x.qd[i];
    return sum;
  };
  const double before = energy<S>(x.q, x.qd).total();
  double work = 0.0, last = power();
  for (int k = 0; k < 3000; ++k) {
    ASSERT_TRUE(advance<RungeKutta4>(x, h, driven).ok());
    const double now = power();
    work += 0.5 * h * (last + now), last = now;  // off by h^2
  }
  EXPECT_NEAR(energy<S>(x.q, x.qd).total() - before, work, 1e-6);
  EXPECT_GT(std::fabs(work), 1e-2) << "then nothing was done";
}

}  // namespace

TEST(Energy, OfAPointMassIsTheTextbooks) {
  for (const double q : {-1.0, 0.0, 0.7}) {
    const double qd = 1.5;
    const auto found = energy<Sprung>(Joints<Rod, double>{q}, Joints<Rod, double>{qd});
    EXPECT_NEAR(found.kinetic, 0.5 * (weight * length * length + gear * gear * rotor) * qd * qd, 1e-14);
    EXPECT_NEAR(found.potential, weight * pull * length * std::sin(q) + 0.5 * spring * (q - rested) * (q - rested),
                1e-13);
    EXPECT_EQ(found.total(), found.kinetic + found.potential);
    EXPECT_TRUE(found.status.ok());
  }
  EXPECT_EQ(energy<Sprung>(Joints<Rod, double>{std::nan("")}, Joints<Rod, double>{0.0}).status.code,
            Status::Code::not_finite);
}

TEST(Energy, HasThePayloads) {
  using Loaded = Scene<robots::Puma560, Gravity, RotorInertia, Payload>;
  Inputs<Loaded, double> in;
  const Joints<robots::Puma560, double> q{0.3, -0.7, 1.9, 0.2, 0.4, -0.5}, still{};
  const auto without = energy<Loaded>(q, still, in);
  in.payload = {1.5, {0.0, 0.0, 0.1}, {0.01, 0.01, 0.01, 0.0, 0.0, 0.0}};
  const auto poses = forward_kinematics<Loaded>(q, in);
  const double height = poses.frames[5].position.z + dot(Vec3{0.0, 0.0, 0.1}, poses.frames[5].rotation.z);
  EXPECT_NEAR(energy<Loaded>(q, still, in).potential - without.potential, 1.5 * 9.81 * height, 1e-12);
}

TEST(Energy, ChangesByWork) {
  Motion<robots::Scara, double> scara;
  scara.q = {0.3, 0.9, 0.1}, scara.qd = {0.5, -0.4, 0.1};
  expect_work_to_be_energy(scara);
  Motion<Scene<robots::Puma560, Gravity, RotorInertia>, double> puma;
  puma.q = {0.3, 1.2, 1.4, 0.2, 0.4, -0.5}, puma.qd = {0.5, 0.1, -0.4, 0.6, -0.2, 0.3};
  expect_work_to_be_energy(puma);
  Motion<robots::Palletiser, double> drives;  // that joints share
  drives.q[0] = 0.2, drives.qd[1] = 0.3;
  expect_work_to_be_energy(drives);
}

TEST(Energy, OfAModelIsThatOfItsType) {
  Model<6> model;
  for (const auto& link : robots::Puma560::chain.links)
    ASSERT_TRUE(model.add(link));
  model.set_gravity(0.0, 0.0, -9.81);
  const Joints<robots::Puma560, double> q{0.3, -0.7, 1.9, 0.2, 0.4, -0.5}, qd{1.0, 0.5, -0.5, 2.0, 1.0, -1.0};
  Joints<Model<6>, double> own_q{}, own_qd{};
  for (int i = 0; i < 6; ++i)
    own_q[i] = q[i], own_qd[i] = qd[i];
  const auto type = energy<robots::Puma560>(q, qd), run_time = energy(model, own_q, own_qd);
  EXPECT_NEAR(type.kinetic, run_time.kinetic, 1e-12);
  EXPECT_NEAR(type.potential, run_time.potential, 1e-12);
}

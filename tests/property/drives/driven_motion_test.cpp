// Plants whose joints share drives: their motion against Runge-Kutta steps of Lagrange's equations of all joints with
// their couplings as constraints, multipliers and all, in 113 bits; their energy, their stops, the ground.
#include <host_sim/plants/simulation/integrate.hpp>
#include <host_sim/plants/simulation/plant.hpp>

#include <cstdio>

#include "constrained.hpp"

namespace {

using namespace constrained;
namespace simulation = host_sim::simulation;
using simulation::DrivenModel;
using simulation::DrivenMotion;
using Values = axial::Joints<DrivenModel, double>;
using Stiffness = axial::DriveStiffness<DrivenModel, double>;

Values values(const std::vector<double>& from) {
  Values to{};
  std::copy(from.begin(), from.end(), to.values);
  return to;
}

/// A pose in the middle of what the drives may, moving at a quarter of their speeds.
struct Start {
  std::vector<double> u, ud, tau;
};
template <class R>
Start start_of(const std::vector<int>& owner) {
  Start s;
  for (std::size_t k = 0; k < owner.size(); ++k) {
    constexpr auto& drives = axial::scene_of<R>::Robot::chain.links;
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    s.u.push_back(0.5 * (drives[k].position_min + drives[k].position_max) + 0.1 * sign);
    s.ud.push_back(0.25 * sign * drives[k].speed_limit);
    s.tau.push_back(0.1 * sign * R::chain.links[owner[k]].effort_limit);
  }
  return s;
}

/// A Runge-Kutta step of h under held efforts, friction and all.
void constrained_step(const Constrained& exact, Vector<quad>& u, Vector<quad>& ud, const Vector<quad>& tau, quad h) {
  const auto along = [](Vector<quad> x, quad by, const Vector<quad>& d) {
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] += by * d[k];
    return x;
  };
  const auto a = exact.forward(u, ud, tau);
  const auto u1 = along(ud, h / 2, a), b = exact.forward(along(u, h / 2, ud), u1, tau);
  const auto u2 = along(ud, h / 2, b), c = exact.forward(along(u, h / 2, u1), u2, tau);
  const auto u3 = along(ud, h, c), d = exact.forward(along(u, h, u2), u3, tau);
  for (std::size_t k = 0; k < u.size(); ++k) {
    u[k] += h / 6 * (ud[k] + 2 * u1[k] + 2 * u2[k] + u3[k]);
    ud[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
  }
}

template <class R>
void expect_constrained_motion() {
  oracle::Load<quad> load;
  load.friction = true;
  const auto exact = Constrained::of<R>(load);
  const Start start = start_of<R>(exact.owner());
  const auto model = simulation::driven_model(R::name);
  ASSERT_EQ(model.size(), exact.drives());
  DrivenMotion x{values(start.u), values(start.ud), 0};
  auto u = convert<quad>(start.u), ud = convert<quad>(start.ud);
  constexpr double h = 1.0 / 1024;
  constexpr int steps = 12;
  const simulation::DriveOf<DrivenMotion> held = [&](const auto&, Values& tau, auto&, auto&) {
    tau = values(start.tau);
  };
  simulation::run(simulation::Method::rk4, model, x, h, steps, held, [](const auto&) {});
  for (int k = 0; k < steps; ++k)
    constrained_step(exact, u, ud, convert<quad>(start.tau), quad(h));
  for (std::size_t k = 0; k < u.size(); ++k) {
    const int i = static_cast<int>(k);
    const double moved = static_cast<double>(oracle::abs(u[k] - quad(start.u[k])));
    EXPECT_GT(moved, 1e-4) << k;
    EXPECT_LE(static_cast<double>(oracle::abs(u[k] - quad(x.q[i]))), 1e-12 * (1.0 + std::fabs(x.q[i]))) << k;
    EXPECT_LE(static_cast<double>(oracle::abs(ud[k] - quad(x.qd[i]))), 1e-11 * (1.0 + std::fabs(x.qd[i]))) << k;
  }
}

std::vector<axial::LinkParameters> frictionless(const std::string& robot) {
  auto links = simulation::robot_links(robot);
  for (auto& link : links)
    link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
  return links;
}

/// Largest change of energy, less the work of held efforts where there are, over the largest kinetic energy.
template <class R>
double energy_error(simulation::Method method, double h, double seconds, bool driven) {
  const Start start = start_of<R>(Constrained::of<R>().owner());
  const auto model = simulation::driven_model_of(R::name, frictionless(R::name));
  DrivenMotion x{values(start.u), values(start.ud), 0};
  const Values tau = driven ? values(start.tau) : Values{};
  const auto work = [&] {
    double sum = 0.0;
    for (int k = 0; k < model.size(); ++k)
      sum += tau[k] * (x.q[k] - start.u[static_cast<std::size_t>(k)]);
    return sum;
  };
  const simulation::DriveOf<DrivenMotion> held = [&](const auto&, Values& effort, auto&, auto&) { effort = tau; };
  const double first = simulation::energy(model, x.q, x.qd);
  double worst = 0.0, most = 0.0;
  simulation::run(method, model, x, h, std::lround(seconds / h), held, [&](const DrivenMotion& now) {
    const auto M = axial::mass_matrix(model, now.q, {});
    double kinetic = 0.0;
    for (int k = 0; k < model.size(); ++k)
      for (int l = 0; l < model.size(); ++l)
        kinetic += 0.5 * M(k, l) * now.qd[k] * now.qd[l];
    most = std::fmax(most, kinetic);
    worst = std::fmax(worst, std::fabs(simulation::energy(model, now.q, now.qd) - first - work()));
  });
  return worst / most;
}

template <class R>
void expect_energy() {
  const double coarse = energy_error<R>(simulation::Method::rk4, 4e-3, 2.0, false),
               fine = energy_error<R>(simulation::Method::rk4, 1e-3, 2.0, false),
               driven = energy_error<R>(simulation::Method::rk4, 5e-4, 0.5, true),
               symplectic = energy_error<R>(simulation::Method::semi_implicit, 1e-3, 2.0, false);
  std::printf("%s: energy off by %.2g at 4 ms, %.2g at 1 ms, under efforts %.2g, semi-implicitly %.2g\n", R::name,
              coarse, fine, driven, symplectic);
  EXPECT_LE(fine, 1e-7) << R::name;
  EXPECT_LE(fine, coarse / 100 + 1e-13) << R::name << ": of fourth order";
  EXPECT_LE(driven, 1e-8) << R::name;
  EXPECT_LE(symplectic, 0.02) << R::name;
}

}  // namespace

TEST(DrivenMotion, IsThatOfConstraintsWithMultipliers) {
  expect_constrained_motion<robots::ScaraQuill>();
  expect_constrained_motion<robots::Palletiser>();
  expect_constrained_motion<robots::WristArm>();
  expect_constrained_motion<robots::Gripper>();
}

TEST(DrivenMotion, KeepsItsEnergy) {
  expect_energy<robots::ScaraQuill>();
  expect_energy<robots::Palletiser>();
  expect_energy<robots::WristArm>();
  expect_energy<robots::Gripper>();
}

TEST(DrivenMotion, SpringsOfJointsStoreEnergyThatDrivesFeel) {
  auto links = frictionless("scara_quill");
  links[2].spring_stiffness = 4000.0, links[2].spring_rest = 0.1;  // N/m, of the slide
  const auto model = simulation::driven_model_of("scara_quill", links);
  DrivenMotion x{values({0.2, 0.3, 25.0, 0.1}), values({0.5, -0.5, 10.0, 1.0}), 0};
  const double first = simulation::energy(model, x.q, x.qd);
  double least = 1e9, most = -1e9;
  simulation::run(simulation::Method::rk4, model, x, 2.5e-4, 4000,
                  simulation::DriveOf<DrivenMotion>{[](const auto&, auto&, auto&, auto&) {}},
                  [&](const DrivenMotion& now) {
                    EXPECT_NEAR(simulation::energy(model, now.q, now.qd), first, 1e-8 * std::fabs(first));
                    const double slide = 0.020 / (2 * 3.14159265358979323846) * (now.q[2] - now.q[3]);
                    least = std::fmin(least, slide), most = std::fmax(most, slide);
                  });
  EXPECT_GT(most - least, 0.02) << "the slide swings";
}

namespace {

/// Where a robot rests that is pushed against its stops.
Values at_rest(const std::string& robot, simulation::Method method, double h, double damping, const Values& start,
               const Values& push) {
  simulation::Surroundings surroundings;
  surroundings.stops = {1e6, damping};
  const simulation::DrivenPlant plant(simulation::driven_model(robot), simulation::robot_links(robot), surroundings,
                                      [&](const auto&, Values& tau, auto&) { tau = push; });
  DrivenMotion x{start, {}, 0};
  simulation::run(method, plant.model(), x, h, std::lround(1.5 / h), std::cref(plant), [](const auto&) {});
  return x.q;
}

}  // namespace

// A drive runs into the stop of a joint that two drives move, and into its own.
TEST(DrivenPlant, RestsAgainstStopsOfItsJointsAndOfItsDrives) {
  const double lead = 0.020 / (2 * 3.14159265358979323846);
  for (const auto method : {simulation::Method::rk4, simulation::Method::linearly_implicit}) {
    const double h = method == simulation::Method::rk4 ? 2e-5 : 1e-3;
    const Values quill = at_rest("scara_quill", method, h, 50, values({0, 0, 30, 0}), values({0, 0, 1, -1.5}));
    EXPECT_NEAR(lead * (quill[2] - quill[3]), 0.200, 1e-3);
    EXPECT_GT(lead * (quill[2] - quill[3]), 0.200) << "a stop is a spring";
    EXPECT_NEAR(quill[3], -6.28, 1e-3);
    // The upper arm against its stop, the crank of the forearm against its own.
    const Values arm = at_rest("palletiser", method, h, 2e4, values({0, 1.4, -0.5, 0}), values({0, 5900, 5900, 0}));
    EXPECT_NEAR(arm[1], 2.4, 0.02);
    EXPECT_NEAR(arm[2], 0.5, 0.02);
    // The forearm's joint has room where its motor, behind a belt, is at its end.
    const Values belt = at_rest("wrist_arm", method, h, 500, values({0, 2, 2, 0, 0}), values({0, 50, 30, 0, 0}));
    EXPECT_NEAR(belt[2], 2.6, 1e-3);
    EXPECT_LT(belt[2] - belt[1], 0.3);
  }
}

TEST(DrivenPlant, StandsOnTheGroundWithWhatItsDrivesLeave) {
  // The quill, its drives let go, stands on the ground: arm links carry none of it.
  simulation::Surroundings surroundings;
  surroundings.ground = simulation::Ground{};
  const auto model = simulation::driven_model_of("scara_quill", frictionless("scara_quill"));
  const Values start = values({0.3, -0.4, 30, 0});
  surroundings.ground->height = axial::forward_kinematics(model, start, {}).tool.position.z - 0.01;
  const Values damping = values({50, 50, 1e-3, 1});
  const simulation::DrivenPlant plant(model, surroundings, [&](const auto& at, Values& tau, Stiffness& stiffness) {
    for (int k = 0; k < model.size(); ++k)
      tau[k] = -damping[k] * at.qd[k], stiffness.damping[k] = damping[k];
  });
  DrivenMotion x{start, {}, 0};
  simulation::run(simulation::Method::linearly_implicit, model, x, 1e-3, 4000, std::cref(plant), [](const auto&) {});
  EXPECT_NEAR(plant.ground_force(x.q, x.qd).z, (0.95 + 0.60) * 9.81, 0.01);
}

TEST(DrivenPlant, IsRefusedWhereItsModelDoesNotKnowDrives) {
  EXPECT_THROW(simulation::robot_model("scara_quill"), std::runtime_error);
  EXPECT_THROW(simulation::driven_model("scara"), std::runtime_error);
  for (const std::string& robot : simulation::driven_robot_names())
    EXPECT_TRUE(simulation::driven_model(robot).drives_are_sound()) << robot;
}

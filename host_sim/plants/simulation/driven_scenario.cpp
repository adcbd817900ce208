// Robots whose joints share drives, let go and moving: what becomes of their energy.
#include <host_sim/plants/simulation/integrate.hpp>
#include <host_sim/plants/simulation/rows.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <algorithm>
#include <cmath>

namespace host_sim::simulation {

namespace {

using Drives = axial::Joints<DrivenModel, double>;

constexpr double seconds = 4.0;

struct Arm {
  const char* name;
  Drives u, ud;
  double gates[2];  ///< at 4 and 2 ms: twice what was measured
};
constexpr Arm arms[] = {
    {"scara_quill", {0.3, -0.5, 25.0, 0.5}, {2.0, -1.5, 60.0, 5.0}, {2.4e-10, 1.5e-11}},
    {"palletiser", {0.1, 1.4, -0.5, 0.3}, {0.8, -0.5, 0.5, 2.0}, {8.6e-8, 5.4e-9}},
    {"wrist_arm", {0.2, 1.0, 0.3, 0.5, -0.5}, {1.0, 0.5, -1.0, 3.0, -2.0}, {6.8e-7, 4.4e-8}},
    {"gripper", {0.5, 0.02}, {2.0, 0.1}, {2.8e-10, 1.8e-11}},
};

DrivenModel frictionless(const Arm& arm) {
  auto links = robot_links(arm.name);
  for (auto& link : links)
    link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
  return driven_model_of(arm.name, links);
}

double energy_error(const Arm& arm, double h) {
  const DrivenModel model = frictionless(arm);
  const Drives rest{};
  DrivenMotion x{arm.u, arm.ud, 0};
  const double first = energy(model, x.q, x.qd);
  double worst = 0.0, most = 0.0;
  const DriveOf<DrivenMotion> free = [](const auto&, auto&, auto&, auto&) {};
  run(Method::rk4, model, x, h, std::lround(seconds / h), free, [&](const DrivenMotion& now) {
    const double all = energy(model, now.q, now.qd);
    host_sim::note_size(worst, all - first);
    most = std::max(most, all - energy(model, now.q, rest));
  });
  return worst / most;
}

}  // namespace

std::vector<Row> shared_drives() {
  std::vector<Row> rows;
  for (const Arm& arm : arms)
    for (const int milliseconds : {4, 2}) {
      const double h = milliseconds * 1e-3;
      rows.push_back(
          gated({std::string("ST24_") + arm.name, "double", name(Method::rk4), h, seconds,
                 "energy over the largest kinetic", energy_error(arm, h), arm.gates[milliseconds == 2], false, ""}));
    }
  return rows;
}

}  // namespace host_sim::simulation

#include <host_sim/simulation/plant.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace host_sim::simulation {

namespace {

/// The tool point, and how joints move it, in the world.
struct Tip {
  axial::Vec3<double> position, velocity;
  axial::Mat3<axial::Vec3<double>> link_axes;
  axial::Jacobian<Model, double> jacobian;

  Tip(const Model& model, const Values<double>& q, const Values<double>& qd) : jacobian(axial::jacobian(model, q)) {
    const auto poses = axial::forward_kinematics(model, q);
    position = poses.tool.position;
    link_axes = poses.frames[model.size() - 1].rotation;
    for (int i = 0; i < model.size(); ++i)
      velocity = velocity + qd[i] * jacobian[i].linear;
  }
};

/// A force of the ground, and its slopes: with depth, with the speed of approach, with sliding speed.
struct GroundForce {
  axial::Vec3<double> force{};
  double per_depth = 0.0, per_approach = 0.0, per_slip = 0.0;

  GroundForce(const Ground& ground, const Tip& tip) {
    const double depth = ground.height - tip.position.z;
    if (depth <= 0.0) return;
    const double grip = 1.0 - 1.5 * ground.dissipation * tip.velocity.z;
    const double normal = std::max(0.0, ground.stiffness * depth * grip);
    const double slip = std::hypot(tip.velocity.x, tip.velocity.y);
    per_depth = ground.stiffness * std::max(0.0, grip);
    per_approach = normal > 0.0 ? 1.5 * ground.stiffness * depth * ground.dissipation : 0.0;
    const double ratio = slip / ground.slip_speed;
    per_slip = ground.friction * normal / ground.slip_speed * (ratio > 1e-8 ? std::tanh(ratio) / ratio : 1.0);
    force = {-per_slip * tip.velocity.x, -per_slip * tip.velocity.y, normal};
  }
};

// w g g^T of one direction g of the tip is at most the diagonal matrix of w |g_i| sum_j |g_j|, by its quadratic forms.
// An implicit step that takes more stiffness than there is stays stable.
template <class Direction>
void add_bound(Values<double>& diagonal, const Tip& tip, int joints, double weight, Direction direction) {
  double sum = 0.0;
  for (int i = 0; i < joints; ++i)
    sum += std::fabs(direction(tip.jacobian[i].linear));
  for (int i = 0; i < joints; ++i)
    diagonal[i] += weight * sum * std::fabs(direction(tip.jacobian[i].linear));
}

}  // namespace

Plant::Plant(const Model& model, const std::vector<axial::LinkParameters>& links, const Surroundings& surroundings,
             Control<double> control)
    : Plant(model, surroundings, std::move(control)) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    low_[static_cast<int>(i)] = links[i].position_min;
    high_[static_cast<int>(i)] = links[i].position_max;
  }
}

Plant::Plant(const Model& model, const Surroundings& surroundings, Control<double> control)
    : model_(model), surroundings_(surroundings), control_(std::move(control)) {
  for (int i = 0; i < Values<double>::size; ++i) {
    low_[i] = -std::numeric_limits<double>::infinity();
    high_[i] = std::numeric_limits<double>::infinity();
  }
}

void Plant::operator()(const Instant<double>& at, Values<double>& tau, axial::Inputs<Model, double>& in,
                       Stiffness<double>& stiffness) const {
  if (control_) control_(at, tau, stiffness);
  if (surroundings_.stops.stiffness > 0.0) add_stops(at, tau, stiffness);
  if (surroundings_.ground) add_ground(at, in, stiffness);
}

axial::Vec3<double> Plant::ground_force(const Values<double>& q, const Values<double>& qd) const {
  if (!surroundings_.ground) return {};
  return GroundForce(*surroundings_.ground, Tip(model_, q, qd)).force;
}

void Plant::add_stops(const Instant<double>& at, Values<double>& tau, Stiffness<double>& stiffness) const {
  const EndStops& stop = surroundings_.stops;
  for (int i = 0; i < model_.size(); ++i) {
    const double beyond = at.q[i] > high_[i] ? at.q[i] - high_[i] : at.q[i] < low_[i] ? at.q[i] - low_[i] : 0.0;
    if (!(std::fabs(beyond) > 0.0)) continue;
    const double push = stop.stiffness * beyond + stop.damping * at.qd[i];
    if (push * beyond <= 0.0) continue;
    tau[i] -= push;
    stiffness.stiffness[i] += stop.stiffness;
    stiffness.damping[i] += stop.damping;
  }
}

void Plant::add_ground(const Instant<double>& at, axial::Inputs<Model, double>& in,
                       Stiffness<double>& stiffness) const {
  const Tip tip(model_, at.q, at.qd);
  const GroundForce ground(*surroundings_.ground, tip);
  if (!(ground.force.z > 0.0)) return;
  const auto force = axial::transpose_times(tip.link_axes, ground.force);
  in.tip_wrench = {axial::cross(model_.links<double>().tool_pose().position, force), force};
  const int n = model_.size();
  const auto x = [](const auto& v) { return v.x; };
  const auto y = [](const auto& v) { return v.y; };
  const auto z = [](const auto& v) { return v.z; };
  add_bound(stiffness.stiffness, tip, n, ground.per_depth, z);
  add_bound(stiffness.damping, tip, n, ground.per_approach, z);
  add_bound(stiffness.damping, tip, n, ground.per_slip, x);
  add_bound(stiffness.damping, tip, n, ground.per_slip, y);
}

}  // namespace host_sim::simulation

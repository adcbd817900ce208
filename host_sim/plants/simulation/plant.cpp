#include <host_sim/plants/simulation/plant.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace host_sim::simulation {

namespace {

/// The tool point, and how joints, or the drives that they share, move it, in the world.
template <class M>
struct Tip {
  using Joints = axial::Joints<M, double>;
  axial::Vec3<double> position, velocity;
  axial::Mat3<axial::Vec3<double>> link_axes;
  axial::Jacobian<M, double> jacobian;

  Tip(const M& model, const Joints& q, const Joints& qd) : jacobian(axial::jacobian(model, q, {})) {
    const auto poses = axial::forward_kinematics(model, q, {});
    position = poses.tool.position;
    link_axes = poses.frames[model.link_count() - 1].rotation;
    for (int i = 0; i < model.size(); ++i)
      velocity = velocity + qd[i] * jacobian[i].linear;
  }
};

/// A force of the ground, and its slopes: with depth, with the speed of approach, with sliding speed.
struct GroundForce {
  axial::Vec3<double> force{};
  double per_depth = 0.0, per_approach = 0.0, per_slip = 0.0;

  template <class M>
  GroundForce(const Ground& ground, const Tip<M>& tip) {
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
template <class M, class Direction>
void add_bound(axial::Joints<M, double>& diagonal, const Tip<M>& tip, int joints, double weight, Direction direction) {
  double sum = 0.0;
  for (int i = 0; i < joints; ++i)
    sum += std::fabs(direction(tip.jacobian[i].linear));
  for (int i = 0; i < joints; ++i)
    diagonal[i] += weight * sum * std::fabs(direction(tip.jacobian[i].linear));
}

constexpr int most_links = 12;

/// The tool point in the last link's frame.
axial::Vec3<double> tool_point(const Model& model) { return model.links<double>().tool_pose().position; }
axial::Vec3<double> tool_point(const DrivenModel& model) { return model.links<double>().joints().tool_pose().position; }

}  // namespace

template <class M>
PlantOf<M>::PlantOf(const M& model, const std::vector<axial::LinkParameters>& links, const Surroundings& surroundings,
                    ControlOf<M> control)
    : PlantOf(model, surroundings, std::move(control)) {
  axial::LinkParameters all[most_links] = {};
  std::copy(links.begin(), links.end(), all);
  const auto g = axial::drive_matrix_of(all);
  for (int i = 0; i < model_.link_count(); ++i) {
    const auto& link = all[i];
    Stop of_joint{link.position_min, link.position_max, g.offset[i], {}};
    for (int k = 0; k < model_.size(); ++k)
      of_joint.ratio[k] = g.ratio[i][k];
    stops_.push_back(of_joint);
    if (g.drive_of(i) < 0) continue;
    Stop of_drive{link.drive_min, link.drive_max, 0.0, {}};
    of_drive.ratio[g.drive_of(i)] = 1.0;
    if (g.is_alone(i))
      stops_.back().low = std::max(of_joint.low, of_drive.low),
      stops_.back().high = std::min(of_joint.high, of_drive.high);
    else
      stops_.push_back(of_drive);
  }
}

template <class M>
PlantOf<M>::PlantOf(const M& model, const Surroundings& surroundings, ControlOf<M> control)
    : model_(model), surroundings_(surroundings), control_(std::move(control)) {}

template <class M>
void PlantOf<M>::operator()(const axial::Instant<M, double>& at, Joints& tau, axial::Inputs<M, double>& in,
                            Stiffness& stiffness) const {
  if (control_) control_(at, tau, stiffness);
  if (surroundings_.stops.stiffness > 0.0) add_stops(at, tau, stiffness);
  if (surroundings_.ground) add_ground(at, in, stiffness);
}

template <class M>
axial::Vec3<double> PlantOf<M>::ground_force(const Joints& q, const Joints& qd) const {
  if (!surroundings_.ground) return {};
  return GroundForce(*surroundings_.ground, Tip<M>(model_, q, qd)).force;
}

template <class M>
void PlantOf<M>::add_stops(const axial::Instant<M, double>& at, Joints& tau, Stiffness& stiffness) const {
  const EndStops& spring = surroundings_.stops;
  for (const Stop& stop : stops_) {
    double q = stop.offset, qd = 0.0, sum = 0.0;
    for (int k = 0; k < model_.size(); ++k)
      q += stop.ratio[k] * at.q[k], qd += stop.ratio[k] * at.qd[k], sum += std::fabs(stop.ratio[k]);
    const double beyond = q > stop.high ? q - stop.high : q < stop.low ? q - stop.low : 0.0;
    if (!(std::fabs(beyond) > 0.0)) continue;
    const double push = spring.stiffness * beyond + spring.damping * qd;
    if (push * beyond <= 0.0) continue;
    for (int k = 0; k < model_.size(); ++k) {
      tau[k] -= stop.ratio[k] * push;
      stiffness.stiffness[k] += spring.stiffness * sum * std::fabs(stop.ratio[k]);  // a bound, as add_bound()
      stiffness.damping[k] += spring.damping * sum * std::fabs(stop.ratio[k]);
    }
  }
}

template <class M>
void PlantOf<M>::add_ground(const axial::Instant<M, double>& at, axial::Inputs<M, double>& in,
                            Stiffness& stiffness) const {
  const Tip<M> tip(model_, at.q, at.qd);
  const GroundForce ground(*surroundings_.ground, tip);
  if (!(ground.force.z > 0.0)) return;
  const auto force = axial::transpose_times(tip.link_axes, ground.force);
  in.tip_wrench = {axial::cross(tool_point(model_), force), force};
  const int n = model_.size();
  const auto x = [](const auto& v) { return v.x; };
  const auto y = [](const auto& v) { return v.y; };
  const auto z = [](const auto& v) { return v.z; };
  add_bound(stiffness.stiffness, tip, n, ground.per_depth, z);
  add_bound(stiffness.damping, tip, n, ground.per_approach, z);
  add_bound(stiffness.damping, tip, n, ground.per_slip, x);
  add_bound(stiffness.damping, tip, n, ground.per_slip, y);
}

template class PlantOf<Model>;
template class PlantOf<DrivenModel>;

}  // namespace host_sim::simulation

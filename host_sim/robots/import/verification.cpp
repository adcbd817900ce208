#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/import/verification.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <axial/axial.hpp>

#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace importer {
namespace {

using host_sim::note_size;

using Model = axial::Model<description::most_links, axial::Gravity, axial::RotorInertia, axial::SharedDrives>;
using Joints = axial::Joints<Model, double>;

KDL::Frame frame(const axial::FixedPose& p) {
  const double* r = p.rotation;
  return {KDL::Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]),
          KDL::Vector(p.position[0], p.position[1], p.position[2])};
}
KDL::Frame frame(const axial::WorldPose<double>& p) {
  const auto& R = p.rotation;
  return {KDL::Rotation(R.x.x, R.x.y, R.x.z, R.y.x, R.y.y, R.y.z, R.z.x, R.z.y, R.z.z),
          KDL::Vector(p.position.x, p.position.y, p.position.z)};
}

class Comparison {
 public:
  Comparison(const Imported& imported, const Reference& reference)
      : imported_(imported),
        reference_(reference),
        n_(imported.robot.size()),
        g_(description::drive_matrix(imported.robot)),
        model_(description::to_model<Model>(imported.robot)),
        position_(reference.tree),
        torque_(reference.tree, reference.gravity),
        still_(reference.tree, KDL::Vector::Zero()) {
    for (const auto& name : reference.joints)
      order_.push_back(GetTreeElementQNr(reference.tree.getSegment(name)->second));
  }

  void state(std::mt19937& random) {
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    if (g_.drives != reference_.drives) throw description::Refused("drives are counted differently");
    Joints u{}, ud{}, udd{};  // of the drives
    for (int k = 0; k < g_.drives; ++k) {
      const auto& p = imported_.robot.links[static_cast<std::size_t>(g_.owner[k])].parameters;
      const double span = p.type == axial::JointType::revolute ? 3.14159 : 1.0;
      u[k] = between(std::isfinite(p.position_min) ? p.position_min : -span,
                     std::isfinite(p.position_max) ? p.position_max : span);
      ud[k] = between(-2.0, 2.0), udd[k] = between(-5.0, 5.0);
    }
    poses(u);
    torques(u, ud, udd);
    mass_matrix(u);
  }

  /// What does not depend on a state.
  void constants() {
    const auto& g = imported_.robot.gravity;
    const KDL::Vector ours =
        reference_.world.M.Inverse() * (frame(imported_.robot.base).M * KDL::Vector(g.x, g.y, g.z));
    note_size(body_, length_of(ours - reference_.gravity) / std::max(1.0, length_of(reference_.gravity)));
    for (int i = imported_.robot.base_body ? -1 : 0; i < n_; ++i)
      body(i);
    if (reference_.limits.empty()) return;
    for (int i = 0; i < n_; ++i)
      limits(i);
    for (int k = 0; k < g_.drives; ++k)
      friction(k);
  }

  Figures figures(int states, unsigned seed) const {
    const auto over = [](double error, double scale) { return error == 0.0 ? 0.0 : error / scale; };
    Figures result{states, seed, pose_, over(torque_error_, torque_scale_), over(mass_error_, mass_scale_)};
    result.body = body_, result.limits = limits_;
    result.changed_angle = reference_.changed_angle, result.changed_length = reference_.changed_length;
    result.changed_angle_bound = reference_.changed_angle_bound;
    for (int k = 0; k < g_.drives; ++k)
      if (resistance_[k] <= 1e-12 * mass_scale_) result.unresisted.push_back(g_.owner[k]);
    return result;
  }

 private:
  /// Values of joints from those of the drives, by the source.
  Joints theirs(const Joints& u, bool positions) const {
    Joints q{};
    for (int i = 0; i < n_; ++i) {
      const auto& row = reference_.ratios[static_cast<std::size_t>(i)];
      q[i] = positions ? reference_.offsets[static_cast<std::size_t>(i)] : 0.0;
      for (int k = 0; k < reference_.drives; ++k)
        q[i] += row[static_cast<std::size_t>(k)] * u[k];
    }
    return q;
  }
  KDL::JntArray kdl(const Joints& values) const {
    KDL::JntArray result(static_cast<unsigned>(n_));
    for (int i = 0; i < n_; ++i)
      result(order_[static_cast<std::size_t>(i)]) = values[i];
    return result;
  }
  /// Of the drives, from KDL's at the joints: the power is the same.
  Joints torque(KDL::TreeIdSolver_RNE& solver, const Joints& u, const Joints& ud, const Joints& udd) const {
    const Joints q = theirs(u, true), qd = theirs(ud, false), qdd = theirs(udd, false);
    KDL::JntArray tau(static_cast<unsigned>(n_));
    if (solver.CartToJnt(kdl(q), kdl(qd), kdl(qdd), {}, tau) < 0) throw description::Refused("KDL refuses the robot");
    Joints result{};
    for (int i = 0; i < n_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double effort = tau(order_[k]) + reference_.rotors[k] * qdd[i];
      for (int d = 0; d < reference_.drives; ++d)
        result[d] += reference_.ratios[k][static_cast<std::size_t>(d)] * effort;
    }
    return result;
  }

  KDL::Frame their_frame(const KDL::JntArray& q, const std::string& segment) {
    KDL::Frame pose;
    if (position_.JntToCart(q, pose, segment) < 0) throw description::Refused("KDL knows no segment " + segment);
    return reference_.world * pose;
  }
  void compare(const KDL::Frame& ours, const KDL::Frame& other) {
    for (int i = 0; i < 9; ++i)
      note_size(pose_, ours.M.data[i] - other.M.data[i]);
    note_size(pose_, length_of(ours.p - other.p) / std::max(1.0, length_of(other.p)));
  }
  void poses(const Joints& u) {
    const auto ours = axial::forward_kinematics(model_, u);
    const KDL::JntArray positions = kdl(theirs(u, true));
    for (const auto& tracked : imported_.frames) {
      const KDL::Frame carrier = tracked.link < 0 ? KDL::Frame::Identity() : frame(ours.frames[tracked.link]);
      compare(carrier * frame(tracked.pose), their_frame(positions, tracked.name));
    }
    if (!reference_.tool_segment.empty())
      compare(frame(ours.tool), their_frame(positions, reference_.tool_segment) * reference_.tool);
  }
  void torques(const Joints& u, const Joints& ud, const Joints& udd) {
    const auto ours = axial::inverse_dynamics(model_, u, ud, udd), other = torque(torque_, u, ud, udd);
    for (int k = 0; k < g_.drives; ++k)
      note_size(torque_scale_, other[k]), note_size(torque_error_, ours[k] - other[k]);
  }
  void mass_matrix(const Joints& u) {
    const auto ours = axial::mass_matrix(model_, u);
    for (int l = 0; l < g_.drives; ++l) {
      Joints unit{};
      unit[l] = 1.0;
      const auto column = torque(still_, u, Joints{}, unit);
      note_size(resistance_[l], ours(l, l));
      for (int k = 0; k < g_.drives; ++k)
        note_size(mass_scale_, column[k]), note_size(mass_error_, ours(k, l) - column[k]);
    }
  }

  /// A frame in that of the link that carries it; of the base in frame 0.
  KDL::Frame where(const TrackedFrame& tracked) const {
    return tracked.link < 0 ? frame(imported_.robot.base).Inverse() * frame(tracked.pose) : frame(tracked.pose);
  }
  /// The bodies of the source that link i carries, as one, against the description's.
  void body(int i) {
    KDL::RigidBodyInertia sum = KDL::RigidBodyInertia::Zero();
    for (const auto& tracked : imported_.frames)
      if (tracked.link == i)
        sum = sum + where(tracked) * reference_.tree.getSegment(tracked.name)->second.segment.getInertia();
    const auto& p = i < 0 ? *imported_.robot.base_body : parameters(i);
    const KDL::RotationalInertia own(p.inertia_com[0], p.inertia_com[1], p.inertia_com[2], p.inertia_com[3],
                                     p.inertia_com[4], p.inertia_com[5]);
    const KDL::RigidBodyInertia ours(p.mass, KDL::Vector(p.com[0], p.com[1], p.com[2]), own);
    const auto over = [](double error, double scale) { return error == 0.0 ? 0.0 : error / scale; };
    note_size(body_, over(std::abs(sum.getMass() - ours.getMass()), sum.getMass()));
    if (sum.getMass() > 0.0)
      note_size(body_, length_of(sum.getCOG() - ours.getCOG()) / std::max(1.0, length_of(ours.getCOG())));
    const auto theirs = sum.getRotationalInertia(), mine = ours.getRotationalInertia();
    for (const int k : {0, 1, 2, 4, 5, 8})
      note_size(body_, over(std::abs(theirs.data[k] - mine.data[k]),
                            std::abs(theirs.data[0]) + std::abs(theirs.data[4]) + std::abs(theirs.data[8])));
  }
  const axial::LinkParameters& parameters(int i) const {
    return imported_.robot.links[static_cast<std::size_t>(i)].parameters;
  }
  const WrittenLimits& written(int i) const { return reference_.limits[static_cast<std::size_t>(i)]; }
  double ratio(int joint, int drive) const {
    return reference_.ratios[static_cast<std::size_t>(joint)][static_cast<std::size_t>(drive)];
  }
  /// Whether one drive alone moves a joint.
  bool moves_alone(int drive, int joint) const {
    for (int k = 0; k < reference_.drives; ++k)
      if ((ratio(joint, k) != 0.0) != (k == drive)) return false;
    return true;
  }
  void same(double ours, double theirs) {
    if (ours != theirs) note_size(limits_, std::abs(ours - theirs) / std::max(std::abs(theirs), std::abs(ours)));
  }
  void limits(int i) {
    const auto& p = parameters(i);
    const auto& theirs = written(i);
    if (theirs.positions) same(p.position_min, theirs.lower), same(p.position_max, theirs.upper);
    if (theirs.speed != 0.0) same(p.speed_limit, theirs.speed);
  }
  /// Effort and friction of the joints that a drive moves alone, at the drive: the power is the same.
  void friction(int k) {
    const int owner = g_.owner[k];
    double damping = 0.0, forward = 0.0, backward = 0.0, stiffness = 0.0, moment = 0.0;
    for (int i = 0; i < n_; ++i) {
      if (!moves_alone(k, i)) continue;
      damping += ratio(i, k) * ratio(i, k) * written(i).damping, forward += std::abs(ratio(i, k)) * written(i).friction;
      backward += std::abs(ratio(i, k)) * written(i).backward;
      stiffness += ratio(i, k) * ratio(i, k) * written(i).stiffness;
      moment +=
          ratio(i, k) * written(i).stiffness * (written(i).rest - reference_.offsets[static_cast<std::size_t>(i)]);
    }
    const auto& p = parameters(owner);
    same(p.viscous, damping), same(p.coulomb_forward, forward), same(p.coulomb_backward, -backward);
    same(p.spring_stiffness, stiffness);
    if (stiffness != 0.0) same(p.spring_rest, moment / stiffness);
    if (moves_alone(k, owner) && ratio(owner, k) == 1.0 && written(owner).effort != 0.0)
      same(p.effort_limit, written(owner).effort);
  }

  const Imported& imported_;
  const Reference& reference_;
  int n_;
  axial::DriveMatrix<description::most_links> g_;
  Model model_;
  KDL::TreeFkSolverPos_recursive position_;
  KDL::TreeIdSolver_RNE torque_, still_;
  std::vector<unsigned> order_;
  double pose_ = 0.0, torque_error_ = 0.0, torque_scale_ = 0.0, mass_error_ = 0.0, mass_scale_ = 0.0;
  double body_ = 0.0, limits_ = 0.0;
  double resistance_[description::most_links] = {};  ///< largest entries of the mass matrix's diagonal
};

}  // namespace

bool Figures::good() const {
  return pose <= pose_bound && torque <= torque_bound && mass_matrix <= torque_bound && body <= body_bound &&
         limits <= limits_bound && engine.good() && changed_angle <= changed_angle_bound &&
         changed_length <= changed_length_bound;
}

bool EngineFigures::good() const {
  return engine.empty() ||
         (pose <= bound && torque <= bound && mass_matrix <= bound && body <= bound && joint <= bound);
}
std::string EngineFigures::line() const {
  const auto two = [](double value) { return description::number(value, 2); };
  if (engine.empty()) return why_not.empty() ? "" : "not against " + asked + ": " + why_not;
  return "the file as it is written against " + engine + " on " + std::to_string(states) +
         " of these states: poses within " + two(pose) + ", torques with rotors within " + two(torque) +
         " of the largest, mass matrix within " + two(mass_matrix) + ", bodies within " + two(body) +
         ", what joints have within " + two(joint) + " (bound of each " + two(bound) + ")";
}

std::vector<std::string> Figures::lines() const {
  const auto two = [](double value) { return description::number(value, 2); };
  std::vector<std::string> text{
      against + std::to_string(states) + " random states (seed " + std::to_string(seed) + "), axial::Model in double:",
      "frames and tool within " + two(pose) + " (bound " + two(pose_bound) + "), torques within " + two(torque) +
          " of the largest, mass matrix within " + two(mass_matrix) + " of its largest entry (bound " +
          two(torque_bound) + "), bodies within " + two(body) + " (bound " + two(body_bound) + ")",
      "no angle is read more than " + two(changed_angle) + " rad, no origin more than " + two(changed_length) +
          " m from what is written"};
  if (const std::string line = engine.line(); !line.empty()) text.push_back(line);
  return text;
}

Figures verify(const Imported& imported, const Reference& reference, unsigned seed, int states) {
  Comparison comparison(imported, reference);
  comparison.constants();
  std::mt19937 random(seed);
  for (int i = 0; i < states; ++i)
    comparison.state(random);
  return comparison.figures(states, seed);
}

}  // namespace importer

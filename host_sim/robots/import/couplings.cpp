#include <host_sim/robots/import/couplings.hpp>

#include <Eigen/Dense>

#include <cmath>
#include <string>
#include <vector>

namespace importer {
namespace {

using description::Description;
using Parameters = axial::LinkParameters;

int index_of(const Description& robot, const std::string& joint) {
  for (int i = 0; i < robot.size(); ++i)
    if (robot.links[static_cast<std::size_t>(i)].joint == joint) return i;
  throw description::Refused("joint '" + joint + "' is not there");
}
Parameters& parameters(Description& robot, int i) { return robot.links[static_cast<std::size_t>(i)].parameters; }

void name_mimic(const SourceJoint& joint, Description& robot) {
  auto& p = parameters(robot, index_of(robot, joint.name));
  p.drives.name(index_of(robot, joint.leader), joint.ratio);
  p.drives.offset = joint.offset, p.drives.follows = p.drives.complete = true;
}

void name_transmission(const SourceTransmission& transmission, Description& robot) {
  const int a = index_of(robot, transmission.joints[0]), b = index_of(robot, transmission.joints[1]);
  const double first = transmission.reductions[0], second = transmission.reductions[1];
  auto &of_a = parameters(robot, a).drives, &of_b = parameters(robot, b).drives;
  if (transmission.law == SourceTransmission::Law::differential) {
    of_a.name(a, 0.5 / first), of_a.name(b, 0.5 / first);
    of_b.name(a, 0.5 / second), of_b.name(b, -0.5 / second);
  } else {
    if (first != 1.0) of_a.name(a, 1.0 / first);
    if (second != 1.0) of_b.name(b, 1.0 / second);
    of_b.name(a, -1.0 / (first * second));
  }
}

void add(std::string& list, const std::string& joint) { list += (list.empty() ? "" : ", ") + joint; }

/// What files say of joints and axial of drives.
class ToDrives {
 public:
  explicit ToDrives(Description& robot) : robot_(robot), g_(description::drive_matrix(robot)) {
    for (int i = 0; i < robot_.size(); ++i)
      if (!g_.is_alone(i)) move(i);
    say("joint friction, which belongs to no single drive, left out", friction_);
    say("effort limits of joints, which are none of a drive's, left out", effort_);
  }

 private:
  void say(const std::string& what, const std::string& joints) {
    if (!joints.empty()) robot_.assumptions.push_back(what + ": " + joints);
  }
  /// The one drive that moves joint i, or -1.
  int only_drive(int i) const {
    int found = -1;
    for (int k = 0; k < g_.drives; ++k)
      if (g_.is_moved(i, k)) found = found < 0 ? k : g_.drives;
    return found < g_.drives ? found : -1;
  }
  void move(int i) {
    auto& p = parameters(robot_, i);
    const std::string& joint = robot_.links[static_cast<std::size_t>(i)].joint;
    const int drive = only_drive(i);
    const double ratio = drive < 0 ? 0.0 : g_.ratio[i][drive];
    const bool own = drive >= 0 && g_.owner[drive] == i && ratio == 1.0;
    if (own) return;
    move_friction(p, drive, ratio, joint);
    if (p.drives.follows && drive >= 0) move_inertia(p, ratio, g_.offset[i], parameters(robot_, g_.owner[drive]));
    if (std::isfinite(p.effort_limit) && !p.drives.follows) add(effort_, joint);
    p.effort_limit = Parameters::unlimited;
  }
  void move_friction(Parameters& p, int drive, double ratio, const std::string& joint) {
    const double viscous = p.viscous, dry = p.coulomb_forward;
    p.viscous = p.coulomb_forward = p.coulomb_backward = 0.0;
    if (viscous == 0.0 && dry == 0.0) return;
    if (drive < 0) return add(friction_, joint);
    auto& owner = parameters(robot_, g_.owner[drive]);
    owner.viscous += ratio * ratio * viscous;
    owner.coulomb_forward += std::abs(ratio) * dry, owner.coulomb_backward -= std::abs(ratio) * dry;
  }

  /// Rotor and spring of a joint that follows, at the joint that it follows: energies are the same.
  static void move_inertia(Parameters& p, double ratio, double offset, Parameters& owner) {
    owner.rotor_inertia += ratio * ratio * p.rotor_inertia;
    const double stiffness = ratio * ratio * p.spring_stiffness, sum = owner.spring_stiffness + stiffness;
    if (stiffness != 0.0)
      owner.spring_rest =
          (owner.spring_stiffness * owner.spring_rest + ratio * p.spring_stiffness * (p.spring_rest - offset)) / sum;
    owner.spring_stiffness = sum;
    p.rotor_inertia = p.spring_stiffness = p.spring_rest = 0.0;
  }

  Description& robot_;
  axial::DriveMatrix<description::most_links> g_;
  std::string friction_, effort_;
};

/// How far a weighted sum of joint values goes; `weights` are a row of G's inverse.
double reach(const Description& robot, const std::vector<int>& joints, const Eigen::RowVectorXd& weights,
             double Parameters::*positive, double Parameters::*negative) {
  double sum = 0.0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const double w = weights[static_cast<Eigen::Index>(i)];
    const auto& p = robot.links[static_cast<std::size_t>(joints[i])].parameters;
    if (std::abs(w) > 1e-12) sum += w > 0.0 ? w * (p.*positive) : w * (p.*negative);
  }
  return sum;
}
double speed_of(const Description& robot, const std::vector<int>& joints, const Eigen::RowVectorXd& weights,
                double Parameters::*limit) {
  return reach(robot, joints, weights.cwiseAbs(), limit, limit);
}

}  // namespace

void check_leaders(const SourceTree& tree, const std::function<void(const SourceJoint&, LeaderFault)>& refuse) {
  const auto moving = [&](const std::string& name) -> const SourceJoint* {
    for (const auto& link : tree.links)
      if (link.joint.moves() && link.joint.name == name) return &link.joint;
    return nullptr;
  };
  for (const auto& link : tree.links) {
    if (!link.joint.moves() || link.joint.leader.empty()) continue;
    const SourceJoint* at = moving(link.joint.leader);
    if (at == nullptr) refuse(link.joint, LeaderFault::does_not_move);
    for (std::size_t i = 0; at != nullptr && at != &link.joint && i < tree.links.size(); ++i)
      at = moving(at->leader);
    if (at == &link.joint) refuse(link.joint, LeaderFault::follows_itself);
  }
}

void couple(const SourceTree& source, Description& robot) {
  for (const auto& transmission : source.transmissions)
    name_transmission(transmission, robot);
  for (const auto& link : source.links)
    if (link.joint.moves() && !link.joint.leader.empty()) name_mimic(link.joint, robot);
  if (robot.size() <= description::most_links) ToDrives{robot};  // others are refused later
}

void assume_drive_limits(Description& robot) {
  const auto g = description::drive_matrix(robot);
  std::vector<int> owners;
  for (int k = 0; k < g.drives; ++k)
    owners.push_back(g.owner[k]);
  Eigen::MatrixXd ratios(g.drives, g.drives);
  for (int k = 0; k < g.drives; ++k)
    for (int l = 0; l < g.drives; ++l)
      ratios(k, l) = g.ratio[owners[static_cast<std::size_t>(k)]][l];
  const Eigen::FullPivLU<Eigen::MatrixXd> solver(ratios);
  if (g.drives == 0 || !solver.isInvertible()) return;
  const Eigen::MatrixXd drives = solver.inverse();
  std::string filled;
  for (int k = 0; k < g.drives; ++k) {
    auto& p = parameters(robot, g.owner[k]);
    if (g.is_alone(g.owner[k]) || p.has_drive_limits()) continue;
    const Eigen::RowVectorXd row = drives.row(k);
    p.drive_max = reach(robot, owners, row, &Parameters::position_max, &Parameters::position_min);
    p.drive_min = reach(robot, owners, row, &Parameters::position_min, &Parameters::position_max);
    p.drive_speed_limit = speed_of(robot, owners, row, &Parameters::speed_limit);
    p.drive_acceleration_limit = speed_of(robot, owners, row, &Parameters::acceleration_limit);
    add(filled, robot.links[static_cast<std::size_t>(g.owner[k])].joint);
  }
  if (!filled.empty())
    robot.assumptions.push_back("limits of shared drives as far as those of their joints let them go: " + filled);
}

}  // namespace importer

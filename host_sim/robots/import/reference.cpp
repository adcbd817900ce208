// A source tree as Orocos KDL has it: what the rows that are made of it are compared with.
#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/import/reference.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace importer {
namespace {

KDL::Rotation rotation(const Rows& r) { return {r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]}; }
KDL::Frame frame(const Placement& p) {
  return {rotation(p.rotation), KDL::Vector(p.position[0], p.position[1], p.position[2])};
}

class Builder {
 public:
  Builder(const SourceTree& tree, Reference& result) : tree_(tree), result_(result) {
    for (const auto& link : tree.links)
      if (link.parent >= 0 && link.joint.moves()) movers_[link.joint.name] = &link;
  }

  void build(const std::vector<std::string>& order) {
    // KDL's root has no body: that of a base that floats is a segment of its own.
    if (tree_.floating)
      result_.tree.addSegment(KDL::Segment(segment_name(tree_.links[0].name), KDL::Joint("base", KDL::Joint::Fixed),
                                           KDL::Frame::Identity(), body(tree_.links[0])),
                              "root");
    for (std::size_t i = 1; i < tree_.links.size(); ++i)
      result_.tree.addSegment(segment(tree_.links[i]), name(tree_.links[i].parent));
    if (order.size() != movers_.size()) throw description::Refused("the joints that move are not those of the file");
    for (const auto& joint : order)
      add_joint(*movers_.at(joint));
    result_.rotors.clear();
    for (const auto& joint : order) {
      result_.rotors.push_back(movers_.at(joint)->joint.rotor), result_.offsets.push_back(position(joint, ""));
      result_.ratios.emplace_back();
    }
    for (const auto& drive : order) {
      if (!movers_.at(drive)->joint.leader.empty()) continue;
      ++result_.drives;
      for (std::size_t i = 0; i < order.size(); ++i)
        result_.ratios[i].push_back(position(order[i], drive) - result_.offsets[i]);
    }
  }

 private:
  std::string name(int link) const {
    return link == 0 ? "root" : segment_name(tree_.links[static_cast<std::size_t>(link)].name);
  }
  static KDL::RigidBodyInertia body(const SourceLink& link) {
    if (!link.has_inertial) return KDL::RigidBodyInertia::Zero();
    const auto& j = link.inertia;
    return frame(link.inertial) * KDL::RigidBodyInertia(link.mass, KDL::Vector::Zero(),
                                                        KDL::RotationalInertia(j[0], j[1], j[2], j[3], j[4], j[5]));
  }
  static KDL::Segment segment(const SourceLink& link) {
    const auto& joint = link.joint;
    const KDL::Frame origin = frame(joint.origin);
    const KDL::Joint still(joint.name, KDL::Joint::Fixed);
    const auto made = [&](const KDL::Joint& carrier, const KDL::Frame& pose) {
      return KDL::Segment(segment_name(link.name), carrier, pose, body(link));
    };
    if (joint.kind == Kind::fixed) return made(still, origin);
    const auto type = joint.kind == Kind::prismatic ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
    const KDL::Joint moves(joint.name, origin.p, origin.M * KDL::Vector(joint.axis[0], joint.axis[1], joint.axis[2]),
                           type);
    return joint.moves() ? made(moves, origin) : made(still, moves.pose(joint.held_at) * KDL::Frame(origin.M));
  }
  void add_joint(const SourceLink& link) {
    const auto& joint = link.joint;
    WrittenLimits limits;
    limits.positions = joint.has_limits, limits.lower = joint.lower, limits.upper = joint.upper;
    limits.speed = joint.speed, limits.effort = joint.effort;
    limits.damping = joint.damping, limits.friction = limits.backward = joint.friction;
    limits.stiffness = joint.stiffness, limits.rest = joint.rest;
    result_.joints.push_back(segment_name(link.name)), result_.limits.push_back(limits);
  }
  /// A joint's position with one drive at 1, the others at 0; with no drive named, all at 0.
  double position(const std::string& joint, const std::string& drive) const {
    const auto& at = movers_.at(joint)->joint;
    return at.leader.empty() ? (joint == drive ? 1.0 : 0.0) : at.offset + at.ratio * position(at.leader, drive);
  }

  const SourceTree& tree_;
  Reference& result_;
  std::map<std::string, const SourceLink*> movers_;
};

/// How far joints' origins are from where they are written.
void measure(const SourceTree& tree, const SourceTree& written, Reference& result) {
  for (std::size_t i = 1; i < tree.links.size(); ++i) {
    const KDL::Frame now = frame(tree.links[i].joint.origin), before = frame(written.links[i].joint.origin);
    const KDL::Rotation by = before.M.Inverse() * now.M;
    // Of a small rotation; GetRot() takes what is below 1e-6 for nothing.
    const KDL::Vector turn(by(2, 1) - by(1, 2), by(0, 2) - by(2, 0), by(1, 0) - by(0, 1));
    host_sim::note_size(result.changed_angle, length_of(turn) / 2.0);
    host_sim::note_size(result.changed_length, length_of(now.p - before.p));
  }
}

}  // namespace

Reference reference_of(const SourceTree& tree, const SourceTree& written, const ReadingOptions& options,
                       const axial::GravityVector& gravity, const std::vector<std::string>& joint_order) {
  Reference result;
  result.gravity = {gravity.x, gravity.y, gravity.z};
  result.changed_angle_bound =
      1e-12 + (options.snap ? std::max(nearly_right, options.right_angles) : options.right_angles);
  Builder(tree, result).build(joint_order);
  measure(tree, written, result);
  if (tree.tool > 0) result.tool_segment = segment_name(tree.links[static_cast<std::size_t>(tree.tool)].name);
  return result;
}

}  // namespace importer

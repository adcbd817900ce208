#include <host_sim/import/reference.hpp>

#include <string>

namespace importer {
namespace {

KDL::Vector vector(const double* v) { return {v[0], v[1], v[2]}; }
KDL::Rotation rotation(const double* r) { return {r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]}; }
KDL::Frame frame(const Placement& p) { return {rotation(p.rotation.data()), vector(p.position.data())}; }
KDL::Frame frame(const axial::FixedPose& p) { return {rotation(p.rotation), vector(p.position)}; }

KDL::RotationalInertia tensor(const double* j) { return KDL::RotationalInertia(j[0], j[1], j[2], j[3], j[4], j[5]); }

KDL::RigidBodyInertia body(const SourceLink& link) {
  if (!link.has_inertial) return KDL::RigidBodyInertia::Zero();
  return frame(link.inertial) * KDL::RigidBodyInertia(link.mass, KDL::Vector::Zero(), tensor(link.inertia.data()));
}

/// The joint, and where its link's frame is at position 0.
KDL::Segment segment(const SourceLink& link, const std::string& name) {
  KDL::Frame origin = frame(link.joint.origin);
  const KDL::Vector axis = origin.M * vector(link.joint.axis.data());
  const bool slides = link.joint.kind == Kind::prismatic;
  const auto type = slides ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
  if (link.joint.moves()) return KDL::Segment(name, KDL::Joint(name, origin.p, axis, type), origin, body(link));
  if (link.joint.held && link.joint.kind != Kind::fixed)
    origin = KDL::Joint(name, origin.p, axis, type).pose(link.joint.held_at) * KDL::Frame(origin.M);
  return KDL::Segment(name, KDL::Joint(name, KDL::Joint::Fixed), origin, body(link));
}

}  // namespace

std::string segment_name(int index) { return "segment" + std::to_string(index); }

Reference reference_of(const SourceTree& source, const axial::GravityVector& gravity,
                       const std::vector<std::string>& joint_order) {
  Reference result;
  result.gravity = {gravity.x, gravity.y, gravity.z};
  for (std::size_t i = 1; i < source.links.size(); ++i) {
    const auto& link = source.links[i];
    const std::string parent = link.parent == 0 ? "root" : segment_name(link.parent);
    result.tree.addSegment(segment(link, segment_name(static_cast<int>(i))), parent);
  }
  for (const auto& joint : joint_order)
    for (std::size_t i = 1; i < source.links.size(); ++i)
      if (source.links[i].joint.name == joint) result.joints.push_back(segment_name(static_cast<int>(i)));
  result.rotors.assign(joint_order.size(), 0.0);
  if (source.tool > 0) result.tool_segment = segment_name(source.tool);
  return result;
}

Reference reference_of(const description::Table& table) {
  Reference result;
  const auto& robot = table.robot;
  result.world = frame(robot.base), result.tool = frame(robot.tool);
  result.gravity = {robot.gravity.x, robot.gravity.y, robot.gravity.z};
  for (int i = 0; i < robot.size(); ++i) {
    const auto& p = robot.links[static_cast<std::size_t>(i)].parameters;
    const KDL::Frame branch(KDL::Rotation::RotZ(p.gamma.radians), KDL::Vector(0.0, 0.0, p.b));
    const KDL::Frame twist = branch * KDL::Frame::DH_Craig1989(p.a, p.alpha.radians, 0.0, 0.0);
    const KDL::Frame row = table.classical
                               ? KDL::Frame::DH(p.a, p.alpha.radians, p.d, p.theta.radians)
                               : branch * KDL::Frame::DH_Craig1989(p.a, p.alpha.radians, p.d, p.theta.radians);
    const KDL::Frame axis = table.classical ? KDL::Frame::Identity() : twist;
    const bool slides = p.type == axial::JointType::prismatic;
    const std::string name = segment_name(i + 1),
                      parent = robot.parent(i) < 0 ? "root" : segment_name(robot.parent(i) + 1);
    const KDL::Joint joint(name, axis.p, axis.M.UnitZ(), slides ? KDL::Joint::TransAxis : KDL::Joint::RotAxis);
    result.tree.addSegment(
        KDL::Segment(name, joint, row, KDL::RigidBodyInertia(p.mass, vector(p.com), tensor(p.inertia_com))), parent);
    result.joints.push_back(name), result.rotors.push_back(p.gear * p.gear * p.rotor_inertia);
    result.tool_segment = name;
  }
  return result;
}

}  // namespace importer

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

/// Positions of joints by the laws of a source, as it writes them: a drive has the name of the joint that it belongs
/// to.
class Laws {
 public:
  explicit Laws(const SourceTree& source) : source_(source) {}

  /// With one drive at 1 and the others at 0; with no name, all at 0.
  double position(const std::string& joint, const std::string& drive) const {
    const auto at = [&](const std::string& name) { return name == drive ? 1.0 : 0.0; };
    for (const auto& t : source_.transmissions) {
      const double first = at(t.joints[0]), second = at(t.joints[1]);
      const bool sum = t.law == SourceTransmission::Law::differential;
      const double a = (sum ? (first + second) / 2.0 : first) / t.reductions[0];
      if (t.joints[0] == joint) return a;
      if (t.joints[1] == joint) return (sum ? (first - second) / 2.0 : second - a) / t.reductions[1];
    }
    for (const auto& link : source_.links)
      if (link.joint.name == joint && !link.joint.leader.empty())
        return link.joint.offset + link.joint.ratio * position(link.joint.leader, drive);
    return at(joint);
  }
  bool has_drive(const std::string& joint) const {
    for (const auto& link : source_.links)
      if (link.joint.name == joint) return link.joint.leader.empty();
    return false;
  }

 private:
  const SourceTree& source_;
};

void add_drives(Reference& result, const SourceTree& source, const std::vector<std::string>& joints) {
  const Laws laws(source);
  result.ratios.assign(joints.size(), {}), result.offsets.clear();
  for (const auto& joint : joints)
    result.offsets.push_back(laws.position(joint, ""));
  for (const auto& drive : joints) {
    if (!laws.has_drive(drive)) continue;
    ++result.drives;
    for (std::size_t i = 0; i < joints.size(); ++i)
      result.ratios[i].push_back(laws.position(joints[i], drive) - result.offsets[i]);
  }
}
/// A drive a joint.
void add_drives(Reference& result) {
  const std::size_t n = result.joints.size();
  result.drives = static_cast<int>(n);
  result.ratios.assign(n, std::vector<double>(n, 0.0)), result.offsets.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    result.ratios[i][i] = 1.0;
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
  add_drives(result, source, joint_order);
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
  add_drives(result);
  return result;
}

}  // namespace importer

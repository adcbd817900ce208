#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/import/bodies.hpp>
#include <host_sim/robots/import/to_mdh.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace importer {
namespace {

constexpr int base = axial::LinkParameters::base;

Pose to_pose(const Placement& p) {
  return {orthonormal(p.rotation.data()), {p.position[0], p.position[1], p.position[2]}};
}

/// A joint that moves: where it is in the source and what hangs on it.
struct Mover {
  int link = 0;       ///< in the source
  int parent = base;  ///< mover
  Line axis;
  std::vector<int> children;
  int carried = 1;  ///< joints from here outwards
};

class Converter {
 public:
  Converter(SourceTree& source, const axial::GravityVector& gravity, const Nearness& near)
      : source_(source), near_(near) {
    find_movers();
    count();
    place();
    result_.robot.name = source.name, result_.robot.notes = source.notes;
    start(gravity);
    add_bodies();
    add_frames();
  }
  Imported result() const { return result_; }

 private:
  const SourceLink& link(int i) const { return source_.links[static_cast<std::size_t>(i)]; }
  Mover& mover(int i) { return movers_[static_cast<std::size_t>(i)]; }
  std::vector<int>& children(int parent) { return parent < 0 ? roots_ : mover(parent).children; }

  /// Which mover carries each link.
  void find_movers() {
    for (int i = 0; i < static_cast<int>(source_.links.size()); ++i) {
      const int above = link(i).parent < 0 ? base : carriers_[static_cast<std::size_t>(link(i).parent)];
      carriers_.push_back(link(i).parent >= 0 && link(i).joint.moves() ? add_mover(i, above) : above);
    }
  }
  /// Poses of links at position 0 in the root's frame, and axes there.
  void place() {
    poses_.assign(1, Pose{});
    for (int i = 1; i < static_cast<int>(source_.links.size()); ++i) {
      const Pose joint = poses_[static_cast<std::size_t>(link(i).parent)] * to_pose(link(i).joint.origin);
      poses_.push_back(joint * held(link(i).joint));
      if (link(i).joint.moves())
        mover(carriers_[static_cast<std::size_t>(i)]).axis = {joint.position,
                                                              joint.rotation * direction(link(i).joint)};
    }
  }
  static Vector unit(const std::array<double, 3>& v) { return Vector(v[0], v[1], v[2]).normalized(); }
  static Vector direction(const SourceJoint& joint) { return unit(joint.axis); }
  static Pose held(const SourceJoint& joint) {
    Pose result;
    if (!joint.held || joint.kind == Kind::fixed) return result;
    if (joint.kind == Kind::prismatic)
      result.position = static_cast<Real>(joint.held_at) * direction(joint);
    else
      result.rotation = Eigen::AngleAxis<Real>(joint.held_at, direction(joint)).toRotationMatrix();
    return result;
  }
  int add_mover(int at, int parent) {
    const int index = static_cast<int>(movers_.size());
    movers_.push_back({at, parent, {}, {}, 1});
    children(parent).push_back(index);
    return index;
  }
  void count() {
    for (int i = static_cast<int>(movers_.size()); i-- > 0;)
      if (mover(i).parent >= 0) mover(mover(i).parent).carried += mover(i).carried;
    const auto most_first = [&](int a, int b) { return mover(a).carried > mover(b).carried; };
    for (int i = base; i < static_cast<int>(movers_.size()); ++i)
      std::stable_sort(children(i).begin(), children(i).end(), most_first);
    frames_.resize(movers_.size()), index_.resize(movers_.size());
  }

  void start(const axial::GravityVector& gravity) {
    Normal out{Vector::Zero(), Vector::Zero(), Vector::UnitX()};
    if (!roots_.empty()) settle(roots_[0], {});
    if (!roots_.empty()) out = common_normal({}, mover(roots_[0]).axis, Vector::Zero(), Vector::UnitX());
    frame0_ = frame(out.first_foot, out.direction, Vector::UnitZ());
    const Vector g = frame0_.rotation.transpose() * Vector(gravity.x, gravity.y, gravity.z);
    result_.robot.gravity = {rounded(g[0]), rounded(g[1]), rounded(g[2])};
    result_.robot.base = rounded(frame0_);
    for (const int child : roots_)
      add_row(child, base, {Vector::Zero(), Vector::UnitZ()}, frame0_);
  }

  /// Makes a mover's axis special in the frame that carries it, where it nearly is.
  void settle(int i, const Pose& carrier) {
    if (!near_.changes()) return;
    auto& joint = source_.links[static_cast<std::size_t>(mover(i).link)].joint;
    const auto above = static_cast<std::size_t>(link(mover(i).link).parent);
    const Matrix own = (poses_[above] * to_pose(joint.origin)).rotation, to_carrier = carrier.rotation.transpose();
    if (const auto by = turn_of(to_carrier * own, to_carrier * mover(i).axis.direction))
      turn(joint, poses_[above].rotation.transpose() * carrier.rotation * *by), place();
    const Vector shift = carrier.rotation * shift_of(mover(i).axis, carrier);
    if (shift.norm() > 0.0L) move(joint, poses_[above].rotation.transpose() * shift), place();
  }
  /// The small rotation vector, in the carrier's frame, that makes a joint's frame, or its axis alone, special there.
  std::optional<Vector> turn_of(const Matrix& joint, const Vector& axis) const {
    const Matrix right = joint.array().round().matrix();
    if (std::abs(right.determinant() - 1.0L) < 0.5L && right.cwiseAbs().sum() < 3.5L) {
      const Eigen::AngleAxis<Real> by(Matrix(right * joint.transpose()));
      const Vector turned = by * axis;  // a frame may be special, and the axis in it only nearly
      if (by.angle() <= near_.of_joints() && (turned - special_of(turned)).norm() <= rounding)
        return chosen(by.angle() * by.axis());
    }
    const Vector by = axis.cross(special_of(axis));
    return by.norm() <= near_.of_joints() ? chosen(by) : std::nullopt;
  }
  Vector special_of(Vector axis) const {
    for (int k = 0; k < 3; ++k)
      if (std::abs(axis[k]) <= near_.of_joints()) axis[k] = 0.0L;
    return axis.normalized();
  }
  static std::optional<Vector> chosen(const Vector& by) {
    return by.norm() > rounding ? std::optional<Vector>(by) : std::nullopt;
  }
  /// Turns a joint's origin by a rotation vector in its parent's axes, and all that it carries with it.
  void turn(SourceJoint& joint, const Vector& by) {
    const Matrix turned = Eigen::AngleAxis<Real>(by.norm(), by.normalized()).toRotationMatrix() *
                          orthonormal(joint.origin.rotation.data());
    for (int k = 0; k < 9; ++k)
      joint.origin.rotation[static_cast<std::size_t>(k)] = static_cast<double>(turned(k / 3, k % 3));
    for (std::size_t k = 0; k < 3; ++k)
      record(source_.changes,
             {Change::Of::joint_turn, joint.name, k, 0.0, static_cast<double>(by[static_cast<int>(k)])});
  }
  void move(SourceJoint& joint, const Vector& by) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double written = joint.origin.position[k];
      joint.origin.position[k] = static_cast<double>(written + by[static_cast<int>(k)]);
      if (joint.origin.position[k] != written)
        record(source_.changes, {Change::Of::joint_xyz, joint.name, k, written, joint.origin.position[k]});
    }
  }
  /// What is missing for an axis to stand at lengths that are meant, in the carrier's frame.
  Vector shift_of(const Line& axis, const Pose& carrier) const {
    const Line there{carrier.rotation.transpose() * (axis.point - carrier.position),
                     carrier.rotation.transpose() * axis.direction};
    Vector shift = Vector::Zero();
    if (there.direction.head<2>().norm() <= rounding) {
      for (int k = 0; k < 2; ++k)
        shift[k] = missing(there.point[k]);
    } else {
      const Normal normal = common_normal({}, there, Vector::Zero(), Vector::UnitX());
      const Real a = (normal.second_foot - normal.first_foot).dot(normal.direction);
      shift = missing(a) * normal.direction;
      shift[2] += missing(normal.first_foot[2]);
    }
    return shift;
  }
  /// From a length to 0, or to one that the source writes, where either is less than its last digit away.
  Real missing(Real length) const {
    Real best = near_.length, result = 0.0L;
    const auto meet = [&](Real meant) {
      if (std::abs(meant - length) < best) best = std::abs(meant - length), result = meant - length;
    };
    meet(0.0L);
    for (const auto& other : source_.links)
      for (const Real written : other.joint.origin.position)
        meet(written), meet(-written);
    return std::abs(result) <= rounding ? 0.0L : result;
  }
  /// The row from a parent's frame to a mover's, then those of what it carries.
  void add_row(int i, int parent, const Line& parent_axis, const Pose& parent_frame) {
    const Vector x = parent_frame.rotation.col(0), z = parent_axis.direction;
    const bool main = children(parent)[0] == i;
    if (!main) settle(i, parent_frame);
    Normal in = common_normal(parent_axis, mover(i).axis, parent_frame.position, x);
    if (main) in.direction = x;
    axial::LinkParameters p;
    p.parent = parent < 0 ? base : index_[static_cast<std::size_t>(parent)];
    if (!main) p.gamma = near_angle(angle_about(z, x, in.direction));
    if (!main) p.b = rounded((in.first_foot - parent_frame.position).dot(z));
    p.a = rounded((in.second_foot - in.first_foot).dot(in.direction));
    p.alpha = near_angle(angle_about(in.direction, z, mover(i).axis.direction));
    finish_row(i, in, p);
  }
  void finish_row(int i, const Normal& in, axial::LinkParameters& p) {
    const Line axis = mover(i).axis;
    Normal out{in.second_foot, in.second_foot, in.direction};
    if (!mover(i).children.empty()) {
      settle(mover(i).children[0], frame(in.second_foot, in.direction, axis.direction));
      out = common_normal(axis, mover(mover(i).children[0]).axis, in.second_foot, in.direction);
    }
    p.theta = near_angle(angle_about(axis.direction, in.direction, out.direction));
    p.d = rounded((out.first_foot - in.second_foot).dot(axis.direction));
    const Pose own = frame(out.first_foot, out.direction, axis.direction);
    const auto k = static_cast<std::size_t>(i);
    frames_[k] = own, index_[k] = result_.robot.size();
    set_drive(link(mover(i).link).joint, p);
    result_.robot.links.push_back({link(mover(i).link).name, link(mover(i).link).joint.name, p});
    for (const int child : mover(i).children)
      add_row(child, i, axis, own);
  }
  static void set_drive(const SourceJoint& joint, axial::LinkParameters& p) {
    p.type = joint.kind == Kind::prismatic ? axial::JointType::prismatic : axial::JointType::revolute;
    p.viscous = joint.damping, p.coulomb_forward = joint.friction, p.coulomb_backward = -joint.friction;
    p.rotor_inertia = joint.rotor, p.spring_stiffness = joint.stiffness, p.spring_rest = joint.rest;
    if (joint.has_limits) p.position_min = joint.lower, p.position_max = joint.upper;
    if (joint.speed > 0.0) p.speed_limit = joint.speed;
    if (joint.effort > 0.0) p.effort_limit = joint.effort;
  }

  void add_bodies() {
    std::vector<std::vector<Body>> bodies(movers_.size());
    std::vector<Body> floating;
    for (std::size_t i = 0; i < source_.links.size(); ++i) {
      if (!source_.links[i].has_inertial) continue;
      if (carriers_[i] < 0) floating.push_back(body_of(source_.links[i], frame0_.inverse() * poses_[i]));
      if (carriers_[i] < 0) continue;
      const auto carrier = static_cast<std::size_t>(carriers_[i]);
      bodies[carrier].push_back(body_of(source_.links[i], frames_[carrier].inverse() * poses_[i]));
    }
    for (std::size_t i = 0; i < movers_.size(); ++i)
      if (!bodies[i].empty())
        set_body(merged(bodies[i]), result_.robot.links[static_cast<std::size_t>(index_[i])].parameters);
    if (source_.floating) set_body(merged(floating), result_.robot.base_body.emplace());
  }
  static void set_body(const Body& body, axial::LinkParameters& p) {
    p.mass = near_decimal(body.mass, 1e-15L * body.mass);
    const Real noise = 1e-15L * body.inertia.trace();
    for (int k = 0; k < 3; ++k)
      p.com[k] = rounded(body.com[k]), p.inertia_com[k] = near_decimal(body.inertia(k, k), noise);
    const Real slack = 1e-17L * body.inertia.trace();  // what turning by right angles leaves of zeros
    const Real products[] = {body.inertia(0, 1), body.inertia(0, 2), body.inertia(1, 2)};
    for (int k = 0; k < 3; ++k)
      p.inertia_com[3 + k] = std::abs(products[k]) <= slack ? 0.0 : near_decimal(products[k], noise);
  }

  void add_frames() {
    for (std::size_t i = 0; i < source_.links.size(); ++i) {
      TrackedFrame tracked{source_.links[i].name, base, rounded(poses_[i])};
      if (carriers_[i] >= 0) {
        const auto carrier = static_cast<std::size_t>(carriers_[i]);
        tracked.link = index_[carrier];
        tracked.pose = rounded(frames_[carrier].inverse() * poses_[i]);
      }
      result_.frames.push_back(tracked);
    }
    if (source_.tool >= 0) result_.robot.tool = result_.frames[static_cast<std::size_t>(source_.tool)].pose;
  }

  static constexpr Real rounding = 1e-14L;  // rad, m

  SourceTree& source_;
  Nearness near_;
  Imported result_;
  std::vector<Pose> poses_;    ///< of source links in the root's frame
  std::vector<int> carriers_;  ///< mover of each source link
  std::vector<Mover> movers_;
  std::vector<int> roots_;
  std::vector<Pose> frames_;  ///< MDH frames of movers in the root's frame
  std::vector<int> index_;    ///< of movers in the description
  Pose frame0_;
};

}  // namespace

Imported to_mdh(SourceTree& source, const axial::GravityVector& gravity, const Nearness& near) {
  return Converter(source, gravity, near).result();
}

}  // namespace importer

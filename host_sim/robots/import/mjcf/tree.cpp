#include <host_sim/robots/import/mjcf/couplings.hpp>
#include <host_sim/robots/import/mjcf/mjcf_reader.hpp>

#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/import/couplings.hpp>

#include <algorithm>
#include <set>

namespace importer {
namespace mjcf {
namespace {

using description::Refused;

Placement placement(const Pose& pose) {
  Placement result;
  for (int k = 0; k < 9; ++k)
    result.rotation[static_cast<std::size_t>(k)] = static_cast<double>(pose.rotation(k / 3, k % 3));
  for (int k = 0; k < 3; ++k)
    result.position[static_cast<std::size_t>(k)] = static_cast<double>(pose.position[k]);
  return result;
}
Pose moved(const Vector& by) { return {Matrix::Identity(), by}; }

/// Chooses root and tip among the bodies, and what is between them.
class Choice {
 public:
  Choice(const Model& model, const std::string& from, const ReadingOptions& options) : m_(model), from_(from) {
    if (!options.tip.empty()) find_tip(options.tip);
    root = options.root.empty() ? default_root() : body_named(options.root, "--root");
    for (int at = tip; has_tip() && at != root; at = node(at).parent) {
      if (at <= 0)
        throw Refused(from + ": '" + options.tip + "' does not hang on '" + node(root).name +
                      "'; choose another --root");
      path.insert(at);
    }
  }
  bool has_tip() const { return tip >= 0; }

  int root = 0, tip = -1;  ///< bodies
  std::string site;        ///< the tip, where it is a site of that body
  std::set<int> path;
  std::vector<std::string> left;  ///< bodies that float beside

 private:
  const BodyNode& node(int i) const { return m_.bodies[static_cast<std::size_t>(i)]; }
  int count() const { return static_cast<int>(m_.bodies.size()); }
  int find_body(const std::string& name) const {
    const auto found = m_.body_of_name.find(name);
    return found != m_.body_of_name.end() ? found->second : -1;
  }
  int body_named(const std::string& name, const std::string& option) const {
    const int found = find_body(name);
    if (found >= 0) return found;
    std::string ends;
    for (int i = 0; i < count(); ++i)
      if (m_.children[static_cast<std::size_t>(i)].empty() && ends.size() < 300) ends += " " + node(i).name;
    throw Refused(from_ + ": " + option + ": there is no body '" + name + "'" +
                  (option == "--tip" ? ", and no site" : "") + "; bodies at the ends are" + ends);
  }
  void find_tip(const std::string& name) {
    tip = find_body(name);
    if (const auto found = m_.body_of_site.find(name); tip < 0 && found != m_.body_of_site.end())
      tip = found->second, site = name;
    if (tip < 0) body_named(name, "--tip");
  }
  int top(int i) const {
    while (node(i).parent > 0)
      i = node(i).parent;
    return i;
  }
  /// The world, or the one body that floats and carries joints.
  int default_root() {
    if (has_tip()) return node(top(tip)).free ? top(tip) : 0;
    std::set<int> with_joints;
    for (int i = 1; i < count(); ++i)
      if (!node(i).joints.empty()) with_joints.insert(top(i));
    int floating = 0;
    std::string names;
    for (const int i : with_joints) {
      names += (names.empty() ? "'" : ", '") + node(i).name + "'";
      if (node(i).free) floating = i;
    }
    if (floating > 0 && with_joints.size() > 1)
      throw Refused(from_ + ": several robots, of which '" + node(floating).name + "' floats: " + names +
                    "; choose one by --root, or world for all that stand");
    return floating;
  }

  const Model& m_;
  const std::string& from_;
};

class Cut {
 public:
  Cut(const Model& model, const std::string& from, const ReadingOptions& options)
      : m_(model), options_(options), choice_(model, from, options), laws_(laws_of(model)) {
    auto& tree = result_.tree;
    tree.name = m_.name.empty() ? "robot" : m_.name, tree.notes = m_.notes, tree.warnings = m_.warnings,
    tree.length_digit = m_.length_digit;
    result_.engine = "MuJoCo itself";
    frames_.assign(m_.bodies.size(), -1);
    scale_ = scale();
    add_root();
    check_leaders(result_.tree, [this](const SourceJoint& joint, LeaderFault fault) { refuse_leader(joint, fault); });
    check_tendons(m_, tree);
    refuse_loops(m_, [&](const std::string& body) { return carrier(body); });
    set_efforts(m_, tree);
    take_bodies();
    say();
  }
  EngineTree result() const { return result_; }

 private:
  const BodyNode& node(int i) const { return m_.bodies[static_cast<std::size_t>(i)]; }
  std::vector<SourceLink>& links() { return result_.tree.links; }

  double scale() const {
    if (m_.settings.total_mass <= 0.0) return 1.0;
    Real sum = 0.0L;
    for (const auto& body : m_.bodies)
      if (body.parent >= 0) sum += inertia_of(body, m_.settings).mass;
    return sum > 0.0L ? static_cast<double>(m_.settings.total_mass / sum) : 1.0;
  }

  void add_root() {
    const int root = choice_.root;
    const auto& body = node(root);
    add_link(body.name, -1, {}, {"body", body.named ? body.name : "", "", root});
    frames_[static_cast<std::size_t>(root)] = 0, owners_.push_back(root);
    result_.tree.floating = body.free;
    Matrix world = Matrix::Identity();
    for (int at = root; at > 0; at = node(at).parent)
      world = node(at).pose.rotation * world;
    const auto& g = m_.settings.gravity;
    const Vector turned = world.transpose() * Vector(g[0], g[1], g[2]);
    result_.gravity = {rounded(turned[0]), rounded(turned[1]), rounded(turned[2])};
    add_sites(root, 0), add_children(root);
  }
  int add_link(const std::string& name, int parent, const SourceJoint& joint, const EngineName& names) {
    SourceLink link;
    link.name = name, link.parent = parent, link.joint = joint;
    link.between = names.kind.empty();
    links().push_back(link), result_.names.push_back(names);
    if (joint.moves() && parent >= 0) ++movers_;
    if (movers_ > description::most_links || links().size() > 1000)
      throw Refused(node(names.body).place + ": body '" + node(names.body).name + "' is one too many: at most " +
                    std::to_string(description::most_links) +
                    " joints and 1000 bodies are imported; choose a --root, or a --tip");
    return static_cast<int>(links().size()) - 1;
  }
  void add_children(int body) {
    for (const int i : m_.children[static_cast<std::size_t>(body)])
      add_body(i);
  }
  void add_body(int i) {
    const auto& body = node(i);
    const bool on_path = choice_.path.count(i) != 0;
    if (choice_.has_tip() && body.parent == choice_.root && !on_path) return;
    if (body.free) {
      left_.push_back(body.name);
      return;
    }
    int parent = frames_[static_cast<std::size_t>(body.parent)];
    Pose pose = body.pose;
    for (std::size_t k = 0; k < body.joints.size(); ++k) {
      const auto& joint = body.joints[k];
      const bool last = k + 1 == body.joints.size(), here = last && joint.anchor.norm() == 0.0L;
      const std::string name = last ? body.name : body.name + " before " + body.joints[k + 1].name;
      parent = add_link(
          name, parent, source_joint(joint, pose * moved(joint.anchor), on_path),
          {here ? "body" : "", body.named ? body.name : "", joint.named ? joint.name : "", i, static_cast<int>(k)});
      owners_.push_back(last ? i : -1);
      pose = moved(-joint.anchor);
    }
    if (body.joints.empty() || body.joints.back().anchor.norm() != 0.0L) {
      const bool mass = body.joints.empty();
      SourceJoint still;
      still.name = "frame of " + body.name, still.origin = placement(pose);
      parent = add_link(mass ? body.name : body.name + " frame", parent, still,
                        {"body", body.named ? body.name : "", "", i});
      owners_.push_back(mass ? i : -1);
    }
    frames_[static_cast<std::size_t>(i)] = parent;
    if (choice_.tip == i) result_.tree.tool = parent;
    add_sites(i, parent), add_children(i);
  }
  void add_sites(int i, int parent) {
    for (const auto& fixed : node(i).sites) {
      const std::string name = fixed.attributes.word("name", "");
      if (name.empty()) continue;
      double unused = 0.0;
      SourceJoint still;
      still.name = "site " + name;
      still.origin = placement(fixed.frame * pose_of(fixed.attributes, m_.settings, unused));
      const bool taken = m_.body_of_name.count(name) != 0;
      const int link = add_link(taken ? "site " + name : name, parent, still, {"site", name, "", i});
      owners_.push_back(-1);
      if (choice_.site == name) result_.tree.tool = link;
    }
  }

  SourceJoint source_joint(const JointNode& joint, const Pose& origin, bool on_path) {
    SourceJoint result;
    result.name = joint.name;
    if (joint.type == "ball") return ball(joint, origin, on_path);
    result.kind = joint.turns() ? Kind::revolute : Kind::prismatic;
    for (std::size_t k = 0; k < 3; ++k)
      result.axis[k] = static_cast<double>(joint.axis[static_cast<int>(k)]);
    result.origin = placement(origin * before(joint));
    result.has_limits = joint.limited, result.lower = joint.lower, result.upper = joint.upper;
    couple(joint, on_path, result);
    const auto& a = joint.attributes;
    result.damping = positive(a, "damping"), result.friction = positive(a, "frictionloss");
    result.rotor = positive(a, "armature"), result.stiffness = positive(a, "stiffness");
    const double unit = joint.turns() ? static_cast<double>(m_.settings.angle) : 1.0;
    if (result.stiffness != 0.0) result.rest = a.number("springref", 0.0) * unit;
    return result;
  }
  SourceJoint ball(const JointNode& joint, const Pose& origin, bool on_path) {
    if (!choice_.has_tip() || on_path)
      joint.attributes.refuse("type is 'ball': three freedoms in one joint",
                              "write three hinges in the body, or choose a --tip that leaves it beside the chain");
    SourceJoint result;
    result.name = joint.name, result.origin = placement(origin), held_.push_back(joint.name);
    return result;
  }
  static double positive(const Attributes& a, const std::string& name) {
    const double value = a.number(name, 0.0);
    if (value < 0.0) a.refuse(name + " is " + description::number(value), "give a value that is not below 0");
    return value;
  }
  /// Back from where the file draws a joint to where its position is 0.
  Pose before(const JointNode& joint) const {
    Pose result;
    if (joint.turns())
      result.rotation = Eigen::AngleAxis<Real>(-Real(joint.zero), joint.axis).toRotationMatrix();
    else
      result.position = -Real(joint.zero) * joint.axis;
    return result;
  }
  void couple(const JointNode& joint, bool on_path, SourceJoint& result) {
    const auto law = laws_.find(joint.name);
    const bool beside = choice_.has_tip() && !on_path;
    if (beside) {
      result.held = true, result.held_at = joint.zero, held_.push_back(joint.name);
      if (joint.limited) result.held_at = std::clamp(joint.zero, joint.lower, joint.upper);
    } else if (law != laws_.end() && !law->second.problem.empty()) {
      law->second.written.refuse(law->second.problem,
                                 "axial has joints that follow others linearly; take it out for a "
                                 "drive of its own, or choose a --tip beside which it is held");
    } else if (law != laws_.end() && (law->second.leader.empty() || options_.hold_mimic)) {
      result.held = true, result.held_at = law->second.offset, fixed_.push_back(joint.name);
    } else if (law != laws_.end()) {
      result.leader = law->second.leader, result.ratio = law->second.ratio, result.offset = law->second.offset;
    }
  }
  void refuse_leader(const SourceJoint& joint, LeaderFault fault) const {
    const auto& written = laws_.at(joint.name).written;
    if (fault == LeaderFault::follows_itself)
      written.refuse("joint '" + joint.name + "' follows itself, by way of others", "one of them has a drive");
    written.refuse("joint '" + joint.name + "' follows '" + joint.leader + "', which does not move here",
                   "--hold-mimic holds it; or choose a --tip beside which it is held");
  }

  /// The link that carries a body and moves; -1: none; -2: the body is not in the tree.
  int carrier(const std::string& body) {
    const auto found = m_.body_of_name.find(body);
    if (found == m_.body_of_name.end()) return -2;
    int at = frames_[static_cast<std::size_t>(found->second)];
    if (at < 0) return found->second == 0 ? -1 : -2;
    while (at > 0 && !links()[static_cast<std::size_t>(at)].joint.moves())
      at = links()[static_cast<std::size_t>(at)].parent;
    return at > 0 ? at : -1;
  }

  /// Of bodies that something moves: those of others may have meshes.
  void take_bodies() {
    for (std::size_t i = 0; i < links().size(); ++i) {
      if (owners_[i] < 0) continue;
      const auto& body = node(owners_[i]);
      if (carrier(body.name) < 0 && !result_.tree.floating) continue;
      Body found;
      if (carrier(body.name) >= 0)
        found = inertia_of(body, m_.settings);
      else if (!base_body(body, found))
        return take_bodies();  // the base stands still now
      result_.names[i].weighs = true;
      result_.is_diagonalised = result_.is_diagonalised || is_diagonalised(body, m_.settings);
      const Vector shift = body.joints.empty() ? Vector(Vector::Zero()) : Vector(-body.joints.back().anchor);
      take(found, owners_[i] == choice_.root ? Vector(Vector::Zero()) : shift, links()[i]);
    }
  }
  /// Of a base that floats. What has it by a mesh stands still where --root chose it.
  bool base_body(const BodyNode& body, Body& found) {
    try {
      found = inertia_of(body, m_.settings);
      return true;
    } catch (const Refused& refused) {
      const std::string& root = node(choice_.root).name;
      if (options_.root.empty())
        throw Refused(std::string(refused.what()) + "; or give --root '" + root + "', a base that stands still then");
      result_.tree.floating = false;
      result_.tree.notes.push_back("body '" + body.name +
                                   "' of the base has its mass by a mesh: the base stands still");
      return false;
    }
  }
  void take(const Body& body, const Vector& shift, SourceLink& link) const {
    link.has_inertial = body.mass != 0.0L || body.inertia.cwiseAbs().sum() != 0.0L;
    link.mass = static_cast<double>(body.mass) * scale_;
    link.inertial = placement(moved(body.com + shift));
    const auto& j = body.inertia;
    link.inertia = {entry(j(0, 0)), entry(j(1, 1)), entry(j(2, 2)), entry(j(0, 1)), entry(j(0, 2)), entry(j(1, 2))};
  }
  double entry(Real value) const { return static_cast<double>(value) * scale_; }

  static std::string listed(const std::vector<std::string>& names) {
    std::string all;
    for (const auto& name : names)
      all += (all.empty() ? "" : ", ") + name;
    return all;
  }
  void say() {
    auto& notes = result_.tree.notes;
    if (result_.tree.floating)
      notes.push_back("joint '" + node(choice_.root).free_joint + "' is free: body '" + node(choice_.root).name +
                      "' is the base, fixed unless a scene names FloatingBase");
    if (!held_.empty())
      notes.push_back(
          "joints beside the chain are held where the file draws them (or at their nearest limit), their "
          "bodies carried along: " +
          listed(held_));
    if (!fixed_.empty())
      notes.push_back("joints that an equality holds, their bodies carried along: " + listed(fixed_));
    if (!left_.empty()) notes.push_back("bodies that float beside are left out: " + listed(left_));
    if (scale_ != 1.0)
      notes.push_back("all masses and inertias times " + description::number(scale_, 6) + " (settotalmass)");
  }

  const Model& m_;
  const ReadingOptions& options_;
  Choice choice_;
  std::map<std::string, Law> laws_;
  EngineTree result_;
  std::vector<int> frames_;  ///< of bodies: the link that is their frame, -1 for none
  std::vector<int> owners_;  ///< of links: the body whose mass they have, -1 for none
  std::vector<std::string> held_, fixed_, left_;
  double scale_ = 1.0;
  int movers_ = 0;
};

}  // namespace
}  // namespace mjcf

EngineTree read_mjcf(const std::string& text, const std::string& from, const ReadingOptions& options) {
  mjcf::Model model;
  mjcf::read_model(text, from, model);
  return mjcf::Cut(model, from, options).result();
}

}  // namespace importer

#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/import/couplings.hpp>
#include <host_sim/robots/import/right_angles.hpp>
#include <host_sim/robots/import/sdf/model.hpp>
#include <host_sim/robots/import/sdf/sdf_reader.hpp>
#include <host_sim/robots/import/sdf/sdf_text.hpp>

#include <sdf/Frame.hh>
#include <sdf/JointAxis.hh>

#include <algorithm>
#include <cmath>
#include <set>

namespace importer {
namespace sdf_model {
namespace {

using description::harmless;
using description::number;
using description::Refused;

Pose moved(const Vector& by) { return {Matrix::Identity(), by}; }

Placement placement(const Pose& pose) {
  Placement result;
  for (int k = 0; k < 9; ++k)
    result.rotation[static_cast<std::size_t>(k)] = static_cast<double>(pose.rotation(k / 3, k % 3));
  for (int k = 0; k < 3; ++k)
    result.position[static_cast<std::size_t>(k)] = static_cast<double>(pose.position[k]);
  return result;
}

constexpr int none = -2, the_world = -1;  // of links

/// Chooses a model, root and tip among the links, and what is between them.
class Choice {
 public:
  Choice(const Model& model, const ReadingOptions& options) : m_(model) {
    if (!options.tip.empty()) find_tip(options.tip);
    if (!options.root.empty()) root = options.root == "world" ? the_world : link_named(options.root, "--root");
    if (options.root.empty() || (root == the_world && tip < 0)) default_root(options.root.empty());
    for (int at = tip; has_tip() && at != root; at = parent(at)) {
      if (at < 0)
        throw Refused(m_.from + ": '" + options.tip + "' does not hang on '" + options.root +
                      "'; choose another --root");
      path.insert(at);
    }
    top = top_of(root >= 0 ? root : tip >= 0 ? tip : first_of_world);
  }
  bool has_tip() const { return tip >= 0; }
  bool is_free(int link) const { return m_.links[static_cast<std::size_t>(link)].joint < 0; }

  int root = none, tip = none, top = 0;
  std::string frame;  ///< the tip, where it is a frame of that link
  int frame_model = 0;
  std::set<int> path;

 private:
  int count() const { return static_cast<int>(m_.links.size()); }
  const LinkNode& node(int i) const { return m_.links[static_cast<std::size_t>(i)]; }
  int top_of(int i) const { return m_.models[static_cast<std::size_t>(node(i).model)].top; }
  int parent(int i) const {
    return node(i).joint < 0 ? none : m_.joints[static_cast<std::size_t>(node(i).joint)].parent;
  }
  int find_link(const std::string& name) const {
    int found = none;
    for (int i = 0; i < count(); ++i) {
      if (node(i).whole == name) return i;
      if (node(i).name != name) continue;
      if (found >= 0)
        throw Refused(m_.from + ": link '" + name + "' is there twice: give '" + node(found).whole + "' or '" +
                      node(i).whole + "'");
      found = i;
    }
    return found;
  }
  int link_named(const std::string& name, const std::string& option) const {
    if (const int found = find_link(name); found >= 0) return found;
    std::set<int> carriers;
    for (const auto& joint : m_.joints)
      carriers.insert(joint.parent);
    std::string ends;
    for (int i = 0; i < count(); ++i)
      if (carriers.count(i) == 0 && ends.size() < 300) ends += " " + node(i).name;
    throw Refused(m_.from + ": " + option + ": there is no link '" + name + "'" +
                  (option == "--tip" ? ", and no frame" : "") + "; links at the ends are" + ends);
  }
  void find_tip(const std::string& name) {
    tip = find_link(name);
    for (std::size_t i = 0; tip < 0 && i < m_.models.size(); ++i)
      for (std::uint64_t k = 0; k < m_.models[i].model->FrameCount(); ++k) {
        const std::string own = m_.models[i].model->FrameByIndex(k)->Name();
        if (harmless(m_.models[i].scope + own) != name) continue;
        frame = own, frame_model = static_cast<int>(i), tip = m_.link_of(frame_model, own);
      }
    if (tip < 0) link_named(name, "--tip");
  }
  /// The farthest that carries a link; the world where a joint fixes it there.
  int base_of(int i) const {
    while (i >= 0 && parent(i) != none)
      i = parent(i);
    return i;
  }
  static bool moves(const JointNode& joint) { return joint.joint->Type() != sdf::JointType::FIXED; }
  void default_root(bool any) {
    if (has_tip()) {
      root = base_of(tip);
      return;
    }
    std::set<std::pair<int, int>> bases;  // with joints that move: the model, and what carries them
    std::string names;
    for (const auto& joint : m_.joints) {
      const int base = base_of(joint.child), model = top_of(joint.child);
      if (base == the_world && first_of_world < 0) first_of_world = joint.child;
      if (!moves(joint) || (!any && base >= 0) || !bases.insert({model, base}).second) continue;
      names += (names.empty() ? "'" : ", '") + (base < 0 ? node(joint.child).whole : node(base).whole) + "'";
      root = base, first_of_world = joint.child;
    }
    if (bases.empty()) throw Refused(m_.from + ": there is no joint that moves; is a part of the robot missing?");
    if (bases.size() > 1) throw Refused(m_.from + ": several robots: " + names + "; choose one by --root MODEL::LINK");
  }

  const Model& m_;
  int first_of_world = none;
};

class Cut {
 public:
  Cut(Model& model, const sdf_text::Checked& checked, const std::string& from, const ReadingOptions& options)
      : m_(model), from_(from), options_(options), choice_(model, options) {
    auto& tree = result_.tree;
    tree.name = harmless(m_.models[static_cast<std::size_t>(choice_.top)].model->Name());
    tree.notes = checked.notes, tree.warnings = checked.warnings, result_.engine = "DART";
    refuse_static();
    for (std::size_t i = 0; i < m_.joints.size(); ++i)
      children_[m_.joints[i].parent].push_back(static_cast<int>(i));
    add_root();
    check_leaders(result_.tree, [this](const SourceJoint& joint, LeaderFault fault) { refuse_leader(joint, fault); });
    if (tree.tool < 0 && choice_.has_tip()) add_frame();
    say();
    tree.length_digit = digit_.value();
  }
  EngineTree result() const { return result_; }

 private:
  std::vector<SourceLink>& links() { return result_.tree.links; }
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const {
    throw Refused(from_ + ": " + what + "; " + remedy);
  }
  const LinkNode& node(int i) const { return m_.links[static_cast<std::size_t>(i)]; }
  void refuse_static() const {
    for (const auto& node : m_.models)
      if (node.top == choice_.top && node.model->Static())
        refuse("model '" + harmless(node.model->Name()) + "' is static: nothing of it moves",
               "take <static> out; a base stands still by a fixed joint to the world");
  }

  void add_root() {
    const bool stands = choice_.root == the_world;
    const Pose at = stands ? Pose{} : m_.pose_of(node(choice_.root));
    result_.tree.floating = !stands && choice_.is_free(choice_.root);
    const auto g = m_.world() != nullptr ? m_.world()->Gravity() : ignition::math::Vector3d(0.0, 0.0, -9.81);
    const Vector turned = at.rotation.transpose() * vector(g);
    result_.gravity = {rounded(turned[0]), rounded(turned[1]), rounded(turned[2])};
    if (m_.world() == nullptr)
      result_.assumptions.push_back("gravity of 9.81 m/s^2 along -z of the world: the file has a model alone");
    else
      refuse_wind();
    SourceLink root;
    root.name = stands ? "world" : node(choice_.root).name;
    links().push_back(root);
    // A world has no frame of its own for an engine to tell.
    result_.names.push_back({stands ? "" : "link", stands ? "" : node(choice_.root).whole, "", -1, 0, false});
    if (result_.tree.floating) {
      take_body(node(choice_.root), Vector::Zero(), 0);
      result_.tree.notes.push_back("no joint fixes link '" + root.name +
                                   "' to the world: it is the base, fixed unless a scene names FloatingBase");
    }
    if (choice_.root == choice_.tip && choice_.frame.empty()) result_.tree.tool = 0;
    at_[choice_.root] = 0;
    add_children(choice_.root, at);
  }
  void refuse_wind() const {
    const auto& wind = m_.world()->WindLinearVelocity();
    for (const auto& node : m_.models)
      if (node.top == choice_.top && node.model->EnableWind() && wind.Length() > 0.0)
        refuse("model '" + harmless(node.model->Name()) + "' stands in a wind of " + number(wind.Length()) + " m/s",
               "take <enable_wind> out");
  }

  /// `frame`: in the world, of the tree's link that carries them.
  void add_children(int link, const Pose& frame) {
    const auto found = children_.find(link);
    if (found == children_.end()) return;
    for (const int i : found->second) {
      const auto& joint = m_.joints[static_cast<std::size_t>(i)];
      const bool on_path = choice_.path.count(joint.child) != 0;
      const bool of_others = m_.models[static_cast<std::size_t>(joint.model)].top != choice_.top;
      if (!of_others && (!choice_.has_tip() || link != choice_.root || on_path)) add(joint, frame, on_path);
    }
  }
  void add(const JointNode& joint, const Pose& carrier, bool on_path) {
    const auto& child = node(joint.child);
    const Pose own = m_.pose_of(child), at = m_.pose_of(joint);
    // The axis goes through the origin of the tree's link, which has the axes of the file's.
    const SourceJoint source = source_joint(joint, own, on_path);
    const Pose frame{own.rotation, source.kind == Kind::fixed ? own.position : at.position};
    const Vector shift = frame.rotation.transpose() * (own.position - frame.position);
    const bool here = shift.norm() < 1e-14L;
    const int parent = at_.at(joint.parent);
    const int index = add_link(child.name, parent, source, carrier.inverse() * frame,
                               {here ? "link" : "", child.whole, whole(joint), -1, 0, false}, joint);
    take_body(child, here ? Vector(Vector::Zero()) : shift, index);
    int last = index;
    if (!here) {
      SourceJoint still;
      still.name = "frame of " + child.name;
      last =
          add_link(child.name + " frame", index, still, moved(shift), {"link", child.whole, "", -1, 0, false}, joint);
    }
    at_[joint.child] = last;
    if (choice_.tip == joint.child && choice_.frame.empty()) result_.tree.tool = last;
    add_children(joint.child, here ? frame : own);
  }
  int add_link(const std::string& name, int parent, const SourceJoint& joint, const Pose& origin,
               const EngineName& names, const JointNode& by) {
    SourceLink link;
    link.name = name, link.parent = parent, link.joint = joint, link.joint.origin = placement(origin);
    for (const double length : link.joint.origin.position)
      digit_.see(number(rounded(Real(length)), 9), length);
    links().push_back(link), result_.names.push_back(names);
    if (joint.moves()) ++movers_;
    if (movers_ > description::most_links || links().size() > 1000)
      refuse("joint '" + by.name + "' is one too many: at most " + std::to_string(description::most_links) +
                 " joints and 1000 links are imported",
             "choose a --root, or a --tip");
    return static_cast<int>(links().size()) - 1;
  }
  std::string whole(const JointNode& joint) const {
    return harmless(m_.models[static_cast<std::size_t>(choice_.top)].model->Name()) + "::" + joint.name;
  }
  void add_frame() {
    if (choice_.frame.empty()) return;
    const Pose carrier = choice_.tip == the_world ? Pose{} : m_.pose_of(node(choice_.tip));
    SourceJoint still;
    const auto& model = m_.models[static_cast<std::size_t>(choice_.frame_model)];
    const std::string name = harmless(model.scope + choice_.frame);
    still.name = "frame " + name;
    const Pose frame = m_.pose_of(choice_.frame_model) * m_.pose_in(choice_.frame_model, choice_.frame);
    result_.tree.tool =
        add_link(name, at_.at(choice_.tip), still, carrier.inverse() * frame,
                 {"frame", harmless(m_.models[static_cast<std::size_t>(choice_.top)].model->Name()) + "::" + name, "",
                  -1, 0, false},
                 {});
  }

  // --- joints

  SourceJoint source_joint(const JointNode& joint, const Pose& own, bool on_path) {
    SourceJoint result;
    result.name = joint.name;
    const auto type = joint.joint->Type();
    if (type == sdf::JointType::FIXED) return result;
    const bool beside = choice_.has_tip() && !on_path;
    const bool moves =
        type == sdf::JointType::REVOLUTE || type == sdf::JointType::CONTINUOUS || type == sdf::JointType::PRISMATIC;
    if (!moves && !beside) refuse_type(joint);
    if (beside) held_.push_back(result.name);
    if (!moves) return result;  // held where it is drawn
    if (joint.joint->Axis(0) == nullptr) refuse("joint '" + joint.name + "' has no <axis>", "give one");
    result.kind = type == sdf::JointType::PRISMATIC    ? Kind::prismatic
                  : type == sdf::JointType::CONTINUOUS ? Kind::continuous
                                                       : Kind::revolute;
    const Vector axis = own.rotation.transpose() * m_.axis_of(joint);
    for (std::size_t k = 0; k < 3; ++k)
      result.axis[k] = static_cast<double>(axis[static_cast<int>(k)]);
    read_axis(joint, *joint.joint->Axis(0), result);
    result.held = result.held || beside;
    if (beside && result.has_limits) result.held_at = std::clamp(0.0, result.lower, result.upper);
    return result;
  }
  [[noreturn]] void refuse_type(const JointNode& joint) const {
    const std::string beside = "; or choose a --tip that leaves it beside the chain, where joints are held";
    const std::string here = "joint '" + joint.name + "' is ";
    switch (joint.joint->Type()) {
      case sdf::JointType::BALL:
        refuse(here + "a ball: three freedoms", "write three revolute joints with links between" + beside);
      case sdf::JointType::UNIVERSAL:
      case sdf::JointType::REVOLUTE2:
        refuse(here + "universal or revolute2: two freedoms", "write two revolute joints with a link between" + beside);
      case sdf::JointType::SCREW:
        refuse(here + "a screw: a turn that shifts",
               "write a revolute and a prismatic joint that mimics it, with a link between" + beside);
      case sdf::JointType::GEARBOX:
        refuse(here + "a gearbox: it couples two other joints", "write <mimic> in the joint that follows" + beside);
      default:
        refuse(here + "of a kind that is not known here", "write revolute, continuous, prismatic or fixed" + beside);
    }
  }
  void read_axis(const JointNode& joint, const sdf::JointAxis& axis, SourceJoint& result) {
    const std::string here = "joint '" + joint.name + "': ";
    constexpr double far = 1e9;  // what stands for none, or might as well
    const bool below = axis.Lower() > -far, above = axis.Upper() < far;
    result.lower = axis.Lower(), result.upper = axis.Upper();
    if (axis.Lower() > axis.Upper())
      refuse(
          here + "position limits are upside down: lower " + number(axis.Lower()) + ", upper " + number(axis.Upper()),
          "give the lower one first");
    if (below && above && axis.Lower() == axis.Upper() && result.kind != Kind::continuous) {
      result.held = true, result.held_at = axis.Lower();
      locked_.push_back(joint.name);
    }
    result.has_limits = result.kind != Kind::continuous && below && above;
    if (result.kind != Kind::continuous && below != above) half_.push_back(joint.name);
    result.speed = limit(axis.MaxVelocity()), result.effort = limit(axis.Effort());
    const auto positive = [&](double value, const std::string& name) {
      if (value < 0.0) refuse(here + name + " is " + number(value), "give a value that is not below 0");
      return value;
    };
    result.damping = positive(axis.Damping(), "damping"), result.friction = positive(axis.Friction(), "friction");
    result.stiffness = positive(axis.SpringStiffness(), "spring_stiffness");
    if (result.stiffness != 0.0) result.rest = axis.SpringReference();
    read_mimic(joint, axis, result);
  }
  /// An infinite one, and one below 0, are none.
  static double limit(double value) { return value > 0.0 && std::isfinite(value) ? value : 0.0; }
  void read_mimic(const JointNode& joint, const sdf::JointAxis& axis, SourceJoint& result) {
    const auto element = axis.Element();
    if (element == nullptr || !element->HasElement("mimic")) return;
    const auto mimic = element->FindElement("mimic");
    const auto value = [&](const std::string& name, double otherwise) {
      const auto found = mimic->FindElement(name);
      return found == nullptr || found->GetValue() == nullptr ? otherwise : std::stod(found->GetValue()->GetAsString());
    };
    const auto leader = mimic->GetAttribute("joint");
    const auto of = mimic->GetAttribute("axis");
    const std::string here = "joint '" + joint.name + "': ";
    if (leader == nullptr || leader->GetAsString().empty())
      refuse(here + "<mimic> names no joint", "give joint=\"...\", the one that it follows");
    if (of != nullptr && !of->GetAsString().empty() && of->GetAsString() != "axis")
      refuse(here + "mimics '" + harmless(of->GetAsString()) + "' of a joint", "joints of one axis can be followed");
    const double ratio = value("multiplier", 1.0), reference = value("reference", 0.0);
    result.offset = value("offset", 0.0) - ratio * reference, result.ratio = ratio;
    if (!(std::abs(ratio) > 1e-9 && std::abs(ratio) < 1e9) || !(std::abs(result.offset) < 1e9))
      refuse(here + "mimics with multiplier " + number(ratio) + " and offset " + number(result.offset),
             "give a multiplier that is not 0; a joint that cannot move is a fixed joint");
    if (options_.hold_mimic) {
      result.held = true, result.held_at = result.offset, result.ratio = 1.0, result.offset = 0.0;
      mimics_.push_back(joint.name);
    } else {
      result.leader = harmless(m_.models[static_cast<std::size_t>(joint.model)].scope + leader->GetAsString());
    }
  }
  void refuse_leader(const SourceJoint& joint, LeaderFault fault) const {
    if (fault == LeaderFault::follows_itself)
      refuse("joint '" + joint.name + "' mimics itself, by way of others", "one of them has a drive");
    refuse("joint '" + joint.name + "' mimics '" + joint.leader + "', which does not move here",
           "--hold-mimic holds it; or choose a --tip beside which it is held");
  }

  // --- bodies

  bool is_carried(int link) {
    for (; link > 0; link = links()[static_cast<std::size_t>(link)].parent)
      if (links()[static_cast<std::size_t>(link)].joint.moves()) return true;
    return result_.tree.floating;
  }
  void take_body(const LinkNode& node, const Vector& shift, int index) {
    if (!is_carried(index)) return;
    const auto element = node.link->Element();
    check_link(node, *element);
    auto& link = links()[static_cast<std::size_t>(index)];
    const auto& inertial = node.link->Inertial();
    const auto& m = inertial.MassMatrix();
    const auto &diagonal = m.DiagonalMoments(), &products = m.OffDiagonalMoments();
    link.mass = m.Mass();
    link.inertia = {diagonal.X(), diagonal.Y(), diagonal.Z(), products.X(), products.Y(), products.Z()};
    link.inertial = placement(moved(shift) * pose(inertial.Pose()));
    link.has_inertial = link.mass != 0.0 || diagonal.Length() != 0.0;
    result_.names[static_cast<std::size_t>(index)].weighs = true;
    if (result_.names[static_cast<std::size_t>(index)].name.empty()) return;
    warn_of_defaults(node, *element);
  }
  void check_link(const LinkNode& node, sdf::Element& element) const {
    const std::string here = "link '" + node.name + "': ", remedy = "take it out if the motion does not depend on it";
    if (!element.Get<bool>("gravity", true).first) refuse(here + "gravity does not act on it", remedy);
    if (element.Get<bool>("kinematic", false).first) refuse(here + "kinematic: it moves without forces", remedy);
    if (element.HasElement("velocity_decay")) {
      const auto decay = element.FindElement("velocity_decay");
      for (const char* name : {"linear", "angular"})
        if (const double value = decay->Get<double>(name, 0.0).first; value != 0.0)
          refuse(here + "velocity_decay is " + number(value) + ": a drag on the link",
                 "write the joints' damping instead, or take it out");
    }
  }
  /// What a file leaves out has values that few robots have.
  void warn_of_defaults(const LinkNode& node, sdf::Element& element) {
    std::string missing = "mass and inertia";
    if (element.HasElement("inertial")) {
      const auto inertial = element.FindElement("inertial");
      const bool mass = inertial->HasElement("mass"), inertia = inertial->HasElement("inertia");
      if (mass && inertia) return;
      missing = mass ? "inertia" : inertia ? "mass" : missing;
    }
    result_.tree.warnings.push_back({false, node.name, "has no " + missing + ": in an SDF these are 1 kg, 1 kg m^2",
                                     "write <inertial> with what it weighs"});
  }

  static std::string listed(const std::vector<std::string>& names) {
    std::string all;
    for (const auto& name : names)
      all += (all.empty() ? "" : ", ") + name;
    return all;
  }
  void say() {
    auto& notes = result_.tree.notes;
    const auto say = [&](const std::string& what, const std::vector<std::string>& names) {
      if (!names.empty()) notes.push_back(what + ": " + listed(names));
    };
    say("joints beside the chain are held at 0 (or their nearest limit), their bodies carried along", held_);
    say("joints whose limits are one position are held there, their bodies carried along", locked_);
    say("joints that mimic another one are held where that one is 0, their bodies carried along", mimics_);
    say("position limits of which there is only one are left out", half_);
    std::vector<std::string> left;
    for (const auto& node : m_.models)
      if (node.parent < 0 && node.top != choice_.top) left.push_back(harmless(node.model->Name()));
    say("models that are left out", left);
    std::vector<std::string> loose;
    for (std::size_t i = 0; i < m_.links.size(); ++i)
      if (m_.links[i].joint < 0 && static_cast<int>(i) != choice_.root && !choice_.has_tip() && options_.root.empty() &&
          m_.models[static_cast<std::size_t>(m_.links[i].model)].top == choice_.top)
        loose.push_back(m_.links[i].name);
    say("links that nothing carries are left out", loose);
  }

  Model& m_;
  const std::string& from_;
  const ReadingOptions& options_;
  Choice choice_;
  EngineTree result_;
  std::map<int, std::vector<int>> children_;  ///< joints by the link that carries them
  std::map<int, int> at_;                     ///< of links: the tree's link that is their frame
  std::vector<std::string> held_, locked_, mimics_, half_;
  LengthDigit digit_;
  int movers_ = 0;
};

}  // namespace
}  // namespace sdf_model

EngineTree read_sdf(const std::string& text, const std::string& from, const ReadingOptions& options) {
  const host_sim::TemporaryFolder folder;
  const auto checked = sdf_text::check(text, from, folder);
  sdf_model::Model model(checked.text, from);
  return sdf_model::Cut(model, checked, from, options).result();
}

}  // namespace importer

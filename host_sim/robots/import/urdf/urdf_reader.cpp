#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/import/couplings.hpp>
#include <host_sim/robots/import/right_angles.hpp>
#include <host_sim/robots/import/urdf/transmissions.hpp>
#include <host_sim/robots/import/urdf/urdf_reader.hpp>
#include <host_sim/robots/import/urdf/urdf_text.hpp>

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <set>

namespace importer {
namespace {

using description::number;
using description::Refused;

/// What urdfdom prints while this lives.
class Messages : public console_bridge::OutputHandler {
 public:
  Messages() { console_bridge::useOutputHandler(this); }
  ~Messages() override { console_bridge::restorePreviousOutputHandler(); }
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) text_ += (text_.empty() ? "" : "; ") + text;
  }
  std::string text() const { return description::harmless(text_); }

 private:
  std::string text_;
};

urdf::ModelInterfaceSharedPtr parse(const std::string& text, const std::string& from) {
  Messages messages;
  std::string thrown;
  try {
    auto model = urdf::parseURDF(text);
    // urdfdom leaves a body out that it cannot read, and goes on.
    if (model && messages.text().find("nertia") == std::string::npos) return model;
  } catch (const std::exception& error) {
    thrown = description::harmless(error.what());
  }
  throw Refused(from + ": " + (thrown.empty() ? messages.text() : thrown) +
                "; give what a URDF needs there, numbers as 1.5 with a point and spaces between");
}

Kind kind_of(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
      return Kind::revolute;
    case urdf::Joint::CONTINUOUS:
      return Kind::continuous;
    case urdf::Joint::PRISMATIC:
      return Kind::prismatic;
    default:
      return Kind::fixed;
  }
}

class Reader {
 public:
  Reader(const urdf::ModelInterface& model, const std::string& from, const ReadingOptions& options,
         const WrittenNumbers& written, const Nearness& near)
      : model_(model), from_(from), written_(written), angles_(near), hold_mimic_(options.hold_mimic) {
    tree_.name = model.getName();
    const auto root = find(options.root.empty() ? model.getRoot()->name : options.root, "--root");
    if (!options.tip.empty()) choose_path(root, find(options.tip, "--tip"));
    has_tip_ = !options.tip.empty();
    add(root, -1);
    if (has_tip_) choose_tool(options.tip);
    check_leaders(tree_, [this](const SourceJoint& joint, LeaderFault fault) { refuse_leader(joint, fault); });
    if (!problems_.empty()) throw Refused(problems_);
    say_held();
    tree_.changes = angles_.changes(), tree_.warnings = angles_.warnings();
  }
  SourceTree tree() const { return tree_; }

 private:
  void refuse(const std::string& what, const std::string& remedy) {
    problems_ += (problems_.empty() ? "" : "\n") + from_ + ": " + what + "; " + remedy;
  }
  urdf::LinkConstSharedPtr find(const std::string& name, const std::string& option) const {
    const auto link = model_.getLink(name);
    if (link) return link;
    std::string leaves;
    for (const auto& entry : model_.links_)
      if (entry.second->child_joints.empty() && leaves.size() < 300) leaves += " " + entry.first;
    throw Refused(from_ + ": " + option + ": there is no link '" + name + "'; links at the ends are" + leaves);
  }
  void choose_path(const urdf::LinkConstSharedPtr& root, urdf::LinkConstSharedPtr tip) {
    const std::string name = tip->name;
    for (; tip && tip != root; tip = tip->getParent())
      path_.insert(tip->name);
    if (!tip)
      throw Refused(from_ + ": link '" + name + "' does not hang on '" + root->name + "'; choose another --root");
  }
  void choose_tool(const std::string& tip) {
    for (std::size_t i = 0; i < tree_.links.size(); ++i)
      if (tree_.links[i].name == tip) tree_.tool = static_cast<int>(i);
  }

  void add(const urdf::LinkConstSharedPtr& link, int parent) {
    SourceLink result;
    result.name = description::harmless(link->name), result.parent = parent;
    if (parent >= 0) result.joint = read_joint(*link->parent_joint, path_.count(link->name) != 0);
    read_body(*link, result);
    const int index = static_cast<int>(tree_.links.size());
    tree_.links.push_back(result);
    for (const auto& child : link->child_links)
      if (!has_tip_ || parent >= 0 || path_.count(child->name) != 0) add(child, index);
  }

  SourceJoint read_joint(const urdf::Joint& joint, bool on_path) {
    SourceJoint result;
    result.name = description::harmless(joint.name), result.kind = kind_of(joint);
    const bool mimics = joint.mimic && hold_mimic_;
    result.held = (mimics || (has_tip_ && !on_path)) && joint.type != urdf::Joint::FIXED;
    const auto& origin = joint.parent_to_joint_origin_transform.position;
    result.origin = {angles_.rotation(written_.joint_rpy.at(result.name), Change::Of::joint_rpy, result.name),
                     angles_.position({origin.x, origin.y, origin.z}, result.name)};
    if (joint.type == urdf::Joint::FIXED) return result;
    if (mimics)
      mimics_.push_back(result.name), result.held_at = joint.mimic->offset;
    else if (result.held)
      held_.push_back(result.name);
    else
      check_kind(joint, result.name), read_mimic(joint, result);
    read_axis(joint, result), read_limits(joint, result);
    return result;
  }
  void check_kind(const urdf::Joint& joint, const std::string& name) {
    const std::string beside = "; or choose a --tip that leaves it beside the chain, where joints are held";
    if (joint.type == urdf::Joint::FLOATING)
      refuse("joint '" + name + "' is floating: six freedoms",
             "import what it carries with --root, as a fixed base" + beside);
    if (joint.type == urdf::Joint::PLANAR)
      refuse("joint '" + name + "' is planar: three freedoms",
             "write two prismatic joints and a revolute one" + beside);
  }
  void read_mimic(const urdf::Joint& joint, SourceJoint& result) {
    if (!joint.mimic) return;
    result.leader = description::harmless(joint.mimic->joint_name);
    result.ratio = joint.mimic->multiplier, result.offset = joint.mimic->offset;
    if (!(std::abs(result.ratio) > 1e-9 && std::abs(result.ratio) < 1e9) || !(std::abs(result.offset) < 1e9))
      refuse("joint '" + result.name + "': mimics with multiplier " + number(result.ratio) + " and offset " +
                 number(result.offset),
             "give a multiplier that is not 0; a joint that cannot move is a fixed joint");
  }
  void refuse_leader(const SourceJoint& joint, LeaderFault fault) {
    if (fault == LeaderFault::follows_itself)
      return refuse("joint '" + joint.name + "' mimics itself, by way of others", "one of them has a drive");
    refuse("joint '" + joint.name + "' mimics '" + joint.leader + "', which does not move here",
           "--hold-mimic holds it and carries its body along; remove <mimic> if a drive of its own moves it; or "
           "choose a --tip that leaves it beside the chain, where joints are held");
  }
  void read_axis(const urdf::Joint& joint, SourceJoint& result) {
    const double x = joint.axis.x, y = joint.axis.y, z = joint.axis.z, length = std::hypot(x, y, z);
    if (!(length > 1e-9 && length < 1e9))
      refuse("joint '" + result.name + "': axis is (" + number(x) + ", " + number(y) + ", " + number(z) + ")",
             "give a direction, such as <axis xyz=\"0 0 1\"/>");
    else
      result.axis = angles_.axis({x, y, z}, result.name);
  }
  void read_limits(const urdf::Joint& joint, SourceJoint& result) {
    if (joint.dynamics) result.damping = joint.dynamics->damping, result.friction = joint.dynamics->friction;
    if (!joint.limits) return;
    const auto& limits = *joint.limits;
    const bool blank = limits.lower == 0.0 && limits.upper == 0.0;
    result.has_limits = result.kind != Kind::continuous && result.kind != Kind::fixed && !blank;
    result.lower = limits.lower, result.upper = limits.upper;
    result.speed = limits.velocity, result.effort = limits.effort;
    if (result.held && result.has_limits && limits.lower <= limits.upper)
      result.held_at = std::clamp(result.held_at, limits.lower, limits.upper);
    check_limits(result);
  }
  void check_limits(const SourceJoint& joint) {
    const std::string here = "joint '" + joint.name + "': ";
    if (joint.has_limits && !joint.held && !(joint.lower < joint.upper))
      refuse(here + "position limits are upside down: lower " + number(joint.lower) + ", upper " + number(joint.upper),
             "give the lower one first; a joint that cannot move is a fixed joint");
    if (joint.speed < 0.0) refuse(here + "velocity limit is " + number(joint.speed), "give a value > 0");
    if (joint.effort < 0.0) refuse(here + "effort limit is " + number(joint.effort), "give a value > 0");
  }

  void read_body(const urdf::Link& link, SourceLink& result) {
    if (!link.inertial) return;
    const auto& inertial = *link.inertial;
    result.has_inertial = true, result.mass = inertial.mass;
    const auto& centre = inertial.origin.position;
    result.inertial = {angles_.rotation(written_.inertial_rpy.at(result.name), Change::Of::inertial_rpy, result.name),
                       {centre.x, centre.y, centre.z}};
    result.inertia = {inertial.ixx, inertial.iyy, inertial.izz, inertial.ixy, inertial.ixz, inertial.iyz};
  }
  static std::string listed(const std::vector<std::string>& names) {
    std::string all;
    for (const auto& name : names)
      all += (all.empty() ? "" : ", ") + name;
    return all;
  }
  void say_held() {
    if (!held_.empty())
      tree_.notes.push_back(
          "joints beside the chain are held at 0 (or their nearest limit), their bodies carried along: " +
          listed(held_));
    if (!mimics_.empty())
      tree_.notes.push_back(
          "joints that mimic another one are held where that one is 0 (or their nearest limit), their bodies carried "
          "along: " +
          listed(mimics_));
  }

  const urdf::ModelInterface& model_;
  const std::string& from_;
  const WrittenNumbers& written_;
  RightAngles angles_;
  SourceTree tree_;
  std::set<std::string> path_;
  std::vector<std::string> held_, mimics_;
  std::string problems_;
  bool has_tip_ = false, hold_mimic_ = false;
};

}  // namespace

SourceTree read_urdf(const std::string& text, const std::string& from, const ReadingOptions& options) {
  check_urdf_text(text, from);
  const auto model = parse(with_blank_limits(text), from);
  const auto written = written_numbers(text);
  SourceTree tree = Reader(*model, from, options, written, nearness_of(options, written.length_digit)).tree();
  tree.length_digit = written.length_digit;
  read_transmissions(text, from, tree);
  return tree;
}

}  // namespace importer

#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/import/sdf/model.hpp>

#include <console_bridge/console.h>
#include <sdf/Console.hh>
#include <sdf/Frame.hh>
#include <sdf/JointAxis.hh>
#include <sdf/ParserConfig.hh>

namespace importer::sdf_model {
namespace {

using description::harmless;
using description::Refused;

/// What libsdformat refuses. Inertias are judged by the importer, as those of other formats.
void check(const sdf::Errors& errors, const std::string& from) {
  std::string all;
  int count = 0;
  for (const auto& error : errors) {
    const auto code = error.Code();
    if (code == sdf::ErrorCode::LINK_INERTIA_INVALID || code == sdf::ErrorCode::STRING_READ || ++count > 5) continue;
    all += (all.empty() ? "" : "\n") + from + ": " + harmless(error.Message().substr(0, 300));
  }
  if (all.empty() && count == 0 && !errors.empty() && errors.back().Code() == sdf::ErrorCode::STRING_READ)
    all = from + ": libsdformat cannot read it";
  if (!all.empty()) throw Refused(all + "; give what libsdformat " SDF_VERSION_FULL " reads: gz sdf -k checks it");
}

/// It would say on the terminal what it returns.
class Silence {
 public:
  Silence() {
    console_bridge::noOutputHandler();
    sdf::Console::Instance()->SetQuiet(true);
  }
  ~Silence() { console_bridge::restorePreviousOutputHandler(); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
};

}  // namespace

Vector vector(const ignition::math::Vector3d& given) { return {Real(given.X()), Real(given.Y()), Real(given.Z())}; }

Pose pose(const ignition::math::Pose3d& given) {
  const auto& q = given.Rot();
  const Eigen::Quaternion<Real> rotation(Real(q.W()), Real(q.X()), Real(q.Y()), Real(q.Z()));
  return {rotation.normalized().toRotationMatrix(), vector(given.Pos())};
}

Model::Model(const std::string& text, const std::string& file) : from(file) {
  const Silence silence;
  sdf::ParserConfig config;
  config.SetWarningsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetDeprecatedElementsPolicy(sdf::EnforcementPolicy::LOG);
  check(root_.LoadSdfString(text, config), from);
  if (root_.WorldCount() > 1) throw Refused(from + ": has several worlds; give each a file of its own");
  if (root_.Model() != nullptr) add(*root_.Model(), -1);
  for (std::uint64_t i = 0; world() != nullptr && i < world()->ModelCount(); ++i)
    add(*world()->ModelByIndex(i), -1);
  if (models.empty()) throw Refused(from + ": there is no <model>; a robot is one");
  for (std::size_t i = 0; i < models.size(); ++i)
    add_joints(static_cast<int>(i));
}

void Model::add(const sdf::Model& model, int parent) {
  const int index = static_cast<int>(models.size());
  const auto* above = parent < 0 ? nullptr : &models[static_cast<std::size_t>(parent)];
  ModelNode node{&model, parent, above == nullptr ? index : above->top,
                 above == nullptr ? "" : above->scope + model.Name() + "::"};
  models.push_back(node);
  const std::string whole = models[static_cast<std::size_t>(node.top)].model->Name() + "::" + node.scope;
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    const auto* link = model.LinkByIndex(i);
    links.push_back({link, index, harmless(node.scope + link->Name()), harmless(whole + link->Name()), -1});
  }
  for (std::uint64_t i = 0; i < model.ModelCount(); ++i)
    add(*model.ModelByIndex(i), index);
}

void Model::add_joints(int model) {
  const auto& node = models[static_cast<std::size_t>(model)];
  for (std::uint64_t i = 0; i < node.model->JointCount(); ++i) {
    const auto* joint = node.model->JointByIndex(i);
    JointNode result{joint, model, harmless(node.scope + joint->Name()), -1, -1};
    if (joint->ParentLinkName() != "world") result.parent = link_of(model, joint->ParentLinkName());
    result.child = link_of(model, joint->ChildLinkName());
    if (result.child < 0)
      throw Refused(from + ": joint '" + result.name + "': its child is the world; the world is a joint's parent");
    auto& child = links[static_cast<std::size_t>(result.child)];
    if (child.joint >= 0)
      throw Refused(from + ": joint '" + result.name + "': link '" + child.name + "' is the child of joint '" +
                    joints[static_cast<std::size_t>(child.joint)].name +
                    "' too: a loop, or two carriers; take one out, or write the coupling as <mimic>");
    child.joint = static_cast<int>(joints.size());
    joints.push_back(result);
    int at = result.child;
    for (std::size_t steps = 0; at >= 0; ++steps) {
      const int by = links[static_cast<std::size_t>(at)].joint;
      at = by < 0 ? -1 : joints[static_cast<std::size_t>(by)].parent;
      if (steps > links.size())
        throw Refused(from + ": joint '" + result.name +
                      "' closes a loop of links; take it out, or write the "
                      "coupling as <mimic>");
    }
  }
}

int Model::nested(int model, const std::string& name) const {
  for (std::size_t i = 0; i < models.size(); ++i)
    if (models[i].parent == model && models[i].model->Name() == name) return static_cast<int>(i);
  return -1;
}

std::pair<int, std::string> Model::within(int model, std::string name) const {
  for (auto at = name.find("::"); at != std::string::npos; at = name.find("::")) {
    const int inner = nested(model, name.substr(0, at));
    if (inner < 0) break;
    model = inner, name = name.substr(at + 2);
  }
  return {model, name};
}

int Model::link_of(int model, const std::string& frame) const {
  auto [at, name] = within(model, frame);
  for (std::size_t steps = 0; steps < 10000; ++steps) {
    const auto& node = *models[static_cast<std::size_t>(at)].model;
    if (name == "world") return -1;
    for (std::size_t i = 0; i < links.size(); ++i)
      if (links[i].model == at && links[i].link->Name() == name) return static_cast<int>(i);
    if (const int inner = nested(at, name); inner >= 0) {
      at = inner, name = "__model__";
    } else if (name == "__model__" || name.empty()) {
      std::tie(at, name) = within(at, node.CanonicalLinkAndRelativeName().second);
    } else if (const auto* joint = node.JointByName(name); joint != nullptr) {
      std::tie(at, name) = within(at, joint->ChildLinkName());
    } else if (const auto* other = node.FrameByName(name); other != nullptr) {
      std::tie(at, name) = within(at, other->AttachedTo().empty() ? "__model__" : other->AttachedTo());
    } else {
      break;
    }
  }
  throw Refused(from + ": there is no frame '" + harmless(frame) + "' in model '" +
                harmless(models[static_cast<std::size_t>(model)].model->Name()) + "'; correct its name");
}

Pose Model::pose_of(int model) {
  const auto& node = models[static_cast<std::size_t>(model)];
  return node.parent < 0 ? placed(model) : pose_of(node.parent) * pose_in(node.parent, node.model->Name());
}

/// In what carries it: what its pose is of may be a frame of its own.
Pose Model::placed(int model) {
  const auto& node = models[static_cast<std::size_t>(model)];
  const std::string& by = node.model->PoseRelativeTo();
  Pose origin;
  if (node.parent >= 0)
    origin = pose_in(node.parent, by.empty() ? "__model__" : by);
  else if (!by.empty() && by != "world")
    throw Refused(from + ": model '" + harmless(node.model->Name()) + "': its pose is relative to '" + harmless(by) +
                  "', a frame of the world; give it in the world itself");
  Pose result = origin * pose(node.model->RawPose());
  const std::string& placement = node.model->PlacementFrameName();
  return placement.empty() ? result : result * pose_in(model, placement).inverse();
}

Pose Model::pose_in(int model, const std::string& frame) {
  const auto key = std::make_pair(model, frame);
  if (const auto known = poses_.find(key); known != poses_.end()) return known->second;
  return poses_[key] = found(model, frame);
}

Pose Model::found(int model, const std::string& frame) {
  const auto& node = *models[static_cast<std::size_t>(model)].model;
  if (frame == "__model__" || frame.empty()) return {};
  const auto relative = [&](const std::string& to, const std::string& otherwise) {
    return pose_in(model, to.empty() ? otherwise : to);
  };
  if (const auto [inner, name] = within(model, frame); inner != model) {
    Pose result = pose_in(inner, name);
    for (int at = inner; at != model; at = models[static_cast<std::size_t>(at)].parent)
      result =
          pose_in(models[static_cast<std::size_t>(at)].parent, models[static_cast<std::size_t>(at)].model->Name()) *
          result;
    return result;
  }
  if (const auto* link = node.LinkByName(frame); link != nullptr)
    return relative(link->PoseRelativeTo(), "__model__") * pose(link->RawPose());
  if (const auto* joint = node.JointByName(frame); joint != nullptr)
    return relative(joint->PoseRelativeTo(), joint->ChildLinkName()) * pose(joint->RawPose());
  if (const auto* other = node.FrameByName(frame); other != nullptr)
    return relative(other->PoseRelativeTo(), other->AttachedTo()) * pose(other->RawPose());
  if (const int inner = nested(model, frame); inner >= 0) return placed(inner);
  throw Refused(from + ": there is no frame '" + harmless(frame) + "' in model '" + harmless(node.Name()) +
                "'; correct its name");
}

Vector Model::axis_of(const JointNode& joint) {
  const auto* axis = joint.joint->Axis(0);
  const std::string& in = axis->XyzExpressedIn();
  const Vector direction = vector(axis->Xyz()).normalized();
  return pose_of(joint.model).rotation *
         (pose_in(joint.model, in.empty() ? joint.joint->Name() : in).rotation * direction);
}

}  // namespace importer::sdf_model

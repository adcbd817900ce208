// dart_engine QUESTIONS ANSWER: an SDF as DART has it, a skeleton that is put together from the frames that libsdformat
// resolves by itself. Of the reader it has the text alone: without pictures, with the files that are included.
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/sdf/sdf_text.hpp>

#include <nlohmann/json.hpp>

#include <dart/config.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <sdf/sdf.hh>

#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>

namespace {

using Json = nlohmann::json;
using dart::dynamics::BodyNode;
using Eigen::Isometry3d;

Isometry3d isometry(const ignition::math::Pose3d& pose) {
  Isometry3d result = Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z())
                        .normalized()
                        .toRotationMatrix();
  result.translation() = Eigen::Vector3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z());
  return result;
}
void check(const sdf::Errors& errors) {
  for (const auto& error : errors)
    if (error.Code() != sdf::ErrorCode::LINK_INERTIA_INVALID) throw std::runtime_error(error.Message());
}
Isometry3d resolved(const sdf::SemanticPose& pose, const std::string& to) {
  ignition::math::Pose3d result;
  check(pose.Resolve(result, to));
  return isometry(result);
}

struct Link {
  const sdf::Link* link = nullptr;
  Isometry3d model = Isometry3d::Identity();  ///< of its model, in the world
  BodyNode* body = nullptr;
};
struct Joint {
  const sdf::Joint* joint = nullptr;
  Isometry3d model = Isometry3d::Identity();
  std::string parent, child;            ///< links with all scopes, or world
  std::string parent_here, child_here;  ///< as its model names them
  dart::dynamics::Joint* made = nullptr;
};
struct Frame {
  std::string link;
  Isometry3d pose = Isometry3d::Identity();  ///< in that link
};

class Robot {
 public:
  explicit Robot(const sdf::Root& root) : skeleton_(dart::dynamics::Skeleton::create("robot")) {
    const auto* world = root.WorldByIndex(0);
    if (root.Model() != nullptr) add(*root.Model(), "", Isometry3d::Identity());
    for (std::uint64_t i = 0; world != nullptr && i < world->ModelCount(); ++i)
      add(*world->ModelByIndex(i), "", Isometry3d::Identity());
    for (const auto& entry : joints_)
      if (entry.second.joint->Type() != sdf::JointType::GEARBOX) carriers_[entry.second.child] = entry.first;
    for (auto& entry : links_)
      make(entry.second, entry.first);
    const auto g = world != nullptr ? world->Gravity() : ignition::math::Vector3d(0.0, 0.0, -9.81);
    skeleton_->setGravity(Eigen::Vector3d(g.X(), g.Y(), g.Z()));
  }

  Json answer(const Json& questions) {
    const auto& links = questions.at("links");
    for (const std::size_t mover : questions.at("movers"))
      movers_.push_back(&joints_.at(links.at(mover).at("joint")));
    for (const auto& held : questions.at("held")) {
      const auto& joint = joints_.at(links.at(held.at("link").get<std::size_t>()).at("joint"));
      if (joint.made->getNumDofs() > 0) joint.made->setPosition(0, held.at("at"));
    }
    Json states = Json::array(), bodies = Json::array(), joints = Json::array();
    for (const auto& state : questions.at("states"))
      states.push_back(state_of(links, state));
    move(questions.at("states").at(0));
    for (const auto& link : links)
      bodies.push_back(body(links, link));
    for (const auto* mover : movers_)
      joints.push_back(said_of(*mover));
    return {{"version", "DART " DART_VERSION ", built from the frames of libsdformat " SDF_VERSION_FULL},
            {"states", states},
            {"bodies", bodies},
            {"joints", joints}};
  }

 private:
  void add(const sdf::Model& model, const std::string& above, const Isometry3d& carrier) {
    // A model of the world is placed in it, another one in the model around it.
    const Isometry3d here = carrier * resolved(model.SemanticPose(), above.empty() ? "" : "__model__");
    const std::string scope = above + model.Name() + "::";
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i)
      links_[scope + model.LinkByIndex(i)->Name()] = {model.LinkByIndex(i), here, nullptr};
    for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
      Joint joint;
      joint.joint = model.JointByIndex(i), joint.model = here;
      check(joint.joint->ResolveParentLink(joint.parent_here));
      check(joint.joint->ResolveChildLink(joint.child_here));
      joint.parent = joint.parent_here == "world" ? "world" : scope + joint.parent_here;
      joint.child = scope + joint.child_here;
      joints_[scope + joint.joint->Name()] = joint;
    }
    for (std::uint64_t i = 0; i < model.FrameCount(); ++i) {
      const auto* frame = model.FrameByIndex(i);
      std::string body;
      check(frame->ResolveAttachedToBody(body));
      if (body != "world") frames_[scope + frame->Name()] = {scope + body, resolved(frame->SemanticPose(), body)};
    }
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i)
      add(*model.ModelByIndex(i), scope, here);
  }

  BodyNode* make(Link& link, const std::string& name) {
    if (link.body != nullptr) return link.body;
    const auto carrier = carriers_.find(name);
    if (carrier == carriers_.end()) {
      dart::dynamics::WeldJoint::Properties stands;
      stands.mName = "base of " + name;
      stands.mT_ParentBodyToJoint = link.model * resolved(link.link->SemanticPose(), "__model__");
      link.body = skeleton_
                      ->createJointAndBodyNodePair<dart::dynamics::WeldJoint>(nullptr, stands,
                                                                              BodyNode::Properties(named(name)))
                      .second;
    } else {
      auto& joint = joints_.at(carrier->second);
      auto* parent = joint.parent == "world" ? nullptr : make(links_.at(joint.parent), joint.parent);
      connect(joint, carrier->second, parent, link, named(name));
    }
    link.body->setInertia(inertia(*link.link));
    return link.body;
  }
  static BodyNode::AspectProperties named(const std::string& name) { return BodyNode::AspectProperties(name); }
  void connect(Joint& joint, const std::string& name, BodyNode* parent, Link& link,
               const BodyNode::AspectProperties& body) {
    const auto pose = joint.joint->SemanticPose();
    const Isometry3d before = joint.parent == "world" ? joint.model * resolved(pose, "__model__")
                                                      : resolved(pose, joint.parent_here),
                     behind = resolved(pose, joint.child_here);
    const auto place = [&](auto properties) {
      properties.mName = name, properties.mT_ParentBodyToJoint = before, properties.mT_ChildBodyToJoint = behind;
      return properties;
    };
    const auto type = joint.joint->Type();
    if (type == sdf::JointType::REVOLUTE || type == sdf::JointType::CONTINUOUS) {
      auto properties = place(dart::dynamics::RevoluteJoint::Properties());
      properties.mAxis = axis(joint);
      std::tie(joint.made, link.body) = skeleton_->createJointAndBodyNodePair<dart::dynamics::RevoluteJoint>(
          parent, properties, BodyNode::Properties(body));
    } else if (type == sdf::JointType::PRISMATIC) {
      auto properties = place(dart::dynamics::PrismaticJoint::Properties());
      properties.mAxis = axis(joint);
      std::tie(joint.made, link.body) = skeleton_->createJointAndBodyNodePair<dart::dynamics::PrismaticJoint>(
          parent, properties, BodyNode::Properties(body));
    } else {
      std::tie(joint.made, link.body) = skeleton_->createJointAndBodyNodePair<dart::dynamics::WeldJoint>(
          parent, place(dart::dynamics::WeldJoint::Properties()), BodyNode::Properties(body));
    }
  }
  static Eigen::Vector3d axis(const Joint& joint) {
    ignition::math::Vector3d result;
    check(joint.joint->Axis(0)->ResolveXyz(result, joint.joint->Name()));
    return Eigen::Vector3d(result.X(), result.Y(), result.Z()).normalized();
  }
  static dart::dynamics::Inertia inertia(const sdf::Link& link) {
    const Isometry3d pose = isometry(link.Inertial().Pose());
    const auto moments = link.Inertial().MassMatrix().Moi();
    Eigen::Matrix3d tensor;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        tensor(i, j) = moments(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    return {link.Inertial().MassMatrix().Mass(), pose.translation(),
            pose.linear() * tensor * pose.linear().transpose()};
  }

  void move(const Json& state) {
    for (std::size_t k = 0; k < movers_.size(); ++k) {
      movers_[k]->made->setPosition(0, state.at("q").at(k));
      movers_[k]->made->setVelocity(0, state.at("qd").at(k));
      movers_[k]->made->setAcceleration(0, state.at("qdd").at(k));
    }
  }
  Json state_of(const Json& links, const Json& state) {
    move(state);
    skeleton_->computeInverseDynamics();
    Json poses = Json::array(), torque = Json::array(), matrix = Json::array();
    for (const auto& link : links)
      poses.push_back(pose(links, link));
    const Eigen::MatrixXd& mass = skeleton_->getMassMatrix();
    for (const auto* row : movers_) {
      const auto i = static_cast<Eigen::Index>(row->made->getIndexInSkeleton(0));
      torque.push_back(skeleton_->getForce(row->made->getIndexInSkeleton(0)));
      matrix.push_back(Json::array());
      for (const auto* column : movers_)
        matrix.back().push_back(mass(i, static_cast<Eigen::Index>(column->made->getIndexInSkeleton(0))));
    }
    return {{"poses", poses}, {"torque", torque}, {"mass_matrix", matrix}};
  }
  Isometry3d world_of(const Json& link) const {
    const std::string name = link.at("name"), kind = link.at("kind");
    if (kind == "frame") return links_.at(frames_.at(name).link).body->getTransform() * frames_.at(name).pose;
    return links_.at(name).body->getTransform();
  }
  Isometry3d back_to_root(const Json& links) const {
    return links.at(0).at("kind") == "" ? Isometry3d::Identity() : Isometry3d(world_of(links.at(0)).inverse());
  }
  static void put(Json& list, const Eigen::Vector3d& p, const Eigen::Matrix3d& m) {
    for (int k = 0; k < 3; ++k)
      list.push_back(p[k]);
    for (int k = 0; k < 9; ++k)
      list.push_back(m(k / 3, k % 3));
  }
  Json pose(const Json& links, const Json& link) const {
    if (link.at("kind") == "") return {};
    const Isometry3d at = back_to_root(links) * world_of(link);
    Json list = Json::array();
    put(list, at.translation(), at.linear());
    return list;
  }
  Json body(const Json& links, const Json& link) const {
    const auto found = links_.find(link.at("name"));
    if (found == links_.end()) return {};
    const auto& inertia = found->second.body->getInertia();
    const Isometry3d at = back_to_root(links) * found->second.body->getTransform();
    Json list{inertia.getMass()};
    put(list, at * inertia.getLocalCOM(), at.linear() * inertia.getMoment() * at.linear().transpose());
    return list;
  }

  static Json said_of(const Joint& mover) {
    const auto& axis = *mover.joint->Axis(0);
    const auto finite = [](double value) { return value > 0.0 && std::isfinite(value) ? value : 0.0; };
    const bool limited = mover.joint->Type() != sdf::JointType::CONTINUOUS && std::abs(axis.Lower()) < 1e9 &&
                         std::abs(axis.Upper()) < 1e9;
    Json result{{"limited", limited},
                {"lower", axis.Lower()},
                {"upper", axis.Upper()},
                {"damping", axis.Damping()},
                {"friction", axis.Friction()},
                {"rotor", 0.0},
                {"stiffness", axis.SpringStiffness()},
                {"rest", axis.SpringReference()},
                {"speed", finite(axis.MaxVelocity())},
                {"effort", finite(axis.Effort())},
                {"leader", ""},
                {"ratio", 1.0},
                {"offset", 0.0}};
    if (!axis.Element()->HasElement("mimic")) return result;
    // libsdformat 12 copies the element as it stands.
    const auto mimic = axis.Element()->GetElement("mimic");
    const auto value = [&](const char* name, double otherwise) {
      return mimic->HasElement(name) ? std::stod(mimic->GetElement(name)->GetValue()->GetAsString()) : otherwise;
    };
    const double ratio = value("multiplier", 1.0);
    result["leader"] = mimic->GetAttribute("joint")->GetAsString(), result["ratio"] = ratio;
    result["offset"] = -ratio * value("reference", 0.0) + value("offset", 0.0);
    return result;
  }

  dart::dynamics::SkeletonPtr skeleton_;
  std::map<std::string, Link> links_;
  std::map<std::string, Joint> joints_;
  std::map<std::string, Frame> frames_;
  std::map<std::string, std::string> carriers_;  ///< joints by what they carry
  std::vector<const Joint*> movers_;
};

Json answer(const std::string& questions) {
  const Json asked = Json::parse(description::read_text(questions));
  const std::string file = asked.at("file"), text = description::read_text(file);
  const host_sim::TemporaryFolder folder;
  sdf::Console::Instance()->SetQuiet(true);
  sdf::Root root;
  sdf::ParserConfig config;
  config.SetWarningsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::LOG);
  check(root.LoadSdfString(importer::sdf_text::check(text, file, folder).text, config));
  return Robot(root).answer(asked);
}

}  // namespace

int main(int count, char** given) {
  if (count != 3) return 1;
  Json found;
  try {
    found = answer(given[1]);
  } catch (const std::exception& error) {
    found = {{"refused", error.what()}};
  }
  std::ofstream(given[2]) << found.dump(-1, ' ', false, Json::error_handler_t::replace);
  return 0;
}

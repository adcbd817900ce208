// The models of an SDF in a row, and where their frames are: before anything is chosen or cut.
#pragma once

#include <host_sim/robots/import/geometry.hpp>

#include <sdf/Joint.hh>
#include <sdf/Link.hh>
#include <sdf/Model.hh>
#include <sdf/Root.hh>
#include <sdf/World.hh>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace importer::sdf_model {

Vector vector(const ignition::math::Vector3d& given);
Pose pose(const ignition::math::Pose3d& given);

struct ModelNode {
  const sdf::Model* model = nullptr;
  int parent = -1;    ///< index of an earlier one; -1 for those of the world
  int top = 0;        ///< the one of the world that it is in
  std::string scope;  ///< in that one: "gripper::", empty for itself
};
struct LinkNode {
  const sdf::Link* link = nullptr;
  int model = 0;
  std::string name;   ///< in the model of the world that it is in: "gripper::finger"
  std::string whole;  ///< in the world: "arm::gripper::finger"
  int joint = -1;     ///< that carries it
};
struct JointNode {
  const sdf::Joint* joint = nullptr;
  int model = 0;
  std::string name;
  int parent = -1, child = 0;  ///< links; -1 is the world
};

class Model {
 public:
  /// Throws description::Refused with what libsdformat refuses, loops, and joints that nothing can carry.
  Model(const std::string& text, const std::string& from);

  const sdf::World* world() const { return root_.WorldByIndex(0); }
  /// Pose of a frame that a model may name, in that model's frame.
  Pose pose_in(int model, const std::string& frame);
  /// In the world, of a model.
  Pose pose_of(int model);
  /// In the world, of a link.
  Pose pose_of(const LinkNode& link) { return pose_of(link.model) * pose_in(link.model, link.link->Name()); }
  /// In the world, of what a joint names as its frame, and the unit vector of its axis.
  Pose pose_of(const JointNode& joint) { return pose_of(joint.model) * pose_in(joint.model, joint.joint->Name()); }
  Vector axis_of(const JointNode& joint);
  /// The link that a frame of a model is fixed to; -1 for the world.
  int link_of(int model, const std::string& frame) const;

  std::vector<ModelNode> models;
  std::vector<LinkNode> links;
  std::vector<JointNode> joints;
  std::string from;

 private:
  void add(const sdf::Model& model, int parent);
  void add_joints(int model);
  Pose found(int model, const std::string& frame);
  /// The model and the name in it of a name with scopes.
  std::pair<int, std::string> within(int model, std::string name) const;
  int nested(int model, const std::string& name) const;
  Pose placed(int model);

  sdf::Root root_;
  std::map<std::pair<int, std::string>, Pose> poses_;
};

}  // namespace importer::sdf_model

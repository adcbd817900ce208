#include "reference.hpp"

#include <axial/axial.hpp>

#include <cstdlib>

namespace combinations {
namespace {

using Model =
    axial::Model<most_joints, axial::RuntimeGravity, axial::BaseMotion, axial::Underwater, axial::VelocityThroughWater,
                 axial::RotorInertia, axial::Friction, axial::JointSprings, axial::ExternalWrenches, axial::Payload>;
using Values = axial::Joints<Model, double>;
using Inputs = axial::Inputs<Model, double>;

Model model_of(const Situation& s) {
  Model model;
  for (int i = 0; i < s.joints; ++i)
    if (!model.add(s.links[i])) std::abort();
  model.set_base(s.base);
  model.set_tool(s.tool);
  return model;
}

Inputs inputs_of(const Situation& s) {
  Inputs in;
  in.gravity = s.gravity, in.base_motion = s.base_motion, in.velocity_through_water = s.through_water;
  in.payload = s.payload;
  for (int i = 0; i < s.joints; ++i)
    in.wrenches[i] = s.wrenches[i];
  return in;
}

Values values(const double (&x)[most_joints]) {
  Values all{};
  for (int i = 0; i < most_joints; ++i)
    all[i] = x[i];
  return all;
}

Numbers numbers(const Values& x) {
  Numbers all;
  for (int i = 0; i < most_joints; ++i)
    all.of[i] = x[i];
  return all;
}

}  // namespace

Numbers efforts(const Situation& s) {
  return numbers(axial::inverse_dynamics(model_of(s), values(s.q), values(s.qd), values(s.qdd), inputs_of(s)));
}

double inertia(const Situation& s, int i, int j) {
  return axial::mass_matrix(model_of(s), values(s.q), inputs_of(s))(i, j);
}

Numbers momenta(const Situation& s) {
  Numbers all;
  const auto m = axial::mass_matrix(model_of(s), values(s.q), inputs_of(s));
  for (int i = 0; i < s.joints; ++i)
    for (int j = 0; j < s.joints; ++j)
      all.of[i] += m(i, j) * s.qd[j];
  return all;
}

Numbers accelerations(const Situation& s, const Numbers& efforts) {
  const auto a = axial::forward_dynamics(model_of(s), values(s.q), values(s.qd), values(efforts.of), inputs_of(s));
  Numbers all = numbers(a);
  all.near_singular = a.status.code == axial::Status::Code::near_singular;
  return all;
}

Poses poses(const Situation& s) {
  const auto all = axial::forward_kinematics(model_of(s), values(s.q), inputs_of(s));
  Poses result;
  for (int i = 0; i < s.joints; ++i)
    result.frames[i] = all.frames[i];
  result.tool = all.tool;
  return result;
}

Columns jacobian(const Situation& s) {
  const auto all = axial::jacobian(model_of(s), values(s.q), inputs_of(s));
  Columns result;
  for (int i = 0; i < s.joints; ++i)
    result.of[i] = all[i];
  return result;
}

}  // namespace combinations

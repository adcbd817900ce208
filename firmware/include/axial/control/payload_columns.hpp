// What a payload's mass and first moment add to the joints' momenta and drifts: four columns each, linear in them.
#pragma once

#include <axial/dynamics/kinematics.hpp>

namespace axial::detail {

/// Per unit of mass (kg) and of first moment (kg m, axes of the last link): the payload's row of one joint.
template <class T>
struct PayloadRow {
  T of[4] = {};
};
/// Columns of a payload's momentum and of its drift dT/dq - g.
template <class S, class T>
struct PayloadColumns {
  PayloadRow<T> momentum[joint_count<S>] = {}, drift[joint_count<S>] = {};
};

/// Gravity of a robot in world axes, m/s^2.
template <class S, class T>
constexpr Vec3<T> world_gravity() {
  static_assert(scene_of<S>::template has<Gravity> && !scene_of<S>::template has<RuntimeGravity>,
                "axial: a payload is weighed under the gravity that the chain declares; name Gravity in the scene");
  constexpr const auto& chain = robot_of<S>::chain;
  const auto& r = chain.base.pose.rotation;
  const double x = chain.gravity.x, y = chain.gravity.y, z = chain.gravity.z;
  using N = NumberTraits<T>;
  return {N::constant(r[0] * x + r[1] * y + r[2] * z), N::constant(r[3] * x + r[4] * y + r[5] * z),
          N::constant(r[6] * x + r[7] * y + r[8] * z)};
}

// A payload of mass m and first moment h about the tool point has the momentum l = m v + w x h, n = h x v; along
// a motion (a, b) that is m b.v + h.(b x w + v x a). Its inertia about the tool point is left out.
template <class T, class R>
constexpr PayloadRow<T> payload_row(const T& along, const Vec3<T>& across, const R& rotation) {
  const Vec3<T> h = transpose_times(rotation, across);
  return {{along, h.x, h.y, h.z}};
}

/// The columns at q and qd. Source: the Jacobian of the tool point; dT/dq_i of a momentum is the one along
/// v_i x J_i, v_i being the velocity of link i there; gravity's torque -g along J_i.
template <class S, class T>
constexpr PayloadColumns<S, T> payload_columns(const Positions<robot_of<S>, T>& q,
                                               const Velocities<robot_of<S>, T>& qd) {
  constexpr int n = joint_count<S>;
  using V = Vec3<T>;
  const auto columns = jacobian<S>(q);
  const auto rotation = forward_kinematics<S>(q).frames[n - 1].rotation;
  const V g = world_gravity<S, T>();
  V w{}, v{};
  for (int i = 0; i < n; ++i)
    w = w + qd[i] * columns[i].angular, v = v + qd[i] * columns[i].linear;
  PayloadColumns<S, T> all;
  V wi{}, vi{};
  for (int i = 0; i < n; ++i) {
    const V a = columns[i].angular, b = columns[i].linear;
    wi = wi + qd[i] * a, vi = vi + qd[i] * b;
    const V da = cross(wi, a), db = cross(wi, b) + cross(vi, a);
    all.momentum[i] = payload_row<T>(dot(b, v), cross(b, w) + cross(v, a), rotation);
    all.drift[i] = payload_row<T>(dot(db, v) + dot(b, g), cross(db, w) + cross(v, da) + cross(g, a), rotation);
  }
  return all;
}

}  // namespace axial::detail

#pragma once
/// The measured kernels. Each has a name, `run(state, tau)` and `write(result, put)`, which gives every number of the
/// result to `put` in the order that README.md documents.

#include <axial/axial.hpp>

#include "../states.hpp"

namespace axial::apps::kernels {

template <class Robot, class T, class Put>
void write_joints(const Joints<Robot, T>& values, Put put) {
  for (int i = 0; i < joint_count<Robot>; ++i)
    put(values[i]);
}

template <class T, class Put>
void write_vector(const Vec3<T>& v, Put put) {
  put(v.x), put(v.y), put(v.z);
}

template <class Robot, class T>
struct InverseDynamics {
  static constexpr const char* name = "inverse_dynamics";
  static auto run(const MotionState<Robot, T>& s, const Joints<Robot, T>&) {
    return inverse_dynamics<Robot>(s.q, s.qd, s.qdd);
  }
  template <class Put>
  static void write(const Joints<Robot, T>& tau, Put put) {
    write_joints(tau, put);
  }
};

/// The same torque with its terms apart: separated and summed.
template <class Robot, class T>
struct SeparationKernel {
  static constexpr const char* name = "separation";
  static auto run(const MotionState<Robot, T>& s, const Joints<Robot, T>&) {
    return torque(separate<Robot>(s.q), s.qd, s.qdd);
  }
  template <class Put>
  static void write(const Joints<Robot, T>& tau, Put put) {
    write_joints(tau, put);
  }
};

template <class Robot, class T>
struct BiasTorque {
  static constexpr const char* name = "bias";
  static auto run(const MotionState<Robot, T>& s, const Joints<Robot, T>&) { return bias_torque<Robot>(s.q, s.qd); }
  template <class Put>
  static void write(const Joints<Robot, T>& tau, Put put) {
    write_joints(tau, put);
  }
};

template <class Robot, class T>
struct GravityTorque {
  static constexpr const char* name = "gravity";
  static auto run(const MotionState<Robot, T>& s, const Joints<Robot, T>&) { return gravity_torque<Robot>(s.q); }
  template <class Put>
  static void write(const Joints<Robot, T>& tau, Put put) {
    write_joints(tau, put);
  }
};

template <class Robot, class T>
struct MassMatrixKernel {
  static constexpr const char* name = "mass_matrix";
  static auto run(const MotionState<Robot, T>& s, const Joints<Robot, T>&) { return mass_matrix<Robot>(s.q); }
  template <class Put>
  static void write(const MassMatrix<Robot, T>& m, Put put) {
    for (int i = 0; i < joint_count<Robot>; ++i)
      for (int j = 0; j <= i; ++j)
        put(m(i, j));
  }
};

template <class Robot, class T>
struct ForwardDynamicsKernel {
  static constexpr const char* name = "forward_dynamics";
  static auto run(const MotionState<Robot, T>& s, const Joints<Robot, T>& tau) {
    return forward_dynamics<Robot>(s.q, s.qd, tau);
  }
  template <class Put>
  static void write(const ForwardDynamics<Robot, T>& qdd, Put put) {
    for (int i = 0; i < joint_count<Robot>; ++i)
      put(qdd[i]);
  }
};

inline constexpr const char* route_name(ArticulatedBody) { return "articulated_body"; }
inline constexpr const char* route_name(SplitArticulatedBody) { return "split_articulated_body"; }
inline constexpr const char* route_name(CompositeBody) { return "composite_body"; }

/// Forward dynamics by a named route.
template <class Robot, class Route>
struct ForwardDynamicsBy {
  static constexpr const char* name = route_name(Route{});
  static auto run(const MotionState<Robot, float>& s, const Joints<Robot, float>& tau) {
    return forward_dynamics<Scene<Robot, Gravity, RotorInertia, Route>>(s.q, s.qd, tau);
  }
};

template <class Robot, class T>
struct ForwardKinematicsKernel {
  static constexpr const char* name = "forward_kinematics";
  static auto run(const MotionState<Robot, T>& s, const Joints<Robot, T>&) {
    return forward_kinematics<Robot>(s.q).tool;
  }
  template <class Put>
  static void write(const WorldPose<T>& tool, Put put) {
    write_vector(tool.rotation.x, put), write_vector(tool.rotation.y, put), write_vector(tool.rotation.z, put);
    write_vector(tool.position, put);
  }
};

template <class Robot, class T>
struct JacobianKernel {
  static constexpr const char* name = "jacobian";
  static auto run(const MotionState<Robot, T>& s, const Joints<Robot, T>&) { return jacobian<Robot>(s.q); }
  template <class Put>
  static void write(const Jacobian<Robot, T>& columns, Put put) {
    for (int j = 0; j < joint_count<Robot>; ++j)
      write_vector(columns[j].angular, put), write_vector(columns[j].linear, put);
  }
};

template <class Robot, class T>
struct ClosedForm {
  static constexpr const char* name = "closed_form";
  static auto run(const MotionState<Robot, T>& s, const Joints<Robot, T>&) {
    return closed_form::scara_torque<Robot>(s.q, s.qd, s.qdd);
  }
  template <class Put>
  static void write(const Joints<Robot, T>& tau, Put put) {
    write_joints(tau, put);
  }
};

}  // namespace axial::apps::kernels

// Robots whose joints share drives: inverse dynamics, mass matrix, forward dynamics and kinematics in values of drives.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/kinematics.hpp>
#include <axial/transmissions/coupling_terms.hpp>
#include <axial/transmissions/driven_algorithms.hpp>
#include <axial/transmissions/driven_floating_base.hpp>
#include <axial/transmissions/driven_links.hpp>
#include <axial/transmissions/driven_model.hpp>
#include <axial/transmissions/driven_motion.hpp>
#include <axial/transmissions/driven_rotors.hpp>
#include <axial/transmissions/driven_separation.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace driven {
/// Forward dynamics by composite bodies; a number system with formats has its own.
template <class Links>
struct CompositeRigidBodies {
  /// Accelerations of the drives.
  template <class Input, class Q, class V, class Tau, class A>
  AXIAL_INLINE static constexpr auto accelerations(const Links& links, const Input& in, const Q& u, const V& ud,
                                                   const Tau& tau, A& udd) {
    if constexpr (!Links::Scene::template has<FloatingBase>) {
      using Kernels = DrivenKernels<Links>;
      const auto q = links.positions(u);
      auto screws = joint_screws(links.joints(), in, q);
      Kernels::remaining_efforts(links, in, q, screws, links.rates(ud), ud, tau, udd);
      typename Kernels::Matrix m{};
      Kernels::matrix(links, in, screws, m);
      return crba::solve(links.drives(), m, udd);
    } else if constexpr (Links::unrolled) {
      const auto own = links_of<typename Links::Scene, typename Links::Scalar, FullParameters>();
      return driven::FloatingBaseCoupled<std::decay_t<decltype(own)>>::accelerations(own, in, u, ud, tau, udd);
    } else {
      return driven::FloatingBaseCoupled<Links>::accelerations(links, in, u, ud, tau, udd);
    }
  }
};
}  // namespace driven

/// Kernels in values of drives: joints by q = G u + q0, efforts of the drives by tau_u = G^T tau_q, rotors and friction
/// of the drives themselves.
template <class Links>
struct DrivenKernels {
  using T = typename Links::Scalar;                                                     ///< the number
  using JointMatrix = MassMatrixOf<typename Links::JointScene, typename Links::Value>;  ///< M of the joints
  using JointJacobian = Jacobian<typename Links::JointRobot, typename Links::Value>;    ///< by the joints
  using Matrix = MassMatrix<typename Links::Scene::Robot, T>;                           ///< M of the drives

  /// M of the drives.
  template <class Input, class Screws, class M>
  AXIAL_INLINE static constexpr void matrix(const Links& links, const Input& in, const Screws& screws, M& m) {
    JointMatrix joints{};
    crba::entries(links.joints(), in, screws, joints);
    reduce(links, joints, m);
    if constexpr (Links::Scene::template has<RotorDynamics>) driven::couple_rotors(links, screws, m);
  }
  /// G^T M G and the rotors.
  template <class M, class Drives>
  AXIAL_INLINE static constexpr void reduce(const Links& links, const M& joints, Drives& m) {
    if constexpr (Links::unrolled)
      driven::reduce(links, joints, m, std::make_integer_sequence<int, driven::share_count<Links>>{});
    else
      links.reduce(joints, m);
  }
  /// Columns of a Jacobian by drives, from those by joints.
  template <class J, class Result>
  AXIAL_INLINE static constexpr void columns(const Links& links, const J& joints, Result& result) {
    links.each_drive([&](auto k) AXIAL_INLINE { result[k] = column(links, k, joints); });
    result.status = joints.status;
  }

  /// What the drives' efforts leave to accelerate.
  template <class Of, class Input, class Q, class Screws, class W, class V, class Tau, class A>
  AXIAL_INLINE static constexpr void remaining_efforts(const Of& links, const Input& in, const Q& q,
                                                       const Screws& screws, const W& qd, const V& ud, const Tau& tau,
                                                       A& left) {
    typename Links::JointValues bias{};
    const auto& joints = links.joints();
    const auto of_rotor =
        driven::run_joints(links, joints, in, q, screws, qd, NoMotion{}, ud, NoMotion{},
                           [&](auto i, const auto& effort) AXIAL_INLINE { joints.write(bias, i, effort); });
    remaining_efforts(links, bias, ud, tau, left);
    if constexpr (Links::Scene::template has<RotorDynamics>)
      links.each_drive([&](auto k) AXIAL_INLINE { left[k] = static_cast<T>(left[k] - of_rotor(k)); });
  }
  /// What the drives' efforts leave besides efforts of the joints and the drives' friction.
  template <class Of, class Values, class V, class Tau, class A>
  AXIAL_INLINE static constexpr void remaining_efforts(const Of& links, const Values& bias, const V& ud, const Tau& tau,
                                                       A& left) {
    links.each_drive([&](auto k) AXIAL_INLINE {
      left[k] =
          static_cast<T>(tau[k] - (links.actuator_effort(k, bias) + friction_effort(links.drives().link(k), ud[k])));
    });
  }

 private:
  template <class K, class J>
  AXIAL_INLINE static constexpr auto column(const Links& links, K k, const J& joints) {
    using Vector = Vec3<typename Links::Value>;
    MotionVector<Vector, Vector> sum{};
    const auto part = [&](const auto& get) {
      if constexpr (Links::unrolled)
        return Links::template column_part<K::value>(get);
      else
        return links.column_part(k, get);
    };
    sum.angular = {part([&](int i) { return joints[i].angular.x; }), part([&](int i) { return joints[i].angular.y; }),
                   part([&](int i) { return joints[i].angular.z; })};
    sum.linear = {part([&](int i) { return joints[i].linear.x; }), part([&](int i) { return joints[i].linear.y; }),
                  part([&](int i) { return joints[i].linear.z; })};
    return sum;
  }
};

namespace crba {
/// Structure of M of drives: those pairs that some pair of moved joints makes, and what the elimination fills in.
template <class R, class... Features, class T, class Parameters>
inline constexpr auto structure<StaticLinks<Scene<DriveCoordinates<R>, Features...>, T, Parameters>> = [] {
  using Links = DrivenLinks<Scene<DriveCoordinates<R>, Features...>, T, BaseParameters>;
  Structure<Links::capacity> met;
  driven::each_share_of<Links>([&](const driven::Share& share) { met.present[share.k][share.l] = true; });
  for (int k = 0; k < Links::capacity; ++k) {
    met.present[k][k] = true;
    if constexpr (Links::Scene::template has<FloatingBase>)
      for (int l = 0; l < k; ++l)
        met.present[k][l] = true;
    if constexpr (Links::Scene::template has<RotorDynamics>)
      for (int l = 0; l < k; ++l)
        met.present[k][l] =
            met.present[k][l] || driven::turns_carrier<Links>(l, k) || driven::turns_carrier<Links>(k, l);
  }
  met.fill();
  return met;
}();
}  // namespace crba

namespace detail {
/// Every drive has a rotor, or every joint something that resists it: then M of the joints is positive definite.
template <class Scene>
constexpr bool every_drive_is_resisted() {
  bool rotors = Scene::template has<RotorInertia>;
  for (const LinkParameters& drive : Scene::Robot::chain.links)
    rotors = rotors && drive.rotor_inertia > 0.0;
  return rotors || every_joint_is_resisted<typename SceneOfJoints<Scene>::type>();
}
// What links do not say of a drive is told at run time.
template <class R, class... Features>
inline constexpr bool elimination_loses_little<Scene<DriveCoordinates<R>, Features...>> = false;
template <class R, class... Features, int I, class T, class Parameters>
struct AlwaysResists<StaticLink<Scene<DriveCoordinates<R>, Features...>, I, T, Parameters, Plain>> : std::false_type {};
}  // namespace detail

/// Joint positions at positions of the drives, G u + q0: rad or m, of all joints of a robot whose joints share drives.
template <class S, class T>
[[nodiscard]] constexpr Joints<JointCoordinates<robot_of<S>>, T> joint_positions(const Positions<robot_of<S>, T>& u) {
  return decltype(links_of<S, T>())::positions(u);
}
/// Joint speeds or accelerations: G times those of the drives.
template <class S, class T>
[[nodiscard]] constexpr Joints<JointCoordinates<robot_of<S>>, T> joint_rates(const Velocities<robot_of<S>, T>& ud) {
  return decltype(links_of<S, T>())::rates(ud);
}
/// Efforts of the drives that do what efforts at the joints would, G^T tau: N m or N per unit of the drive. The power
/// is the same.
template <class S, class T>
[[nodiscard]] constexpr Efforts<robot_of<S>, T> drive_efforts(const Joints<JointCoordinates<robot_of<S>>, T>& tau) {
  using Links = decltype(links_of<S, T>());
  Efforts<robot_of<S>, T> actuator_effort{};
  Links::each_drive(
      [&](auto k) { actuator_effort[k] = static_cast<T>(Links::template actuator_effort<decltype(k)::value>(tau)); });
  return actuator_effort;
}

}  // namespace axial

#include <axial/options/end.hpp>

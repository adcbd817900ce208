// Algorithms in values of drives of which more is to be known than the roles of their arguments.
#pragma once

#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/joint_torque.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/transmissions/clustered_dynamics.hpp>
#include <axial/transmissions/driven_rotors.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace driven {

template <class Links>
struct CompositeRigidBodies;
}  // namespace driven

/// Efforts of the drives.
template <class Links>
struct Execution<rnea::InverseDynamics, Links, IfDriven<Links>> {
  /// writes them; rates may be NoMotion
  template <class Input, class Q, class V, class A, class Tau>
  AXIAL_INLINE static constexpr void run(const Links& links, const Input& in, const Q& u, const V& ud, const A& udd,
                                         Tau& tau) {
    const auto& joints = links.joints();
    const auto q = links.positions(u);
    const auto qd = links.kernel_rates(ud);
    const auto qdd = links.kernel_rates(udd);
    const auto at = joints.read(q);
    typename Links::JointValues at_joints{};
    const auto of_rotor =
        driven::run_joints(links, joints, in, at, joint_screws(joints, in, at), joints.read(qd), joints.read(qdd), ud,
                           udd, [&](auto i, const auto& effort) AXIAL_INLINE { joints.write(at_joints, i, effort); });
    const auto actuator_effort = links.actuator_efforts(at_joints);
    const auto speeds = links.read_drives(ud);
    const auto accelerations = links.read_drives(udd);
    links.each_drive([&](auto k) AXIAL_INLINE {
      const auto drive = links.drives().link(k);
      links.answer(tau, k, actuator_effort, friction_effort(drive, speeds[k]), drive.rotor() * accelerations[k],
                   of_rotor(k));
    });
  }
};
/// Effort of one drive.
template <class S, class T, int Drive, class Links>
struct Execution<rnea::JointEffort<S, T, Drive>, Links, IfDriven<Links>> {
  /// of those of all: compilers leave out what nobody reads
  template <class... X>
  AXIAL_INLINE static constexpr T run(const Links& links, X&&... x) {
    EffortsOf<S, T> effort{};
    Execution<rnea::InverseDynamics, Links>::run(links, x..., effort);
    return effort[Drive];
  }
};
/// M of the drives.
template <class Links>
struct Execution<crba::CompositeMatrix, Links, IfDriven<Links>> {
  /// writes it
  template <class Input, class Q, class M>
  AXIAL_INLINE static constexpr void run(const Links& links, const Input& in, const Q& u, M& m) {
    const auto q = links.positions(u);
    const auto& at = links.joints();
    DrivenKernels<Links>::matrix(links, in, joint_screws(at, in, at.read(q)), m);
  }
};
/// Accelerations of the drives, by composite bodies.
template <class Links>
struct Execution<crba::Accelerations, Links, IfDriven<Links>> {
  /// their status
  template <class... X>
  AXIAL_INLINE static constexpr auto run(const Links& links, X&&... x) {
    return driven::CompositeRigidBodies<Links>::accelerations(links, x...);
  }
};
/// Accelerations of the drives by articulated bodies over clusters; `bias_links` are those of the bias effort.
template <class Links>
struct Execution<aba::SplitForm, Links, IfDriven<Links>> {
  /// their status
  template <class BiasLinks, class Input, class Q, class V, class Tau, class A>
  AXIAL_INLINE static constexpr auto run(const Links& links, const BiasLinks& bias_links, const Input& in, const Q& u,
                                         const V& ud, const Tau& tau, A& udd) {
    const auto q = links.positions(u);
    const auto screws = joint_screws(bias_links.joints(), in, q);
    DrivenKernels<Links>::remaining_efforts(bias_links, in, q, screws, links.rates(ud), ud, tau, udd);
    using Scenes = detail::SceneOfClusters<typename Links::Scene>;
    const auto bodies =
        links_of<typename Scenes::type, typename Links::Scalar, FullParameters, recursion::ArticulatedBodiesAtRest>();
    return clusters::Passes<typename Scenes::Robot, Links, decltype(bodies)>::run(bodies, in, screws, udd);
  }
};
/// Momenta and drifts of the drives: G^T times momenta and drifts of the joints, and what each drive has of its own:
/// rotor and friction.
template <class Holding>
struct Execution<momentum::Terms, Holding, IfDriven<Holding>> {
  /// writes them
  template <class Links, class Input, class U, class V, class Result>
  AXIAL_INLINE static constexpr void run(const Holding& at_rest, const Links& links, const Input& in, const U& u,
                                         const V& ud, Result& terms) {
    const auto q = links.positions(u);
    MomentumTerms<typename Links::JointScene, typename Links::Value> at_joints{};
    execute<momentum::Terms>(at_rest.joints(), links.joints(), in, q, links.rates(ud), at_joints);
    const auto speeds = links.read_drives(ud);
    const auto momenta = links.actuator_efforts(at_joints.momentum);
    const auto drifts = links.actuator_efforts(at_joints.drift);
    Soundness<typename Links::Scalar> all;
    detail::judge_positions(all, links.joints(), in, q);
    links.each_drive([&](auto k) AXIAL_INLINE {
      const auto drive = links.drives().link(k);
      links.answer(terms.momentum, k, momenta, drive.rotor() * speeds[k]);
      links.answer(terms.drift, k, drifts, -friction_effort(drive, speeds[k]));
      all.number(ud[k]), all.number(terms.momentum[k]), all.number(terms.drift[k]);
    });
    terms.status = all.status();
  }
};

}  // namespace axial

#include <axial/options/end.hpp>

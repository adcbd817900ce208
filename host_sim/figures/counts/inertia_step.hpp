// The library's articulated-body algorithm with another congruence in its inertia step, and nothing else changed.
#pragma once

#include <axial/dynamics/articulated_body.hpp>
#include <axial/links/model.hpp>

namespace counts {

/// aba::reflect, the inertia carried by Congruence.
template <class Congruence, class T, class Kind, class Link, class Screw, class Tree, class Vel>
auto reflect_by(Kind joint, const Link& link, const Screw& screw, const Tree& tree, const Vel& velocity, const T& tau) {
  using namespace axial;
  auto x = link.x();
  auto r = reflection(joint, link, tree.inertia, tree.bias, velocity.zeta, tau, singularity_scale(joint, tree.scale));
  aba::Subtree sent{Congruence::template to_parent<T>(x, screw, r.inertia),
                    to_parent(x, to_parent(screw, r.bias, link), link),
                    seen_from(tree.scale, shift_length(x) + shift_length(screw))};
  return aba::InwardResult{r.gain, r.free, velocity.zeta, r.singular, r.left, sent};
}

/// Accelerations of a run-time model without friction and outside forces.
template <class Congruence, class M, class T>
axial::Joints<M, T> forward_dynamics_by(const M& model, const axial::Joints<M, T>& q, const axial::Joints<M, T>& qd,
                                        const axial::Joints<M, T>& tau) {
  using namespace axial;
  const auto links = model.template links<T>();
  const Inputs<M, T> in{};
  const auto screws = joint_screws(links, in, q);
  const auto water = axial::immersions(links, in, screws, qd);  // none
  const aba::InMotion<decltype(links), Inputs<M, T>, Joints<M, T>, Joints<M, T>, decltype(water)> situation{
      links, in, q, qd, water};
  const auto velocities = situation.velocities(screws);
  const auto own = [&](auto i) {
    const auto link = links.link(i);
    const auto body = link.body();
    const auto external = situation.external(i, link, body, velocities[i]);
    return link.shape(aba::alone(link, body, link.inertia_differences(), velocities[i], external));
  };
  const auto joints = inward(links, own, [&](auto i, const auto& tree) {
    const auto link = links.link(i);
    return link.on_joint([&](auto joint) {
      return aba::shaped(link, reflect_by<Congruence, T>(joint, link, screws[i], tree, velocities[i], tau[i]));
    });
  });
  Joints<M, T> qdd{};
  outward(links, situation.base(joints).acceleration, [&](auto i, const auto& parent) {
    const auto link = links.link(i);
    const auto& left = joints[i];
    const auto moved = to_child(screws[i], to_child(link.x(), parent, link), link) + left.zeta;
    return link.on_joint([&](auto joint) {
      const T acceleration = left.free - gain_times(left.gain, moved);
      qdd[i] = acceleration;
      return link.shape(moved + along_axis(joint, acceleration));
    });
  });
  return qdd;
}

}  // namespace counts

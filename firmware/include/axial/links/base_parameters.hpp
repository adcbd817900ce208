// Base inertial parameters: what the joint torques can feel, regrouped by the compiler so that most entries vanish.
#pragma once

#include <axial/links/link_constants.hpp>
#include <axial/spatial/congruence.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

using Body = RigidInertia<double, Vec3<double>, Sym3<double>>;

constexpr void set_differences(LinkConstants<double>& link) {
  link.jzz_jyy = link.jzz - link.jyy, link.jxx_jzz = link.jxx - link.jzz, link.jyy_jxx = link.jyy - link.jxx;
}

constexpr void add(TreeLinkConstants<double>& link, const Body& body) {
  link.mass += body.mass;
  link.hx += body.first_moment.x, link.hy += body.first_moment.y, link.hz += body.first_moment.z;
  link.jxx += body.inertia.xx, link.jyy += body.inertia.yy, link.jzz += body.inertia.zz;
  link.jxy += body.inertia.xy, link.jxz += body.inertia.xz, link.jyz += body.inertia.yz;
}

constexpr auto way_to_axis(const TreeLinkConstants<double>& link) {
  return BranchScrew{z_screw(link.branch.cos_gamma, link.branch.sin_gamma, link.branch.b),
                     x_screw(link.cos_alpha, link.sin_alpha, link.a)};
}

// A body that is symmetric about a revolute joint's axis turns about it unseen: it may sit on either side of the joint.
// Takes mass, hz and diag(Jyy, Jyy, 0) from the link; returns them in the parent's frame.
constexpr Body shift_to_parent(Revolute, TreeLinkConstants<double>& link) {
  const double j = link.jyy;
  const Body symmetric{link.mass, {0.0, 0.0, link.hz}, {j, j, 0.0, 0.0, 0.0, 0.0}};
  link.mass = link.hz = link.jyy = 0.0, link.jxx -= j;
  const auto shifted = to_parent(z_screw(1.0, 0.0, link.d), symmetric);
  return to_parent(way_to_axis(link), shifted);
}
// A prismatic link turns as its parent does: its inertia about its own origin belongs to the parent. So does its first
// moment where all that turns it inboard turns about the slide's direction: across it the moment moves as the parent,
// along it it is not felt. An axial mass is borne by the parent, and stays in the link for the slide's own drive.
constexpr Body shift_to_parent(Prismatic, TreeLinkConstants<double>& link, bool turns_along_slide, bool axial_mass) {
  const Sym3<double> own{link.jxx, link.jyy, link.jzz, link.jxy, link.jxz, link.jyz};
  link.jxx = link.jyy = link.jzz = link.jxy = link.jxz = link.jyz = 0.0;
  Body body{axial_mass ? link.mass : 0.0, {}, own};
  if (turns_along_slide) body.first_moment = {link.hx, link.hy, 0.0}, link.hx = link.hy = link.hz = 0.0;
  const auto turned_z = to_parent(z_screw(link.cos_theta, link.sin_theta, 0.0), body);
  return to_parent(way_to_axis(link), turned_z);
}

// Whether every revolute joint inboard of slide i turns about an axis parallel to it.
constexpr bool turns_along_slide(const TreeLinkConstants<double>* links, int i) {
  bool parallel = links[i].sin_alpha == 0.0;
  for (int k = links[i].parent; k >= 0; k = links[k].parent) {
    if (!links[k].prismatic && !parallel) return false;
    parallel = parallel && links[k].sin_alpha == 0.0;
  }
  return true;
}

// Whether slide i moves apart from all else: joints inboard turn about axes parallel to it, joints outboard turn. Then
// its mass acts across its direction as a part of its parent, and along it on its own drive alone.
constexpr bool has_axial_mass(const TreeLinkConstants<double>* links, int size, int i) {
  if (!links[i].prismatic || !turns_along_slide(links, i)) return false;
  for (int k = links[i].parent; k >= 0; k = links[k].parent)
    if (links[k].prismatic) return false;
  for (int k = i + 1; k < size; ++k) {
    int inboard = links[k].prismatic ? k : -1;
    while (inboard > i)
      inboard = links[inboard].parent;
    if (inboard == i) return false;
  }
  return true;
}

}  // namespace detail

/// Regroups the parameters of a chain in place, from the tips to the base (links sorted so that parents come first).
/// What a body gives up acts on its parent as it did on itself, so no joint torque changes; on a base with given motion
/// say so, because first moments of slides stay there. Where algorithms know axial masses (spatial/inertia.hpp), a
/// slide that moves apart from all else gives its mass up too. Source: Khalil and Dombre 2002, chapter 9; Gautier and
/// Khalil 1990, in closed form for each joint.
constexpr void regroup(TreeLinkConstants<double>* links, int size, bool moving_base = true, bool axial_masses = false) {
  for (int i = size; i-- > 0;) {
    auto& link = links[i];
    const bool along = !moving_base && detail::turns_along_slide(links, i);
    const bool axial = axial_masses && detail::has_axial_mass(links, size, i);
    const auto body = link.prismatic ? detail::shift_to_parent(Prismatic{}, link, along, axial)
                                     : detail::shift_to_parent(Revolute{}, link);
    if (link.parent >= 0) detail::add(links[link.parent], body);
    detail::set_differences(link);
  }
}

/// Base parameters as a fixed base allows them, with rotors folded into links where that is exact: what scenes with
/// RotorInertia on a fixed base compute with where they compute with base parameters.
struct BaseParametersAndRotors {};
/// BaseParametersAndRotors with axial masses: for bodies that nothing is added to at run time.
struct BaseParametersAndAxialMasses {};

/// Folds rotors in place into links that turn about an axis of fixed direction: no joint inboard turns, and neither
/// does the base. There Jzz enters the joint's own effort and nothing else, as gear^2 J does.
constexpr void fold_rotors(TreeLinkConstants<double>* links, int size) {
  for (int i = 0; i < size; ++i) {
    int inboard = links[i].parent;
    while (inboard >= 0 && links[inboard].prismatic)
      inboard = links[inboard].parent;
    if (links[i].prismatic || inboard >= 0) continue;
    links[i].jzz += links[i].rotor, links[i].rotor = 0.0;
    detail::set_differences(links[i]);
  }
}

/// Regroups as the parameters' name says: for a moving base unless it names what a fixed one allows.
template <class Parameters>
constexpr void regroup_as(TreeLinkConstants<double>* links, int size) {
  constexpr bool axial_masses = std::is_same_v<Parameters, BaseParametersAndAxialMasses>;
  constexpr bool fixed_base = axial_masses || std::is_same_v<Parameters, BaseParametersAndRotors>;
  regroup(links, size, !fixed_base, axial_masses);
  if constexpr (fixed_base) fold_rotors(links, size);
}

}  // namespace axial

#include <axial/options/end.hpp>

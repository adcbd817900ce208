// Links whose joints are as heavy as an implicit step makes them.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/recursion/drive_slopes.hpp>
#include <axial/recursion/passes.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Stiffness -d tau_i / d q_i (N m/rad, N/m) and damping -d tau_i / d qd_i (N m s/rad, N s/m) of what drives the
/// joints, each on its own joint and not negative: a stiff controller, end stops.
template <class S, class T>
struct DriveStiffness {
  Joints<robot_of<S>, T> stiffness{};  ///< N m/rad or N/m
  Joints<robot_of<S>, T> damping{};    ///< N m s/rad or N s/m
};

/// Drives without stiffness and damping: zero by type.
struct NoStiffness {
  NoMotion stiffness{};  ///< none
  NoMotion damping{};    ///< none
};

namespace detail {

// What friction damps: viscous, and dry friction over its smooth speed, whose effort is the larger breakaway of both
// directions; the fall of Stribeck's curve is left out, for its slope is negative.
template <class Link, class V>
AXIAL_INLINE constexpr auto friction_damping(const Link& link, const V& qd) {
  if constexpr (!Link::Scene::template has<Friction>) {
    return Zero{};
  } else if constexpr (is_zero_v<decltype(link.inverse_smooth_speed())>) {
    return link.viscous();
  } else {
    const V forward(link.coulomb_forward() + link.stribeck_forward());
    const V backward(-(link.coulomb_backward() + link.stribeck_backward()));
    return link.viscous() + sign_slope(link, qd) * select(forward > backward, forward, backward);
  }
}

}  // namespace detail

/// A link with the inertia `added` on its joint.
template <class Link, class Added>
class HeavierLink : public Link {
 public:
  /// `added` in kg m^2 or kg.
  AXIAL_INLINE constexpr HeavierLink(const Link& link, const Added& added) : Link(link), added_(added) {}
  /// Inertia on the joint: the rotor's and the added.
  AXIAL_INLINE constexpr auto rotor() const { return Link::rotor() + added_; }

 private:
  Added added_;
};

/// The links as M + h D + h^2 K sees them: the springs' K and the dampers' D of each joint, at velocities qd, stand
/// where a rotor's inertia does, so that the articulated-body recursion solves for them in O(n). A joint without either
/// is as it was, by type.
template <class Links, class V, class Stiffness>
class StiffLinks : public Links {
 public:
  using Scalar = typename Links::Scalar;  ///< of the links
  /// For a step of h seconds at the velocities qd; all three are only referred to.
  AXIAL_INLINE constexpr StiffLinks(const Links& links, Scalar h, const V& qd, const Stiffness& drive)
      : Links(links), h_(h), qd_(qd), drive_(drive) {}

  /// Link i with what its springs, dampers and drive add to the inertia of its joint.
  template <class I>
  AXIAL_INLINE constexpr auto link(I i) const {
    auto link = Links::link(i);
    auto damping = detail::friction_damping(link, qd_[i]) + drive_.damping[i];
    auto added = h_ * (damping + h_ * stiffness(i));
    return HeavierLink<decltype(link), decltype(added)>(link, added);
  }
  /// Stiffness of springs and drive together, N m/rad or N/m.
  template <class I>
  AXIAL_INLINE constexpr auto stiffness(I i) const {
    return spring_slope(Links::link(i)) + drive_.stiffness[i];
  }

 private:
  Scalar h_;
  const V& qd_;
  const Stiffness& drive_;
};

}  // namespace axial

#include <axial/options/end.hpp>

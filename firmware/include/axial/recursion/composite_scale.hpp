// How large the composite inertia about a joint can be: the scale against which a joint is singular or not.
#pragma once

#include <axial/recursion/passes.hpp>
#include <axial/scalar/math.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Mass, a bound of |first moment| and the polar moment (integral of r^2 dm, bounded) of all that a link carries.
/// Made of constants, it is folded by the compiler; it scales with masses and lengths, so no absolute threshold hides
/// in it.
template <class M, class H, class P>
struct CompositeScale {
  M mass{};          ///< kg
  H first_moment{};  ///< kg m
  P polar{};         ///< kg m^2
  /// This scale as plain numbers.
  template <class T>
  AXIAL_INLINE constexpr CompositeScale<T, T, T> dense() const {
    return {mass, first_moment, polar};
  }
};
template <class M, class H, class P>
CompositeScale(M, H, P) -> CompositeScale<M, H, P>;

/// Two bodies about one point.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto operator+(const CompositeScale<A, B, C>& a, const CompositeScale<D, E, F>& b) {
  return CompositeScale{a.mass + b.mass, a.first_moment + b.first_moment, a.polar + b.polar};
}

/// Distance of a child's origin from its parent's, at most: the lengths of the shifts on the way.
template <class Axis, class C, class S, class L, class Turn>
AXIAL_INLINE constexpr auto shift_length(const AxialScrew<Axis, C, S, L, Turn>& screw) {
  return detail::absolute(screw.shift);
}
/// Overload for a branch: the shifts of both screws.
template <class Z, class X>
AXIAL_INLINE constexpr auto shift_length(const BranchScrew<Z, X>& branch) {
  return shift_length(branch.z) + shift_length(branch.x);
}

/// Scale of one rigid body: the polar moment is half the trace of its inertia.
template <class Body>
AXIAL_INLINE constexpr auto composite_scale(const Body& body) {
  const auto& h = body.first_moment;
  const auto& j = body.inertia;
  return CompositeScale{body.mass, detail::absolute(h.x) + detail::absolute(h.y) + detail::absolute(h.z),
                        j.xx + j.yy + j.zz};
}

/// Seen from a point at a distance of at most `shift`: polar' <= polar + 2 shift |h| + shift^2 m (parallel axes).
/// `polar` holds the trace, twice the moment, which only makes the bound wider.
template <class M, class H, class P, class L>
AXIAL_INLINE constexpr auto seen_from(const CompositeScale<M, H, P>& r, const L& shift) {
  auto grown = r.first_moment + shift * r.mass;
  auto growth = shift * (r.first_moment + grown);
  return CompositeScale{r.mass, grown, r.polar + growth + growth};
}

/// What the water adds to the composite inertia that a joint or the base is compared with.
template <class Water>
AXIAL_INLINE constexpr auto scale_of_water(const Water& water) {
  return CompositeScale{water.scale_mass(), water.scale_first_moment(), water.scale_polar()};
}

/// Where ranges are proved no joint is near singular, so that no scale is needed.
struct Unscaled {
  /// This scale itself: there is nothing to convert.
  template <class T>
  AXIAL_INLINE constexpr Unscaled dense() const {
    return {};
  }
};
AXIAL_INLINE constexpr Unscaled operator+(Unscaled, Unscaled) { return {}; }  ///< none beside none
/// The scale seen from anywhere: itself.
template <class L>
AXIAL_INLINE constexpr Unscaled seen_from(Unscaled, const L&) {
  return {};
}
/// The scale of a link's own body: Unscaled where ranges are proved.
template <class Link, class Body>
AXIAL_INLINE constexpr auto scale_of(const Link&, const Body& body) {
  if constexpr (Link::ranged)
    return Unscaled{};
  else
    return composite_scale(body);
}

namespace detail {
/// Whether every drive that joints share is resisted: shared_drives.hpp.
template <class Scene>
constexpr bool every_drive_is_resisted();
}  // namespace detail

/// Index of a joint of a robot that nothing outboard resists, the outermost; -1 where all are resisted: by their own
/// inertia about the axis (or mass along it), any mass or inertia further out, a rotor or a payload that the scene
/// names. Of joints that share drives 0, where a drive is not resisted.
template <class S>
[[nodiscard]] constexpr int unresisted_joint() {
  using Scene = scene_of<S>;
  if constexpr (detail::shares_drives_in<typename Scene::Robot>)
    return detail::every_drive_is_resisted<Scene>() ? -1 : 0;
  const auto& links = detail::robot_constants<typename Scene::Robot>.links;
  constexpr int n = Scene::Robot::chain.size;
  bool moves_something[n] = {};
  for (int i = n; i-- > 0;) {
    const auto& c = links[i];
    const bool rotor = Scene::template has<RotorInertia> && c.rotor > 0.0;
    const bool along_axis = c.prismatic ? c.mass > 0.0 : c.jzz > 0.0;
    const bool payload = Scene::template has<Payload> && i + 1 == n;
    if (!(moves_something[i] || rotor || along_axis || payload)) return i;
    if (c.parent >= 0 && (moves_something[i] || c.mass > 0.0 || c.jxx + c.jyy + c.jzz > 0.0))
      moves_something[c.parent] = true;
  }
  return -1;
}
/// True where every joint of a robot is resisted.
template <class S>
[[nodiscard]] constexpr bool every_joint_is_resisted() {
  return unresisted_joint<S>() < 0;
}

/// Whether every joint moves some mass: compilers print it with the joint's index, from 0 at the base.
template <int joint>
inline constexpr bool every_joint_moves_mass_but = joint < 0;

}  // namespace axial

/// What is said where one does not (a macro: static_assert takes a literal only).
#define AXIAL_JOINTS_MOVE_MASS                                                                                      \
  "axial: forward dynamics needs every joint to move some mass, inertia or rotor; give the links outboard of each " \
  "joint a mass, an inertia about the joint axis, or rotor_inertia()"

#include <axial/options/end.hpp>

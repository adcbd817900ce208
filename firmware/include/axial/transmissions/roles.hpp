// Algorithms over joints that share drives, by the roles of their arguments: q = G u + q0, rates and twists by G. The
// scenes of such a robot: those of its joints and of its clusters.
#pragma once

#include <axial/links/links.hpp>
#include <axial/robot/drive_coordinates.hpp>
#include <axial/scene/joints.hpp>
#include <axial/scene/scene.hpp>
#include <axial/scene/without_drives.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Whether links stand for joints that share drives (driven_links.hpp), and what kernels do then.
///@{
template <class Links>
inline constexpr bool is_driven = false;
template <class Links>
inline constexpr bool is_driven<const Links> = is_driven<Links>;
template <class Links>
struct DrivenKernels;
template <class Links>
using IfDriven = std::enable_if_t<is_driven<Links>>;
namespace driven {
template <class Links, class By>
struct SlopeShares;
/// Values of drives over numbers T without formats, as they are.
template <class T>
struct PlainDrives {
  static constexpr NoMotion rates(NoMotion) { return {}; }  ///< nothing moves
  template <class U>
  AXIAL_INLINE static constexpr const U& read_drives(const U& u) {  ///< as kernels compute with them
    return u;
  }
  /// Writes for drive k what it feels of the joints, and terms of its own.
  template <class Values, class K, class AtActuators, class... Own>
  AXIAL_INLINE static constexpr void answer(Values& values, K k, const AtActuators& actuator_effort,
                                            const Own&... own) {
    values[k] = static_cast<T>((actuator_effort[k] + ... + own));
  }
  /// values[k] = x.
  template <class Values, class K, class X>
  AXIAL_INLINE static constexpr void write(Values& values, K k, const X& x) {
    values[k] = static_cast<T>(x);
  }
};
/// term(Index<0>{}) + (term(Index<1>{}) + ...), `count` of them.
template <int count, int i = 0, class Term>
AXIAL_INLINE constexpr auto sum_of(const Term& term) {
  if constexpr (i == count)
    return Zero{};
  else
    return term(Index<i>{}) + sum_of<count, i + 1>(term);
}
}  // namespace driven
///@}
/// Stops the compiler where such links reach a kernel without: at once, being a class.
template <class Links>
struct Walkable<Links, IfDriven<Links>> {
  static_assert(!is_driven<Links>,
                "axial: this function does not know joints that share drives; call it for "
                "axial::JointCoordinates<Robot> with joint_positions<Robot>(u) and map efforts by drive_efforts()");
};

/// An algorithm whose arguments have roles, by those.
template <class Algorithm, class Links>
struct Execution<Algorithm, Links, std::void_t<IfDriven<Links>, typename Algorithm::Roles>> {
  /// over the joints
  template <class Input, class... X>
  AXIAL_INLINE static constexpr decltype(auto) run(const Links& links, const Input& in, X&&... x) {
    return by_role(typename Algorithm::Roles{}, links, in, x...);
  }

 private:
  template <class Role, class X>
  AXIAL_INLINE static constexpr decltype(auto) at_joints(const Links& links, X& x) {
    if constexpr (std::is_same_v<Role, role::None>)
      return (x);
    else if constexpr (std::is_same_v<Role, role::Position>)
      return links.positions(x);
    else
      return links.rates(x);
  }
  template <class... Role, class Input, class... X>
  AXIAL_INLINE static constexpr decltype(auto) by_role(Roles<Role...>, const Links& links, const Input& in, X&... x) {
    return execute<Algorithm>(links.joints(), in, at_joints<Role>(links, x)...);
  }
  template <class... Role, class Input, class J, class... X>
  AXIAL_INLINE static constexpr void by_role(Roles<TwistByRate, Role...>, const Links& links, const Input& in,
                                             J& jacobian, X&... x) {
    typename DrivenKernels<Links>::JointJacobian by_joints{};
    by_role(Roles<role::None, Role...>{}, links, in, by_joints, x...);
    DrivenKernels<Links>::columns(links, by_joints, jacobian);
  }
};
/// The joints.
template <class Links>
struct Execution<JointLinks, Links, IfDriven<Links>> {
  /// as links of their own
  AXIAL_INLINE static constexpr decltype(auto) run(const Links& links) { return links.joints(); }
};
/// The drives.
template <class Links>
struct Execution<Actuators, Links, IfDriven<Links>> {
  /// as links of their own
  AXIAL_INLINE static constexpr decltype(auto) run(const Links& links) { return links.drives(); }
};

namespace detail {

template <class R>
struct LinksOwner<DriveCoordinates<R>> {
  using type = JointCoordinates<R>;
};

/// The scene of a robot's joints: what belongs to drives is left to them.
template <class Scene>
struct SceneOfJoints;
template <class R, class... Features>
struct SceneOfJoints<Scene<DriveCoordinates<R>, Features...>> {
  using type = typename WithoutDrives<Scene<JointCoordinates<R>>, Features...>::type;
};

/// The scene of a robot's clusters: that of its joints with the rotors that are a joint's alone.
template <class Scene>
struct SceneOfClusters;
template <class R, class... Features>
struct SceneOfClusters<Scene<DriveCoordinates<R>, Features...>> {
  using Robot = R;  ///< whose joints share drives
  using type = std::conditional_t<Scene<DriveCoordinates<R>, Features...>::template has<RotorInertia>,
                                  typename WithoutDrives<Scene<ClusterCoordinates<R>, RotorInertia>, Features...>::type,
                                  typename WithoutDrives<Scene<ClusterCoordinates<R>>, Features...>::type>;
};

template <class R, class... Features>
constexpr const auto& drive_matrix_of_scene(const Scene<DriveCoordinates<R>, Features...>*) {
  return drive_matrix<R>;
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

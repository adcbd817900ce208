// Algorithms over joints that share drives, by the roles of their arguments: q = G u + q0, rates and twists by G.
#pragma once

#include <axial/links/links.hpp>
#include <axial/scene/joints.hpp>

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

}  // namespace axial

#include <axial/options/end.hpp>

// Which entries of the Jacobians of inverse dynamics are not zero, as the compiler finds by running the kernel once.
#pragma once

#include <axial/derivatives/derivative_entries.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// Which entries of the Jacobians are not zero by structure; where a kernel writes them.
template <int N>
struct JacobianStructure {
  bool by_position[N][N] = {};  ///< d tau / d q, by row and column
  bool by_velocity[N][N] = {};  ///< d tau / d qd

  template <class X>
  constexpr void effort(int, const X&) {}  ///< not looked at
  template <class X>
  constexpr void mass(int, int, const X&) {}  ///< not looked at
  constexpr void position(int, int, Zero) {}  ///< what is zero by type stays absent
  constexpr void velocity(int, int, Zero) {}  ///< what is zero by type stays absent
  template <class X>
  constexpr void position(int i, int j, const X&) {
    by_position[i][j] = true;
  }  ///< present
  template <class X>
  constexpr void velocity(int i, int j, const X&) {
    by_velocity[i][j] = true;
  }  ///< present

  /// Entries by positions.
  constexpr const auto& of(by::Position) const { return by_position; }
  constexpr const auto& of(by::Velocity) const { return by_velocity; }  ///< entries by velocities
};
/// Structure of the Jacobians of drives that joints share.
template <class Links>
constexpr auto driven_jacobian_structure();
/// Found by types alone, so at any motion: the compiler runs the kernel once over zeros.
template <class Links>
constexpr auto jacobian_structure_of() {
  using Scene = typename Links::Scene;
  if constexpr (detail::shares_drives_in<typename Scene::Robot>) {
    return driven_jacobian_structure<decltype(links_of<Scene, double, BaseParameters>())>();
  } else {
    constexpr StaticLinks<Scene, double, typename Links::Parameters> links;
    constexpr Joints<typename Scene::Robot, double> rest{};
    JacobianStructure<Links::capacity> structure;
    entries(links, Inputs<Scene, double>{}, rest, map_links(links, [&](auto i) { return links.link(i).z(0.0); }), rest,
            rest, structure);
    return structure;
  }
}
/// Structure of the Jacobians over these links.
template <class Links>
inline constexpr auto jacobian_structure = jacobian_structure_of<Links>();

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>

// Is a robot's inertia one that matter can have? A query, to the last bit; chain() refuses what is 5 % beyond it.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/robot/principal_moments.hpp>
#include <axial/scene/scene.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Index of the first link of a robot that no distribution of mass >= 0 has, or -1.
template <class S>
[[nodiscard]] constexpr int first_inconsistent_link(double tolerance = 1e-9) {
  constexpr auto& chain = robot_of<S>::chain;
  for (int i = 0; i < chain.size; ++i)
    if (!physically_consistent(chain.links[i].inertia_com, chain.links[i].mass, tolerance)) return i;
  return -1;
}

/// For a static_assert or a report: every link could be made of matter. A massless link with an inertia could not.
template <class S>
[[nodiscard]] constexpr bool physically_consistent(double tolerance = 1e-9) {
  return first_inconsistent_link<S>(tolerance) < 0;
}

}  // namespace axial

#include <axial/options/end.hpp>

// Is a robot's inertia one that matter can have? A query, never an error: published models in daily use fail it.
#pragma once

#include <axial/model/scene.hpp>

namespace axial {

/// True where an inertia tensor about a centre of mass (xx yy zz xy xz yz) belongs to a distribution of mass >= 0: its
/// pseudo-inertia tr(J)/2 1 - J is positive semidefinite, which says the triangle inequality in every axes
/// (Wensing, Kim and Slotine 2018). `tolerance` is relative to the trace.
[[nodiscard]] constexpr bool physically_consistent(const double (&j)[6], double mass, double tolerance = 1e-9) {
  const double trace = j[0] + j[1] + j[2], slack = tolerance * trace;
  if (mass < 0.0 || trace < 0.0) return false;
  if (mass == 0.0) return j[0] == 0.0 && j[1] == 0.0 && j[2] == 0.0 && j[3] == 0.0 && j[4] == 0.0 && j[5] == 0.0;
  const double xx = 0.5 * trace - j[0] + slack, yy = 0.5 * trace - j[1] + slack, zz = 0.5 * trace - j[2] + slack;
  const double xy = -j[3], xz = -j[4], yz = -j[5];
  const double minor_xy = xx * yy - xy * xy, minor_xz = xx * zz - xz * xz, minor_yz = yy * zz - yz * yz;
  const double determinant = xx * minor_yz - xy * (xy * zz - xz * yz) + xz * (xy * yz - xz * yy);
  return xx >= 0.0 && yy >= 0.0 && zz >= 0.0 && minor_xy >= 0.0 && minor_xz >= 0.0 && minor_yz >= 0.0 &&
         determinant >= 0.0;
}

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

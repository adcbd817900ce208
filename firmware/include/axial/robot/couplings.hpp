// Transmissions by name: parts of a chain that say which drives the links before them share.
#pragma once

#include <axial/robot/link_parameters.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Screw and spline on one shaft: the last two links before it, a slide and a turn about one axis in either order.
struct ScrewSpline {
  double lead = 0.0;  ///< slide travel per turn of the nut, m
};
/// A SCARA's quill: the nut turns by u_s, the spline by u_t; then q_turn = u_t, q_slide = lead/(2 pi) (u_s - u_t).
/// `lead` in m per turn, negative for a left-handed thread. The slide's drive is the nut: rad, N m.
constexpr ScrewSpline screw_spline(double lead) { return {lead}; }

/// Two drives whose sum moves the one, and whose difference moves the other of the last two links before it.
struct Differential {
  double ratio = 1.0;  ///< of the second joint
};
/// A differential wrist: q_a = (u_a + u_b) / 2, q_b = ratio (u_a - u_b) / 2.
constexpr Differential differential(double ratio = 1.0) { return {ratio}; }

/// G, row by row: a row per joint, a column the drive of each joint; a column of zeros where a joint has none.
template <int N>
struct DriveRatios {
  double rows[N][N] = {};  ///< rad or m of a joint per unit of the drive
};
/// Ratios of all joints at once: `axial::drive_ratios<3>({{1, 0, 0}, {0, 1, 0}, {0, -1, 1}})`, q = G u.
template <int N>
constexpr DriveRatios<N> drive_ratios(const double (&rows)[N][N]) {
  DriveRatios<N> g;
  for (int i = 0; i < N; ++i)
    for (int k = 0; k < N; ++k)
      g.rows[i][k] = rows[i][k];
  return g;
}

namespace detail {

/// Whether drive a or b is named already.
constexpr bool names_one(const JointDrives& drives, int a, int b) {
  for (int k = 0; k < drives.count && k < JointDrives::most; ++k)
    if (!drives.follows && (drives.of[k] == a || drives.of[k] == b)) return true;
  return false;
}

/// Writes a part's rows into the links before it, of which there are `count`.
template <int N>
constexpr bool couple(const ScrewSpline& screw, LinkParameters (&links)[N], int count) {
  if (count < 2) return false;
  const int slide = links[count - 1].type == JointType::prismatic ? count - 1 : count - 2;
  const int turn = 2 * count - 3 - slide;
  if (names_one(links[slide].drives, slide, turn) || names_one(links[turn].drives, slide, turn)) return false;
  constexpr double two_pi = 6.283185307179586476925;
  links[slide].drives.name(slide, screw.lead / two_pi), links[slide].drives.name(turn, -screw.lead / two_pi);
  return links[slide].type == JointType::prismatic && links[turn].type == JointType::revolute;
}
template <int N>
constexpr bool couple(const Differential& gears, LinkParameters (&links)[N], int count) {
  const int a = count - 2, b = count - 1;
  if (count < 2 || names_one(links[a].drives, a, b) || names_one(links[b].drives, a, b)) return false;
  links[a].drives.name(a, 0.5), links[a].drives.name(b, 0.5);
  links[b].drives.name(a, 0.5 * gears.ratio), links[b].drives.name(b, -0.5 * gears.ratio);
  return true;
}
template <int M, int N>
constexpr bool couple(const DriveRatios<M>& g, LinkParameters (&links)[N], int count) {
  if (M != N || count != N) return false;
  for (int i = 0; i < N; ++i) {
    if (links[i].drives.count > 0) return false;
    links[i].drives.complete = true;
    for (int k = 0; k < N; ++k)
      if (M == N && g.rows[i % M][k % M] != 0.0) links[i].drives.name(k, g.rows[i % M][k % M]);
    if (links[i].drives.count == 0) links[i].drives.name(i, 0.0);
  }
  return true;
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

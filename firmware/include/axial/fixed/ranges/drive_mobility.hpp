// How far a unit of energy moves drives that joints share: what bounds accelerations by efforts, whatever the position.
#pragma once

#include <axial/fixed/ranges/forward_error.hpp>
#include <axial/robot/drive_matrix.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Of what nothing that resists is known.
inline constexpr double unknown_mobility = 1e60;

/// Square roots of the largest (M^-1)_kk of drives, from above: v^2 <= mobility^2 v^T M v. Every link bounds how fast
/// it turns and moves by its own inertia and mass, hence its joint, and every rotor its drive; what the drives make of
/// either is a row of G or of the unit matrix, and any left inverse of all rows gives a bound for each drive.
template <int N>
class DriveMobility {
 public:
  /// `turns_across(i)` tells whether link i turns about axes other than its own; `rotor(k)` in kg m^2, 0 for none.
  template <class Across, class Rotor>
  constexpr DriveMobility(const Mechanism<N>& m, const DriveMatrix<N>& g, const Across& turns_across,
                          const Rotor& rotor)
      : g_(g) {
    for (int k = 0; k < g.drives; ++k)
      rows_[N + k] = drives_[k] = rotor(k) > 0.0 ? 1.0 / square_root(rotor(k)) : unknown_mobility;
    for (int i = 0; i < N; ++i)
      see(m, i, turns_across(i));
    combine();
  }
  constexpr double of(int k) const { return drives_[k]; }

 private:
  /// How fast a link turns and its origin moves for a unit of sqrt(qd^T M qd).
  struct Speed {
    double turn = 0.0, shift = 0.0;
  };
  const DriveMatrix<N>& g_;
  Speed links_[N] = {};
  double rows_[2 * N] = {}, drives_[N] = {};

  constexpr double by_rotors(int i) const {
    double sum = 0.0;
    for (int k = 0; k < g_.drives; ++k)
      if (g_.is_moved(i, k)) sum += magnitude(g_.ratio[i][k]) * drives_[k];
    return least(sum, unknown_mobility);
  }
  constexpr void see(const Mechanism<N>& m, int i, bool turns_across) {
    const auto& c = m.links[i];
    const Speed up = m.parent(i) < 0 ? Speed{} : links_[m.parent(i)];
    const double carried = up.shift + m.origin_distance(i) * up.turn;
    const double centre = c.mass > 0.0 ? length_of(c.hx, c.hy, c.hz) / c.mass : 0.0;
    const double inertia = inertia_against_turning(c, turns_across);
    const double freely = inertia > 0.0 ? 1.0 / square_root(inertia) : unknown_mobility;
    const double straight = c.mass > 0.0 ? 1.0 / square_root(c.mass) : unknown_mobility;
    Speed& own = links_[i];
    double joint = by_rotors(i);
    if (c.prismatic) {
      own.turn = least(freely, up.turn);
      joint = least(joint, straight + centre * own.turn + carried);
    } else {
      joint = least(joint, freely + up.turn);
      own.turn = least(freely, up.turn + joint);
    }
    own.shift = least(carried + (c.prismatic ? joint : 0.0), straight + centre * own.turn);
    own = {least(own.turn, unknown_mobility), least(own.shift, unknown_mobility)};
    rows_[i] = least(joint, unknown_mobility);
  }

  constexpr double entry(int row, int k) const { return row < N ? g_.ratio[row][k] : (row - N == k ? 1.0 : 0.0); }
  constexpr double weight(int row) const {
    return row < N + g_.drives && rows_[row] < unknown_mobility ? 1.0 / (rows_[row] * rows_[row]) : 0.0;
  }
  // The left inverse by least squares, rows weighted by what they know.
  constexpr void combine() {
    double a[N][N] = {}, p[N][2 * N] = {};
    for (int k = 0; k < g_.drives; ++k)
      for (int row = 0; row < 2 * N; ++row) {
        p[k][row] = entry(row, k) * weight(row);
        for (int l = 0; l < g_.drives; ++l)
          a[k][l] += p[k][row] * entry(row, l);
      }
    for (int k = 0; k < g_.drives; ++k) {
      double whole = 0.0;
      for (int row = 0; row < 2 * N; ++row)
        whole += entry(row, k) * entry(row, k) * weight(row);
      if (!(a[k][k] > 1e-9 * whole)) return;  // some drive is resisted by nothing that is known: rotors alone count
      for (int l = 0; l < g_.drives; ++l) {
        if (l == k) continue;
        const double factor = a[l][k] / a[k][k];
        for (int j = 0; j < g_.drives; ++j)
          a[l][j] -= factor * a[k][j];
        for (int row = 0; row < 2 * N; ++row)
          p[l][row] -= factor * p[k][row];
      }
    }
    for (int k = 0; k < g_.drives; ++k) {
      double sum = 0.0;
      for (int row = 0; row < N + g_.drives; ++row)
        if (weight(row) > 0.0) sum += magnitude(p[k][row] / a[k][k]) * rows_[row];
      drives_[k] = least(drives_[k], sum * (1.0 + 1e-6));
    }
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>

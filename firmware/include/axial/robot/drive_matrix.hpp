// Joints that share drives: q = G u + q0, with G and q0 from what the links of a chain name.
#pragma once

#include <axial/robot/chain_parameters.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A row of a matrix as an earlier one and one more number: row = sign row[from] + unit e[at].
struct RowStep {
  int from = -1;      ///< an earlier row; -1: the row is best taken as it is
  double sign = 1.0;  ///< 1 or -1
  int at = 0;         ///< the one number
  double unit = 0.0;  ///< 1 or -1 of it
};
/// Row i with n entries, entry(i, k), by an earlier row where that spares products, which 0, 1 and -1 are not. The rows
/// of a differential are (1/2, 1/2) and (1/2, -1/2).
template <class Entry>
constexpr RowStep row_step(const Entry& entry, int i, int n) {
  int products = 0;
  for (int k = 0; k < n; ++k)
    products += entry(i, k) == 0.0 || entry(i, k) == 1.0 || entry(i, k) == -1.0 ? 0 : 1;
  for (int j = 0; j < i && products > 1; ++j)
    for (const double sign : {1.0, -1.0}) {
      RowStep step{j, sign};
      int others = 0;
      for (int k = 0; k < n; ++k)
        if (const double left = entry(i, k) - sign * entry(j, k); left != 0.0) ++others, step.at = k, step.unit = left;
      if (others == 1 && (step.unit == 1.0 || step.unit == -1.0)) return step;
    }
  return {};
}

/// q = G u + q0 of N joints and as many drives at most: what the drives of a robot make of its joints. Efforts go the
/// other way: tau_u = G^T tau_q, so that power is the same on either side.
template <int N>
struct DriveMatrix {
  int drives = 0;            ///< number of drives: columns of G
  int owner[N] = {};         ///< index of the joint that owns a drive
  double ratio[N][N] = {};   ///< G: rad or m of a joint per unit of the drive
  double offset[N] = {};     ///< q0: rad or m
  bool named[N] = {};        ///< whether what a joint names is there, has a drive, and does not follow the joint
  bool independent = false;  ///< whether every motion of the drives moves some joint

  /// Drive that a joint owns, or -1.
  constexpr int drive_of(int joint) const {
    for (int k = 0; k < drives; ++k)
      if (owner[k] == joint) return k;
    return -1;
  }
  /// The drive that a joint owns, or the first that moves it.
  constexpr int mover_of(int joint) const {
    if (drive_of(joint) >= 0) return drive_of(joint);
    for (int k = 0; k < drives; ++k)
      if (is_moved(joint, k)) return k;
    return -1;
  }
  /// Whether nothing but its own drive moves a joint, one to one: then its limits are the drive's.
  constexpr bool is_alone(int joint) const {
    const int own = drive_of(joint);
    if (own < 0) return false;
    for (int k = 0; k < drives; ++k)
      if (ratio[joint][k] != (k == own ? 1.0 : 0.0)) return false;
    return true;
  }
  /// Whether all that joint i names is there.
  constexpr bool is_there(int i) const { return named[i]; }
  /// Whether every drive moves something of its own, and every joint is moved.
  constexpr bool moves_all() const {
    for (int i = 0; i < N; ++i) {
      bool moved = false;
      for (int k = 0; k < drives; ++k)
        moved = moved || is_moved(i, k);
      if (!moved) return false;
    }
    return independent;
  }
  /// The row of a joint by an earlier one, and what a drive feels by what an earlier drive does.
  ///@{
  constexpr RowStep joint_step(int joint) const {
    return row_step([this](int i, int k) { return ratio[i][k]; }, joint, drives);
  }
  constexpr RowStep drive_step(int drive) const {
    return row_step([this](int k, int i) { return ratio[i][k]; }, drive, N);
  }
  ///@}
  /// The size that all entries of a joint's row share, where there are several, else 1.
  constexpr double common_factor(int joint) const {
    double factor = 0.0;
    int entries = 0;
    for (int k = 0; k < drives; ++k) {
      const double entry = ratio[joint][k] < 0.0 ? -ratio[joint][k] : ratio[joint][k];
      if (entry == 0.0) continue;
      if (++entries > 1 && entry != factor) return 1.0;
      factor = entry;
    }
    return entries > 1 ? factor : 1.0;
  }
  /// The first joint that a drive moves.
  constexpr int first_joint(int drive) const {
    int i = 0;
    while (i + 1 < N && !is_moved(i, drive))
      ++i;
    return i;
  }
  /// Whether a drive moves a joint.
  constexpr bool is_moved(int joint, int drive) const { return ratio[joint][drive] != 0.0; }
};

namespace detail {

/// G with a column for every joint, those of no drive being 0, row by row as links name it.
template <int N>
struct NamedRows {
  const LinkParameters (&links)[N];
  DriveMatrix<N> rows{};
  int state[N] = {};  // 0: not looked at, 1: being looked at, 2: found

  constexpr explicit NamedRows(const LinkParameters (&all)[N]) : links(all) {
    for (int i = 0; i < N; ++i)
      find(i);
  }
  constexpr void find(int i) {
    if (state[i] == 2) return;
    const JointDrives& d = links[i].drives;
    state[i] = 1;
    rows.named[i] = d.count <= JointDrives::most && !(d.follows && d.count > 1);
    for (int n = 0; rows.named[i] && n < d.count; ++n)
      rows.named[i] = d.of[n] >= 0 && d.of[n] < N && (d.follows ? state[d.of[n]] != 1 : !links[d.of[n]].drives.follows);
    if (rows.named[i] && d.follows)
      follow(i, d);
    else if (rows.named[i])
      add(i, d);
    state[i] = 2;
  }
  constexpr void follow(int i, const JointDrives& d) {
    find(d.of[0]);
    for (int k = 0; k < N; ++k)
      rows.ratio[i][k] = d.ratio[0] * rows.ratio[d.of[0]][k];
    rows.offset[i] = d.ratio[0] * rows.offset[d.of[0]] + d.offset;
  }
  constexpr void add(int i, const JointDrives& d) {
    bool names_own = d.complete;
    for (int n = 0; n < d.count; ++n)
      names_own = names_own || d.of[n] == i;
    if (!names_own) rows.ratio[i][i] = 1.0;
    for (int n = 0; n < d.count; ++n)
      rows.ratio[i][d.of[n]] += d.ratio[n];
  }
};

/// Whether G^T G is regular: Gauss elimination of its columns, each scaled to length 1.
template <int N>
constexpr bool is_independent(const DriveMatrix<N>& g) {
  double left[N][N] = {};
  for (int k = 0; k < g.drives; ++k)
    for (int i = 0; i < N; ++i)
      left[k][i] = g.ratio[i][k];
  for (int k = 0; k < g.drives; ++k) {
    double length = 0.0, before = 0.0;
    for (int i = 0; i < N; ++i)
      length += left[k][i] * left[k][i], before += g.ratio[i][k] * g.ratio[i][k];
    if (!(length > 1e-12 * before)) return false;
    for (int l = k + 1; l < g.drives; ++l) {
      double along = 0.0;
      for (int i = 0; i < N; ++i)
        along += left[k][i] * left[l][i];
      for (int i = 0; i < N; ++i)
        left[l][i] -= along / length * left[k][i];
    }
  }
  return true;
}

}  // namespace detail

/// What the links of a chain name: a drive for every joint that moves anything.
template <int N>
constexpr DriveMatrix<N> drive_matrix_of(const LinkParameters (&links)[N]) {
  const DriveMatrix<N> rows = detail::NamedRows<N>(links).rows;
  DriveMatrix<N> g;
  for (int i = 0; i < N; ++i)
    g.offset[i] = rows.offset[i], g.named[i] = rows.named[i];
  for (int k = 0; k < N; ++k) {
    bool moves = false;
    for (int i = 0; i < N; ++i)
      moves = moves || rows.ratio[i][k] != 0.0;
    if (!moves) continue;
    for (int i = 0; i < N; ++i)
      g.ratio[i][g.drives] = rows.ratio[i][k];
    g.owner[g.drives++] = k;
  }
  g.independent = detail::is_independent(g);
  return g;
}

}  // namespace axial

#include <axial/options/end.hpp>

// Joints that share drives as clusters: one joint of several degrees of freedom each.
#pragma once

#include <axial/robot/drive_matrix.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Which joints move together. A cluster hangs on one link: joints on the way between two that share a drive belong to
/// it as well. A joint whose drive is its own, one to one, and that no cluster takes in, is plain.
template <int N>
struct DriveClusters {
  int first[N] = {};            ///< of each joint: the first joint of its cluster
  int parent[N] = {};           ///< of each cluster, by its first joint: the link that it hangs on, or base
  int count = 0;                ///< clusters that are no plain joint
  int number[N] = {};           ///< of each joint: number of its cluster, or -1 for a plain joint
  int drives[N] = {};           ///< of each numbered cluster: how many drives it has
  int drive[N][N] = {};         ///< of each numbered cluster: its drives, in rising order
  int carrier[N] = {};          ///< of each numbered cluster: the link that it hangs on, or base
  int joints_of_drive[N] = {};  ///< how many joints a drive moves
};

namespace detail {

template <int N>
struct ClusterBuilder {
  const int (&parents)[N];
  const DriveMatrix<N>& g;
  DriveClusters<N> found{};

  constexpr ClusterBuilder(const int (&parent_of)[N], const DriveMatrix<N>& matrix) : parents(parent_of), g(matrix) {
    for (int i = 0; i < N; ++i)
      found.first[i] = i;
    for (int k = 0; k < g.drives; ++k)
      for (int i = 0, last = -1; i < N; ++i)
        if (g.is_moved(i, k)) join(i, last < 0 ? i : last), last = i, ++found.joints_of_drive[k];
    while (grows()) {
    }
    number_them();
  }
  constexpr void join(int i, int j) {
    const int a = found.first[i], b = found.first[j], low = a < b ? a : b;
    for (int& first : found.first)
      if (first == a || first == b) first = low;
  }
  /// Takes in the link farthest out on which some but not all of a cluster hangs; false where each hangs on one link.
  constexpr bool grows() {
    for (int c = 0; c < N; ++c) {
      int low = N, high = -2;
      for (int i = 0; i < N; ++i) {
        if (found.first[i] != c) continue;
        const int p = parents[i];
        if (p >= 0 && found.first[p] == c) continue;
        low = p < low ? p : low, high = p > high ? p : high;
      }
      if (high > low) return join(high, c), true;
      found.parent[c] = high;
    }
    return false;
  }
  constexpr void number_them() {
    int number[N] = {};
    for (int i = 0; i < N; ++i) {
      number[i] = found.first[i] == i && is_cluster(i) ? found.count : -1;
      if (number[i] >= 0) found.carrier[found.count++] = found.parent[i];
    }
    for (int i = 0; i < N; ++i)
      found.number[i] = number[found.first[i]];
    for (int k = 0; k < g.drives; ++k)
      if (const int c = found.number[g.first_joint(k)]; c >= 0) found.drive[c][found.drives[c]++] = k;
  }
  /// Whether what begins with a joint is no plain joint.
  constexpr bool is_cluster(int first) const {
    for (int j = first + 1; j < N; ++j)
      if (found.first[j] == first) return true;
    return !g.is_alone(first);
  }
};

}  // namespace detail

/// Clusters from a chain's parents (indices of links, or base) and the drives of its joints.
template <int N>
constexpr DriveClusters<N> drive_clusters(const int (&parents)[N], const DriveMatrix<N>& g) {
  return detail::ClusterBuilder<N>(parents, g).found;
}

}  // namespace axial

#include <axial/options/end.hpp>

// How large M and its inverse can be, joint by joint.
#pragma once

#include <axial/fixed/bounds/mass_matrix.hpp>
#include <axial/fixed/formats/joint_formats.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

template <class S, class Word>
constexpr auto found_joint_mobilities() {
  constexpr int size = joint_count<S>;
  PerJoint<size> all;
  const ForwardErrorAnalysis<size> analysis(mechanism_of<scene_of<S>, FullParameters>, joint_rounding<Word>,
                                            free_ranges_of<S, Word>, motion_ranges_of<S, Word>);
  for (int i = 0; i < size; ++i)
    all.of[i] = analysis.mobility(i);
  return all;
}
/// Square roots of the largest (M^-1)_ii: |(M^-1)_ij| is at most the product of two.
template <class S, class Word>
inline constexpr auto joint_mobilities = found_joint_mobilities<S, Word>();

template <class S, class Word>
constexpr auto found_joint_inertias() {
  constexpr int size = joint_count<S>;
  PerJoint<size> all;
  const auto ranges =
      composite_body_ranges(mechanism_of<scene_of<S>, FullParameters>, joint_rounding<Word>, Wanted::formats);
  for (int i = 0; i < size; ++i)
    all.of[i] = ranges.range[i].joint_inertia.size;
  return all;
}
/// The largest M_ii.
template <class S, class Word>
inline constexpr auto joint_inertias = found_joint_inertias<S, Word>();

/// Sizes of joints that share no drives, as DriveSizes has them of drives.
template <class S, class Word>
struct JointSizes {
  static constexpr double inertia(int i) { return joint_inertias<S, Word>.of[i]; }
  static constexpr double mobility(int i) { return joint_mobilities<S, Word>.of[i]; }
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

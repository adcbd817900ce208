// How large M and its inverse can be; joints that share drives: how far drives move them, and how large what they
// answer can be.
#pragma once

#include <axial/fixed/bounds/dynamics.hpp>
#include <axial/fixed/formats/joint_formats.hpp>
#include <axial/fixed/ranges/drive_mobility.hpp>
#include <axial/transmissions/driven_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A robot's joints as far as its drives take them: a joint's reach is the sum of its row of G over the limits of the
/// drives, and no more than its own limits. A little room is for what its words are off.
template <class R>
struct JointsWithinDrives {
  /// Chain of the tree.
  static constexpr auto chain = [] {
    constexpr double room = 1.0 + 1.0 / 4096.0;
    auto joints = JointCoordinates<R>::chain;
    constexpr auto& g = detail::drive_matrix<R>;
    const auto within = [&](int i, double own, double LinkParameters::*limit) {
      double sum = 0.0;
      for (int k = 0; k < g.drives; ++k) {
        const double most = DriveCoordinates<R>::chain.links[k].*limit;
        if (!g.is_moved(i, k)) continue;
        sum = detail::is_bounded(most) && detail::is_bounded(sum) ? sum + magnitude(g.ratio[i][k]) * most
                                                                  : LinkParameters::unlimited;
      }
      const double least = sum < own ? sum : own;
      return detail::is_bounded(least) ? room * least : least;
    };
    const auto farthest = [&](int i, double sign) {
      double sum = sign * g.offset[i];
      for (int k = 0; k < g.drives; ++k) {
        const double ratio = sign * g.ratio[i][k];
        const auto& drive = DriveCoordinates<R>::chain.links[k];
        const double end = ratio > 0.0 ? drive.position_max : -drive.position_min;
        if (!g.is_moved(i, k)) continue;
        sum = detail::is_bounded(end) && detail::is_bounded(sum) ? sum + magnitude(ratio) * end
                                                                 : LinkParameters::unlimited;
      }
      return sum;
    };
    for (int i = 0; i < joints.size; ++i) {
      LinkParameters& link = joints.links[i];
      link.speed_limit = within(i, link.speed_limit, &LinkParameters::speed_limit);
      link.acceleration_limit = within(i, link.acceleration_limit, &LinkParameters::acceleration_limit);
      if (link.type == JointType::revolute) continue;
      double high = farthest(i, 1.0), low = farthest(i, -1.0);  // the latter downwards
      high = high < link.position_max ? high : link.position_max;
      low = low < -link.position_min ? low : -link.position_min;
      const double more = (room - 1.0) * (magnitude(high) > magnitude(low) ? magnitude(high) : magnitude(low));
      if (!detail::is_bounded(high) || !detail::is_bounded(low)) continue;
      link.position_max = high + more, link.position_min = -low - more;
    }
    return joints;
  }();
};

namespace detail {

/// The scene of a robot's joints in fixed point.
template <class Scene>
struct WithinDrives;
template <class R, class... Features>
struct WithinDrives<Scene<JointCoordinates<R>, Features...>> {
  using type = Scene<JointsWithinDrives<R>, Features...>;
};
template <class S>
using JointsOf = typename WithinDrives<typename SceneOfJoints<scene_of<S>>::type>::type;

/// The least power of two that x does not exceed, none below 1.
constexpr int bits_up_to(double x) {
  int e = 0;
  while (power_of_two(e) < x)
    ++e;
  return e;
}
/// An exponent for each entry of a matrix.
template <int N>
struct EntryExponents {
  int of[N][N] = {};
};
template <int N, class Exponent>
constexpr EntryExponents<N> entry_exponents(const Exponent& exponent) {
  EntryExponents<N> all;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      all.of[i][j] = exponent(i, j);
  return all;
}

/// Square roots of the largest (M^-1)_ii of joints: |(M^-1)_ij| is at most the product of two.
template <class S, class Word>
inline constexpr auto joint_mobilities = [] {
  constexpr int size = joint_count<S>;
  const ForwardErrorAnalysis<size> analysis(mechanism_of<scene_of<S>, FullParameters>, joint_rounding<Word>,
                                            free_ranges_of<S, Word>, motion_ranges_of<S, Word>);
  return per_joint<size>([&](int i) { return analysis.mobility(i); });
}();
/// The largest M_ii of joints.
template <class S, class Word>
inline constexpr auto joint_inertias = [] {
  const auto ranges =
      composite_body_ranges(mechanism_of<scene_of<S>, FullParameters>, joint_rounding<Word>, Wanted::formats);
  return per_joint<joint_count<S>>([&](int i) { return ranges.range[i].joint_inertia.size; });
}();
/// Sizes of joints that share no drives, as DriveSizes has them of drives.
template <class S, class Word>
struct JointSizes : MotionSizes<S, Word> {
  static constexpr double inertia(int i) { return joint_inertias<S, Word>.of[i]; }
  static constexpr double mobility(int i) { return joint_mobilities<S, Word>.of[i]; }
};

/// Square roots of the largest (M^-1)(k, k) of the drives.
template <class S, class Word>
constexpr auto found_mobilities();
template <class S, class Word>
inline constexpr auto drive_mobilities = found_mobilities<S, Word>();

/// Sums of what drives feel of joints, column by column of G, with a rotor and friction of their own.
template <class S, class Word>
struct DriveSizes {
  using Scene = scene_of<S>;
  using Joint = JointsOf<S>;
  static constexpr int joints = Joint::Robot::chain.size;
  static constexpr const auto& g = drive_matrix_of_scene(static_cast<const Scene*>(nullptr));

  static constexpr const LinkParameters& drive(int k) { return Scene::Robot::chain.links[k]; }
  /// The sum of |G| times what each joint has.
  template <class Get>
  static constexpr double actuator_effort(int k, const Get& get) {
    double sum = 0.0;
    for (int i = 0; i < joints; ++i)
      if (g.is_moved(i, k)) sum += magnitude(g.ratio[i][k]) * get(i);
    return sum;
  }
  /// Rotor inertia on drive k, kg m^2, where the scene names RotorInertia.
  static constexpr double rotor(int k) {
    return Scene::template has<RotorInertia> ? drive(k).gear * drive(k).gear * drive(k).rotor_inertia : 0.0;
  }
  /// Viscous and Coulomb friction of drive k, N m s/rad and N m, where the scene names Friction.
  ///@{
  static constexpr double viscous(int k) { return Scene::template has<Friction> ? drive(k).viscous : 0.0; }
  static constexpr double coulomb(int k) {
    const double forward = magnitude(drive(k).coulomb_forward), backward = magnitude(drive(k).coulomb_backward);
    return Scene::template has<Friction> ? (forward > backward ? forward : backward) : 0.0;
  }
  ///@}
  static constexpr double friction(int k) { return viscous(k) * drive(k).speed_limit + coulomb(k); }

  static constexpr double joint_effort(int i) { return motion_ranges_of<Joint, Word>.range[i].joint_effort.size; }
  static constexpr double joint_momentum(int i) { return momentum_ranges_of<Joint, Word>.range[i].joint_effort.size; }
  static constexpr double joint_rate(int i) { return momentum_ranges_of<Joint, Word>.slope[i].size + joint_effort(i); }
  /// Effort, momentum and its rate at drive k, at most: N m or N per unit of the drive, and so on.
  ///@{
  static constexpr double effort(int k) {
    return actuator_effort(k, joint_effort) + rotor(k) * drive(k).acceleration_limit + friction(k);
  }
  static constexpr double momentum(int k) {
    return actuator_effort(k, joint_momentum) + rotor(k) * drive(k).speed_limit;
  }
  static constexpr double momentum_rate(int k) { return actuator_effort(k, joint_rate) + friction(k); }
  ///@}
  /// Size of M(k, k): |M_ij| <= sqrt(M_ii M_jj).
  static constexpr double inertia(int k) {
    const double root = actuator_effort(k, [](int i) { return square_root(joint_inertias<Joint, Word>.of[i]); });
    return root * root + rotor(k);
  }
  /// Square root of the largest (M^-1)(k, k).
  static constexpr double mobility(int k) { return drive_mobilities<S, Word>.of[k]; }
  /// What a drive has left to accelerate with, at most: its declared effort, or what motions take, and the bias.
  static constexpr double drive_left(int k) {
    return effort(k) + (is_bounded(drive(k).effort_limit) ? drive(k).effort_limit : effort(k));
  }
  /// sqrt(udd^T M udd) = sqrt(b^T M^-1 b) under those, at most.
  static constexpr double energy() {
    double sum = 0.0;
    for (int k = 0; k < g.drives; ++k)
      sum += mobility(k) * drive_left(k);
    return sum;
  }
};

template <class S, class Word>
constexpr auto found_mobilities() {
  using Sizes = DriveSizes<S, Word>;
  using Joint = typename Sizes::Joint;
  constexpr const auto& motion = motion_ranges_of<Joint, Word>;
  const DriveMobility<Sizes::joints> found(
      mechanism_of<Joint, FullParameters>, Sizes::g, [](int i) { return motion.range[i].turns_across; },
      [](int k) { return Sizes::rotor(k); });
  return per_joint<joint_count<S>>([&found](int k) { return found.of(k); });
}
/// Sizes of what drives answer, or joints where each has its own.
template <class S, class Word>
using SizesOf =
    std::conditional_t<shares_drives_in<typename scene_of<S>::Robot>, DriveSizes<S, Word>, JointSizes<S, Word>>;

}  // namespace detail

/// Bits that columns of a Jacobian by drives need beyond those by joints: of the largest sum of a column of |G|.
template <class S>
inline constexpr int column_headroom = [] {
  if constexpr (detail::shares_drives_in<typename scene_of<S>::Robot>) {
    using Sizes = detail::DriveSizes<S, std::int32_t>;
    double most = 1.0;
    for (int k = 0; k < joint_count<S>; ++k) {
      const double sum = Sizes::actuator_effort(k, [](int) { return 1.0; });
      most = sum > most ? sum : most;
    }
    return detail::bits_up_to(most);
  } else {
    return 0;
  }
}();

}  // namespace axial

#include <axial/options/end.hpp>

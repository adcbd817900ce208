// How stiff springs, dampers and drives are for what they move, where joints share drives.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/simulation/eigenvalue_bound.hpp>
#include <axial/simulation/stiff_links.hpp>
#include <axial/transmissions/roles.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Bounds of the largest eigenvalues of M^-1 K (1/s^2) and M^-1 D (1/s).
template <class T>
struct StiffBounds {
  T stiffness{}, damping{};
};

/// M_u(u)^-1 of drives that joints share.
template <class T, int N, class Links, class Input, class Q>
constexpr Square<T, N> drive_mobility(const Links& links, const Input& in, const Q& u) {
  Square<T, N> a{};
  typename DrivenKernels<Links>::Matrix whole{};
  execute<crba::CompositeMatrix>(links, in, u, whole);
  for (int j = 0; j < links.drives().size(); ++j) {
    auto m = whole;  // solved in place
    Accelerations<robot_of<typename Links::Scene>, T> column{};
    column[j] = T(1);
    (void)crba::solve(links.drives(), m, column);
    for (int i = 0; i < links.drives().size(); ++i)
      a.values[i][j] = column[i];
  }
  return a;
}

/// w^1/2 A w^1/2 of the diagonal w.
template <class T, int N>
constexpr Square<T, N> weighted(Square<T, N> a, const T (&weight)[N]) {
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      a.values[i][j] *= square_root(weight[i]) * square_root(weight[j]);
  return a;
}

template <class S, class T>
struct StiffnessAt;

}  // namespace detail

/// Bounds where joints share drives: springs K are the joints', M_u^-1 G^T K G having the eigenvalues of K^1/2 G M_u^-1
/// G^T K^1/2; what drives them and dampers are the drives' own. Bounds of both kinds of stiffness are added.
template <class S, class T, class Links>
struct Execution<detail::StiffnessAt<S, T>, Links, IfDriven<Links>> {
  /// bounds at u
  template <class Q, class Stiffness>
  [[nodiscard]] static constexpr detail::StiffBounds<T> run(const Links& links, const Q& u, const Inputs<S, T>& in,
                                                            const Stiffness& drive) {
    constexpr int n = Links::JointValues::size, m = joint_count<S>;
    const auto joints = links.joints();
    const auto mobility = detail::drive_mobility<T, m>(links, in, u);
    T springs[n] = {}, dampers[m] = {}, drives[m] = {};
    for_each_link(joints, [&](auto i) AXIAL_INLINE { springs[i] = T(spring_slope(joints.link(i))); });
    links.each_drive([&](auto k) AXIAL_INLINE {
      drives[k] = T(drive.stiffness[k]);
      dampers[k] = T(detail::friction_damping(links.drives().link(k), T(0)) + drive.damping[k]);
    });
    Velocities<robot_of<S>, T> moved[n] = {};  // rows of G M_u^-1
    for (int k = 0; k < links.drives().size(); ++k) {
      Velocities<robot_of<S>, T> column{};
      for (int l = 0; l < links.drives().size(); ++l)
        column[l] = mobility.values[l][k];
      const auto rates = links.rates(column);
      for (int i = 0; i < joints.size(); ++i)
        moved[i][k] = rates[i];
    }
    detail::Square<T, n> of_joints{};
    for (int i = 0; i < joints.size(); ++i) {
      const auto row = links.rates(moved[i]);
      for (int j = 0; j < joints.size(); ++j)
        of_joints.values[i][j] = row[j];
    }
    return {detail::largest_eigenvalue_bound(detail::weighted(of_joints, springs), joints.size()) +
                detail::largest_eigenvalue_bound(detail::weighted(mobility, drives), links.drives().size()),
            detail::largest_eigenvalue_bound(detail::weighted(mobility, dampers), links.drives().size())};
  }
};

}  // namespace axial

#include <axial/options/end.hpp>

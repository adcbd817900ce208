// Derivatives of efforts in values of drives that joints share: G^T D G of the joints' matrices, and what drives add.
#pragma once

#include <axial/derivatives/inverse_dynamics_derivatives.hpp>
#include <axial/transmissions/roles.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace driven {

/// The joints as derivatives walk over them.
template <class Links>
using DerivedJoints = std::decay_t<decltype(std::declval<const Links&>().template joints<recursion::Derivatives>())>;

/// Which entries of a Jacobian of the joints, by positions or velocities, a Jacobian of the drives takes: those that
/// are not zero, between joints that the drives move. The compiler sums them up in two steps, (D G) and G^T (D G).
template <class Links, class By>
struct SlopeShares {
  using T = typename Links::Scalar;                ///< the number
  static constexpr const auto& g = Links::matrix;  ///< G
  static constexpr int n = Links::size;            ///< number of joints
  using Half = Row<Row<T, Links::capacity>, n>;    ///< D G
  /// Whether D(i, j) is there.
  static constexpr bool is_present(int i, int j) {
    if constexpr (DerivedJoints<Links>::unrolled)
      return derivatives::jacobian_structure<DerivedJoints<Links>>.of(By{})[i][j];
    else
      return true;
  }
  /// Whether (D G)(i, l) is there.
  static constexpr bool has_half(int i, int l) {
    bool there = false;
    for (int j = 0; j < n; ++j)
      there = there || (is_present(i, j) && g.is_moved(j, l));
    return there;
  }
  /// Whether (G^T D G)(k, l) is there.
  static constexpr bool has(int k, int l) {
    bool there = false;
    for (int i = 0; i < n; ++i)
      there = there || (g.is_moved(i, k) && has_half(i, l));
    return there;
  }
  /// (D G)(I, L).
  template <int I, int L, class D>
  AXIAL_INLINE static constexpr auto half(const D& d) {
    return sum_of<n>([&](auto j) AXIAL_INLINE {
      constexpr int J = decltype(j)::value;
      if constexpr (is_present(I, J) && g.is_moved(J, L))
        return literal<T>([] { return g.ratio[J][L]; }) * d(I, J);
      else
        return Zero{};
    });
  }
  /// (G^T D G)(K, L) as one sum, from joints I and J on, where a number system with formats rounds it once.
  template <int K, int L, int I = 0, int J = 0, class D>
  AXIAL_INLINE static constexpr auto at_once(const D& d) {
    if constexpr (I == n)
      return Zero{};
    else if constexpr (J == n || !g.is_moved(I, K))
      return at_once<K, L, I + 1>(d);
    else if constexpr (is_present(I, J) && g.is_moved(J, L))
      return Links::add(literal<T>([] { return g.ratio[I][K] * g.ratio[J][L]; }) * Links::template entry<I, J>(d),
                        at_once<K, L, I, J + 1>(d));
    else
      return at_once<K, L, I, J + 1>(d);
  }
  /// (G^T D G)(K, L).
  template <int K, int L>
  AXIAL_INLINE static constexpr auto whole(const Half& dg) {
    return sum_of<n>([&](auto i) AXIAL_INLINE {
      constexpr int I = decltype(i)::value;
      if constexpr (g.is_moved(I, K) && has_half(I, L))
        return literal<T>([] { return g.ratio[I][K]; }) * dg[I][L];
      else
        return Zero{};
    });
  }
};

/// A row of a matrix as values of joints.
template <class D>
struct MatrixRow {
  const D& matrix;  ///< referred to
  int row = 0;      ///< which one
  /// Its entry for joint j.
  AXIAL_INLINE constexpr const auto& operator[](int j) const { return matrix(row, j); }
};

/// Whether sums over joints wait for their one rounding.
template <class Links>
inline constexpr bool rounds_once = Links::unrolled && !is_number_v<typename Links::Value>;

/// Calls out(k, l, entry) for every entry of G^T D G, D a Jacobian of the joints.
template <class By, class Links, class D, class Out>
AXIAL_INLINE constexpr void reduce_slopes(const Links& links, const D& d, const Out& out) {
  if constexpr (rounds_once<Links>) {
    links.each_drive([&](auto k) AXIAL_INLINE {
      links.each_drive([&](auto l) AXIAL_INLINE {
        out(k, l, SlopeShares<Links, By>::template at_once<decltype(k)::value, decltype(l)::value>(d));
      });
    });
  } else if constexpr (Links::unrolled) {
    using Shares = SlopeShares<Links, By>;
    typename Shares::Half half{};
    links.each_joint([&](auto i) AXIAL_INLINE {
      links.each_drive([&](auto l) AXIAL_INLINE {
        constexpr int row = decltype(i)::value, column = decltype(l)::value;
        if constexpr (Shares::has_half(row, column))
          half[row][column] = static_cast<typename Shares::T>(Shares::template half<row, column>(d));
      });
    });
    links.each_drive([&](auto k) AXIAL_INLINE {
      links.each_drive([&](auto l) AXIAL_INLINE {
        out(k, l, Shares::template whole<decltype(k)::value, decltype(l)::value>(half));
      });
    });
  } else {
    for (int l = 0; l < links.size(); ++l) {
      typename Links::JointValues column{};  // D G
      for (int i = 0; i < links.joint_count(); ++i)
        column[i] = links.actuator_effort(l, MatrixRow<D>{d, i});
      for (int k = 0; k < links.size(); ++k)
        out(k, l, links.actuator_effort(k, column));
    }
  }
}
/// Writes G^T D G into a Jacobian of the drives; what their own friction adds stands on the diagonal.
///@{
template <class Links, class D, class V, class Matrix>
AXIAL_INLINE constexpr void write_slopes(by::Position by, const Links& links, const D& d, const V&, Matrix& matrix) {
  reduce_slopes<decltype(by)>(
      links, d, [&](auto k, auto l, const auto& x) AXIAL_INLINE { derivatives::write_entry(matrix, k, l, x); });
}
template <class Links, class D, class V, class Matrix>
AXIAL_INLINE constexpr void write_slopes(by::Velocity by, const Links& links, const D& d, const V& ud, Matrix& matrix) {
  if constexpr (rounds_once<Links>) {
    reduce_slopes<decltype(by)>(links, d, [&](auto k, auto l, const auto& x) AXIAL_INLINE {
      if constexpr (decltype(k)::value == decltype(l)::value)
        derivatives::write_entry(matrix, k, l, Links::add(x, friction_slope(links.drives().link(k), ud[k])));
      else
        derivatives::write_entry(matrix, k, l, x);
    });
  } else {
    reduce_slopes<decltype(by)>(
        links, d, [&](auto k, auto l, const auto& x) AXIAL_INLINE { derivatives::write_entry(matrix, k, l, x); });
    links.each_drive(
        [&](auto k) AXIAL_INLINE { matrix.set(k, k, matrix(k, k) + friction_slope(links.drives().link(k), ud[k])); });
  }
}
///@}

/// What is asked of the joints where `Wanted` are asked of the drives.
template <class JointScene, class S, class T, class... Wanted>
WantedResults<JointScene, T, Wanted...> as_of_joints(const WantedResults<S, T, Wanted...>*);
/// Results of the joints from which those of the drives follow.
template <class Links, class Result>
using JointResults = decltype(as_of_joints<typename Links::JointScene>(static_cast<const Result*>(nullptr)));

/// The joints' results, by the algorithm itself. Zeros between branches stay unwritten where the compiler knows them.
template <class Result, class Joint, class Input, class Q, class Screws, class V, class A>
AXIAL_INLINE constexpr Result results_of_joints(const Joint& joints, const Input& in, const Q& q, const Screws& screws,
                                                const V& qd, const A& qdd) {
  auto result = derivatives::blank<Joint, Result>();
  derivatives::Entries<Joint, Result> out{result};
  derivatives::entries(joints, in, q, screws, qd, qdd, out);
  return result;
}

}  // namespace driven

namespace derivatives {
/// Structure of the Jacobians of drives: what the joints' structure and G make of it, and friction.
template <class Links>
constexpr auto driven_jacobian_structure() {
  JacobianStructure<Links::capacity> structure;
  for (int k = 0; k < Links::capacity; ++k)
    for (int l = 0; l < Links::capacity; ++l) {
      structure.by_position[k][l] = driven::SlopeShares<Links, by::Position>::has(k, l);
      structure.by_velocity[k][l] =
          driven::SlopeShares<Links, by::Velocity>::has(k, l) || (k == l && Links::Scene::template has<Friction>);
    }
  return structure;
}
}  // namespace derivatives

/// Efforts of the drives with their derivatives by values of the drives.
template <class Result, class Links>
struct Execution<derivatives::Slopes<Result>, Links, IfDriven<Links>> {
  /// all results
  template <class Input, class U, class V, class A>
  AXIAL_INLINE static constexpr Result run(const Links& links, const Input& in, const U& u, const V& ud, const A& udd) {
    using Joint = driven::JointResults<Links, Result>;
    const auto& joints = links.template joints<recursion::Derivatives>();
    const auto q = links.positions(u);
    const auto qd = links.rates(ud);
    const auto qdd = links.rates(udd);
    const auto at_q = joints.read(q);
    const Joint at = driven::results_of_joints<Joint>(joints, in, at_q, joint_screws(joints, in, at_q), joints.read(qd),
                                                      joints.read(qdd));
    const auto speeds = links.read_drives(ud);
    Result result{};
    if constexpr (Result::template has<with_efforts>) {
      const auto actuator_effort = links.actuator_efforts(at.tau);
      const auto accelerations = links.read_drives(udd);
      links.each_drive([&](auto k) AXIAL_INLINE {
        const auto drive = links.drives().link(k);
        links.answer(result.tau, k, actuator_effort, friction_effort(drive, speeds[k]),
                     drive.rotor() * accelerations[k]);
      });
    }
    if constexpr (Result::template has<with_mass_matrix>) DrivenKernels<Links>::reduce(links, at.M, result.M);
    if constexpr (Result::template has<with_position_jacobian>)
      driven::write_slopes(by::Position{}, links, at.dtau_dq, speeds, result.dtau_dq);
    if constexpr (Result::template has<with_velocity_jacobian>)
      driven::write_slopes(by::Velocity{}, links, at.dtau_dqd, speeds, result.dtau_dqd);
    return result;
  }
};

}  // namespace axial

#include <axial/options/end.hpp>

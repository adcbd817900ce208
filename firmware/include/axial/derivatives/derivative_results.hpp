// What derivatives of the dynamics are handed back in.
#pragma once

#include <axial/dynamics/mass_matrix.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// By what efforts or accelerations are derived.
namespace by {
struct Position {};  ///< q
struct Velocity {};  ///< qd
}  // namespace by

/// N x N matrix with an entry for each pair of joints, row by row: (i, j) is the derivative of joint i's by joint j's.
template <class S, class T, class By>
struct JointMatrix {
  static constexpr int size = joint_count<S>;  ///< number of joints
  T values[size * size];                       ///< row by row; zero where the matrix is initialised by {}

  AXIAL_INLINE constexpr T& operator()(int i, int j) { return values[i * size + j]; }  ///< entry (i, j)
  /// Entry (i, j).
  AXIAL_INLINE constexpr const T& operator()(int i, int j) const { return values[i * size + j]; }
  /// Sets entry (i, j); structural zeros become numbers.
  template <class V>
  AXIAL_INLINE constexpr void set(int i, int j, const V& value) {
    values[i * size + j] = static_cast<T>(value);
  }
};

/// Matrix of a scene's joints.
template <class S, class T, class By>
using JointMatrixOf = JointMatrix<subject_of<S, T>, T, By>;

/// Results that are wanted: a member for each.
template <class S, class T, class... Wanted>
struct WantedResults : Wanted::template Result<S, T>... {
  /// Whether it was asked for.
  template <class What>
  static constexpr bool has = (std::is_same_v<What, Wanted> || ...);
};

/// What inverse_dynamics_derivatives() may be asked for.
///@{
struct with_efforts {
  /// Member that this tag adds to the results.
  template <class S, class T>
  struct Result {
    EffortsOf<S, T> tau{};  ///< N m or N
  };
};
struct with_mass_matrix {
  /// Member that this tag adds to the results.
  template <class S, class T>
  struct Result {
    MassMatrixOf<S, T> M;  ///< d tau / d qdd, with rotors as the scene names them
  };
};
struct with_position_jacobian {
  /// Member that this tag adds to the results.
  template <class S, class T>
  struct Result {
    JointMatrixOf<S, T, by::Position> dtau_dq;  ///< (i, j) = d tau_i / d q_j: N m/rad, N m/m, N/rad or N/m
  };
};
struct with_velocity_jacobian {
  /// Member that this tag adds to the results.
  template <class S, class T>
  struct Result {
    JointMatrixOf<S, T, by::Velocity> dtau_dqd;  ///< (i, j) = d tau_i / d qd_j: N m s/rad and so on
  };
};
///@}

/// Stands where something else would be asked for: no member.
template <int>
struct NotWanted {
  /// Nothing.
  template <class S, class T>
  struct Result {};
};

/// Efforts and their derivatives: a member for each that is wanted, of all four unless some are named.
template <class S, class T, class... Wanted>
struct InverseDynamicsDerivatives : WantedResults<S, T, Wanted...> {};
/// Efforts and all of their derivatives.
template <class S, class T>
struct InverseDynamicsDerivatives<S, T>
    : WantedResults<S, T, with_efforts, with_mass_matrix, with_position_jacobian, with_velocity_jacobian> {};

namespace derivatives {

/// Results without numbers in their matrices.
template <class Result>
AXIAL_INLINE inline Result unwritten() {
  Result result;
  return result;
}
/// What the algorithm over `Links` starts with. Unrolled, it writes every entry, those of zero too: zeros beforehand
/// would be written twice, and only constant expressions ask for them. A loop does not write pairs of
/// two branches.
template <class Links, class Result>
AXIAL_INLINE constexpr Result blank() {
  if constexpr (Links::unrolled)
    if (!__builtin_is_constant_evaluated()) return unwritten<Result>();
  return Result{};
}
/// Whether joint j is link i's own or one that carries it; j before i.
template <class Links>
constexpr bool is_carried_by(int i, int j) {
  while (i > j)
    i = Links::parent_index(i);
  return i == j;
}
/// Hands zeros of pairs of joints on two branches to `out`, where the compiler knows the branches.
template <class Links, class Out>
AXIAL_INLINE constexpr void write_between_branches(const Links& links, Out& out) {
  if constexpr (Links::unrolled)
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      for_each_link(links, [&](auto j) AXIAL_INLINE {
        constexpr int row = decltype(i)::value, column = decltype(j)::value;
        if constexpr (column < row && !is_carried_by<Links>(row, column)) {
          out.mass(i, j, Zero{});
          out.position(i, j, Zero{});
          out.position(j, i, Zero{});
          out.velocity(i, j, Zero{});
          out.velocity(j, i, Zero{});
        }
      });
    });
}
/// Writes an entry; what is zero by type becomes a number.
template <class Matrix, class I, class J, class X>
AXIAL_INLINE constexpr void write_entry(Matrix& matrix, I i, J j, const X& x) {
  if constexpr (is_zero_v<X>)
    matrix(i, j) = {};
  else
    matrix.set(i, j, x);
}

/// Where the algorithm over `Links` writes entries: into what was asked for.
template <class Links, class Result>
struct Entries {
  Result& result;  ///< referred to

  /// tau_i, N m or N
  template <class I, class X>
  AXIAL_INLINE constexpr void effort(I i, const X& x) {
    if constexpr (Result::template has<with_efforts>) Links::write(result.tau, i, x);
  }
  /// M(i, j)
  template <class I, class J, class X>
  AXIAL_INLINE constexpr void mass(I i, J j, const X& x) {
    if constexpr (Result::template has<with_mass_matrix>) write_entry(result.M, i, j, x);
  }
  /// d tau_i / d q_j
  template <class I, class J, class X>
  AXIAL_INLINE constexpr void position(I i, J j, const X& x) {
    if constexpr (Result::template has<with_position_jacobian>) write_entry(result.dtau_dq, i, j, x);
  }
  /// d tau_i / d qd_j
  template <class I, class J, class X>
  AXIAL_INLINE constexpr void velocity(I i, J j, const X& x) {
    if constexpr (Result::template has<with_velocity_jacobian>) write_entry(result.dtau_dqd, i, j, x);
  }
};

}  // namespace derivatives
namespace detail {

// Scenes and numbers that derivatives are offered for.
template <class Scene, class T>
constexpr void check_derivable() {
  static_assert(!Scene::template has<Underwater>, "axial: derivatives have no water; take Underwater out of the scene");
  static_assert(
      !Scene::template has<RotorDynamics>,
      "axial: derivatives have no rotors as bodies but inverse_dynamics_along(); take RotorDynamics out of the "
      "scene");
}

// Scenes that derivatives of forward dynamics, which solves, are offered for.
template <class Scene, class T>
constexpr void check_forward_derivable() {
  static_assert(!Scene::template has<FloatingBase>,
                "axial: derivatives of forward dynamics know no free base; where its motion is known, name BaseMotion "
                "instead of FloatingBase");
  static_assert(is_number_v<T> || !shares_drives_in<typename Scene::Robot>,
                "axial: derivatives of forward dynamics of joints that share drives have no formats in fixed point; "
                "take inverse_dynamics_derivatives and mass_matrix there, or compute them in float");
  check_derivable<Scene, T>();
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

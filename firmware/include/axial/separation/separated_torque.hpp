// Torque from dynamics with its terms apart: separated once at q, for many velocities and accelerations. Coefficients
// that vanish, as the compiler finds by running the kernel once, are passed over.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scene/joints.hpp>
#include <axial/separation/separation.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace separation {

/// Which coefficients of a scene are not zero for every q, and what notes them.
///@{
template <class S>
using Present = Separated<S, bool>;
template <class S>
using PresentTerms = const Collected<S, bool, double, Present<S>>;
///@}

/// Coefficients of drives that joints share: what the joints' and G make of them.
template <class S>
constexpr auto driven_present_terms();
/// Found by types alone, so at any q: the compiler runs the algorithm once over zeros.
template <class S>
constexpr auto present_terms() {
  if constexpr (detail::shares_drives_in<typename scene_of<S>::Robot>) {
    return driven_present_terms<S>();
  } else {
    constexpr auto links = links_of<S, double, BaseParameters>();
    Present<S> found{};
    PresentTerms<S> terms{found};
    run(links, Inputs<S, double>{}, Joints<robot_of<S>, double>{},
        map_links(links, [&](auto i) { return links.link(i).z(0.0); }), terms);
    return found;
  }
}
/// Coefficients of a scene that are not zero for every q.
template <class S>
inline constexpr auto present = present_terms<S>();

/// A run-time model and a looped scene have tables: there nothing is known of single coefficients.
template <class S>
inline constexpr bool is_table = IsModel<S>::value || scene_of<S>::template has<Looped>;

/// Whether a coefficient of qdd_j may differ from zero. I, J: Index<...>, or int in a loop.
template <class S, class I, class J>
constexpr bool has_inertia() {
  if constexpr (is_table<S>)
    return true;
  else
    return present<S>.A[I::value][J::value];
}
/// Whether a coefficient of qd_j qd_k, or of qd_j^2, may differ from zero.
template <class S, class I, class J, class K = J>
constexpr bool has_product() {
  if constexpr (is_table<S>)
    return true;
  else if constexpr (std::is_same_v<J, K>)
    return present<S>.C[I::value][J::value];
  else
    return present<S>.B[I::value][Present<S>::pair(J::value, K::value)];
}

template <int First, class F, int... I>
AXIAL_INLINE constexpr void each_index(const F& f, std::integer_sequence<int, I...>) {
  (f(Index<First + I>{}), ...);
}  ///< f(Index) of First and those that follow it
/// f(i) for every joint from joint `first` on.
template <class S, class First, class F>
AXIAL_INLINE constexpr void for_each_joint(First first, const F& f) {
  if constexpr (is_table<S>) {
    for (int i = first; i < joint_count<S>; ++i)
      f(i);
  } else {
    each_index<First::value>(f, std::make_integer_sequence<int, joint_count<S> - First::value>{});
  }
}
template <class S, class F>
AXIAL_INLINE constexpr void for_each_joint(const F& f) {
  for_each_joint<S>(Index<0>{}, f);
}  ///< all of them
/// f(j, k) for every pair of joints, j < k.
template <class S, class F>
AXIAL_INLINE constexpr void for_each_pair(const F& f) {
  for_each_joint<S>([&](auto j) AXIAL_INLINE {
    if constexpr (is_table<S>)
      for_each_joint<S>(j + 1, [&](auto k) AXIAL_INLINE { f(j, k); });
    else
      for_each_joint<S>(Index<decltype(j)::value + 1>{}, [&](auto k) AXIAL_INLINE { f(j, k); });
  });
}

/// Products of two rates, each once.
template <class S, class T>
struct RateProducts {
  T pairs[SeparatedB<S, T>::pairs] = {};  ///< rad^2/s^2 or the like, in the order of SeparatedB
  T squares[joint_count<S>] = {};         ///< one per joint

  AXIAL_INLINE constexpr explicit RateProducts(const Velocities<robot_of<S>, T>& qd) {
    for_each_joint<S>([&](auto j) AXIAL_INLINE { squares[j] = qd[j] * qd[j]; });
    for_each_pair<S>([&](auto j, auto k) AXIAL_INLINE { pairs[SeparatedB<S, T>::pair(j, k)] = qd[j] * qd[k]; });
  }  ///< of velocities in rad/s or m/s
};

template <class S, class T, class I>
AXIAL_INLINE constexpr void add_inertial(const SeparatedA<S, T>& s, const Accelerations<robot_of<S>, T>& qdd, I i,
                                         T& sum) {
  for_each_joint<S>([&](auto j) AXIAL_INLINE {
    if constexpr (has_inertia<S, I, decltype(j)>()) sum = sum + s.A[i][j] * qdd[j];
  });
}  ///< adds joint i's row of A qdd
template <class S, class T, class I>
AXIAL_INLINE constexpr void add_products(const Separated<S, T>& s, const RateProducts<S, T>& rates, I i, T& sum) {
  for_each_joint<S>([&](auto j) AXIAL_INLINE {
    if constexpr (has_product<S, I, decltype(j)>()) sum = sum + s.C[i][j] * rates.squares[j];
  });
  for_each_pair<S>([&](auto j, auto k) AXIAL_INLINE {
    constexpr auto pair = &SeparatedB<S, T>::pair;
    if constexpr (has_product<S, I, decltype(j), decltype(k)>())
      sum = sum + s.B[i][pair(j, k)] * rates.pairs[pair(j, k)];
  });
}  ///< adds joint i's rows of B [qd qd] and C [qd^2]

/// How efforts are made of separated terms; a number system with formats has its own way.
template <class S, class T>
struct TorqueOf {
  /// Efforts, friction included where the scene names it.
  template <class Links>
  AXIAL_INLINE static constexpr EffortsOf<S, T> from(const Links& links, const Separated<S, T>& s,
                                                     const Velocities<robot_of<S>, T>& qd,
                                                     const Accelerations<robot_of<S>, T>& qdd) {
    const RateProducts<S, T> rates(qd);
    EffortsOf<S, T> tau{};
    const auto& actuators = execute<Actuators>(links);
    for_each_link(actuators, [&](auto i) AXIAL_INLINE {
      T sum = s.G[i];
      add_inertial(s, qdd, i, sum);
      add_products(s, rates, i, sum);
      tau[i] = static_cast<T>(sum + friction_effort(actuators.link(i), qd[i]));
    });
    return tau;
  }
};

}  // namespace separation

/// Joint efforts A qdd + B [qd qd] + C [qd^2] + G [+ friction] from terms that separate() found: `inverse_dynamics<S>`
/// at the same q, to rounding. Coefficients that vanish for every q are passed over. In: qd (rad/s or m/s), qdd. Out: N
/// m or N.
template <class S, class T>
[[nodiscard]] constexpr EffortsOf<S, T> torque(const Separated<S, T>& separated, const Velocities<robot_of<S>, T>& qd,
                                               const Accelerations<robot_of<S>, T>& qdd) {
  return separation::TorqueOf<S, T>::from(links_of<S, T, BaseParameters, recursion::Separation>(), separated, qd, qdd);
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Efforts<M, T> torque(const Model<N, F...>& model, const Separated<M, T>& separated,
                                             const Velocities<M, T>& qd, const Accelerations<M, T>& qdd) {
  return separation::TorqueOf<M, T>::from(model.template links<T>(), separated, qd, qdd);
}

}  // namespace axial

#include <axial/options/end.hpp>

// Torque from separated terms in fixed point.
#pragma once

#include <axial/dynamics/separated_torque.hpp>
#include <axial/fixed/dynamics/drives.hpp>
#include <axial/fixed/links/separated_terms.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace separation {

/// Products of two rates in fixed point, in the format of their limits.
template <class Robot, class A>
struct FixedRates {
  /// qd_j qd_k, rounded once.
  template <int J, int K, class Values>
  AXIAL_INLINE static constexpr auto product(const Values& qd) {
    constexpr Rounding rounding = rounding_of<A>();
    constexpr int format = rounding.exponent(Robot::chain.links[J].speed_limit * Robot::chain.links[K].speed_limit);
    return round_to<format>(Fx<Values::exponent(J), A>{qd.values[J].raw} *
                            Fx<Values::exponent(K), A>{qd.values[K].raw});
  }
};

/// The terms of one joint in fixed point, each with its format: one exact sum, rounded once into the effort.
template <class Links, class S, class Word>
struct FixedTerms {
  using A = typename Links::Scalar;            ///< arithmetic
  using T = Stored<Word>;                      ///< stored word
  using Format = SeparatedExponents<S, T>;     ///< of the coefficients
  using Rates = FixedRates<robot_of<S>, A>;    ///< products of rates
  static constexpr int size = joint_count<S>;  ///< number of joints
  const Separated<S, T>& s;                    ///< coefficients
  const Velocities<robot_of<S>, T>& qd;        ///< at the exponents of their role
  const Accelerations<robot_of<S>, T>& qdd;    ///< at the exponents of their role

  /// A(i, j) qdd_j, not rounded yet.
  template <int I, int J>
  AXIAL_INLINE constexpr auto inertial() const {
    if constexpr (has_inertia<S, Index<I>, Index<J>>())
      return Fx<Format::inertia(I, J), A>{s.A[I][J].raw} * Links::read(qdd)[Index<J>{}];
    else
      return Zero{};
  }
  /// C(i, j) qd_j^2, likewise.
  template <int I, int J>
  AXIAL_INLINE constexpr auto square() const {
    if constexpr (has_square<S, Index<I>, Index<J>>())
      return Fx<Format::square(I, J), A>{s.C[I][J].raw} * Rates::template product<J, J>(qd);
    else
      return Zero{};
  }
  /// B(i; j k) qd_j qd_k, likewise; of each pair once, j < k.
  template <int I, int J, int K>
  AXIAL_INLINE constexpr auto product() const {
    if constexpr (J >= K)
      return Zero{};
    else if constexpr (!has_product<S, Index<I>, Index<J>, Index<K>>())
      return Zero{};
    else
      return Fx<Format::product(I, J, K), A>{s.B[I][Separated<S, T>::pair(J, K)].raw} *
             Rates::template product<J, K>(qd);
  }
  /// All terms of joint i as a lazy sum.
  template <int I, int... J>
  AXIAL_INLINE constexpr auto effort(std::integer_sequence<int, J...> all) const {
    return detail::lazy_sum(Fx<Format::rest(I), A>{s.G[I].raw}, inertial<I, J>()..., square<I, J>()...,
                            products<I, J>(all)...);
  }

 private:
  template <int I, int J, int... K>
  AXIAL_INLINE constexpr auto products(std::integer_sequence<int, K...>) const {
    return detail::lazy_sum(product<I, J, K>()...);
  }
};

/// Efforts in fixed point, friction included where the scene names it.
template <class S, class Word>
struct TorqueOf<S, Stored<Word>> {
  using T = Stored<Word>;  ///< stored word
  /// Efforts, each of one exact sum.
  template <class Links>
  AXIAL_INLINE static constexpr EffortsOf<S, T> from(const Links& links, const Separated<S, T>& s,
                                                     const Velocities<robot_of<S>, T>& qd,
                                                     const Accelerations<robot_of<S>, T>& qdd) {
    const FixedTerms<Links, S, Word> terms{s, qd, qdd};
    EffortsOf<S, T> tau{};
    auto speed = links.read(qd);
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      auto sum = terms.template effort<i>(std::make_integer_sequence<int, joint_count<S>>{});
      links.write(tau, i, detail::lazy_sum(sum, friction_effort(links.link(i), speed[i])));
    });
    return tau;
  }
};

}  // namespace separation
}  // namespace axial

#include <axial/options/end.hpp>

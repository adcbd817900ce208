// Torque from separated terms in fixed point.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/links/separated_terms.hpp>
#include <axial/fixed/recursion/steps.hpp>
#include <axial/separation/separated_torque.hpp>

#include <axial/options/begin.hpp>

namespace axial::separation {

/// How the torque's words stand: coefficients at their exponents, products of two rates in the format of their limits.
template <class Robot, class A>
struct TorqueWords {
  /// A coefficient as it is stored at exponent E.
  template <int E, class Word>
  AXIAL_INLINE static constexpr Fx<E, A> at(const Stored<Word>& x) {
    return {x.raw};
  }
  /// The exponent of qd_j qd_k.
  template <int J, int K>
  static constexpr int product_exponent =
      rounding_of<A>().exponent(Robot::chain.links[J].speed_limit* Robot::chain.links[K].speed_limit);
  /// qd_j qd_k, rounded once.
  template <int J, int K, class Rates>
  AXIAL_INLINE static constexpr auto product(const Rates& qd) {
    return round_to<product_exponent<J, K>>(qd[Index<J>{}] * qd[Index<K>{}]);
  }
};

/// The terms of one joint in fixed point, each with its format: one exact sum, rounded once into the effort.
/// Coefficients, rates and accelerations are those of words or of bounds, as `Words` reads them.
template <class S, class Format, class Words, class Coefficients, class Rates, class Accelerations>
struct FixedTerms {
  const Words& words;        ///< how the others stand
  const Coefficients& s;     ///< separated terms
  const Rates& qd;           ///< at the exponents of their role
  const Accelerations& qdd;  ///< at the exponents of their role

  /// A(i, j) qdd_j, not rounded yet.
  template <int I, int J>
  AXIAL_INLINE constexpr auto inertial() const {
    if constexpr (has_inertia<S, Index<I>, Index<J>>())
      return words.template at<Format::inertia(I, J)>(s.A[I][J]) * qdd[Index<J>{}];
    else
      return Zero{};
  }
  /// C(i, j) qd_j^2, not rounded yet.
  template <int I, int J>
  AXIAL_INLINE constexpr auto square() const {
    if constexpr (has_product<S, Index<I>, Index<J>>())
      return words.template at<Format::square(I, J)>(s.C[I][J]) * words.template product<J, J>(qd);
    else
      return Zero{};
  }
  /// B(i; j k) qd_j qd_k, not rounded yet; of each pair once, j < k.
  template <int I, int J, int K>
  AXIAL_INLINE constexpr auto product() const {
    if constexpr (J >= K)
      return Zero{};
    else if constexpr (!has_product<S, Index<I>, Index<J>, Index<K>>())
      return Zero{};
    else
      return words.template at<Format::product(I, J, K)>(s.B[I][Coefficients::pair(J, K)]) *
             words.template product<J, K>(qd);
  }
  /// All terms of joint i as a lazy sum.
  template <int I, int... J>
  AXIAL_INLINE constexpr auto effort(std::integer_sequence<int, J...> all) const {
    return detail::lazy_sum(words.template at<Format::rest(I)>(s.G[I]), inertial<I, J>()..., square<I, J>()...,
                            products<I, J>(all)...);
  }

 private:
  template <int I, int J, int... K>
  AXIAL_INLINE constexpr auto products(std::integer_sequence<int, K...>) const {
    return detail::lazy_sum(product<I, J, K>()...);
  }
};

/// Sets the efforts of a scene, friction included where it names it.
template <class S, class T, class Links, class Words, class Coefficients, class Rates, class Accelerations, class Tau>
AXIAL_INLINE constexpr void sum_terms(const Links& links, const Words& words, const Coefficients& s, const Rates& qd,
                                      const Accelerations& qdd, Tau& tau) {
  const FixedTerms<S, SeparatedExponents<S, T>, Words, Coefficients, Rates, Accelerations> terms{words, s, qd, qdd};
  for_each_joint<S>([&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    auto sum = terms.template effort<decltype(i)::value>(std::make_integer_sequence<int, joint_count<S>>{});
    links.write(tau, i, link.sum(quantity::JointEffort{}, sum, friction_effort(link, qd[i])));
  });
}

/// Efforts in fixed point.
template <class S, class Word>
struct TorqueOf<S, Stored<Word>> {
  using T = Stored<Word>;  ///< stored word
  /// Efforts of separated terms, each of one exact sum.
  template <class Links>
  AXIAL_INLINE static constexpr EffortsOf<S, T> from(const Links& links, const Separated<S, T>& s,
                                                     const Velocities<robot_of<S>, T>& qd,
                                                     const Accelerations<robot_of<S>, T>& qdd) {
    EffortsOf<S, T> tau{};
    if constexpr (!is_refused<Links>) {
      const auto& at = execute<Actuators>(links);
      sum_terms<S, T>(at, TorqueWords<typename scene_of<S>::Robot, typename Links::Scalar>{}, s, at.read(qd),
                      at.read(qdd), tau);
    }
    return tau;
  }
};

}  // namespace axial::separation

#include <axial/options/end.hpp>

// What the C interface has in fixed point alone: the formats, and the border to real numbers.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/c_interface/calls.hpp>
#include <axial/fixed.hpp>

#include <axial/options/begin.hpp>

namespace axial::c_interface {

/// Words in C.
template <class Word>
struct InC<Stored<Word>> {
  using type = Word;                                                    ///< what C holds one in
  static constexpr type value(const Stored<Word>& x) { return x.raw; }  ///< one as C holds it
};

/// Formats of fixed point end at the declared limits.
template <class S, class Word>
struct CallCheck<S, Stored<Word>> {
  /// the first value outside the declared limits
  template <class Q, class V, class A>
  static constexpr Status of(const Q& q, const V& qd, const A& qdd) {
    return check_request<S>(q, qd, qdd);
  }
  /// words are always finite
  template <class... Values>
  static constexpr Status of_answer(const Values&...) {
    return {};
  }
};

/// Calls of one scene over words T. Pointers are not null.
template <class S, class Word>
struct ExportedCalls<S, Stored<Word>> : Calls<S, Stored<Word>> {
  using T = Stored<Word>;    ///< the words
  using Base = Calls<S, T>;  ///< what floating point has too
  /// Types of the values, as in Calls.
  ///@{
  using typename Base::A;
  using typename Base::Q;
  using typename Base::Robot;
  using typename Base::Tau;
  using typename Base::V;
  ///@}

  /// Exponents of all values, and which joints are revolute.
  template <class CFormats>
  static axial_status get_formats(CFormats& formats) {
    for (int i = 0; i < Base::size; ++i) {
      formats.revolute[i] = Robot::chain.links[i].type == JointType::revolute;
      formats.position[i] = static_cast<std::int8_t>(Q::exponent(i));
      formats.velocity[i] = static_cast<std::int8_t>(V::exponent(i));
      formats.acceleration[i] = static_cast<std::int8_t>(A::exponent(i));
      formats.effort[i] = static_cast<std::int8_t>(Tau::exponent(i));
      formats.free_acceleration[i] = static_cast<std::int8_t>(FreeAccelerations<S, T>::exponent(i));
      formats.power[i] = static_cast<std::int8_t>(PowersOf<S, T>::exponent(i));
      for (int j = 0; j < Base::size; ++j)
        formats.mass_matrix[i][j] = static_cast<std::int8_t>(MassMatrixOf<S, T>::exponent(i, j));
    }
    formats.rotation = direction_exponent<T>;
    formats.length = length_exponent<S, T>;
    return ok;
  }

  /// Nearest, and inside the declared limits; the status is that of the first value which was not.
  template <class CReal, class C>
  static axial_status to_fixed(const CReal& real_q, const CReal& real_qd, const CReal& real_qdd, C& q, C& qd, C& qdd) {
    using Real = Joints<Robot, float>;
    const auto request =
        to_fixed_request<S, typename T::Word>(from_c<Real>(real_q), from_c<Real>(real_qd), from_c<Real>(real_qdd));
    write_c(request.q, q);
    write_c(request.qd, qd);
    write_c(request.qdd, qdd);
    return to_c(request.status);
  }

  /// Efforts as real numbers, N m or N.
  template <class C, class CReal>
  static axial_status efforts_to_real(const C& tau, CReal& real_tau) {
    write_c(to_real<float>(from_c<Tau>(tau)), real_tau);
    return ok;
  }
};

}  // namespace axial::c_interface

#include <axial/options/end.hpp>

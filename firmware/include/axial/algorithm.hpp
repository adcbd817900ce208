// The algorithms as values: what cost<Scene>() and error_bound<Scene>() are asked for, and what a program calls that
// runs them all.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/closed_form/scara.hpp>
#include <axial/derivatives/forward_dynamics_along.hpp>
#include <axial/derivatives/forward_dynamics_derivatives.hpp>
#include <axial/derivatives/inverse_dynamics_along.hpp>
#include <axial/derivatives/inverse_dynamics_derivatives.hpp>
#include <axial/derivatives/torque_rates.hpp>
#include <axial/derivatives/torque_regressor.hpp>
#include <axial/dynamics/base_wrench.hpp>
#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/separation/separated_torque.hpp>
#include <axial/transmissions/elastic_feedforward.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Third and fourth derivatives of joint positions by time.
template <class S, class T>
struct HigherDerivatives {
  Joints<robot_of<S>, T> q3{};  ///< rad/s^3 or m/s^3
  Joints<robot_of<S>, T> q4{};  ///< rad/s^4 or m/s^4
};

/// The algorithms by name. Each has `name` and `run<S>(q, qd, x, in)`, x being accelerations or efforts, over any
/// number system.
namespace algorithm {

/// axial::inverse_dynamics().
struct InverseDynamics {
  static constexpr const char* name = "inverse_dynamics";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const In& in) {
    return axial::inverse_dynamics<S>(q, qd, qdd, in);
  }
};

/// axial::inverse_dynamics_derivatives(), all four results.
struct InverseDynamicsDerivatives {
  static constexpr const char* name = "inverse_dynamics_derivatives";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const In& in) {
    return axial::inverse_dynamics_derivatives<S>(q, qd, qdd, in);
  }
};

/// axial::inverse_dynamics_along(): a direction besides.
struct InverseDynamicsAlong {
  static constexpr const char* name = "inverse_dynamics_along";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class D, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const D& direction, const In& in) {
    return axial::inverse_dynamics_along<S>(q, qd, qdd, direction, in);
  }
};

/// axial::torque_rates() with the second derivative: higher derivatives besides.
struct TorqueRates {
  static constexpr const char* name = "torque_rates";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class D, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const D& higher, const In& in) {
    return axial::torque_rates<S>(q, qd, qdd, higher.q3, higher.q4, in);
  }
};

/// axial::elastic_feedforward(): higher derivatives besides.
struct ElasticFeedforward {
  static constexpr const char* name = "elastic_feedforward";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class D, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const D& higher, const In& in) {
    return axial::elastic_feedforward<S>(q, qd, qdd, higher.q3, higher.q4, in);
  }
};

/// axial::torque_regressor().
struct TorqueRegressor {
  static constexpr const char* name = "torque_regressor";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const In& in) {
    return axial::torque_regressor<S>(q, qd, qdd, in);
  }
};

/// axial::bias_torque().
struct Bias {
  static constexpr const char* name = "bias";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J&, const In& in) {
    return axial::bias_torque<S>(q, qd, in);
  }
};

/// axial::gravity_torque().
struct Gravity {
  static constexpr const char* name = "gravity";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J&, const J&, const In& in) {
    return axial::detail::holding_torque<S>(q, in);
  }
};

/// axial::mass_matrix().
struct MassMatrix {
  static constexpr const char* name = "mass_matrix";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J&, const J&, const In& in) {
    return axial::mass_matrix<S>(q, in);
  }
};

/// axial::forward_dynamics().
struct ForwardDynamics {
  static constexpr const char* name = "forward_dynamics";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& tau, const In& in) {
    return axial::forward_dynamics<S>(q, qd, tau, in);
  }
};

/// axial::forward_dynamics_derivatives(), all results.
struct ForwardDynamicsDerivatives {
  static constexpr const char* name = "forward_dynamics_derivatives";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& tau, const In& in) {
    return axial::forward_dynamics_derivatives<S>(q, qd, tau, in);
  }
};

/// axial::forward_dynamics_along(): a direction besides.
struct ForwardDynamicsAlong {
  static constexpr const char* name = "forward_dynamics_along";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class D, class In>
  static constexpr auto run(const J& q, const J& qd, const J& tau, const D& direction, const In& in) {
    return axial::forward_dynamics_along<S>(q, qd, tau, direction, in);
  }
};

/// axial::base_wrench().
struct BaseWrench {
  static constexpr const char* name = "base_wrench";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const In& in) {
    return axial::base_wrench<S>(q, qd, qdd, in);
  }
};

/// axial::forward_kinematics().
struct ForwardKinematics {
  static constexpr const char* name = "forward_kinematics";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J&, const J&, const In& in) {
    return axial::forward_kinematics<S>(q, in);
  }
};

/// axial::jacobian() of the tool.
struct Jacobian {
  static constexpr const char* name = "jacobian";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J&, const J&, const In& in) {
    return axial::jacobian<S>(q, in);
  }
};

/// axial::separate(): all four terms.
struct Separation {
  static constexpr const char* name = "separation";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J&, const J&, const In& in) {
    return axial::separate<S>(q, in);
  }
};
/// torque() from terms that are there already.
struct SeparatedTorque {
  static constexpr const char* name = "separated_torque";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class T, class J>
  static constexpr auto run(const Separated<S, T>& separated, const J& qd, const J& qdd) {
    return axial::torque(separated, qd, qdd);
  }
};
/// Only for robots of the SCARA's structure: all terms, and the torque.
struct ClosedFormSeparation {
  static constexpr const char* name = "closed_form_separation";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J&, const J&, const In&) {
    return closed_form::scara<robot_of<S>>(q);
  }
};
/// closed_form::scara_torque(): only for robots of the SCARA's structure.
struct ClosedForm {
  static constexpr const char* name = "closed_form";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const In&) {
    return closed_form::scara_torque<robot_of<S>>(q, qd, qdd);
  }
};

/// The algorithm of that name, as an argument.
///@{
inline constexpr InverseDynamics inverse_dynamics;
inline constexpr InverseDynamicsDerivatives inverse_dynamics_derivatives;
inline constexpr InverseDynamicsAlong inverse_dynamics_along;
inline constexpr TorqueRates torque_rates;
inline constexpr ElasticFeedforward elastic_feedforward;
inline constexpr TorqueRegressor torque_regressor;
inline constexpr Bias bias;
inline constexpr Gravity gravity;
inline constexpr MassMatrix mass_matrix;
inline constexpr ForwardDynamics forward_dynamics;
inline constexpr ForwardDynamicsDerivatives forward_dynamics_derivatives;
inline constexpr ForwardDynamicsAlong forward_dynamics_along;
inline constexpr BaseWrench base_wrench;
inline constexpr ForwardKinematics forward_kinematics;
inline constexpr Jacobian jacobian;
inline constexpr Separation separation;
inline constexpr SeparatedTorque separated_torque;
inline constexpr ClosedFormSeparation closed_form_separation;
inline constexpr ClosedForm closed_form;
///@}

}  // namespace algorithm

}  // namespace axial

#include <axial/options/end.hpp>

// The algorithms, a line each: what is said once of all of them is made of these lines.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/derivatives/forward_dynamics_derivatives.hpp>
#include <axial/derivatives/inverse_dynamics_derivatives.hpp>
#include <axial/derivatives/torque_rates.hpp>
#include <axial/derivatives/torque_regressor.hpp>
#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/dynamics/joint_torque.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/separation/separation.hpp>
#include <axial/transmissions/elastic_feedforward.hpp>

/// ROW(function, number and order of its joint values (joint_roles.hpp), what it answers over a scene and numbers).
///@{
#define AXIAL_ALGORITHMS_OVER_MODELS(ROW)                 \
  ROW(inverse_dynamics, 3, Motion, EffortsOf)             \
  ROW(gravity_torque, 1, Position, EffortsOf)             \
  ROW(bias_torque, 2, State, EffortsOf)                   \
  ROW(forward_dynamics, 3, Driven, ForwardDynamicsOf)     \
  ROW(mass_matrix, 1, Position, MassMatrixOf)             \
  ROW(forward_kinematics, 1, Position, ForwardKinematics) \
  ROW(jacobian, 1, Position, Jacobian)                    \
  ROW(separate, 1, Position, Separated)                   \
  ROW(momentum_terms, 2, State, MomentumTerms)            \
  ROW(torque_regressor, 3, Motion, TorqueRegressor)       \
  ROW(torque_rates, 4, Higher, TorqueRate)                \
  ROW(torque_rates, 5, Highest, TorqueRates)
#define AXIAL_ALGORITHMS(ROW) AXIAL_ALGORITHMS_OVER_MODELS(ROW) ROW(elastic_feedforward, 5, Highest, ElasticFeedforward)
/// The same of those whose results are chosen by name.
#define AXIAL_ALGORITHMS_OF_CHOICE(ROW)                                    \
  ROW(inverse_dynamics_derivatives, 3, Motion, InverseDynamicsDerivatives) \
  ROW(forward_dynamics_derivatives, 3, Driven, ForwardDynamicsDerivatives)
///@}

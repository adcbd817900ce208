// How exact an acceleration is: forward error against quadruple precision, backward error, condition of M.
#pragma once

#include <cases/scenarios.hpp>

namespace stability {

/// Of cond eps: who loses more has no gate of what is lost.
constexpr double sensible = 1e-2;

using cases::Scenario;
using oracle::quad;

/// What the answers to one scenario are measured with.
struct Reference {
  cases::Values qdd;                  ///< in quad; empty where the scenario is singular
  oracle::Matrix<double> magnitudes;  ///< |M_ij|
  oracle::Vector<double> forces;      ///< |tau_i| + |h_i|, h the torque of speeds and gravity
  double condition;                   ///< of M, in the 2-norm, within some per cent; infinite where singular
};

/// Without `measures` only qdd.
Reference reference_of(const Scenario& scenario, bool measures = true);

/// max |error| / max |qdd|, or max |error| where the scenario or a zero reference says so; infinite for NaN.
double forward_error(const Scenario& scenario, const Reference& reference, const oracle::Vector<double>& qdd);

/// max_i |ID(qdd) - tau|_i / (|tau_i| + |h_i| + sum_j |M_ij qdd_j|), the residual in quad; infinite for NaN.
double backward_error(const Scenario& scenario, const Reference& reference, const oracle::Vector<double>& qdd);

/// |M| |M^-1| in the 2-norm, by powers of M and of its inverse (which articulated bodies apply).
double condition(const oracle::Chain<double>& chain, const oracle::Vector<double>& q);

}  // namespace stability

// Reference motions by SUNDIALS.
#pragma once

#include <host_sim/plants/simulation/integrate.hpp>

namespace host_sim::simulation {

/// Who integrates a reference: CVODE's backward differentiation formulas (stiff) or Adams' (smooth), or ARKODE's
/// explicit Runge-Kutta pair of eighth order.
enum class ReferenceMethod { cvode_bdf, cvode_adams, arkode_erk };

/// Whether this build has SUNDIALS.
bool has_references();

struct Reference {
  Motion<double> end;
  long evaluations = 0;  ///< of forward dynamics
};

/// The motion from `start` under a drive after so many seconds; `tolerance` relative, and absolute in rad, m, rad/s.
/// Throws std::runtime_error when SUNDIALS gives up, or is not there.
Reference reference(ReferenceMethod method, const Model& model, const Motion<double>& start, double seconds,
                    const Drive<double>& drive, double tolerance);

}  // namespace host_sim::simulation

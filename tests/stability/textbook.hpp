// The articulated-body algorithm as textbooks have it (R. Featherstone, "Rigid Body Dynamics Algorithms", table 7.1, in
// link axes), with switches for what keeps digits. It shares no code with the library and serves as its ablation.
#pragma once

#include <cases/scenarios.hpp>

namespace stability {

/// How a joint's rank-one update of the articulated inertia is formed.
enum class Update {
  quotient,   ///< U_j U_k / D
  prescaled,  ///< (U_j s) U_k / (D s), s a power of two next to 1/D
  gain        ///< U_j K_k, K = U (1/D)
};

struct Variant {
  bool angular_bias = false;  ///< bias from angular velocities (classical accelerations), not from spatial velocities
  Update update = Update::quotient;
  bool exact_row = false;   ///< the joint's own row and column are K_k J_rotor, its force the effort: nothing cancels
  bool rotor_force = true;  ///< with exact_row: the force is exact with a rotor too, not only without
  bool dense = false;       ///< X^T I X by 6x6 products in place of rotation first, then translation
};

/// Accelerations in T (float or double) of a serial chain.
template <class T>
oracle::Vector<double> textbook(const cases::Scenario& scenario, const Variant& variant);

}  // namespace stability

// Derivatives of inverse and forward dynamics on the scenarios: each block's error against quadruple precision.
#pragma once

#include <array>
#include <functional>
#include <stability/measure.hpp>
#include <stability/routes.hpp>
#include <string>

namespace stability {

/// The blocks that are judged: slopes of efforts at given accelerations, slopes of accelerations at given efforts.
enum class Block { mass_matrix, torque_by_position, torque_by_velocity, by_position, by_velocity };
constexpr std::size_t blocks = 5;
const char* name_of(Block block);

using Derivatives = std::array<oracle::Matrix<quad>, blocks>;

/// A scenario's derivatives in quad: slopes of efforts by differences of the oracle's recursion, those of accelerations
/// by M^-1, which articulated bodies apply in quad.
struct DerivativeReference {
  oracle::Vector<double> qdd;  ///< accelerations as floats, so that all types of numbers derive at the same
  Derivatives exact;
};
/// `halvings` halves the step of the differences: that nothing depends on it tells how exact they are.
DerivativeReference derivative_reference(const Scenario& scenario, int halvings = 0);

/// One block by the run-time model in its looped form, in one type of numbers. Errors are relative to the block's
/// largest entry. A gate of infinity is none: M is too stiff to say more than that the answer is finite and reported.
struct DerivativeRow {
  std::string scenario, family, scalar, block, status;
  int joints = 0;
  double condition = 0.0, error = 0.0, gate = 0.0;
  bool pass = false;
};
std::vector<DerivativeRow> derivative_rows_of(const Scenario& scenario);

/// Regular scenarios of at most 50 joints (a reference takes O(N^2) recursions).
std::vector<Scenario> derived_scenarios();

/// Those whose names hold `filter`; tells `progress` the names.
std::vector<DerivativeRow> derivative_rows(const std::string& filter,
                                           const std::function<void(const std::string&)>& progress);

}  // namespace stability

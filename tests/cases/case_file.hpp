// Reads the validation data of tests/data: schemas mdh-case/1 and mdh-stiff/1 (see the README.md there).
#pragma once

#include <map>
#include <optional>
#include <oracle/chain.hpp>
#include <string>

namespace cases {

using oracle::quad;
using Values = oracle::Vector<quad>;

/// One state of a case file with the figures that belong to it. Matrices and poses are row by row.
struct State {
  std::string id;
  oracle::Vector<double> q, qd, qdd, tau;     ///< qd, qdd are zero where the file is silent; tau may be empty
  oracle::Load<quad> load;                    ///< friction and tip wrench
  std::optional<oracle::Vec3<quad>> gravity;  ///< overrides the file's
  std::map<std::string, Values> expect;       ///< the source's own figures, by quantity
  std::map<std::string, double> tolerance;    ///< their absolute tolerance, by quantity
  std::map<std::string, Values> reference;    ///< 30 digits, by quantity
};

/// Quantities: tau, qdd, M, cor, grav, pose, jac0, jace.
struct CaseFile {
  std::string name;
  oracle::Chain<quad> chain;  ///< exactly the doubles of the file: a twist of 1.5707963267948966 is no right angle here
  std::vector<State> states;

  /// The state of that name; throws if there is none.
  const State& state(const std::string& id) const;
  /// The chain with the gravity of one state.
  oracle::Chain<quad> chain_at(const State& state) const;
  /// Largest magnitude of a quantity's references (else figures) over all states; 1 where that is zero.
  double scale(const std::string& quantity) const;
};

/// Names of all case files of tests/data, without folder and extension.
std::vector<std::string> case_names();
CaseFile load_case(const std::string& name);

/// A scenario of stiff_scenarios.json: every number but right angles is a float, twists are exact right angles.
struct StiffScenario {
  std::string name;
  oracle::Chain<double> chain;
  oracle::Vector<double> q, qd, tau;
  Values qdd;  ///< 30 digits; empty where the mass matrix is singular
};
std::vector<StiffScenario> load_stiff_scenarios();

/// Rows of the negative control of scara_djuric_rrp.json: what the paper's misprinted equation (82) would give.
struct PrintedFigures {
  std::string id;
  double a11, tau1;
};
std::vector<PrintedFigures> load_misprint();

}  // namespace cases

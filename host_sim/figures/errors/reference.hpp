// Exact results of every job at given inputs, in 113-bit arithmetic.
#pragma once

#include <host_sim/figures/errors/job.hpp>
#include <oracle/driven.hpp>

#include <map>
#include <vector>

namespace errors {

using oracle::quad;
using Vector = oracle::Vector<quad>;

/// What a kernel was given, exactly: by joints, or by drives where joints share them.
struct Inputs {
  Vector q, qd, qdd, tau;
};

class Reference {
 public:
  /// `compliance`: 1/K of every joint, 0 of a rigid one; read for motors alone.
  Reference(oracle::DrivenChain<quad> chain, std::vector<Inputs> states, Vector compliance = {})
      : chain_(std::move(chain)), states_(std::move(states)), compliance_(std::move(compliance)) {}

  std::size_t size() const { return states_.size(); }
  const Inputs& inputs(std::size_t state) const { return states_[state]; }
  /// Results in the order of host_sim/boards/on_board; of accelerations those of the states' efforts.
  const std::vector<Vector>& results(Job job);
  /// What errors of each number are relative to.
  const std::vector<double>& scales(Job job);
  /// M(q) times a difference of accelerations.
  Vector torque_of(std::size_t state, const Vector& difference);

 private:
  Vector result(Job job, const Inputs& in) const;
  Vector mass_matrix(const Vector& q) const;
  Vector inverse_mass_matrix(const Vector& q) const;
  Vector torque_derivatives(const Inputs& in) const;
  Vector acceleration_derivatives(const Inputs& in) const;
  Vector motors(const Inputs& in) const;

  oracle::DrivenChain<quad> chain_;
  std::vector<Inputs> states_;
  Vector compliance_;
  std::map<Job, std::vector<Vector>> results_;
  std::map<Job, std::vector<double>> scales_;
};

}  // namespace errors

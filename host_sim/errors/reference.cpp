#include <host_sim/errors/reference.hpp>

#include <host_sim/analysis/error_scales.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/recursive.hpp>

namespace errors {
namespace {

using oracle::Vec3;

void append(Vector& values, const Vec3<quad>& v) { values.insert(values.end(), {v.x, v.y, v.z}); }

Vector pose(const oracle::Chain<quad>& chain, const Vector& q) {
  const auto tool = oracle::tool_pose(chain, q);
  const auto rows = oracle::transpose(tool.rotation);
  Vector values;
  for (const auto& part : {rows.c0, rows.c1, rows.c2, tool.position})
    append(values, part);
  return values;
}

Vector jacobian(const oracle::Chain<quad>& chain, const Vector& q) {
  const auto J = oracle::tool_jacobian(chain, q);
  Vector values;
  for (int j = 0; j < chain.size(); ++j)
    for (const auto* part : {&J.angular, &J.linear})
      append(values, {(*part)(0, j), (*part)(1, j), (*part)(2, j)});
  return values;
}

}  // namespace

/// Lower triangle: a column is the torque of a unit acceleration, without gravity and at rest.
Vector Reference::mass_matrix(const Vector& q) const {
  oracle::Chain<quad> weightless = chain_;
  weightless.gravity = {};
  const std::size_t n = q.size();
  const Vector rest(n, quad(0));
  Vector lower(n * (n + 1) / 2);
  for (std::size_t j = 0; j < n; ++j) {
    Vector unit = rest;
    unit[j] = quad(1);
    const Vector column = oracle::recursive_inverse_dynamics(weightless, q, rest, unit);
    for (std::size_t i = j; i < n; ++i)
      lower[i * (i + 1) / 2 + j] = column[i];
  }
  return lower;
}

Vector Reference::result(Job job, const Inputs& in) const {
  const Vector rest(in.q.size(), quad(0));
  switch (job) {
    case Job::torque:
      return oracle::recursive_inverse_dynamics(chain_, in.q, in.qd, in.qdd);
    case Job::gravity:
      return oracle::recursive_inverse_dynamics(chain_, in.q, rest, rest);
    case Job::bias:
      return oracle::recursive_inverse_dynamics(chain_, in.q, in.qd, rest);
    case Job::mass_matrix:
      return mass_matrix(in.q);
    case Job::acceleration:
      return oracle::recursive_forward_dynamics(chain_, in.q, in.qd, in.tau);
    case Job::pose:
      return pose(chain_, in.q);
    case Job::jacobian:
      return jacobian(chain_, in.q);
  }
  return {};
}

const std::vector<Vector>& Reference::results(Job job) {
  auto& known = results_[job];
  if (known.empty())
    for (const Inputs& in : states_)
      known.push_back(result(job, in));
  return known;
}

const std::vector<double>& Reference::scales(Job job) {
  auto& known = scales_[job];
  if (known.empty()) {
    std::vector<host_sim::Values> exact;
    for (const Vector& values : results(job)) {
      host_sim::Values rounded;
      for (const quad& value : values)
        rounded.push_back(static_cast<double>(value));
      exact.push_back(rounded);
    }
    known = host_sim::error_scales(scaled_as(job), exact);
  }
  return known;
}

Vector Reference::torque_of(std::size_t state, const Vector& difference) {
  const Vector& lower = results(Job::mass_matrix)[state];
  const std::size_t n = difference.size();
  Vector torque(n, quad(0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      torque[i] += lower[i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i] * difference[j];
  return torque;
}

}  // namespace errors

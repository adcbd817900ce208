#include <host_sim/figures/errors/reference.hpp>

#include <host_sim/tools/analysis/error_scales.hpp>
#include <oracle/compare.hpp>
#include <oracle/differences.hpp>

namespace errors {
namespace {

using oracle::Vec3;

void append(Vector& values, const Vec3<quad>& v) { values.insert(values.end(), {v.x, v.y, v.z}); }

Vector pose(const oracle::DrivenChain<quad>& chain, const Vector& q) {
  const auto tool = chain.tool_pose(q);
  const auto rows = oracle::transpose(tool.rotation);
  Vector values;
  for (const auto& part : {rows.c0, rows.c1, rows.c2, tool.position})
    append(values, part);
  return values;
}

Vector jacobian(const oracle::DrivenChain<quad>& chain, const Vector& q) {
  const auto J = chain.tool_jacobian(q);
  Vector values;
  for (int j = 0; j < static_cast<int>(q.size()); ++j)
    for (const auto* part : {&J.angular, &J.linear})
      append(values, {(*part)(0, j), (*part)(1, j), (*part)(2, j)});
  return values;
}

/// Of a symmetric matrix, whose column j is `column` of a unit vector.
template <class Column>
Vector lower_triangle(std::size_t n, const Column& column) {
  Vector lower(n * (n + 1) / 2);
  for (std::size_t j = 0; j < n; ++j) {
    Vector unit(n, quad(0));
    unit[j] = quad(1);
    const Vector values = column(unit);
    for (std::size_t i = j; i < n; ++i)
      lower[i * (i + 1) / 2 + j] = values[i];
  }
  return lower;
}

void append(Vector& values, const Vector& more) { values.insert(values.end(), more.begin(), more.end()); }
Vector joined(const Vector& symmetric, const oracle::Jacobians& slopes) {
  Vector values = symmetric;
  append(values, oracle::elements(slopes.by_position));
  append(values, oracle::elements(slopes.by_velocity));
  return values;
}

}  // namespace

Vector Reference::mass_matrix(const Vector& q) const {
  const auto M = chain_.mass_matrix(q);
  Vector lower;
  for (int i = 0; i < M.rows(); ++i)
    for (int j = 0; j <= i; ++j)
      lower.push_back(M(i, j));
  return lower;
}
Vector Reference::inverse_mass_matrix(const Vector& q) const {
  const auto M = chain_.mass_matrix(q);
  return lower_triangle(q.size(), [&](const Vector& unit) { return oracle::solve(M, unit); });
}

Vector Reference::torque_derivatives(const Inputs& in) const {
  const auto torque = [&](const Vector& q, const Vector& qd) { return chain_.inverse_dynamics(q, qd, in.qdd); };
  Vector values = torque(in.q, in.qd);
  append(values, joined(mass_matrix(in.q), oracle::differences(in.q, in.qd, torque)));
  return values;
}
Vector Reference::acceleration_derivatives(const Inputs& in) const {
  const auto acceleration = [&](const Vector& q, const Vector& qd) { return chain_.forward_dynamics(q, qd, in.tau); };
  Vector values = joined(inverse_mass_matrix(in.q), oracle::differences(in.q, in.qd, acceleration));
  append(values, acceleration(in.q, in.qd));
  return values;
}

/// Spong's equations, with what the kernel takes for the third and fourth derivative: accelerations and efforts.
Vector Reference::motors(const Inputs& in) const {
  const auto& robot = chain_.chain();
  const auto link = oracle::rates_in_time(
      oracle::Path{in.q, in.qd, in.qdd, in.qdd, in.tau}, [&](const Vector& q, const Vector& qd, const Vector& qdd) {
        return oracle::recursive_inverse_dynamics(oracle::without_rotors(robot), q, qd, qdd);
      });
  Vector torque = link.value, position = in.q, velocity = in.qd;
  for (std::size_t i = 0; i < torque.size(); ++i) {
    const auto& motor = robot.links[i];
    const quad& c = compliance_[i];
    position[i] += c * link.value[i], velocity[i] += c * link.first[i];
    torque[i] += motor.gear * motor.gear * motor.rotor_inertia * (in.qdd[i] + c * link.second[i]);
  }
  Vector values = torque;
  append(values, position), append(values, velocity), append(values, link.value);
  return values;
}

Vector Reference::result(Job job, const Inputs& in) const {
  const Vector rest(in.q.size(), quad(0));
  switch (job) {
    case Job::torque:
      return chain_.inverse_dynamics(in.q, in.qd, in.qdd);
    case Job::gravity:
      return chain_.inverse_dynamics(in.q, rest, rest);
    case Job::bias:
      return chain_.inverse_dynamics(in.q, in.qd, rest);
    case Job::mass_matrix:
      return mass_matrix(in.q);
    case Job::acceleration:
      return chain_.forward_dynamics(in.q, in.qd, in.tau);
    case Job::pose:
      return pose(chain_, in.q);
    case Job::jacobian:
      return jacobian(chain_, in.q);
    case Job::torque_derivatives:
      return torque_derivatives(in);
    case Job::acceleration_derivatives:
      return acceleration_derivatives(in);
    case Job::motors:
      return motors(in);
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

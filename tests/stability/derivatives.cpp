#include <algorithm>
#include <axial/axial.hpp>
#include <cases/to_axial.hpp>
#include <cmath>
#include <memory>
#include <oracle/as_float.hpp>
#include <oracle/compare.hpp>
#include <oracle/convert.hpp>
#include <oracle/differences.hpp>
#include <oracle/recursive.hpp>
#include <stability/derivatives.hpp>

namespace stability {
namespace {

using oracle::Matrix;
using oracle::Vector;

constexpr int longest = 50;

/// A matrix by its columns, each what `column` makes of the column of another.
template <class F>
Matrix<quad> by_columns(const Matrix<quad>& source, const F& column) {
  const int n = source.rows();
  Matrix<quad> result(n, n);
  for (int j = 0; j < n; ++j) {
    Vector<quad> given;
    for (int i = 0; i < n; ++i)
      given.push_back(source(i, j));
    const Vector<quad> values = column(given);
    for (int i = 0; i < n; ++i)
      result(i, j) = values[static_cast<std::size_t>(i)];
  }
  return result;
}
Matrix<quad> identity(int n) {
  Matrix<quad> result(n, n);
  for (int i = 0; i < n; ++i)
    result(i, i) = quad(1);
  return result;
}

/// -M^-1 times.
Matrix<quad> solved(const oracle::Chain<quad>& weightless, const Vector<quad>& q, const Matrix<quad>& slopes) {
  const Vector<quad> still(q.size(), quad(0));
  return by_columns(slopes, [&](Vector<quad> column) {
    for (quad& x : column)
      x = -x;
    return oracle::recursive_forward_dynamics(weightless, q, still, column);
  });
}

template <class T, class M>
Matrix<quad> widened(const M& matrix, int n) {
  Matrix<quad> result(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      result(i, j) = quad(T(matrix(i, j)));
  return result;
}

constexpr bool is_of_torque(Block block) { return block <= Block::torque_by_velocity; }

/// Torques lose nothing to any of the scenarios but what adds up; speeds of a body far from its joint cancel in what it
/// contributes to that joint's own slope, squares of the distance beside the distance.
double torque_gate(const std::string& family, Block block) {
  return family == "ST11" && block == Block::torque_by_velocity ? 512.0 : 16.0;
}

/// An elimination loses what M's condition says, and says so itself beyond 13 bits.
double acceleration_gate(const Scenario& scenario, double condition, Scalar scalar, bool reported) {
  const cases::Gate own = scalar == Scalar::in_double ? scenario.in_double : scenario.in_float;
  const double eps = epsilon_of(scalar), lost = condition * eps;
  double gate = lost < sensible ? std::max(2.0 * lost, own.forward) : cases::Gate{}.forward;
  return reported ? gate : std::min(gate, 0x1p13 * eps);
}

struct Answers {
  Derivatives values;
  axial::Status status;
};

template <class T>
Answers derive(const Scenario& s, const Vector<double>& accelerations) {
  using Model = axial::Model<longest, axial::Gravity, axial::RotorInertia, axial::Unbranched>;
  const auto model = std::make_unique<Model>(cases::to_model<Model>(s.chain));
  axial::Joints<Model, T> q{}, qd{}, qdd{}, tau{};
  for (int i = 0; i < model->size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    q[i] = static_cast<T>(s.q[k]), qd[i] = static_cast<T>(s.qd[k]);
    qdd[i] = static_cast<T>(accelerations[k]), tau[i] = static_cast<T>(s.tau[k]);
  }
  const auto inverse = axial::inverse_dynamics_derivatives(*model, q, qd, qdd);
  const auto forward = axial::forward_dynamics_derivatives(*model, q, qd, tau);
  const int n = s.size();
  return {{widened<T>(inverse.M, n), widened<T>(inverse.dtau_dq, n), widened<T>(inverse.dtau_dqd, n),
           widened<T>(forward.dqdd_dq, n), widened<T>(forward.dqdd_dqd, n)},
          forward.qdd.status};
}

}  // namespace

const char* name_of(Block block) {
  constexpr const char* names[] = {"M", "dtau_dq", "dtau_dqd", "dqdd_dq", "dqdd_dqd"};
  return names[static_cast<int>(block)];
}

DerivativeReference derivative_reference(const Scenario& scenario, int halvings) {
  const auto chain = oracle::convert<quad>(scenario.chain);
  auto weightless = chain;
  weightless.gravity = {};
  const auto q = oracle::convert<quad>(scenario.q), qd = oracle::convert<quad>(scenario.qd);
  const Vector<quad> still(q.size(), quad(0));
  const auto exact_qdd = cases::reference_acceleration(scenario);
  DerivativeReference result;
  for (const quad& x : exact_qdd)
    result.qdd.push_back(oracle::as_float(x));
  const auto slopes = [&](const Vector<quad>& qdd) {
    const quad step = oracle::usual_step() / quad(1LL << halvings);
    const auto torque = [&](const Vector<quad>& p, const Vector<quad>& v) {
      return oracle::recursive_inverse_dynamics(chain, p, v, qdd);
    };
    return oracle::differences(q, qd, torque, step);
  };
  const auto at_floats = slopes(oracle::convert<quad>(result.qdd)), at_exact = slopes(exact_qdd);
  result.exact = {by_columns(identity(scenario.size()),
                             [&](const Vector<quad>& unit) {
                               return oracle::recursive_inverse_dynamics(weightless, q, still, unit);
                             }),
                  at_floats.by_position, at_floats.by_velocity, solved(weightless, q, at_exact.by_position),
                  solved(weightless, q, at_exact.by_velocity)};
  return result;
}

std::vector<DerivativeRow> derivative_rows_of(const Scenario& scenario) {
  const auto reference = derivative_reference(scenario);
  const double cond = condition(scenario.chain, scenario.q);
  std::vector<DerivativeRow> rows;
  for (const Scalar scalar : scalars) {
    const Answers answers =
        scalar == Scalar::in_double ? derive<double>(scenario, reference.qdd) : derive<float>(scenario, reference.qdd);
    for (std::size_t b = 0; b < blocks; ++b) {
      const auto block = static_cast<Block>(b);
      const bool torque = is_of_torque(block);
      const double error = oracle::relative_error(answers.values[b], reference.exact[b]);
      const double gate = torque ? torque_gate(scenario.family, block) * epsilon_of(scalar)
                                 : acceleration_gate(scenario, cond, scalar, !answers.status.ok());
      rows.push_back({scenario.name, scenario.family, name_of(scalar), name_of(block),
                      torque ? "ok" : name_of(answers.status), scenario.size(), cond, error, gate,
                      std::isfinite(error) && error <= gate});
    }
  }
  return rows;
}

std::vector<Scenario> derived_scenarios() {
  std::vector<Scenario> all = cases::scenarios();
  const auto left_out = [](const Scenario& s) { return s.singular || s.size() > longest; };
  all.erase(std::remove_if(all.begin(), all.end(), left_out), all.end());
  return all;
}

std::vector<DerivativeRow> derivative_rows(const std::string& filter,
                                           const std::function<void(const std::string&)>& progress) {
  std::vector<DerivativeRow> all;
  for (const Scenario& scenario : derived_scenarios())
    if (scenario.name.find(filter) != std::string::npos) {
      progress(scenario.name);
      const auto rows = derivative_rows_of(scenario);
      all.insert(all.end(), rows.begin(), rows.end());
    }
  return all;
}

}  // namespace stability

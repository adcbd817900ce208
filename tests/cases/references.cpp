#include <cases/implementation.hpp>
#include <oracle/compare.hpp>
#include <oracle/convert.hpp>
#include <oracle/kdl_chain.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/recursive.hpp>
#include <tuple>

namespace cases {
namespace {

using oracle::convert;
using oracle::elements;

template <class T>
oracle::Vector<T> value(const oracle::Vector<double>& v) {
  return convert<T>(v);
}

/// Quantities of position that every reference takes from a pose and a Jacobian in root axes.
template <class T>
std::optional<Values> kinematics(const oracle::Pose<T>& tool, const oracle::Jacobian<T>& J,
                                 const std::string& quantity) {
  if (quantity == "pose") return pose_rows(tool);
  if (quantity == "jac0") return jacobian_rows(J.linear, J.angular);
  if (quantity == "jace") return jacobian_rows(in_axes(tool.rotation, J.linear), in_axes(tool.rotation, J.angular));
  return std::nullopt;
}

template <class T>
class Lagrange : public Implementation {
 public:
  using Implementation::Implementation;

  std::optional<Values> evaluate(const CaseFile& file, const State& state, const std::string& quantity) const override {
    const auto chain = convert<T>(file.chain_at(state));
    const auto q = value<T>(state.q), qd = value<T>(state.qd);
    const oracle::Load<T> load{state.load.friction, convert<T>(state.load.tip)};
    if (quantity == "tau") return convert<quad>(oracle::inverse_dynamics(chain, q, qd, value<T>(state.qdd), load));
    if (quantity == "qdd") return convert<quad>(oracle::forward_dynamics(chain, q, qd, value<T>(state.tau), load));
    if (quantity == "M") return convert<quad>(elements(oracle::mass_matrix(chain, q)));
    if (quantity == "cor") return convert<quad>(oracle::coriolis_torque(chain, q, qd));
    if (quantity == "grav") return convert<quad>(oracle::gravity_torque(chain, q));
    return kinematics(oracle::tool_pose(chain, q), oracle::tool_jacobian(chain, q), quantity);
  }
};

class Recursive : public Implementation {
 public:
  using Implementation::Implementation;

  std::optional<Values> evaluate(const CaseFile& file, const State& state, const std::string& quantity) const override {
    const auto chain = file.chain_at(state);
    const auto q = value<quad>(state.q), qd = value<quad>(state.qd);
    if (quantity == "tau") return oracle::recursive_inverse_dynamics(chain, q, qd, value<quad>(state.qdd), state.load);
    if (quantity == "qdd") return oracle::recursive_forward_dynamics(chain, q, qd, value<quad>(state.tau), state.load);
    return std::nullopt;
  }
};

class Kdl : public Implementation {
 public:
  using Implementation::Implementation;

  std::optional<Values> evaluate(const CaseFile& file, const State& state, const std::string& quantity) const override {
    const auto chain = convert<double>(file.chain_at(state));
    const oracle::KdlChain kdl(chain);
    const auto tip = convert<double>(state.load.tip);
    const auto& [q, qd] = std::tie(state.q, state.qd);
    if (quantity == "tau") return plus(kdl.inverse_dynamics(q, qd, state.qdd, tip), friction(chain, state), 1.0);
    if (quantity == "qdd") return convert<quad>(kdl.forward_dynamics(q, qd, less_friction(chain, state), tip));
    if (quantity == "M") return convert<quad>(elements(kdl.mass_matrix(q)));
    if (quantity == "cor") return convert<quad>(kdl.coriolis_torque(q, qd));
    if (quantity == "grav") return convert<quad>(kdl.gravity_torque(q));
    return kinematics(kdl.tool_pose(q), kdl.tool_jacobian(q), quantity);
  }

 private:
  static oracle::Vector<double> friction(const oracle::Chain<double>& chain, const State& state) {
    return state.load.friction ? oracle::friction_torque(chain, state.qd) : oracle::Vector<double>(state.q.size(), 0.0);
  }
  static Values plus(const oracle::Vector<double>& a, const oracle::Vector<double>& b, double sign) {
    Values sum;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum.push_back(a[i] + sign * b[i]);
    return sum;
  }
  static oracle::Vector<double> less_friction(const oracle::Chain<double>& chain, const State& state) {
    return convert<double>(plus(state.tau, friction(chain, state), -1.0));
  }
};

}  // namespace

ImplementationList references() {
  // Half a last digit of a 30-digit figure is 5e-30; otherwise 100 roundings, and 1000 for KDL, whose M^-1 is by L D
  // L^T.
  constexpr double digits30 = 1e-29, long_double = 1e-17, in_double = 2e-14, kdl = 2e-13;
  return {std::make_shared<Lagrange<quad>>("oracle_quad", digits30),
          std::make_shared<Recursive>("recursive_quad", digits30),
          std::make_shared<Lagrange<long double>>("oracle_long_double", long_double),
          std::make_shared<Lagrange<double>>("oracle_double", in_double), std::make_shared<Kdl>("kdl", kdl)};
}

}  // namespace cases

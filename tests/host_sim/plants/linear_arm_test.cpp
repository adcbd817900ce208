// What ./axial loop --export writes: read back from the header, held to the oracle's nonlinear arm, and regulated.
#include <host_sim/plants/loop/linear_arm.hpp>
#include <host_sim/robots/robots/driven_robot.hpp>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>
#include <sstream>

#include <robots/robots.hpp>

using namespace host_sim::loop;

namespace {

using Dense = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// ---- the header, as a compiler would read it

std::vector<double> numbers(const std::string& header, const std::string& name) {
  std::smatch found;
  const std::regex array("tinytype " + name + "\\[[^\\]]*\\] = \\{([^}]*)\\}");
  if (!std::regex_search(header, found, array)) throw std::runtime_error("there is no " + name);
  std::istringstream text(std::regex_replace(found[1].str(), std::regex(","), " "));
  return {std::istream_iterator<double>(text), {}};
}
int defined(const std::string& header, const std::string& name) {
  std::smatch found;
  return std::regex_search(header, found, std::regex("#define " + name + " (\\d+)\n")) ? std::stoi(found[1]) : -1;
}
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
Dense matrix(const std::vector<double>& values, int rows, int columns) {
  EXPECT_EQ(static_cast<int>(values.size()), rows * columns);
  return Eigen::Map<const RowMajor>(values.data(), rows, columns);
}

struct Problem {
  int n = 0;
  Dense A, B, Q, R;
  Vector low_u, high_u;
};
Problem read(const std::string& header) {
  Problem p;
  const int nx = defined(header, "NSTATES");
  p.n = defined(header, "NINPUTS");
  p.A = matrix(numbers(header, "Adyn_data"), nx, nx), p.B = matrix(numbers(header, "Bdyn_data"), nx, p.n);
  p.Q = Vector(matrix(numbers(header, "Q_data"), nx, 1)).asDiagonal();
  p.R = Vector(matrix(numbers(header, "R_data"), p.n, 1)).asDiagonal();
  p.low_u = matrix(numbers(header, "u_min_data"), p.n, 1), p.high_u = matrix(numbers(header, "u_max_data"), p.n, 1);
  return p;
}

// ---- the nonlinear arm

template <class Robot>
class Arm {
 public:
  Arm() : chain_(host_sim::driven_robot<double, Robot>()) {}

  /// (q, qd) after `seconds` under held efforts: Runge-Kutta, eight steps.
  Vector after(Vector x, const Vector& tau, double seconds) const {
    const double h = seconds / 8;
    for (int k = 0; k < 8; ++k) {
      const Vector a = rate(x, tau), b = rate(x + 0.5 * h * a, tau), c = rate(x + 0.5 * h * b, tau),
                   d = rate(x + h * c, tau);
      x += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return x;
  }

 private:
  Vector rate(const Vector& x, const Vector& tau) const {
    const Eigen::Index n = tau.size();
    const auto list = [](const Vector& v) { return oracle::Vector<double>(v.data(), v.data() + v.size()); };
    const auto qdd = chain_.forward_dynamics(list(x.head(n)), list(x.tail(n)), list(tau));
    Vector dx(2 * n);
    dx << x.tail(n), Eigen::Map<const Vector>(qdd.data(), n);
    return dx;
  }
  oracle::DrivenChain<double> chain_;
};

Vector vector(const std::vector<double>& v) {
  return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
}
Vector state(const LinearArm& arm) {
  Vector x(2 * static_cast<Eigen::Index>(arm.tau.size()));
  x << vector(arm.at.q), vector(arm.at.qd);
  return x;
}

/// The largest difference of A and B to central differences of the nonlinear arm, over the largest entry of each.
template <class Robot>
double prediction_error(double time, double tick) {
  const LinearArm arm = linear_arm(Robot::name, time, tick);
  const Problem p = read(tinympc_header(arm, 10, 1.0));
  const Arm<Robot> real;
  const Vector x = state(arm), tau = vector(arm.tau);
  const double h = 1e-5;
  Dense A(2 * p.n, 2 * p.n), B(2 * p.n, p.n);
  for (int j = 0; j < 2 * p.n; ++j)
    A.col(j) = (real.after(x + h * Vector::Unit(2 * p.n, j), tau, tick) -
                real.after(x - h * Vector::Unit(2 * p.n, j), tau, tick)) /
               (2 * h);
  for (int j = 0; j < p.n; ++j)
    B.col(j) =
        (real.after(x, tau + h * Vector::Unit(p.n, j), tick) - real.after(x, tau - h * Vector::Unit(p.n, j), tick)) /
        (2 * h);
  const auto off = [](const Dense& ours, const Dense& exact) {
    return (ours - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
  };
  const double error = std::max(off(p.A, A), off(p.B, B));
  std::printf("%s at %g s, steps of %g s: off by %.2g\n", Robot::name, time, tick, error);
  return error;
}

/// Gains by going back so many steps.
Dense gains(const Problem& p, int steps) {
  Dense P = p.Q, K;
  for (int k = 0; k < steps; ++k) {
    K = (p.R + p.B.transpose() * P * p.B).ldlt().solve(p.B.transpose() * P * p.A);
    P = p.Q + p.A.transpose() * P * (p.A - p.B * K);
  }
  return K;
}

template <class Robot>
void expect_regulated(double deviation, double tick = 0.01) {
  const LinearArm arm = linear_arm(Robot::name, 0.0, tick);
  const Problem p = read(tinympc_header(arm, 10, 1.0));
  const Dense K = gains(p, 400);
  const double radius = (p.A - p.B * K).eval().eigenvalues().cwiseAbs().maxCoeff();
  EXPECT_LT(radius, std::pow(0.95, tick / 0.01));
  const Arm<Robot> real;
  const Vector wanted = state(arm), tau = vector(arm.tau);
  Vector x = wanted;
  x.head(p.n).array() += deviation;
  for (int k = 0; k < std::lround(1.0 / tick); ++k)
    x = real.after(x, tau + (-K * (x - wanted)).cwiseMax(p.low_u).cwiseMin(p.high_u), tick);
  EXPECT_LT((x - wanted).cwiseAbs().maxCoeff(), 1e-3) << Robot::name;
}

}  // namespace

TEST(LinearArm, OfSharedDrivesPredictsAndIsRegulated) {
  EXPECT_LT(prediction_error<robots::WristArm>(0.0, 0.01), 1e-6);
  EXPECT_LT(prediction_error<robots::ScaraQuill>(0.0, 0.001), 1e-6);
  EXPECT_LT(prediction_error<robots::Palletiser>(0.7, 0.001), 1e-4);
  expect_regulated<robots::WristArm>(0.02, 0.001);
}

TEST(LinearArm, OfSharedDrivesHasTheDrivesBoundsAndUnits) {
  const LinearArm quill = linear_arm("scara_quill", 0.0, 0.001), gripper = linear_arm("gripper", 0.0, 0.001);
  EXPECT_NEAR(quill.high_u[2] + quill.tau[2], 1.1, 1e-12);
  EXPECT_NEAR(quill.high_x[4] + quill.at.qd[0], 6.5, 1e-12);
  EXPECT_DOUBLE_EQ(quill.Q[2], 1.0 / (0.03 * 0.03));  // a nut turns, though its joint slides
  EXPECT_DOUBLE_EQ(gripper.Q[1], 1.0 / (0.01 * 0.01));
}
TEST(LinearArm, PredictsTheNonlinearArm) {
  for (const double tick : {0.001, 0.01, 0.02}) {  // at rest: exact but for the differences
    EXPECT_LT(prediction_error<robots::Puma560>(0.0, tick), 1e-7);
    EXPECT_LT(prediction_error<robots::Scara>(0.0, tick), 1e-7);
  }
  for (const double time : {0.5, 1.0, 2.0}) {  // in motion the arm leaves the point within the step
    EXPECT_LT(prediction_error<robots::Puma560>(time, 0.001), 2e-5);
    EXPECT_LT(prediction_error<robots::Scara>(time, 0.001), 3e-3);
  }
}

TEST(LinearArm, EveryStateCanBeReached) {
  for (const char* robot : {"puma560", "scara", "panda", "scara_rrpr", "planar2r", "wrist_arm", "palletiser"})
    for (const double time : {0.0, 0.7}) {
      const Problem p = read(tinympc_header(linear_arm(robot, time, 0.01), 10, 1.0));
      Dense reach(2 * p.n, 2 * p.n);
      reach << p.B, p.A * p.B;
      EXPECT_EQ(Eigen::FullPivLU<Dense>(reach).rank(), 2 * p.n) << robot;
    }
}

TEST(LinearArm, IsRegulatedByWhatIsExported) {
  expect_regulated<robots::Puma560>(0.05);
  expect_regulated<robots::Scara>(0.01);
}

TEST(LinearArm, BoundsAreTheDeclaredLimitsLessTheMotion) {
  const LinearArm arm = linear_arm("puma560", 0.5, 0.01);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& joint = robots::Puma560::chain.links[i];
    EXPECT_NEAR(arm.high_u[i] + arm.tau[i], joint.effort_limit, 1e-9);
    EXPECT_NEAR(arm.low_u[i] + arm.tau[i], -joint.effort_limit, 1e-9);
    EXPECT_NEAR(arm.low_x[i] + arm.at.q[i], joint.position_min, 1e-9);
    EXPECT_NEAR(arm.high_x[6 + i] + arm.at.qd[i], joint.speed_limit, 1e-9);
  }
}

TEST(LinearArm, SaysWhatItCannotDo) {
  EXPECT_THROW(linear_arm("nobody", 0.0, 0.01), std::runtime_error);
  EXPECT_THROW(linear_arm("puma560", -1.0, 0.01), std::runtime_error);
}

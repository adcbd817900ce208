// The extended Kalman filter beside an arm that the oracle moves, whose noise is what the filter believes it to be:
// then its errors are of the size that its own covariance says. In a loop: observers_test.cpp.
#include <firmware/apps/ekf/controller.hpp>

#include <gtest/gtest.h>
#include <oracle/from_axial.hpp>
#include <oracle/lagrange.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include <robots/puma560.hpp>
#include <robots/scara.hpp>

namespace axial::apps {
namespace {

using Values = oracle::Vector<double>;

constexpr double T = 1e-3;

/// An arm under efforts, shaken by accelerations that nobody knows.
template <class Robot>
struct Arm {
  static constexpr std::size_t n = Robot::chain.size;
  oracle::Chain<double> chain = oracle::of_robot<double, Robot>();
  Values q, qd;

  void run(const Values& tau, const Values& shaken) {  // Runge-Kutta, over a tick
    const auto rate = [&](const Values& position, const Values& velocity) {
      Values a = oracle::forward_dynamics(chain, position, velocity, tau);
      for (std::size_t i = 0; i < n; ++i)
        a[i] += shaken[i];
      return a;
    };
    const auto plus = [](const Values& a, double h, const Values& b) {
      Values sum = a;
      for (std::size_t i = 0; i < n; ++i)
        sum[i] += h * b[i];
      return sum;
    };
    const Values a1 = rate(q, qd), v2 = plus(qd, T / 2, a1), a2 = rate(plus(q, T / 2, qd), v2),
                 v3 = plus(qd, T / 2, a2), a3 = rate(plus(q, T / 2, v2), v3), v4 = plus(qd, T, a3),
                 a4 = rate(plus(q, T, v3), v4);
    for (std::size_t i = 0; i < n; ++i) {
      q[i] += T / 6 * (qd[i] + 2 * v2[i] + 2 * v3[i] + v4[i]);
      qd[i] += T / 6 * (a1[i] + 2 * a2[i] + 2 * a3[i] + a4[i]);
    }
  }
};

/// Mean squares over all joints: of errors over the variances that the filter believes, and of velocities.
struct Outcome {
  double position = 0.0, velocity = 0.0;          ///< over the believed variance
  double filter_rms = 0.0, difference_rms = 0.0;  ///< velocities, over the joint's encoder noise in a second
};

template <class Robot>
Outcome observed(int ticks) {
  constexpr int n = Robot::chain.size;
  StateNoise<n> noise{};
  Arm<Robot> arm;
  for (int i = 0; i < n; ++i) {
    const auto& link = Robot::chain.links[i];
    noise.encoder[i] = link.type == JointType::prismatic ? 6e-5F : 4e-4F;
    noise.acceleration[i] = 0.2F * static_cast<float>(link.acceleration_limit), noise.speed[i] = 1.0F;
    arm.q.push_back(0.5 * (link.position_min + link.position_max)), arm.qd.push_back(0.0);
  }
  const Values middle = arm.q;
  StateEstimator<Robot> estimator(noise, static_cast<float>(T));
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  Values last;
  Outcome sum;
  int counted = 0;
  for (int k = 0; k < ticks; ++k) {
    Joints<Robot, float> measured{}, effort{};
    Values seen = arm.q, wanted(arm.q.size()), shaken(arm.q.size());
    for (std::size_t i = 0; i < arm.q.size(); ++i) {
      const auto j = static_cast<int>(i);
      const double w = 6.0 + static_cast<double>(i), phase = w * T * k, swing = 0.15;
      seen[i] += static_cast<double>(noise.encoder[j]) * normal(engine);
      measured[j] = static_cast<float>(seen[i]);
      shaken[i] = static_cast<double>(noise.acceleration[j]) * normal(engine);
      wanted[i] = -swing * w * w * std::sin(phase) + 400.0 * (middle[i] + swing * std::sin(phase) - arm.q[i]) +
                  40.0 * (swing * w * std::cos(phase) - arm.qd[i]);
    }
    Values tau = oracle::inverse_dynamics(arm.chain, arm.q, arm.qd, wanted);
    for (int i = 0; i < n; ++i) {
      effort[i] = static_cast<float>(tau[static_cast<std::size_t>(i)]);
      tau[static_cast<std::size_t>(i)] = static_cast<double>(effort[i]);
    }
    if (k == 0) estimator.begin(measured);
    estimator.correct(measured);
    const Values velocity = arm.qd;
    const bool counts = k >= 200;
    for (int i = 0; counts && i < n; ++i) {
      const auto j = static_cast<std::size_t>(i);
      const double scale = static_cast<double>(noise.encoder[i]) / T;
      sum.filter_rms += std::pow((static_cast<double>(estimator.qd()[i]) - velocity[j]) / scale, 2.0);
      sum.difference_rms += std::pow(((seen[j] - last[j]) / T - velocity[j]) / scale, 2.0);
    }
    EXPECT_TRUE(estimator.predict(effort).met());
    arm.run(tau, shaken);
    for (int i = 0; counts && i < n; ++i, ++counted) {
      const auto j = static_cast<std::size_t>(i);
      sum.position +=
          std::pow(static_cast<double>(estimator.q()[i]) - arm.q[j], 2.0) / static_cast<double>(estimator.variance(i));
      sum.velocity += std::pow(static_cast<double>(estimator.qd()[i]) - arm.qd[j], 2.0) /
                      static_cast<double>(estimator.variance(n + i));
    }
    last = seen;
  }
  return {sum.position / counted, sum.velocity / counted, std::sqrt(sum.filter_rms / counted),
          std::sqrt(sum.difference_rms / counted)};
}

template <class Robot>
void expect_honest() {
  const Outcome o = observed<Robot>(2200);
  std::printf(
      "%s: errors over what the filter believes: positions %.3f, velocities %.3f; velocity %.4f, differenced %.3f\n",
      Robot::name, o.position, o.velocity, o.filter_rms, o.difference_rms);
  EXPECT_NEAR(o.position, 1.0, 0.2);
  EXPECT_NEAR(o.velocity, 1.0, 0.2);
  EXPECT_LT(15.0 * o.filter_rms, o.difference_rms);
}

}  // namespace

TEST(Estimator, ErrsAsItBelieves) {
  expect_honest<robots::Puma560>();
  expect_honest<robots::Scara>();
}

TEST(Estimator, SaysWhatIsNoNumberAndBeginsAnew) {
  using Robot = robots::Scara;
  StateNoise<3> noise{{1e-4F, 1e-4F, 1e-4F}, {1.0F, 1.0F, 1.0F}, {1.0F, 1.0F, 1.0F}};
  StateEstimator<Robot> estimator(noise, 1e-3F);
  const Joints<Robot, float> here{0.1F, 0.2F, 0.03F};
  estimator.begin(here);
  estimator.correct(here);
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(estimator.predict({none, 0.0F, 0.0F}).met());
  EXPECT_TRUE(estimator.predict({0.0F, 0.0F, 0.0F}).met()) << "nothing has changed";
  estimator.begin(here);
  EXPECT_EQ(estimator.q()[1], 0.2F);
  EXPECT_EQ(estimator.qd()[1], 0.0F);
}

// At first the filter believes the encoders and that the arm rests.
TEST(EkfController, FeedsBackWhatTheFilterBelieves) {
  using Robot = robots::Scara;
  const auto answer = [](float speed, bool feeds_forward) {
    hal::link::SetPoint wanted{};
    hal::link::Measurement seen{};
    wanted.joints = seen.joints = 3;
    wanted.q = {0.01F, -0.02F, 0.05F}, wanted.qd = {speed, -speed, 0.0F};
    seen.position = {0, 0, 499'000}, seen.feeds_forward = feeds_forward ? 1 : 0;
    EkfController<Robot> controller;
    hal::link::Torque torque{};
    controller.measure(seen);
    controller.load(wanted);
    controller.compute();
    controller.settle(wanted);
    controller.store(torque);
    return torque;
  };
  constexpr auto gains = tracking_gains<Robot>();
  const double errors[] = {0.01, -0.02, 1e-4}, speeds[] = {0.1, -0.1, 0.0};
  const auto resting = answer(0.0F, false), moving = answer(0.1F, false), fed = answer(0.0F, true);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(static_cast<double>(resting.tau[k]), gains.stiffness[i] * errors[i], 1e-3);
    EXPECT_NEAR(static_cast<double>(moving.tau[k] - resting.tau[k]), gains.damping[i] * speeds[i], 1e-3);
  }
  EXPECT_NEAR(fed.tau[2] - resting.tau[2], -1.25F * 9.8125F, 1e-3F) << "the slide's weight";
}

}  // namespace axial::apps

// The regulator's gains against the algebraic Riccati equation in double (regulator_reference), and what its torque is
// made of. In QEMU: host_sim.Pushes.*; in a loop: pushes_test.cpp.
#include <firmware/apps/lqr/controller.hpp>

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include "regulator_reference.hpp"

namespace axial::apps {
namespace {

namespace link = hal::link;
using regulator_reference::Motion;
using Vector = std::vector<double>;

constexpr double T = 1e-3, turn = 6.283185307179586;
constexpr int settled = 600;  // ticks
// A tick under constant acceleration leaves out how Coriolis torques change within it: T/2 times some 2/s here.
constexpr double most_off = 1e-3;

// ---- the reference

template <class Robot>
Vector reference(const Motion& at) {
  regulator_reference::Weights weights;
  for (const auto& joint : Robot::chain.links) {
    const double worth = joint.type == JointType::prismatic ? worth_effort_m : worth_effort_rad;
    weights.state.push_back(std::pow(worth, -2.0)), weights.effort.push_back(std::pow(joint.effort_limit, -2.0));
  }
  weights.state.resize(2 * at.q.size());  // speeds are not weighed
  return regulator_reference::gains<Robot>(at, weights);
}

// ---- the controller

template <class Robot>
class Regulator {
 public:
  /// The torque where the joints are `off` more than is wanted (rad, m).
  link::Torque answer(const Motion& at, const Vector& off = {}, bool feeds_forward = true) {
    link::SetPoint wanted{};
    auto& measured = measured_;
    wanted.joints = measured.joints = at.q.size();
    measured.feeds_forward = feeds_forward ? 1 : 0;
    for (std::size_t i = 0; i < at.q.size(); ++i) {
      wanted.q[i] = static_cast<float>(at.q[i]), wanted.qd[i] = static_cast<float>(at.qd[i]);
      wanted.qdd[i] = static_cast<float>(at.qdd[i]);
      const double seen = static_cast<double>(wanted.q[i]) + (off.empty() ? 0.0 : off[i]);
      if (std::isnan(seen)) continue;  // an encoder says what it said before
      const bool slides = Robot::chain.links[i].type == JointType::prismatic;
      measured.position[i] = static_cast<std::int32_t>(
          std::llround(slides ? seen * slide_counts : std::remainder(seen / turn, 1.0) * 4294967296.0));
    }
    controller_.measure(measured);
    controller_.load(wanted);
    controller_.compute();
    controller_.settle(wanted);
    link::Torque torque{};
    controller_.store(torque);
    return torque;
  }
  void settle(const Motion& at) {
    for (int k = 0; k < settled; ++k)
      (void)answer(at);
  }
  LqrController<Robot>& controller() { return controller_; }

 private:
  LqrController<Robot> controller_;
  link::Measurement measured_{};
};

template <class Robot>
Vector as_double(const LqrController<Robot>& controller) {
  const auto& K = controller.gains();
  return {std::begin(K.values), std::end(K.values)};
}

/// Of positions and of speeds, each relative to the largest gain of its kind.
double difference(const Vector& ours, const Vector& exact, std::size_t n) {
  double off[2] = {}, largest[2] = {};
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const auto kind = k / n % 2;
    off[kind] = std::max(off[kind], std::fabs(ours[k] - exact[k]));
    largest[kind] = std::max(largest[kind], std::fabs(exact[k]));
  }
  return std::max(off[0] / largest[0], off[1] / largest[1]);
}

/// K of positions, and of speeds, times x.
Vector times(const Vector& K, const Vector& x, bool speeds) {
  const auto n = x.size();
  Vector y(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      y[i] += K[2 * n * i + (speeds ? n : 0) + j] * x[j];
  return y;
}

template <class Robot>
void expect_gains(const std::vector<Motion>& motions, double most) {
  Regulator<Robot> regulator;
  for (const Motion& at : motions) {
    regulator.settle(at);
    const double error = difference(as_double(regulator.controller()), reference<Robot>(at), at.q.size());
    std::printf("%s: gains off by %.2g of the largest\n", Robot::name, error);
    EXPECT_LT(error, most);
  }
}

const std::vector<Motion> puma{
    {{0.0, -0.7, 2.2, 0.0, 0.1, 0.0}, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}},
    {{-0.8, -0.25, 1.5, 0.4, 0.5, -0.9}, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}},
    {{0.5, 0.3, 0.7, -0.5, 0.7, 0.8}, {1.2, -1.0, 2.0, 3.0, -3.0, 2.0}, {3.0, -2.0, 4.0, 5.0, -8.0, 4.0}},
};
const std::vector<Motion> scara{
    {{0.25, -0.5, 0.125}, {0, 0, 0}, {0, 0, 0}},
    {{-0.5, 1.5, 0.05}, {2.0, -3.0, 0.2}, {5.0, 5.0, 1.0}},
};

}  // namespace

TEST(Regulator, GainsAreThoseOfThePostureAndItsMotion) {
  expect_gains<robots::Puma560>(puma, most_off);
  expect_gains<robots::Scara>(scara, most_off);
}

TEST(Regulator, GainsOfPosturesDiffer) {  // by far more than their errors above
  EXPECT_GT(difference(reference<robots::Puma560>(puma[0]), reference<robots::Puma560>(puma[1]), 6), 0.02);
  EXPECT_GT(difference(reference<robots::Scara>(scara[0]), reference<robots::Scara>(scara[1]), 3), 0.02);
}

TEST(Regulator, TorqueOpposesTheDeviationByTheGains) {
  using Robot = robots::Puma560;
  const Motion& at = puma[1];
  const Vector K = reference<Robot>(at), off{2e-4, -1e-4, 3e-4, -4e-4, 2e-4, 5e-4};
  Regulator<Robot> regulator;
  regulator.settle(at);
  const auto fed = regulator.answer(at), moving = regulator.answer(at, off), resting = regulator.answer(at, off);
  const Vector stiffness = times(K, off, false), damping = times(K, off, true);
  for (std::size_t i = 0; i < 6; ++i) {
    const double came = static_cast<double>(moving.tau[i] - fed.tau[i]),
                 rests = static_cast<double>(resting.tau[i] - fed.tau[i]);
    EXPECT_NEAR(came, -stiffness[i] - damping[i] / T, 1e-2) << i;
    EXPECT_NEAR(rests, -stiffness[i], 2e-3) << i;
    std::printf("joint %zu: %.4f N m, %.4f N m\n", i + 1, came, rests);
  }
}

TEST(Regulator, BeginsWithTheFeedForwardAndNoStep) {
  Regulator<robots::Puma560> regulator, undisturbed;
  const Vector off(6, 0.05);
  for (int session = 0; session < 2; ++session) {
    const auto first = regulator.answer(puma[0], off), fed = undisturbed.answer(puma[0]);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_EQ(first.tau[i], fed.tau[i]) << "session " << session << ", joint " << i;
    for (int k = 0; k < settled; ++k)
      (void)regulator.answer(puma[0], off);
    EXPECT_GT(std::fabs(regulator.answer(puma[0], off).tau[0] - fed.tau[0]), 10.0F);
    regulator.controller().restart();
  }
}

TEST(Regulator, ExertsNoMoreThanIsDeclared) {
  for (const double sign : {-1.0, 1.0}) {
    Regulator<robots::Puma560> regulator;
    regulator.settle(puma[0]);
    bool at_the_limit = false;
    for (int k = 1; k <= 500; ++k) {  // a joint that leapt would be a broken encoder
      const auto torque = regulator.answer(puma[0], Vector(6, sign * 1e-3 * k));
      for (std::size_t i = 0; i < 6; ++i) {
        const double used =
            std::fabs(static_cast<double>(torque.tau[i])) / robots::Puma560::chain.links[i].effort_limit;
        EXPECT_LE(used, 1 + 1e-6);
        at_the_limit = at_the_limit || used > 1 - 1e-6;
      }
    }
    EXPECT_TRUE(at_the_limit);
  }
}

TEST(Regulator, WithoutFeedForwardCarriesNoWeight) {
  Regulator<robots::Puma560> regulator;
  const auto torque = regulator.answer(puma[0], {}, false);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(torque.tau[i], 0.0F, 1e-3F);
}

TEST(Regulator, RefusesWhatIsNoNumber) {
  Regulator<robots::Puma560> regulator;
  regulator.settle(puma[0]);
  Motion none = puma[0];
  none.q[2] = std::nan("");
  EXPECT_EQ(regulator.answer(none).status, static_cast<std::uint8_t>(link::TorqueStatus::not_finite));
  EXPECT_EQ(regulator.answer(puma[0]).status, static_cast<std::uint8_t>(link::TorqueStatus::ok));
}

}  // namespace axial::apps

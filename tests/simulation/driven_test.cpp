// What drives a robot that boards integrate, and what its motion makes of a small error: of a pendulum that stands on
// its joint.
#include <axial/axial.hpp>
#include <host_sim/plants/real_time/measured.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace host_sim::real_time;

namespace {

struct Standing {
  static constexpr const char* name = "standing";
  static constexpr double length = 0.1, mass = 2.0, inertia = 0.005;  // m, kg, kg m^2
  static constexpr auto chain = axial::chain(axial::revolute()
                                                 .alpha_deg(90)
                                                 .mass(mass)
                                                 .com(0.0, length, 0.0)
                                                 .inertia_com(inertia, inertia, inertia)
                                                 .position_limits(-1.0, 1.0)
                                                 .speed_limit(2.0)
                                                 .acceleration_limit(40.0)
                                                 .effort_limit(50.0));
};

constexpr double swing = 0.02;  // rad

/// A second from rest to the other side, by a cosine.
Course across() {
  Course course;
  for (int k = 0; k < 1000; ++k) {
    const double w = 3.14159265358979324, t = k * tick;
    course.q.push_back({-swing / 2 * std::cos(w * t)});
    course.qd.push_back({swing / 2 * w * std::sin(w * t)});
    course.qdd.push_back({swing / 2 * w * w * std::cos(w * t)});
  }
  return course;
}
double end_of(const Driven<Standing>& motion) {
  bool made = true;
  return InDouble<Standing>::driven<axial::RungeKutta4>(motion, 1, made).back()[0];
}

}  // namespace

// By theta'' = m g l / (m l^2 + I) theta + tau, an error at the start grows by the hyperbolic cosine.
TEST(Driven, GrowthOfAStandingPendulumIsTheHyperbolicCosine) {
  const double rate = std::sqrt(Standing::mass * 9.81 * Standing::length /
                                (Standing::mass * Standing::length * Standing::length + Standing::inertia));
  const double growth = growth_of(driven_near<Standing>(across()));
  EXPECT_NEAR(growth / std::cosh(rate), 1.0, 0.01) << std::cosh(rate);
}

TEST(Driven, TorquesOfACourseLeaveItAndThoseOfAControllerDoNot) {
  EXPECT_GT(std::fabs(end_of(driven_along<Standing>(across())) - swing / 2), 0.05 * swing);
  EXPECT_LT(std::fabs(end_of(driven_near<Standing>(across())) - swing / 2), 0.005 * swing);
}

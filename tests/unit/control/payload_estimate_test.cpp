// What an estimate makes of its normal equations, apart from any motion.
#include <gtest/gtest.h>
#include <axial/control/payload_estimator.hpp>
#include <axial/robot/chain.hpp>
#include <cmath>

using namespace axial;

namespace {

using Code = Status::Code;

struct Arm {  // the tool stands off the link's frame
  static constexpr auto chain = axial::chain(revolute().mass(1).com(1, 0, 0).effort_limit(10), tool(0.5, -0.25, 2.0));
};
struct Tuning {
  static constexpr double period = 1e-3, gain = 100.0, deviation = 0.01, memory = 1.0, mass_deviation = 0.5,
                          moment_deviation = 0.25;
};
using State = PayloadState<Arm, double>;

/// Independent information on each of the four parameters.
State knowing(double mass, double moment) {
  State state;
  for (int i = 0; i < 4; ++i)
    state.information[i][i] = i == 0 ? mass : moment;
  return state;
}
constexpr double enough_of_mass = 4.0, enough_of_moment = 16.0;  // 1 / deviation^2

}  // namespace

TEST(PayloadEstimate, SolvesItsEquationsAboutTheToolPoint) {
  State state = knowing(100.0, 100.0);
  state.information[1][0] = 10.0;
  const double mass = 2.0, moment[] = {0.125, -0.5, 0.25};
  state.moment[0] = 100.0 * mass + 10.0 * moment[0], state.moment[1] = 10.0 * mass + 100.0 * moment[0];
  state.moment[2] = 100.0 * moment[1], state.moment[3] = 100.0 * moment[2];
  const auto e = estimate<Tuning>(state);
  EXPECT_TRUE(e.status.ok());
  EXPECT_NEAR(e.mass, mass, 1e-14);
  EXPECT_NEAR(e.first_moment.x, moment[0] + mass * 0.5, 1e-14);
  EXPECT_NEAR(e.first_moment.y, moment[1] - mass * 0.25, 1e-14);
  EXPECT_NEAR(e.first_moment.z, moment[2] + mass * 2.0, 1e-14);
  EXPECT_NEAR(e.variance[0], 100.0 / (100.0 * 100.0 - 10.0 * 10.0), 1e-16);
  EXPECT_NEAR(e.variance[3], 0.01, 1e-17);
}

TEST(PayloadEstimate, IsReadyWhereEveryParameterIsKnownWellEnough) {
  EXPECT_EQ(estimate<Tuning>(knowing(enough_of_mass, enough_of_moment)).status.code, Code::ok);
  for (int lacking = 0; lacking < 4; ++lacking) {
    State state = knowing(enough_of_mass, enough_of_moment);
    state.information[lacking][lacking] *= 0.999;
    EXPECT_EQ(estimate<Tuning>(state).status.code, Code::not_ready) << "parameter " << lacking;
  }
}

TEST(PayloadEstimate, OfNothingIsNotReadyAndFinite) {
  const auto e = estimate<Tuning>(State{});
  EXPECT_EQ(e.status.code, Code::not_ready);
  EXPECT_TRUE(std::isfinite(e.mass) && std::isfinite(e.first_moment.x));
}

TEST(PayloadEstimate, BecomesABodyWhereThereIsMass) {
  PayloadEstimate<double> e;
  e.mass = 2.0, e.first_moment = {1.0, -0.5, 0.25};
  EXPECT_EQ(e.body().mass, 2.0);
  EXPECT_EQ(e.body().com.x, 0.5);
  EXPECT_EQ(e.body().com.y, -0.25);
  EXPECT_EQ(e.body().com.z, 0.125);
  for (const double none : {0.0, -1.0, double(NAN)}) {
    e.mass = none;
    EXPECT_EQ(e.body().mass, 0.0) << none;
    EXPECT_EQ(e.body().com.x, 0.0) << none;
  }
}

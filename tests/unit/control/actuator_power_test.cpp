// Power of actuators against Lagrange's efforts times speeds, in every number system and by every call.
#include <gtest/gtest.h>
#include <axial/batch.hpp>
#include <axial/cost.hpp>
#include <axial/fixed.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/random_chain.hpp>
#include <robots/scara.hpp>

#include <array>
#include <cmath>

namespace {

using namespace axial;
using robots::Scara;

oracle::Vector<double> lagrange_power(const oracle::Chain<double>& chain, const oracle::Vector<double>& q,
                                      const oracle::Vector<double>& qd, const oracle::Vector<double>& qdd) {
  auto power = oracle::inverse_dynamics(chain, q, qd, qdd);
  for (std::size_t i = 0; i < power.size(); ++i)
    power[i] *= qd[i];
  return power;
}

// States inside the declared limits, each value at `part` of its limit at most.
template <class R>
struct Drawn {
  oracle::Vector<double> q, qd, qdd;
  Drawn(oracle::RandomChains& random, double part) {
    for (const LinkParameters& link : R::chain.links) {
      q.push_back(random.uniform(link.position_min, link.position_max));
      qd.push_back(part * random.uniform(-link.speed_limit, link.speed_limit));
      qdd.push_back(part * random.uniform(-link.acceleration_limit, link.acceleration_limit));
    }
  }
  template <class T>
  static Joints<R, T> joints(const oracle::Vector<double>& values) {
    Joints<R, T> result{};
    for (int i = 0; i < result.size; ++i)
      result[i] = T(values[std::size_t(i)]);
    return result;
  }
};

template <class T>
void expect_lagrange(double tolerance) {
  oracle::RandomChains random(20261127);
  const auto chain = oracle::of_robot<double, Scara>();
  for (int k = 0; k < 100; ++k) {
    using D = Drawn<Scara>;
    const D x(random, 1.0);
    const auto expected = lagrange_power(chain, x.q, x.qd, x.qdd);
    const auto found = actuator_power<Scara>(D::joints<T>(x.q), D::joints<T>(x.qd), D::joints<T>(x.qdd));
    for (int i = 0; i < found.size; ++i)
      EXPECT_NEAR(found[i], expected[std::size_t(i)], tolerance * (1.0 + std::fabs(expected[std::size_t(i)])))
          << "state " << k << ", joint " << i;
  }
}

TEST(ActuatorPower, IsLagrangesEffortTimesSpeedInDouble) { expect_lagrange<double>(1e-12); }
TEST(ActuatorPower, IsLagrangesEffortTimesSpeedInFloat) { expect_lagrange<float>(1e-4); }

// The largest error over drawn states, over what is certified, of the joint where that is most.
template <class S, class Word>
double certified_part() {
  using T = Stored<Word>;
  constexpr auto bound = error_bound<S, T>(algorithm::actuator_power);
  oracle::RandomChains random(20261128);
  const auto chain = oracle::of_robot<double, Scara>();
  double most = 0.0;
  for (int k = 0; k < 2000; ++k) {
    using D = Drawn<Scara>;
    const D x(random, k % 4 == 0 ? 1.0 : 0.7);
    const auto in =
        to_fixed_request<S, Word>(D::joints<double>(x.q), D::joints<double>(x.qd), D::joints<double>(x.qdd));
    EXPECT_TRUE(in.status.ok());
    const auto vector = [](const auto& words) {
      const auto real = to_real<double>(words);
      return oracle::Vector<double>(real.values, real.values + real.size);
    };
    const auto expected = lagrange_power(chain, vector(in.q), vector(in.qd), vector(in.qdd));
    const auto found = to_real<double>(actuator_power<S>(in.q, in.qd, in.qdd));
    for (int i = 0; i < found.size; ++i) {
      const double error = std::fabs(found[i] - expected[std::size_t(i)]);
      EXPECT_LE(error, bound[i]) << "state " << k << ", joint " << i;
      most = std::fmax(most, error / bound[i]);
    }
  }
  return most;
}

TEST(ActuatorPower, InFixedPointIsWithinItsBound) {
  EXPECT_GT((certified_part<Scara, std::int32_t>()), 1e-3);
  EXPECT_GT((certified_part<Scara, std::int16_t>()), 1e-3);
}
TEST(ActuatorPower, OfUpperWordsIsWithinItsBound) {
  EXPECT_GT((certified_part<Scene<Scara, Gravity, RotorInertia, HighWord>, std::int32_t>()), 1e-3);
}
TEST(ActuatorPower, InTheLoopedFormIsWithinItsBound) {
  EXPECT_GT((certified_part<Scene<Scara, Gravity, RotorInertia, Looped>, std::int32_t>()), 1e-3);
}
// What a product is off by: a speed times the effort's error, and half a unit of its own.
TEST(ActuatorPower, BoundIsTheEffortsTimesTheSpeedAndARounding) {
  constexpr auto power = error_bound<Scara>(algorithm::actuator_power),
                 effort = error_bound<Scara>(algorithm::inverse_dynamics);
  for (int i = 0; i < power.size; ++i) {
    const double unit = std::ldexp(1.0, -PowersOf<Scara, Fixed32>::exponent(i));
    const double least = effort[i] * Scara::chain.links[i].speed_limit;
    EXPECT_GE(power[i], least + 0.5 * unit) << i;
    EXPECT_LE(power[i], 1.001 * least + unit) << i;
  }
}

// The second joint's drive stands on the base: a belt turns it against the first joint. No rotors, no friction.
struct Belt {
  static constexpr auto link = revolute()
                                   .a(0.3)
                                   .mass(1.5)
                                   .com(0.1, 0.02, 0.03)
                                   .inertia_com(0.03, 0.02, 0.025, 0.001, 0.002, 0.003)
                                   .position_limits(-1.5, 1.5)
                                   .speed_limit(3.0)
                                   .acceleration_limit(20.0);
  static constexpr auto chain = axial::chain(
      gravity(1.0, -9.0, -2.0), link, link.driven_by(0, -1.0).drive_limits(-2.0, 2.0, 3.0, 20.0), link.alpha(0.6));
};
struct Free {
  static constexpr auto chain = axial::chain(gravity(1.0, -9.0, -2.0), Belt::link, Belt::link, Belt::link.alpha(0.6));
};

// Through a coupling power is neither lost nor gained: q = G u with G = [1 0 0; -1 1 0; 0 0 1].
TEST(ActuatorPower, OfSharedDrivesIsThatOfTheJointsTogether) {
  oracle::RandomChains random(20261129);
  const auto chain = oracle::of_robot<double, Free>();
  constexpr auto bound = error_bound<Belt>(algorithm::actuator_power);
  double certified = 0.0;
  for (int k = 0; k < bound.size; ++k)
    certified += bound[k];
  for (int k = 0; k < 100; ++k) {
    const auto u = random.vector(3, 0.7), ud = random.vector(3, 1.4), udd = random.vector(3, 9.0);
    const auto of = [](const auto& x) { return Joints<Belt, double>{x[0], x[1], x[2]}; };
    const auto by_belt = [](const auto& x) { return oracle::Vector<double>{x[0], x[1] - x[0], x[2]}; };
    const auto total = [](const auto& power) { return power[0] + power[1] + power[2]; };
    const double expected = total(lagrange_power(chain, by_belt(u), by_belt(ud), by_belt(udd)));
    EXPECT_NEAR(total(actuator_power<Belt>(of(u), of(ud), of(udd))), expected, 1e-12 * (1.0 + std::fabs(expected)));
    const auto in = to_fixed_request<Belt, std::int32_t>(of(u), of(ud), of(udd));
    const auto words = to_real<double>(actuator_power<Belt>(in.q, in.qd, in.qdd));
    EXPECT_NEAR(total(words), expected, certified + 1e-5 * (1.0 + std::fabs(expected)));  // the request's own rounding
  }
}

TEST(ActuatorPower, EveryCallIsThatOnJointValues) {
  const Joints<Scara, float> q{0.4F, -0.7F, 0.06F}, qd{1.1F, -0.3F, 0.2F}, qdd{2.0F, -1.0F, 9.0F};
  const auto wanted = actuator_power<Scara>(q, qd, qdd);
  const float q_array[3] = {0.4F, -0.7F, 0.06F};
  const std::array<float, 3> qd_array{1.1F, -0.3F, 0.2F};
  const float* const pointer = qdd.values;
  const auto of_arrays = actuator_power<Scara>(q_array, qd_array, pointed<3>(pointer));
  const auto of_braces = actuator_power<Scara>({0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}, {2.0F, -1.0F, 9.0F});
  using M = Model<3, Gravity, RotorInertia>;
  M model;
  for (const LinkParameters& link : Scara::chain.links)
    ASSERT_TRUE(model.add(link));
  const auto& g = Scara::chain.gravity;
  model.set_gravity(g.x, g.y, g.z);
  const auto of_model = actuator_power(model, q_array, {1.1F, -0.3F, 0.2F}, qdd.values);
  const Joints<Scara, float> states[2][3] = {{q, qd, qdd}, {qd, q, q}};
  const Joints<Scara, float> qs[4] = {q, qd, q, qd}, qds[4] = {qd, q, qd, q}, qdds[4] = {qdd, q, qdd, q};
  const auto of_lanes = actuator_power<Scara>(load<4>(qs), load<4>(qds), load<4>(qdds));
  const auto other = actuator_power<Scara>(states[1][0], states[1][1], states[1][2]);
  for (int i = 0; i < wanted.size; ++i) {
    EXPECT_EQ(of_arrays[i], wanted[i]);
    EXPECT_EQ(of_braces[i], wanted[i]);
    EXPECT_NEAR(of_model[i], wanted[i], 1e-5F * (1.0F + std::fabs(wanted[i])));
    EXPECT_NEAR(of_lanes[i][2], wanted[i], 1e-6F * (1.0F + std::fabs(wanted[i])));
    EXPECT_NEAR(of_lanes[i][1], other[i], 1e-6F * (1.0F + std::fabs(other[i])));
  }
}

TEST(ActuatorPower, CostsAProductForEachActuator) {
  constexpr auto power = cost<Scara>(algorithm::actuator_power), effort = cost<Scara>(algorithm::inverse_dynamics);
  static_assert(power.mul == effort.mul + 3 && power.add == effort.add && power.sincos == effort.sincos);
  EXPECT_STREQ(algorithm::actuator_power.name, "actuator_power");
}

}  // namespace

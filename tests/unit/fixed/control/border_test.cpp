#include <gtest/gtest.h>
#include <axial/control/feedforward.hpp>
#include <axial/fixed.hpp>
#include <cmath>
#include <random>
#include <robots/robots.hpp>

using namespace axial;

namespace {

using R = robots::Scara;
using Code = Status::Code;
using Q = Positions<R, Fixed32>;
using Qd = Velocities<R, Fixed32>;
using Qdd = Accelerations<R, Fixed32>;
using Tau = EffortsOf<R, Fixed32>;
constexpr double unit_of_angle = 6.283185307179586477 / 4294967296.0;  // rad

template <class T>
T any_real(std::mt19937& random, double most) {
  return static_cast<T>(std::uniform_real_distribution<double>(-most, most)(random));
}

// The nearest raw value by long double, halves away from 0.
long double nearest(long double x) { return std::round(x); }

struct Turner {  // unlimited positions
  static constexpr auto chain =
      axial::chain(revolute().mass(1).com(1, 0, 0).speed_limit(1000.0).acceleration_limit(1.0e-3));
};

// An arc around half a turn.
struct Backwards {
  static constexpr auto chain =
      axial::chain(revolute().mass(1).com(1, 0, 0).position_limits(2.0, 4.5).speed_limit(1.0).acceleration_limit(1.0));
};

}  // namespace

TEST(Border, IsConstexpr) {
  constexpr auto q = to_fixed<Q>(Joints<R, float>{1.0F, -1.0F, 0.125F});
  static_assert(q.status.ok() && q.values[0].raw == 683565276 && q.values[1].raw == -683565276);
  static_assert(q.values[2].raw == 1 << (Q::exponent(2) - 3));
  constexpr auto back = to_real<float>(q.values);
  EXPECT_EQ(back[0], 1.0F);
  EXPECT_EQ(back[1], -1.0F);
  EXPECT_EQ(back[2], 0.125F);
}

template <class T>
void expect_nearest_words() {
  std::mt19937 random(20240921);
  for (int k = 0; k < 200000; ++k) {
    Joints<R, T> x{any_real<T>(random, 4.0), any_real<T>(random, 5.0), any_real<T>(random, 1.0)};
    if (k % 3 == 0)
      for (T& value : x.values)
        value = std::ldexp(value, -(k % 50));
    const auto fixed = to_fixed<Qd>(x);
    EXPECT_TRUE(fixed.status.ok());
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(static_cast<long double>(fixed.values[i].raw),
                nearest(std::ldexp(static_cast<long double>(x[i]), Qd::exponent(i))))
          << static_cast<double>(x[i]);
  }
}
TEST(Border, FloatsRoundToNearest) { expect_nearest_words<float>(); }
TEST(Border, DoublesRoundToNearest) { expect_nearest_words<double>(); }

template <class T>
void expect_nearest_angles() {
  std::mt19937 random(20240922);
  const long double turn = 2.0L * std::acos(-1.0L);
  for (int k = 0; k < 200000; ++k) {
    T x = any_real<T>(random, 512.0);
    if (k % 2 == 0) x = std::ldexp(x, -(k % 60));
    const auto fixed = to_fixed<Positions<Turner, Fixed32>>(Joints<Turner, T>{x});
    EXPECT_TRUE(fixed.status.ok());
    const long double units = static_cast<long double>(x) / turn * 4294967296.0L;
    const long double error = std::remainder(units - fixed.values[0].raw, 4294967296.0L);
    ASSERT_LE(std::abs(error), 0.5L + 1e-6L) << static_cast<double>(x);
  }
}
TEST(Border, FloatAnglesRoundToNearest) { expect_nearest_angles<float>(); }
TEST(Border, DoubleAnglesRoundToNearest) { expect_nearest_angles<double>(); }

TEST(Border, ToRealIsNearest) {
  std::mt19937 random(20240923);
  for (int k = 0; k < 200000; ++k) {
    const auto raw = static_cast<std::int32_t>(random()) >> (k % 31);
    const Tau tau{{{raw}, {-raw}, {raw / 3}}};
    const auto in_float = to_real<float>(tau);
    const auto in_double = to_real<double>(tau);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(in_double[i], std::ldexp(static_cast<double>(tau[i].raw), -Tau::exponent(i)));
      EXPECT_EQ(in_float[i], static_cast<float>(in_double[i]));
    }
    const Positions<Turner, Fixed32> q{{{raw}}};
    const double radians = raw * unit_of_angle;
    EXPECT_NEAR(to_real<double>(q)[0], radians, 2.3e-16 * std::abs(radians));
    EXPECT_NEAR(static_cast<double>(to_real<float>(q)[0]), radians, 0x1.000002p-24 * std::abs(radians));
  }
  EXPECT_EQ(to_real<float>(Tau{})[0], 0.0F);
  EXPECT_EQ(to_real<double>(Positions<Turner, Fixed32>{{{std::numeric_limits<std::int32_t>::min()}}})[0], -M_PI);
}

TEST(Border, DoublesComeBackAsTheyWere) {
  std::mt19937 random(20240924);
  for (int k = 0; k < 100000; ++k) {
    const Positions<Turner, Fixed32> q{{{static_cast<std::int32_t>(random())}}};
    const auto back = to_fixed<Positions<Turner, Fixed32>>(to_real<double>(q));
    EXPECT_EQ(back.values[0].raw, q[0].raw);
  }
}

template <class T>
void expect_bad_values_named() {
  const T huge = std::numeric_limits<T>::max(), inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN(), tiny = std::numeric_limits<T>::denorm_min();
  const auto& raw = fixed_limits_of<R, std::int32_t>.joints;
  for (int i = 0; i < 3; ++i) {
    const auto q = [&](T x) {
      Joints<R, T> all{};
      all[i] = x;
      return to_fixed<Q>(all);
    };
    const auto qd = [&](T x) {
      Joints<R, T> all{};
      all[i] = x;
      return to_fixed<Qd>(all);
    };
    for (const T bad : {nan, -nan, inf, -inf}) {
      EXPECT_EQ(q(bad).status.code, Code::not_finite);
      EXPECT_EQ(qd(bad).status.code, Code::not_finite);
      EXPECT_EQ(qd(bad).status.joint, i);
      EXPECT_TRUE(raw[i].reaches(q(bad).values[i]));
    }
    EXPECT_EQ(qd(nan).values[i].raw, 0);
    for (const T far : {huge, inf}) {
      EXPECT_EQ(qd(far).values[i].raw, raw[i].speed.raw);
      EXPECT_EQ(qd(-far).values[i].raw, -raw[i].speed.raw);
    }
    for (const T bad : {huge, -huge, static_cast<T>(R::chain.links[i].position_max * 1.000001)}) {
      EXPECT_EQ(q(bad).status.code, Code::position_limit);
      EXPECT_EQ(q(bad).status.joint, i);
      EXPECT_TRUE(raw[i].reaches(q(bad).values[i]));
    }
    const T speed = static_cast<T>(R::chain.links[i].speed_limit);
    EXPECT_TRUE(qd(speed).status.ok());
    EXPECT_EQ(qd(speed).values[i].raw, raw[i].speed.raw);
    EXPECT_EQ(qd(std::nextafter(speed, huge)).status.code, Code::speed_limit);
    EXPECT_TRUE(qd(tiny).status.ok());
    EXPECT_EQ(qd(-tiny).values[i].raw, 0);
    EXPECT_TRUE(q(T(-0.0)).status.ok());
    for (const double limit : {R::chain.links[i].position_min, R::chain.links[i].position_max}) {
      const auto at = q(static_cast<T>(limit));
      EXPECT_TRUE(at.status.ok());
      EXPECT_TRUE(raw[i].reaches(at.values[i])) << "a limit as it is in T is inside, however it rounds";
    }
  }
}
TEST(Border, BadFloatsAreNamedAndSaturate) { expect_bad_values_named<float>(); }
TEST(Border, BadDoublesAreNamedAndSaturate) { expect_bad_values_named<double>(); }

TEST(Border, EveryPowerOfTwoIsASafeInput) {
  for (int e = -149; e < 128; ++e)
    for (const float sign : {1.0F, -1.0F}) {
      const float x = sign * std::ldexp(1.0F, e);
      const auto fixed = to_fixed<Qdd>(Joints<R, float>{x, x, x});
      for (int i = 0; i < 3; ++i) {
        const double limit = R::chain.links[i].acceleration_limit;
        const double expected = std::min(std::max(static_cast<double>(x), -limit), limit);
        EXPECT_NEAR(std::ldexp(static_cast<double>(fixed.values[i].raw), -Qdd::exponent(i)), expected,
                    std::ldexp(0.5, -Qdd::exponent(i)));
      }
      EXPECT_EQ(fixed.status.ok(), std::abs(x) <= 10.0F);
    }
}

TEST(Border, AnglesWithoutLimitsGoUpTo512Radians) {
  using P = Positions<Turner, Fixed32>;
  EXPECT_TRUE(to_fixed<P>(Joints<Turner, float>{512.0F}).status.ok());
  EXPECT_EQ(to_fixed<P>(Joints<Turner, float>{std::nextafter(512.0F, 1e9F)}).status.code, Code::position_limit);
  EXPECT_EQ(to_fixed<P>(Joints<Turner, float>{-1e30F}).status.code, Code::position_limit);
}

TEST(Border, AnArcMayPassHalfATurn) {
  using P = Positions<Backwards, Fixed32>;
  const auto& reach = fixed_limits_of<Backwards, std::int32_t>.joints[0];
  for (const double q : {2.0, 3.0, 3.2, 4.5})
    EXPECT_TRUE(reach.reaches(to_fixed<P>(Joints<Backwards, double>{q}).values[0])) << q;
  for (const double q : {1.9999, 4.5001, 0.0, -1.7})
    EXPECT_EQ(to_fixed<P>(Joints<Backwards, double>{q}).status.code, Code::position_limit) << q;
  EXPECT_EQ(to_fixed<P>(Joints<Backwards, double>{1.9}).values[0].raw, reach.min);
  EXPECT_EQ(to_fixed<P>(Joints<Backwards, double>{4.6}).values[0].raw, reach.max);
}

TEST(Border, ARequestHasTheStatusOfItsRealNumbers) {
  std::mt19937 random(20240925);
  const float odd[] = {0.0F, 1.0F, -3.0F, 30.0F, NAN, INFINITY, 0.2F};
  for (int k = 0; k < 20000; ++k) {
    Joints<R, float> q{}, qd{}, qdd{};
    for (auto* values : {&q, &qd, &qdd})
      for (float& x : values->values)
        x = odd[random() % 7];
    const Status expected = check_request<R>(q, qd, qdd);
    const auto request = to_fixed_request<R, std::int32_t>(q, qd, qdd);
    EXPECT_EQ(request.status.code, expected.code);
    EXPECT_EQ(request.status.joint, expected.joint);
    EXPECT_TRUE(check_request<R>(request.q, request.qd, request.qdd).ok()) << "what was saturated is inside";
  }
}

TEST(Border, SixteenBitsLikewise) {
  using V = Velocities<R, Fixed16>;
  const auto fixed = to_fixed<V>(Joints<R, float>{4.0F, -2.5F, 5.0F});
  EXPECT_EQ(fixed.status.code, Code::speed_limit);
  EXPECT_EQ(fixed.status.joint, 2);
  EXPECT_EQ(to_real<float>(fixed.values)[1], -2.5F);
  EXPECT_EQ(to_real<float>(fixed.values)[2], 1.0F);
}

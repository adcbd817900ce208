#include <gtest/gtest.h>
#include <axial/control/limits.hpp>
#include <axial/robot/chain.hpp>
#include <cmath>
#include <limits>
#include <vector>

using namespace axial;

namespace {

using Code = Status::Code;

struct Arm {
  static constexpr auto chain = axial::chain(
      revolute().mass(1).position_limits(-1.0, 2.0).speed_limit(3.0).acceleration_limit(4.0).effort_limit(5.0),
      prismatic().mass(1).position_limits(0.5, 0.75).speed_limit(0.25).acceleration_limit(8.0),
      axial::payload_limit(2.0, 0.5, 0.125));
};
using J = Joints<Arm, double>;

const J middle{0.5, 0.625}, still{};

template <class T>
Status check(int joint, double q, double qd, double qdd) {
  Joints<Arm, T> at{T(0.5), T(0.625)}, speed{}, acceleration{};
  at[joint] = T(q), speed[joint] = T(qd), acceleration[joint] = T(qdd);
  return check_request<Arm, T>(at, speed, acceleration);
}
double beyond(double limit) { return std::nextafter(limit, limit < 0 ? -INFINITY : INFINITY); }

}  // namespace

TEST(Limits, AreThoseOfTheLinks) {
  constexpr auto& first = limits_of<Arm, double>.joints[0];
  static_assert(first.position_min == -1.0 && first.position_max == 2.0 && first.speed == 3.0);
  static_assert(first.acceleration == 4.0 && first.effort == 5.0);
  constexpr auto& second = limits_of<Arm, float>.joints[1];
  static_assert(second.position_min == 0.5F && second.position_max == 0.75F && second.speed == 0.25F);
  static_assert(second.effort == std::numeric_limits<float>::max(), "undeclared: the largest number");
  SUCCEED();
}

TEST(Limits, EachIsCheckedInBothDirectionsAndNamesItsJoint) {
  struct Case {
    int joint;
    double q, qd, qdd;
    Code code;
  };
  const std::vector<Case> cases = {{0, 2.0, 3.0, 4.0, Code::ok},
                                   {0, -1.0, -3.0, -4.0, Code::ok},
                                   {1, 0.75, 0.25, 8.0, Code::ok},
                                   {1, 0.5, -0.25, -8.0, Code::ok},
                                   {0, beyond(2.0), 0, 0, Code::position_limit},
                                   {0, beyond(-1.0), 0, 0, Code::position_limit},
                                   {1, beyond(0.75), 0, 0, Code::position_limit},
                                   {1, 0.499, 0, 0, Code::position_limit},
                                   {0, 0, beyond(3.0), 0, Code::speed_limit},
                                   {0, 0, beyond(-3.0), 0, Code::speed_limit},
                                   {1, 0.6, beyond(-0.25), 0, Code::speed_limit},
                                   {0, 0, 0, beyond(4.0), Code::acceleration_limit},
                                   {0, 0, 0, beyond(-4.0), Code::acceleration_limit},
                                   {1, 0.6, 0, beyond(8.0), Code::acceleration_limit}};
  for (const Case& c : cases) {
    const Status status = check<double>(c.joint, c.q, c.qd, c.qdd);
    EXPECT_EQ(status.code, c.code) << c.joint << ": " << c.q << ' ' << c.qd << ' ' << c.qdd;
    EXPECT_EQ(status.joint, c.code == Code::ok ? -1 : c.joint);
  }
}

TEST(Limits, NotFiniteGoesBeforePositionSpeedAndAcceleration) {
  for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)}) {
    EXPECT_EQ(check<double>(1, bad, 9, 9).code, Code::not_finite);
    EXPECT_EQ(check<double>(1, 9, bad, 9).code, Code::not_finite);
    EXPECT_EQ(check<float>(1, 9, 9, bad).code, Code::not_finite);
  }
  EXPECT_EQ(check<double>(0, 9, 9, 9).code, Code::position_limit);
  EXPECT_EQ(check<double>(0, 0, 9, 9).code, Code::speed_limit);
}

TEST(Limits, NotFiniteIsFoundWhereItStandsAlone) {
  for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)})
    for (const int joint : {0, 1}) {
      const double q = joint == 0 ? 0.5 : 0.625;
      EXPECT_EQ(check<double>(joint, bad, 0, 0).code, Code::not_finite);
      EXPECT_EQ(check<double>(joint, q, bad, 0).code, Code::not_finite);
      EXPECT_EQ(check<double>(joint, q, 0, bad).code, Code::not_finite);
      EXPECT_EQ(check<float>(joint, q, 0, bad).joint, joint);
    }
}

namespace {

struct Turntable {
  static constexpr auto chain = axial::chain(revolute().mass(1), prismatic().mass(1));
};
struct Winch {
  static constexpr auto chain = axial::chain(revolute().mass(1).position_limits(-1e8, 900).accept(as_published));
};

template <class R, class T>
Status::Code at(T first, T second = T(0)) {
  Joints<R, T> q{};
  q[0] = first;
  if constexpr (Joints<R, T>::size > 1) q[1] = second;
  return check_request<R, T>(q, {}, {}).code;
}

}  // namespace

TEST(Limits, EndWhereSinesAreNoLongerExact) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ((at<Turntable, double>(sign * 524288.0)), Code::ok);
    EXPECT_EQ((at<Turntable, double>(sign * 524289.0)), Code::angle_range);
    EXPECT_EQ((at<Turntable, float>(static_cast<float>(sign) * 8192.0F)), Code::ok);
    EXPECT_EQ((at<Turntable, float>(static_cast<float>(sign) * 8193.0F)), Code::angle_range);
    EXPECT_EQ((at<Turntable, double>(0.0, sign * 1e12)), Code::ok) << "a slide is no angle";
  }
  EXPECT_EQ((at<Winch, double>(-1e7)), Code::angle_range) << "inside the declared limits";
  EXPECT_EQ((at<Winch, double>(-1e9)), Code::position_limit);
  EXPECT_EQ((at<Winch, double>(901.0)), Code::position_limit);
}

TEST(Limits, TheFirstOfTwoBadJointsIsNamed) {
  EXPECT_EQ((check_request<Arm>(J{9, 9}, still, still).joint), 0);
  EXPECT_EQ((check_request<Arm>(J{0.5, 9}, J{0, 9}, still).joint), 1);
}

TEST(ClampedRequest, OfRealNumbersIsTheNearestInEachQuantity) {
  const auto low = clamped_request<Arm>(J{-7, -7}, J{-7, -7}, J{-9, -9});
  EXPECT_EQ(low.q[0], -1.0);
  EXPECT_EQ(low.q[1], 0.5);
  EXPECT_EQ(low.qd[0], -3.0);
  EXPECT_EQ(low.qd[1], -0.25);
  EXPECT_EQ(low.qdd[0], -4.0);
  EXPECT_EQ(low.qdd[1], -8.0);
  EXPECT_EQ(low.status.code, Code::position_limit);
  const auto high = clamped_request<Arm>(middle, J{7, INFINITY}, J{9, 9});
  EXPECT_EQ(high.q[0], 0.5);
  EXPECT_EQ(high.q[1], 0.625);
  EXPECT_EQ(high.qd[0], 3.0);
  EXPECT_EQ(high.qd[1], 0.25);
  EXPECT_EQ(high.qdd[0], 4.0);
  EXPECT_EQ(high.qdd[1], 8.0);
  EXPECT_EQ(high.status.code, Code::speed_limit);
  EXPECT_EQ((clamped_request<Arm>(J{7, 7}, still, still).q[0]), 2.0);
  EXPECT_EQ((clamped_request<Arm>(J{7, 7}, still, still).q[1]), 0.75);
}

TEST(PayloadLimit, HoldsForEveryNumberOfIt) {
  const auto numbers = [](PayloadBody<double>& p) {
    auto& j = p.inertia_com;
    return std::vector<double*>{&p.mass, &p.com.x, &p.com.y, &p.com.z, &j.xx, &j.yy, &j.zz, &j.xy, &j.xz, &j.yz};
  };
  const double most[] = {2.0, 0.5, 0.5, 0.5, 0.125, 0.125, 0.125, 0.125, 0.125, 0.125};
  const double least[] = {0.0, -0.5, -0.5, -0.5, 0.0, 0.0, 0.0, -0.125, -0.125, -0.125};
  for (std::size_t k = 0; k < 10; ++k) {
    PayloadBody<double> load{};
    double& x = *numbers(load)[k];
    for (const double good : {most[k], least[k]}) {
      x = good;
      EXPECT_TRUE(check_payload<Arm>(load).ok()) << "number " << k << " is " << good;
    }
    for (const double bad :
         {most[k] * (1.0 + 1e-12), least[k] * (1.0 + 1e-12) - 1e-12, double(NAN), double(INFINITY)}) {
      x = bad;
      EXPECT_EQ(check_payload<Arm>(load).code, Code::payload_limit) << "number " << k << " is " << bad;
    }
  }
}

TEST(PayloadLimit, OfTheCentreIsADistance) {
  PayloadBody<double> load{};
  load.com = {0.3, 0.4, 0.0};
  EXPECT_TRUE(check_payload<Arm>(load).ok());
  load.com = {0.3, 0.4, 0.1};
  EXPECT_FALSE(check_payload<Arm>(load).ok());
}

TEST(Finite, IsWhatIsNeitherNaNNorInfinite) {
  for (const float x : {0.0F, -0.0F, 1e-45F, std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()})
    EXPECT_TRUE(is_finite(x)) << x;
  for (const double x : {0.0, 5e-324, std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()})
    EXPECT_TRUE(is_finite(x)) << x;
  for (const double x : {double(NAN), double(INFINITY), -double(INFINITY)}) {
    EXPECT_FALSE(is_finite(x)) << x;
    EXPECT_FALSE(is_finite(static_cast<float>(x))) << x;
  }
}

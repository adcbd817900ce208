// What the tests of gravity compensation and of tracking share: a robot with limits, in every number system.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

namespace safe_loop {

using axial::EffortsOf;
using axial::is_stored_v;
using axial::Joints;
using Code = axial::Status::Code;

/// A scene and the numbers that its loop runs on.
template <class Scene_, class Number>
struct Case {
  using S = Scene_;
  using R = axial::robot_of<S>;
  using T = Number;
  using Real = Joints<R, double>;
  using Tau = EffortsOf<S, T>;
  static constexpr int n = R::chain.size;
  static const axial::LinkParameters& link(int i) { return R::chain.links[i]; }

  /// A share of the range of each joint.
  static Real position(double share) {
    Real q{};
    for (int i = 0; i < n; ++i)
      q[i] = link(i).position_min + share * (link(i).position_max - link(i).position_min);
    return q;
  }
  /// A share of the largest speeds.
  static Real speed(double share) {
    Real qd{};
    for (int i = 0; i < n; ++i)
      qd[i] = (i % 2 == 0 ? share : -share) * link(i).speed_limit;
    return qd;
  }
  static axial::Request<S, T> request(const Real& q, const Real& qd = {}, const Real& qdd = {}) {
    if constexpr (is_stored_v<T>) {
      return axial::to_fixed_request<S, typename T::Word>(q, qd, qdd);
    } else {
      axial::Request<S, T> r;
      for (int i = 0; i < n; ++i)
        r.q[i] = static_cast<T>(q[i]), r.qd[i] = static_cast<T>(qd[i]), r.qdd[i] = static_cast<T>(qdd[i]);
      return r;
    }
  }
  static axial::MeasuredMotion<S, T> measured(const Real& q, const Real& qd = {}) {
    const auto r = request(q, qd);
    return {r.q, r.qd, r.status};
  }
  static auto place(const Real& q) { return request(q).q; }
  static Tau effort(const Real& tau) {
    if constexpr (is_stored_v<T>) {
      return axial::to_fixed<Tau>(tau).values;
    } else {
      Tau out{};
      for (int i = 0; i < n; ++i)
        out[i] = static_cast<T>(tau[i]);
      return out;
    }
  }
  static Real real(const Tau& tau) {
    Real out{};
    if constexpr (is_stored_v<T>) {
      out = axial::to_real<double>(tau);
    } else {
      for (int i = 0; i < n; ++i)
        out[i] = static_cast<double>(tau[i]);
    }
    return out;
  }
  static axial::TrackingGains<S, T> gains(const Real& stiffness, const Real& damping) {
    if constexpr (is_stored_v<T>) {
      const auto converted = axial::to_fixed_gains<S, typename T::Word>({stiffness, damping});
      EXPECT_TRUE(converted.status.ok()) << converted.status.joint;
      return converted.gains;
    } else {
      axial::TrackingGains<S, T> g;
      for (int i = 0; i < n; ++i)
        g.stiffness[i] = static_cast<T>(stiffness[i]), g.damping[i] = static_cast<T>(damping[i]);
      return g;
    }
  }
  /// A share of the effort limits.
  static Real efforts(double share) {
    Real tau{};
    for (int i = 0; i < n; ++i)
      tau[i] = share * link(i).effort_limit;
    return tau;
  }
  /// Roundings of an effort, N m or N.
  static double tolerance(int i) {
    const double effort = link(i).effort_limit;
    return effort * (std::is_same_v<T, double> ? 1e-13 : std::is_same_v<T, float> ? 2e-6 : 1e-6);
  }
  static void expect_near(const Real& found, const Real& wanted, const char* what) {
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(found[i], wanted[i], tolerance(i)) << what << ", joint " << i;
  }
  /// The bad numbers that this number system can be given as a position, of joint i.
  static auto bad_positions(int i) {
    const double low = link(i).position_min, high = link(i).position_max;
    std::vector<double> bad{high + 0.05, low - 0.05};
    if (!is_stored_v<T>)
      for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(), 1e30})
        bad.push_back(x);
    return bad;
  }
};

inline void expect_status(const axial::Status& status, Code code, int joint) {
  EXPECT_EQ(static_cast<int>(status.code), static_cast<int>(code));
  EXPECT_EQ(status.joint, joint);
}

}  // namespace safe_loop

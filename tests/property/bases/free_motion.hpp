// What a user integrates for a robot on a free body: pose and velocity of frame 0, positions and speeds of the joints.
#pragma once

#include <axial/axial.hpp>
#include <oracle/algebra.hpp>

namespace property {

/// Orientation of frame 0 in the world as a quaternion, position and velocity of its origin in the world, angular
/// velocity in axes of frame 0.
template <class R>
struct FlightState {
  double orientation[4] = {1.0, 0.0, 0.0, 0.0};
  oracle::Vec3<double> position{}, velocity{}, angular_velocity{};
  axial::Joints<R, double> q{}, qd{};
};

/// Energy, and momentum linear and angular (about the world's origin).
struct Totals {
  double energy = 0.0;
  oracle::Vec3<double> linear{}, angular{};
};

inline double norm(const oracle::Vec3<double>& v) { return std::sqrt(oracle::dot(v, v)); }
/// |a - b| / |b|.
inline double distance(const oracle::Vec3<double>& a, const oracle::Vec3<double>& b) { return norm(a - b) / norm(b); }

template <class R>
oracle::Mat3<double> rotation(const FlightState<R>& x) {
  const auto& [w, i, j, k] = x.orientation;
  return {{1 - 2 * (j * j + k * k), 2 * (i * j + w * k), 2 * (i * k - w * j)},
          {2 * (i * j - w * k), 1 - 2 * (i * i + k * k), 2 * (j * k + w * i)},
          {2 * (i * k + w * j), 2 * (j * k - w * i), 1 - 2 * (i * i + j * j)}};
}

inline axial::Vec3<double> to_axial(const oracle::Vec3<double>& v) { return {v.x, v.y, v.z}; }
inline oracle::Vec3<double> to_oracle(const axial::Vec3<double>& v) { return {v.x, v.y, v.z}; }

/// Its rate of change when no joint is driven.
template <class S, class R>
FlightState<R> rate(const FlightState<R>& x, const oracle::Vec3<double>& gravity) {
  const auto turn = rotation(x);
  axial::Inputs<S, double> in;
  in.base_motion.angular_velocity = to_axial(x.angular_velocity);
  if constexpr (S::template has<axial::RuntimeGravity>) in.gravity = to_axial(oracle::transpose(turn) * gravity);
  if constexpr (S::template has<axial::VelocityThroughWater>)
    in.velocity_through_water = to_axial(oracle::transpose(turn) * x.velocity);
  const auto a = axial::forward_dynamics<S>(x.q, x.qd, axial::Joints<R, double>{}, in);
  FlightState<R> d;
  const auto& [w, i, j, k] = x.orientation;
  const auto& o = x.angular_velocity;
  d.orientation[0] = 0.5 * (-i * o.x - j * o.y - k * o.z);
  d.orientation[1] = 0.5 * (w * o.x + j * o.z - k * o.y);
  d.orientation[2] = 0.5 * (w * o.y + k * o.x - i * o.z);
  d.orientation[3] = 0.5 * (w * o.z + i * o.y - j * o.x);
  d.position = x.velocity;
  d.velocity = turn * to_oracle(a.base_acceleration.linear);
  d.angular_velocity = to_oracle(a.base_acceleration.angular);
  d.q = x.qd, d.qd = a;
  return d;
}

/// x + h d.
template <class R>
FlightState<R> moved(FlightState<R> x, const FlightState<R>& d, double h) {
  for (int i = 0; i < 4; ++i)
    x.orientation[i] += h * d.orientation[i];
  x.position = x.position + h * d.position;
  x.velocity = x.velocity + h * d.velocity;
  x.angular_velocity = x.angular_velocity + h * d.angular_velocity;
  for (int i = 0; i < axial::joint_count<R>; ++i)
    x.q[i] += h * d.q[i], x.qd[i] += h * d.qd[i];
  return x;
}

/// One step of the classical Runge-Kutta method of fourth order.
template <class S, class R>
FlightState<R> rk4(const FlightState<R>& x, const oracle::Vec3<double>& gravity, double h) {
  const auto a = rate<S>(x, gravity), b = rate<S>(moved(x, a, h / 2), gravity),
             c = rate<S>(moved(x, b, h / 2), gravity), d = rate<S>(moved(x, c, h), gravity);
  auto next = moved(moved(moved(moved(x, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
  double length = 0.0;
  for (const double e : next.orientation)
    length += e * e;
  for (double& e : next.orientation)
    e /= std::sqrt(length);
  return next;
}

}  // namespace property

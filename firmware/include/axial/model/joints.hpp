// One value a joint.
#pragma once

#include <axial/model/scene.hpp>

namespace axial {

/// N values, one a joint, from the base outwards. A plain aggregate: `Joints<Robot, float> q{0.1F, 0.2F}`.
template <class S, class T>
struct Joints {
  static constexpr int size = joint_count<S>;
  T values[size];

  constexpr T& operator[](int i) { return values[i]; }
  constexpr const T& operator[](int i) const { return values[i]; }
};

/// Roles: rad or m; rad/s or m/s; rad/s^2 or m/s^2; N m or N.
template <class S, class T>
using Positions = Joints<S, T>;
template <class S, class T>
using Velocities = Joints<S, T>;
template <class S, class T>
using Accelerations = Joints<S, T>;
template <class S, class T>
using Efforts = Joints<S, T>;

/// Joint values that are zero by type: a query that leaves them out does not pay for them.
struct NoMotion {
  constexpr Zero operator[](int) const { return {}; }
};

}  // namespace axial

// What the payload estimator rounds to: nothing in floating point; in fixed point formats from the declared limits.
#pragma once

#include <axial/dynamics/kinematics.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Says what the estimator does not weigh under, and by which numbers not.
template <class Scene>
constexpr auto check_weighed() {
  static_assert(Scene::template has<Gravity> && !Scene::template has<RuntimeGravity>,
                "axial: a payload is weighed under the gravity that the chain declares; name Gravity in the scene");
}
template <class T>
constexpr auto check_weighing() {
  static_assert(!std::is_same_v<T, Fixed16>, "axial: the payload estimator takes Fixed32, float or double");
}

/// Gravity of a robot in world axes, m/s^2.
template <class S>
constexpr Vec3<double> world_gravity() {
  check_weighed<scene_of<S>>();
  constexpr const auto& chain = robot_of<S>::chain;
  const auto& r = chain.base.pose.rotation;
  const double x = chain.gravity.x, y = chain.gravity.y, z = chain.gravity.z;
  return {r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z};
}

/// Per unit of mass (kg) and of first moment (kg m, axes of the last link): the payload's row of one joint. In fixed
/// point words at the exponents of ColumnRounding.
template <class T>
struct PayloadRow {
  T of[4] = {};
};

/// How payload columns are read and rounded: as they are.
template <class S, class T>
struct ColumnRounding {
  using Number = T;  ///< of all vectors
  template <class Q>
  static constexpr const Q& direction(const Q& x) {
    return x;
  }
  template <class Q>
  static constexpr const Q& way(const Q& x) {
    return x;
  }
  static constexpr const T& speed(const Velocities<robot_of<S>, T>& qd, int i) { return qd[i]; }
  static constexpr Vec3<T> gravity() {
    constexpr Vec3<double> g = world_gravity<S>();
    using N = NumberTraits<T>;
    return {N::constant(g.x), N::constant(g.y), N::constant(g.z)};
  }
  using Turning = Vec3<T>;  ///< angular velocities
  using Moving = Vec3<T>;   ///< linear ones
  struct Same {
    template <class X>
    constexpr const X& operator()(const X& x) const {
      return x;
    }
  };
  static constexpr Same turning{}, moving{}, slope{}, momentum_along{}, momentum_across{}, drift_along{},
      drift_across{};
  static constexpr PayloadRow<T> row(const T& mass, const Vec3<T>& moment) {
    return {{mass, moment.x, moment.y, moment.z}};
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>

// A run-time chain: nothing but data, in the oracle's number types.
#pragma once

#include <oracle/algebra.hpp>

namespace oracle {

enum class Joint { revolute, prismatic };

/// A link in SI units and radians. Pose in its parent: Rz(gamma) Tz(b) Rx(alpha) Tx(a) Rz(theta) Tz(d), where theta + q
/// (revolute) or d + q (prismatic) holds the joint variable. Friction acts on the joint side.
template <class T>
struct Link {
  Joint type = Joint::revolute;
  int parent = -1;  ///< index of the link that carries the joint; -1: frame 0
  T alpha{}, a{}, d{}, theta{};
  T gamma{}, b{};  ///< a branch of a tree; 0 in serial chains
  T mass{};
  Vec3<T> com{};      ///< in the link's frame
  Mat3<T> inertia{};  ///< about the centre of mass, axes of the link's frame
  T rotor_inertia{};  ///< on the motor side; gear^2 rotor_inertia is added to the joint
  T gear{T(1)};
  T viscous{};
  T coulomb_forward{}, coulomb_backward{};  ///< friction torque for qd > 0 (>= 0) and for qd < 0 (<= 0)
  T static_friction{}, stribeck_speed{};    ///< breakaway torque in either direction (0: none), speed of half the fall
  T smooth_speed{};                         ///< below which dry friction goes to 0 by a cubic (0: a step)
  T spring_stiffness{}, spring_rest{};
};

template <class T>
struct Chain {
  std::vector<Link<T>> links;  ///< a parent stands before its children; the last link carries the tool
  Vec3<T> gravity{};           ///< acceleration of free fall in axes of frame 0
  Pose<T> base{}, tool{};      ///< frame 0 in the root frame; tool in the last link's frame

  int size() const { return static_cast<int>(links.size()); }
  const Link<T>& operator[](int i) const { return links[std::size_t(i)]; }
  /// Whether joint j moves link i.
  bool moves(int j, int i) const {
    while (i > j)
      i = (*this)[i].parent;
    return i == j;
  }
};

/// Symmetric matrix of tensor entries.
template <class T>
Mat3<T> symmetric(T xx, T yy, T zz, T xy, T xz, T yz) {
  return {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
}

template <class T>
Chain<T> without_rotors(Chain<T> chain) {
  for (auto& link : chain.links)
    link.rotor_inertia = T(0);
  return chain;
}

/// Force and moment that the environment exerts on the last link, in that link's axes, about its origin.
template <class T>
struct Wrench {
  Vec3<T> force{}, moment{};
};

/// What acts on a chain besides gravity and the motors.
template <class T>
struct Load {
  bool friction = false;
  Wrench<T> tip{};
  bool springs = false;
  std::vector<Wrench<T>> links{};  ///< on every link, in its axes, about its origin; empty: none
};

}  // namespace oracle

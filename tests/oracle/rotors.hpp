// Rotors as bodies of their own: every rotor is one more link of the chain, about its axis on its carrier, and turns
// gear times as fast as its joint. Power then says what the drives exert.
#pragma once

#include <oracle/lagrange.hpp>

namespace oracle {

/// Where a rotor turns: about the z axis behind Rz(gamma) Rx(alpha) in the frame of its carrier; -1: frame 0.
template <class T>
struct RotorAxis {
  int carrier = -1;
  T gamma{}, alpha{};
};

/// A joint's own axis, on its parent.
template <class T>
RotorAxis<T> own_axis(const Link<T>& link) {
  return {link.parent, link.gamma, link.alpha};
}

/// A chain of n links with a body for each rotor behind them. The carriers' declared inertias hold J about the axis
/// already, which the bodies bring again: it is taken off.
template <class T>
class RotorChain {
 public:
  RotorChain(const Chain<T>& chain, const Vector<RotorAxis<T>>& axes)
      : n_(chain.size()), bodies_(without_rotors(chain)) {
    for (int i = 0; i < n_; ++i) {
      const T J = chain[i].rotor_inertia;
      const auto& axis = axes[std::size_t(i)];
      Link<T> rotor;
      rotor.parent = axis.carrier, rotor.gamma = axis.gamma, rotor.alpha = axis.alpha;
      rotor.inertia = symmetric(T(0), T(0), J, T(0), T(0), T(0));
      bodies_.links.push_back(rotor);
      gears_.push_back(chain[i].gear);
      if (axis.carrier >= 0) take_off(bodies_.links[std::size_t(axis.carrier)].inertia, J, axis);
    }
  }
  const Chain<T>& bodies() const { return bodies_; }

  /// Joint values with those of the rotors behind them.
  Vector<T> all(Vector<T> x) const {
    for (int i = 0; i < n_; ++i)
      x.push_back(gears_[std::size_t(i)] * x[std::size_t(i)]);
    return x;
  }
  /// What the drives exert where the joints of all bodies exert tau: qd . tau is the power of both.
  Vector<T> drives(const Vector<T>& tau) const {
    Vector<T> result(tau.begin(), tau.begin() + n_);
    for (int i = 0; i < n_; ++i)
      result[std::size_t(i)] += gears_[std::size_t(i)] * tau[std::size_t(n_ + i)];
    return result;
  }
  Vector<T> efforts(const Vector<T>& q, const Vector<T>& qd, const Vector<T>& qdd) const {
    return drives(inverse_dynamics(bodies_, all(q), all(qd), all(qdd)));
  }
  /// Its columns are the drives' efforts at unit accelerations.
  Matrix<T> mass(const Vector<T>& q) const {
    const auto m = mass_matrix(bodies_, all(q));
    Matrix<T> result(n_, n_);
    for (int j = 0; j < n_; ++j) {
      Vector<T> unit(std::size_t(n_), T(0));
      unit[std::size_t(j)] = T(1);
      const auto column = drives(m * all(unit));
      for (int i = 0; i < n_; ++i)
        result(i, j) = column[std::size_t(i)];
    }
    return result;
  }
  T energy(const Vector<T>& q, const Vector<T>& qd) const { return kinetic_energy(bodies_, all(q), all(qd)); }

 private:
  static void take_off(Mat3<T>& inertia, T J, const RotorAxis<T>& axis) {
    T sa, ca, sg, cg;
    sincos_of_constant(axis.alpha, sa, ca);
    sincos_of_constant(axis.gamma, sg, cg);
    const Vec3<T> z{sg * sa, -(cg * sa), ca};
    inertia = inertia - Mat3<T>{J * z.x * z, J * z.y * z, J * z.z * z};
  }

  int n_;
  Chain<T> bodies_;
  Vector<T> gears_;
};

}  // namespace oracle

// What water adds to a chain, from Lagrange's equations: the kinetic energy of the water that moves with the links, the
// potential of buoyancy, and drag through the Jacobians.
#pragma once

#include <oracle/lagrange.hpp>

namespace oracle {

/// Water about one link, in its axes, diagonals about the centre of buoyancy.
template <class T>
struct Water {
  Vec3<T> mass{}, inertia{}, centre{};
  T displaced{};
  Vec3<T> drag{}, turning_drag{}, drag2{}, turning_drag2{};
};

/// The water about every link of a chain.
template <class T>
class SubmergedChain {
 public:
  SubmergedChain(const Chain<T>& chain, const Vector<Water<T>>& waters) : chain_(chain), waters_(waters) {}

  /// sum_k Jv^T R A R^T Jv + Jw^T R B R^T Jw.
  Matrix<T> added_mass(const Vector<T>& q) const {
    const int n = chain_.size();
    Matrix<T> M(n, n);
    for (int k = 0; k < n; ++k) {
      const auto J = columns(q, k);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          M(i, j) += dot(J.linear[at(i)], scaled(waters_[at(k)].mass, J.linear[at(j)])) +
                     dot(J.angular[at(i)], scaled(waters_[at(k)].inertia, J.angular[at(j)]));
    }
    return M;
  }
  /// Torque that moves the water, holds against buoyancy and overcomes drag.
  Vector<T> torque(const Vector<T>& q, const Vector<T>& qd, const Vector<T>& qdd) const {
    Vector<T> tau = added_mass(q) * qdd;
    add_coriolis(tau, q, qd);
    for (int k = 0; k < chain_.size(); ++k)
      add_forces(tau, k, q, qd);
    return tau;
  }
  T kinetic_energy(const Vector<T>& q, const Vector<T>& qd) const {
    const Vector<T> momentum = added_mass(q) * qd;
    T twice(0);
    for (std::size_t i = 0; i < qd.size(); ++i)
      twice += momentum[i] * qd[i];
    return twice / T(2);
  }
  /// Of buoyancy, zero at the origin of frame 0.
  T potential_energy(const Vector<T>& q) const {
    const auto poses = link_poses(chain_, q);
    T energy(0);
    for (int k = 0; k < chain_.size(); ++k)
      energy += waters_[at(k)].displaced *
                dot(chain_.gravity, poses[at(k)].rotation * waters_[at(k)].centre + poses[at(k)].position);
    return energy;
  }

 private:
  struct Columns {
    std::vector<Vec3<T>> linear, angular;  ///< of the centre of buoyancy, in the link's axes
  };
  static std::size_t at(int i) { return std::size_t(i); }
  static Vec3<T> scaled(const Vec3<T>& a, const Vec3<T>& v) { return {a.x * v.x, a.y * v.y, a.z * v.z}; }
  static T resisted(T linear, T quadratic, T speed) { return (linear + quadratic * abs(speed)) * speed; }
  static Vec3<T> resisted(const Vec3<T>& l, const Vec3<T>& q, const Vec3<T>& v) {
    return {resisted(l.x, q.x, v.x), resisted(l.y, q.y, v.y), resisted(l.z, q.z, v.z)};
  }

  Columns columns(const Vector<T>& q, int k) const {
    const auto poses = link_poses(chain_, q);
    const Mat3<T> own = transpose(poses[at(k)].rotation);
    const Vec3<T> point = poses[at(k)].rotation * waters_[at(k)].centre + poses[at(k)].position;
    Columns J;
    for (int j = 0; j < chain_.size(); ++j) {
      const bool moves = chain_.moves(j, k), turns = chain_[j].type == Joint::revolute;
      const Vec3<T> axis = moves ? poses[at(j)].rotation.c2 : Vec3<T>{};
      J.linear.push_back(own * (turns ? cross(axis, point - poses[at(j)].position) : axis));
      J.angular.push_back(own * (turns ? axis : Vec3<T>{}));
    }
    return J;
  }
  /// Christoffel's symbols by central differences: in quad their error is 1e-18.
  void add_coriolis(Vector<T>& tau, const Vector<T>& q, const Vector<T>& qd) const {
    const T step = T(1e-9);
    const int n = chain_.size();
    for (int l = 0; l < n; ++l) {
      Vector<T> more = q, less = q;
      more[at(l)] += step, less[at(l)] -= step;
      const Matrix<T> high = added_mass(more), low = added_mass(less);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const T slope = (high(i, j) - low(i, j)) / (step + step);
          tau[at(i)] += slope * qd[at(j)] * qd[at(l)];
          tau[at(l)] -= slope * qd[at(i)] * qd[at(j)] / T(2);
        }
    }
  }
  void add_forces(Vector<T>& tau, int k, const Vector<T>& q, const Vector<T>& qd) const {
    const Water<T>& water = waters_[at(k)];
    const Columns J = columns(q, k);
    Vec3<T> u{}, w{};
    for (std::size_t j = 0; j < qd.size(); ++j)
      u = u + qd[j] * J.linear[j], w = w + qd[j] * J.angular[j];
    const Vec3<T> gravity = transpose(link_poses(chain_, q)[at(k)].rotation) * chain_.gravity;
    const Vec3<T> force = resisted(water.drag, water.drag2, u) + water.displaced * gravity;
    const Vec3<T> moment = resisted(water.turning_drag, water.turning_drag2, w);
    for (std::size_t j = 0; j < qd.size(); ++j)
      tau[j] += dot(J.linear[j], force) + dot(J.angular[j], moment);
  }

  Chain<T> chain_;
  Vector<Water<T>> waters_;
};

/// A copy of what a robot's description declares.
template <class T, class Parameters>
Water<T> water_from_axial(const Parameters& p) {
  const auto vector = [](const double* v) { return Vec3<T>{T(v[0]), T(v[1]), T(v[2])}; };
  return {vector(p.added_mass),  vector(p.added_inertia),   vector(p.centre),         T(p.displaced_mass),
          vector(p.drag_linear), vector(p.drag_linear + 3), vector(p.drag_quadratic), vector(p.drag_quadratic + 3)};
}

}  // namespace oracle

// What joints feel at a few positions, spread evenly: what formats are made for where the least that any position could
// bring is far smaller. A joint that feels less has a status (`FormatRounding::resisting`).
#pragma once

#include <axial/fixed/bounds/account.hpp>
#include <axial/recursion/reflection.hpp>
#include <axial/scalar/sincos.hpp>
#include <axial/spatial/articulated_congruence.hpp>
#include <axial/spatial/congruence.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// One number per joint or drive; SI where it is none of words.
template <int N, class Number = double>
struct PerJoint {
  Number of[N] = {};
};
/// What `get` has for each.
template <int N, class Get>
constexpr auto per_joint(const Get& get) {
  PerJoint<N, decltype(get(0))> all;
  for (int i = 0; i < N; ++i)
    all.of[i] = get(i);
  return all;
}

using PlainInertia = ArticulatedInertia<Sym3<double>, Mat3<Vec3<double>>, Sym3<double>>;

/// Inertia of a link as it is declared, without payload: the least that the link can have.
constexpr PlainInertia own_inertia(const TreeLinkConstants<double>& c) {
  return articulated(
      RigidInertia{c.mass, Vec3<double>{c.hx, c.hy, c.hz}, Sym3<double>{c.jxx, c.jyy, c.jzz, c.jxy, c.jxz, c.jyz}});
}

/// I - U U^T / D, U the column of the joint's axis; D is what the joint feels.
constexpr PlainInertia reflected_inertia(const PlainInertia& i, bool slides, double d) {
  const auto u = slides ? joint_column(Prismatic{}, i) : joint_column(Revolute{}, i);
  const double s = d > 0.0 ? 1.0 / d : 0.0;
  const MotionVector k{s * u.angular, s * u.linear};
  const auto row = [&u](const Vec3<double>& r, double along) { return r - along * u.linear; };
  const Mat3<Vec3<double>>& h = i.coupling;
  return {reduced(Plain{}, quantity::RotationalInertia{}, i.angular, k.angular, u.angular),
          {row(h.x, k.angular.x), row(h.y, k.angular.y), row(h.z, k.angular.z)},
          reduced(Plain{}, quantity::Mass{}, i.linear, k.linear, u.linear)};
}

/// A link's inertia in the parent's frame, the joint at `angle` (rad) and `along` (m).
constexpr PlainInertia at_parent(const TreeLinkConstants<double>& c, const PlainInertia& i, double angle,
                                 double along) {
  const auto turn = sincos(angle);
  const double cos = c.prismatic ? c.cos_theta : turn.cos, sin = c.prismatic ? c.sin_theta : turn.sin;
  const PlainInertia at_axis = to_parent(z_screw(cos, sin, along), i);
  const PlainInertia behind = to_parent(x_screw(c.cos_alpha, c.sin_alpha, c.a), at_axis);
  return to_parent(z_screw(c.branch.cos_gamma, c.branch.sin_gamma, c.branch.b), behind);
}

/// Place number k of joint i in [0, 1): multiples of a square root per joint, which spread evenly and independently.
constexpr double place(int k, int i) {
  constexpr double primes[] = {2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0};
  const int lap = i / 8;
  const double x = (k + 1) * square_root(primes[i % 8]) + 0.37 * lap;
  return x - static_cast<double>(static_cast<int>(x));
}

/// The least inertia that each joint feels, its rotor included, at a few positions.
template <int N>
constexpr PerJoint<N> usual_inertia(const Mechanism<N>& m) {
  constexpr int positions = 16;
  PerJoint<N> least;
  for (int k = 0; k < positions; ++k) {
    PlainInertia all[N] = {};
    for (int i = N; i-- > 0;) {
      const auto& c = m.links[i];
      all[i] = all[i] + own_inertia(c);
      const double d = (c.prismatic ? all[i].linear.zz : all[i].angular.zz) + (m.loads.rotors ? c.rotor : 0.0);
      least.of[i] = k == 0 || d < least.of[i] ? d : least.of[i];
      if (m.parent(i) < 0) continue;
      const double x = place(k, i), along = c.prismatic ? (2.0 * x - 1.0) * m.joints[i].travel : c.d;
      PlainInertia& up = all[m.parent(i)];
      up = up + at_parent(c, reflected_inertia(all[i], c.prismatic, d), 6.283185307179586 * x, along);
    }
  }
  return least;
}

}  // namespace axial::detail

#include <axial/options/end.hpp>

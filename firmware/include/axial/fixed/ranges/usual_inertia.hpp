// What joints feel at a few positions, spread evenly: what formats are made for where the least that any position could
// bring is far smaller. A joint that feels less has a status (`FormatRounding::resisting`).
#pragma once

#include <axial/fixed/bounds/account.hpp>
#include <axial/scalar/sincos.hpp>
#include <axial/spatial/articulated_congruence.hpp>
#include <axial/spatial/branch_screw.hpp>

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
  const auto& h = i.coupling;
  const Vec3<double> n =
      slides ? Vec3<double>{h.x.z, h.y.z, h.z.z} : Vec3<double>{i.angular.xz, i.angular.yz, i.angular.zz};
  const Vec3<double> f = slides ? Vec3<double>{i.linear.xz, i.linear.yz, i.linear.zz} : h.z;
  const double s = d > 0.0 ? 1.0 / d : 0.0;
  const auto less = [s](const Sym3<double>& m, const Vec3<double>& v) {
    return Sym3<double>{m.xx - s * v.x * v.x, m.yy - s * v.y * v.y, m.zz - s * v.z * v.z,
                        m.xy - s * v.x * v.y, m.xz - s * v.x * v.z, m.yz - s * v.y * v.z};
  };
  const auto row = [s, &f](const Vec3<double>& r, double u) {
    return Vec3<double>{r.x - s * u * f.x, r.y - s * u * f.y, r.z - s * u * f.z};
  };
  return {less(i.angular, n), {row(h.x, n.x), row(h.y, n.y), row(h.z, n.z)}, less(i.linear, f)};
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

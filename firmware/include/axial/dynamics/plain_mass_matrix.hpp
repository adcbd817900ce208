// M(q) by plain loops over plain numbers, for compilers that evaluate it.
#pragma once

#include <axial/dynamics/mass_matrix.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Mass matrix of a looped scene, every rounding as in mass_matrix(), for constants of the compiler. There each call
/// and each structure that is passed costs time and memory that nobody gives back; here are hardly any, a quarter of
/// both. Entries are those of joints on one path to the base.
template <class Scene, class T>
class PlainMassMatrix {
  static constexpr int n = Scene::Robot::chain.size;

 public:
  /// At q (rad or m), with the payload that `in` carries where the scene names one.
  template <class Input>
  constexpr PlainMassMatrix(const Positions<robot_of<Scene>, T>& q, const Input& in) {
    const auto links = links_of<Scene, T, BaseParameters, recursion::CompositeBodies>();
    T bodies[n][size] = {};
    for (int i = 0; i < n; ++i) {
      const auto& row = links.link(i).row;
      place(row, q[i], i);
      put(row.mass, Vec3{row.hx, row.hy, row.hz}, Sym3{row.jxx, row.jyy, row.jzz, row.jxy, row.jxz, row.jyz},
          bodies[i]);
    }
    if constexpr (Scene::template has<Payload>) {
      const auto body = crba::own_body(links, TipLoads<Scene, Input>(in), n - 1);
      put(body.mass, body.first_moment, body.inertia, bodies[n - 1]);
    }
    for (int i = n; i-- > 0;) {
      carry(cosine_[i], sine_[i], shift_[i], about_z, bodies[i]);
      climb(links, bodies[i], i);
      const int parent = links.parent_index(i);
      if (parent < 0) continue;
      const auto& row = links.link(i).row;
      carry(row.cos_alpha, row.sin_alpha, row.a, about_x, bodies[i]);
      if constexpr (decltype(links.link(0))::branches)
        if (row.branches()) carry(row.branch.cos_gamma, row.branch.sin_gamma, row.branch.b, about_z, bodies[i]);
      for (int k = 0; k < size; ++k)
        bodies[parent][k] = bodies[parent][k] + bodies[i][k];
    }
  }
  constexpr T operator()(int i, int j) const { return entries_[i][j]; }  ///< entry (i, j), j not outboard of i

 private:
  static constexpr int size = 10;  ///< of a body: mass, first moment, then xx, yy, zz, xy, xz, yz
  /// Where a body or a force has what a screw along z calls by that name.
  struct Axis {
    int x, y, z, xx, yy, zz, xy, xz, yz;
  };
  static constexpr Axis about_z{1, 2, 3, 4, 5, 6, 7, 8, 9}, about_x{2, 3, 1, 5, 6, 4, 9, 7, 8};

  template <class Row>
  constexpr void place(const Row& row, const T& q, int i) {
    prismatic_[i] = row.prismatic;
    if (row.prismatic) {
      cosine_[i] = row.cos_theta, sine_[i] = row.sin_theta, shift_[i] = row.d + q;
    } else {
      const auto turn = sincos(q);
      cosine_[i] = row.cos_theta * turn.cos - row.sin_theta * turn.sin;
      sine_[i] = row.sin_theta * turn.cos + row.cos_theta * turn.sin, shift_[i] = row.d;
    }
  }
  template <class M, class H, class J>
  static constexpr void put(const M& mass, const H& h, const J& j, T (&to)[size]) {
    to[0] = T(mass), to[1] = T(h.x), to[2] = T(h.y), to[3] = T(h.z);
    to[4] = T(j.xx), to[5] = T(j.yy), to[6] = T(j.zz), to[7] = T(j.xy), to[8] = T(j.xz), to[9] = T(j.yz);
  }
  /// A body from beyond a screw to before it: congruence.hpp.
  static constexpr void carry(T c, T s, T shift, const Axis& at, T (&b)[size]) {
    const T hx = b[at.x], hy = b[at.y], hz = b[at.z], xx = b[at.xx], yy = b[at.yy], xy = b[at.xy], xz = b[at.xz],
            yz = b[at.yz], ss = s * s, sc = s * c, difference = xx - yy;
    const T x = c * hx - s * hy, y = s * hx + c * hy, z = hz + shift * b[0], growth = shift * (hz + z);
    const T k1 = difference * ss + xy * (sc + sc);
    b[at.x] = x, b[at.y] = y, b[at.z] = z;
    b[at.xx] = xx - k1 + growth, b[at.yy] = yy + k1 + growth, b[at.xy] = difference * sc + xy * (T(1) - ss - ss);
    b[at.xz] = c * xz - s * yz - shift * x, b[at.yz] = s * xz + c * yz - shift * y;
  }
  /// A force from beyond a screw to before it: the moment in places 1 to 3 of f, the force in 4 to 6.
  static constexpr void carry_force(T c, T s, T shift, const Axis& at, T (&f)[7]) {
    const T fx = f[at.x + 3], fy = f[at.y + 3], x = f[at.x] - fy * shift, y = f[at.y] + fx * shift;
    f[at.x] = c * x - s * y, f[at.y] = s * x + c * y;
    f[at.x + 3] = c * fx - s * fy, f[at.y + 3] = s * fx + c * fy;
  }
  /// The row of joint i from its composite body beyond the joint.
  template <class Links>
  constexpr void climb(const Links& links, const T (&b)[size], int i) {
    T f[7] = {};
    if (prismatic_[i])
      f[1] = b[2], f[2] = -b[1], f[6] = b[0];
    else
      f[1] = b[8], f[2] = b[9], f[3] = b[6], f[4] = -b[2], f[5] = b[1];
    entries_[i][i] = f[prismatic_[i] ? 6 : 3] + T(links.link(i).rotor());
    for (int k = i, parent = links.parent_index(i); parent >= 0; k = parent, parent = links.parent_index(k)) {
      if (k != i) carry_force(cosine_[k], sine_[k], shift_[k], about_z, f);
      const auto& row = links.link(k).row;
      carry_force(row.cos_alpha, row.sin_alpha, row.a, about_x, f);
      if constexpr (decltype(links.link(0))::branches)
        if (row.branches()) carry_force(row.branch.cos_gamma, row.branch.sin_gamma, row.branch.b, about_z, f);
      entries_[i][parent] = f[prismatic_[parent] ? 6 : 3];
    }
  }

  T cosine_[n] = {}, sine_[n] = {}, shift_[n] = {};
  bool prismatic_[n] = {};
  T entries_[n][n] = {};
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

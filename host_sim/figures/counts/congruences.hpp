// Three ways to carry a reflected inertia N across a joint and its twist, X^T N X: ours and what it is compared with.
// Each has `name` and `to_parent<T>(x, z, n)` over any number system.
#pragma once

#include <axial/spatial/articulated_congruence.hpp>
#include <axial/spatial/congruence.hpp>

#include <array>

namespace counts {

/// The library's: two axial screws, one after the other.
struct AxialScrews {
  static constexpr const char* name = "successive axial screws";
  template <class T, class X, class Z, class N>
  static auto to_parent(const X& x, const Z& z, const N& n) {
    return axial::to_parent(x, axial::to_parent(z, n));
  }
};

/// One screw with a general translation p: the 3x3 blocks are turned about z and about x, then shifted at once. The
/// first draft of McMillan and Orin 1995, [89M, 90A]. With L = R N22 R^T, D = R N12 R^T, E = p~ L: the coupling is
/// D + E, the angular block R N11 R^T + E p~^T + D p~^T + (D p~^T)^T.
struct PlanarRotations {
  static constexpr const char* name = "one screw, planar rotations";
  template <class T, class X, class Z, class N>
  static auto to_parent(const X& x, const Z& z, const N& n) {
    using namespace axial;
    const auto turned = [&](const auto& block) { return axial::to_parent(x, axial::to_parent(z, block)); };
    auto b = turned(n.angular);
    auto d = turned(n.coupling);
    auto l = turned(n.linear);
    auto p = translation(x) + axial::to_parent(x, along_z(z.shift));
    const Vec3 l1{l.xx, l.xy, l.xz}, l2{l.xy, l.yy, l.yz}, l3{l.xz, l.yz, l.zz};
    Mat3 e{p.y * l3 - p.z * l2, p.z * l1 - p.x * l3, p.x * l2 - p.y * l1};
    Mat3 f = from_the_right(p, e), g = from_the_right(p, d);
    Sym3 angular{b.xx + f.x.x + g.x.x + g.x.x, b.yy + f.y.y + g.y.y + g.y.y, b.zz + f.z.z + g.z.z + g.z.z,
                 b.xy + f.x.y + g.x.y + g.y.x, b.xz + f.x.z + g.x.z + g.z.x, b.yz + f.y.z + g.y.z + g.z.y};
    return ArticulatedInertia{angular, d + e, l};
  }

 private:
  // M p~^T: p x every row.
  template <class P, class M>
  static auto from_the_right(const P& p, const M& m) {
    return axial::Mat3{cross(p, m.x), cross(p, m.y), cross(p, m.z)};
  }
};

/// X^T (N X) by products of 6x6 matrices whose zeros are numbers like any other.
struct DenseProduct {
  static constexpr const char* name = "dense 6x6 product";
  template <class T>
  using Matrix = std::array<std::array<T, 6>, 6>;

  template <class T, class X, class Z, class N>
  static auto to_parent(const X& x, const Z& z, const N& n) {
    using namespace axial;
    const Matrix<T> m = transform<T>(x, z), c = times(transposed(m), times(matrix<T>(n), m));
    return ArticulatedInertia{
        Sym3<T>{c[0][0], c[1][1], c[2][2], c[0][1], c[0][2], c[1][2]},
        Mat3<Vec3<T>>{{c[0][3], c[0][4], c[0][5]}, {c[1][3], c[1][4], c[1][5]}, {c[2][3], c[2][4], c[2][5]}},
        Sym3<T>{c[3][3], c[4][4], c[5][5], c[3][4], c[3][5], c[4][5]}};
  }

 private:
  template <class T>
  static Matrix<T> transposed(const Matrix<T>& a) {
    Matrix<T> result{};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        result[i][j] = a[j][i];
    return result;
  }
  template <class T>
  static Matrix<T> times(const Matrix<T>& a, const Matrix<T>& b) {
    Matrix<T> result{};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) {
        result[i][j] = a[i][0] * b[0][j];
        for (std::size_t k = 1; k < 6; ++k)
          result[i][j] = result[i][j] + a[i][k] * b[k][j];
      }
    return result;
  }
  // X of v_child = X v_parent, a column a unit motion of the parent.
  template <class T, class X, class Z>
  static Matrix<T> transform(const X& x, const Z& z) {
    using namespace axial;
    constexpr One i;
    constexpr Zero o;
    const auto moved = [&](const auto& angular, const auto& linear) {
      const MotionVector<Vec3<T>, Vec3<T>> v = to_child(z, to_child(x, MotionVector{angular, linear}));
      return std::array<T, 6>{v.angular.x, v.angular.y, v.angular.z, v.linear.x, v.linear.y, v.linear.z};
    };
    return transposed(Matrix<T>{moved(Vec3{i, o, o}, ZeroVec3{}), moved(Vec3{o, i, o}, ZeroVec3{}),
                                moved(Vec3{o, o, i}, ZeroVec3{}), moved(ZeroVec3{}, Vec3{i, o, o}),
                                moved(ZeroVec3{}, Vec3{o, i, o}), moved(ZeroVec3{}, Vec3{o, o, i})});
  }
  template <class T, class N>
  static Matrix<T> matrix(const N& n) {
    using namespace axial;
    const Sym3<T> a = n.angular, l = n.linear;
    const Mat3<Vec3<T>> c = n.coupling;
    return {{{a.xx, a.xy, a.xz, c.x.x, c.x.y, c.x.z},
             {a.xy, a.yy, a.yz, c.y.x, c.y.y, c.y.z},
             {a.xz, a.yz, a.zz, c.z.x, c.z.y, c.z.z},
             {c.x.x, c.y.x, c.z.x, l.xx, l.xy, l.xz},
             {c.x.y, c.y.y, c.z.y, l.xy, l.yy, l.yz},
             {c.x.z, c.y.z, c.z.z, l.xz, l.yz, l.zz}}};
  }
};

/// Calls visit(way) for each.
template <class Visit>
void for_each_congruence(const Visit& visit) {
  visit(DenseProduct{}), visit(PlanarRotations{}), visit(AxialScrews{});
}

}  // namespace counts

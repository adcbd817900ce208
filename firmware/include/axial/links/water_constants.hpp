// What the algorithms use of the water about a body, derived from its description.
#pragma once

#include <axial/robot/link_parameters.hpp>
#include <axial/scalar/math.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Constants of the water about one body that the algorithms use, derived from its description.
template <class T>
struct WaterConstants {
  T cx{}, cy{}, cz{};                                ///< m, centre of buoyancy
  T displaced{}, hx{}, hy{}, hz{};                   ///< kg, and its first moment in kg m
  T mx{}, my{}, mz{};                                ///< kg, added mass
  T mz_my{}, mx_mz{}, my_mx{};                       ///< its differences
  T ix{}, iy{}, iz{};                                ///< kg m^2, added inertia about the centre
  T iz_iy{}, ix_iz{}, iy_ix{};                       ///< its differences
  T jxx{}, jyy{}, jzz{}, jxy{}, jxz{}, jyz{};        ///< added inertia about the frame's origin
  T c_xy{}, c_xz{}, c_yx{}, c_yz{}, c_zx{}, c_zy{};  ///< coupling c~ diag(m), kg m
  T lx{}, ly{}, lz{}, lrx{}, lry{}, lrz{};           ///< linear drag
  T qx{}, qy{}, qz{}, qrx{}, qry{}, qrz{};           ///< quadratic drag
  T scale_mass{}, scale_first_moment{},
      scale_polar{};  ///< bounds for the scale of singularity (recursion/composite_scale.hpp)
};

/// Those of a description as numbers T. The added inertia is carried to the frame's origin: J = I + c~ A c~^T, coupling
/// c~ A.
template <class T = double>
constexpr WaterConstants<T> water_constants(const WaterParameters& p) {
  const auto as = [](double value) { return NumberTraits<T>::constant(value); };
  const double x = p.centre[0], y = p.centre[1], z = p.centre[2];
  const double *m = p.added_mass, *i = p.added_inertia, *l = p.drag_linear, *q = p.drag_quadratic;
  const double jxx = i[0] + z * z * m[1] + y * y * m[2], jyy = i[1] + z * z * m[0] + x * x * m[2],
               jzz = i[2] + y * y * m[0] + x * x * m[1];
  const double largest = m[0] > m[1] ? (m[0] > m[2] ? m[0] : m[2]) : (m[1] > m[2] ? m[1] : m[2]);
  WaterConstants<T> c;
  c.cx = as(x), c.cy = as(y), c.cz = as(z);
  c.displaced = as(p.displaced_mass);
  c.hx = as(p.displaced_mass * x), c.hy = as(p.displaced_mass * y), c.hz = as(p.displaced_mass * z);
  c.mx = as(m[0]), c.my = as(m[1]), c.mz = as(m[2]);
  c.mz_my = as(m[2] - m[1]), c.mx_mz = as(m[0] - m[2]), c.my_mx = as(m[1] - m[0]);
  c.ix = as(i[0]), c.iy = as(i[1]), c.iz = as(i[2]);
  c.iz_iy = as(i[2] - i[1]), c.ix_iz = as(i[0] - i[2]), c.iy_ix = as(i[1] - i[0]);
  c.jxx = as(jxx), c.jyy = as(jyy), c.jzz = as(jzz);
  c.jxy = as(-x * y * m[2]), c.jxz = as(-x * z * m[1]), c.jyz = as(-y * z * m[0]);
  c.c_xy = as(-z * m[1]), c.c_xz = as(y * m[2]);
  c.c_yx = as(z * m[0]), c.c_yz = as(-x * m[2]);
  c.c_zx = as(-y * m[0]), c.c_zy = as(x * m[1]);
  c.lx = as(l[0]), c.ly = as(l[1]), c.lz = as(l[2]), c.lrx = as(l[3]), c.lry = as(l[4]), c.lrz = as(l[5]);
  c.qx = as(q[0]), c.qy = as(q[1]), c.qz = as(q[2]), c.qrx = as(q[3]), c.qry = as(q[4]), c.qrz = as(q[5]);
  c.scale_mass = as(largest);
  c.scale_first_moment = as(largest * (magnitude(x) + magnitude(y) + magnitude(z)));
  c.scale_polar = as(jxx + jyy + jzz);
  return c;
}

}  // namespace axial

#include <axial/options/end.hpp>

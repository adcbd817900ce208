// What the algorithms use of the water about a body, derived from its description.
#pragma once

#include <axial/robot/link_parameters.hpp>
#include <axial/scalar/math.hpp>

#include <cstddef>

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

/// The added inertia is carried to the frame's origin: J = I + c~ A c~^T, coupling c~ A.
constexpr WaterConstants<double> water_constants(const WaterParameters& p) {
  const double x = p.centre[0], y = p.centre[1], z = p.centre[2];
  const double *m = p.added_mass, *i = p.added_inertia, *l = p.drag_linear, *q = p.drag_quadratic;
  WaterConstants<double> c;
  c.cx = x, c.cy = y, c.cz = z;
  c.displaced = p.displaced_mass;
  c.hx = p.displaced_mass * x, c.hy = p.displaced_mass * y, c.hz = p.displaced_mass * z;
  c.mx = m[0], c.my = m[1], c.mz = m[2];
  c.mz_my = m[2] - m[1], c.mx_mz = m[0] - m[2], c.my_mx = m[1] - m[0];
  c.ix = i[0], c.iy = i[1], c.iz = i[2];
  c.iz_iy = i[2] - i[1], c.ix_iz = i[0] - i[2], c.iy_ix = i[1] - i[0];
  c.jxx = i[0] + z * z * m[1] + y * y * m[2];
  c.jyy = i[1] + z * z * m[0] + x * x * m[2];
  c.jzz = i[2] + y * y * m[0] + x * x * m[1];
  c.jxy = -x * y * m[2], c.jxz = -x * z * m[1], c.jyz = -y * z * m[0];
  c.c_xy = -z * m[1], c.c_xz = y * m[2];
  c.c_yx = z * m[0], c.c_yz = -x * m[2];
  c.c_zx = -y * m[0], c.c_zy = x * m[1];
  c.lx = l[0], c.ly = l[1], c.lz = l[2], c.lrx = l[3], c.lry = l[4], c.lrz = l[5];
  c.qx = q[0], c.qy = q[1], c.qz = q[2], c.qrx = q[3], c.qry = q[4], c.qrz = q[5];
  c.scale_mass = m[0] > m[1] ? (m[0] > m[2] ? m[0] : m[2]) : (m[1] > m[2] ? m[1] : m[2]);
  c.scale_first_moment = c.scale_mass * (magnitude(x) + magnitude(y) + magnitude(z));
  c.scale_polar = c.jxx + c.jyy + c.jzz;
  return c;
}

/// The constants in an order that is the same for every T.
template <class T>
inline constexpr T WaterConstants<T>::*water_numbers[] = {
    &WaterConstants<T>::cx,         &WaterConstants<T>::cy,         &WaterConstants<T>::cz,
    &WaterConstants<T>::displaced,  &WaterConstants<T>::hx,         &WaterConstants<T>::hy,
    &WaterConstants<T>::hz,         &WaterConstants<T>::mx,         &WaterConstants<T>::my,
    &WaterConstants<T>::mz,         &WaterConstants<T>::mz_my,      &WaterConstants<T>::mx_mz,
    &WaterConstants<T>::my_mx,      &WaterConstants<T>::ix,         &WaterConstants<T>::iy,
    &WaterConstants<T>::iz,         &WaterConstants<T>::iz_iy,      &WaterConstants<T>::ix_iz,
    &WaterConstants<T>::iy_ix,      &WaterConstants<T>::jxx,        &WaterConstants<T>::jyy,
    &WaterConstants<T>::jzz,        &WaterConstants<T>::jxy,        &WaterConstants<T>::jxz,
    &WaterConstants<T>::jyz,        &WaterConstants<T>::c_xy,       &WaterConstants<T>::c_xz,
    &WaterConstants<T>::c_yx,       &WaterConstants<T>::c_yz,       &WaterConstants<T>::c_zx,
    &WaterConstants<T>::c_zy,       &WaterConstants<T>::lx,         &WaterConstants<T>::ly,
    &WaterConstants<T>::lz,         &WaterConstants<T>::lrx,        &WaterConstants<T>::lry,
    &WaterConstants<T>::lrz,        &WaterConstants<T>::qx,         &WaterConstants<T>::qy,
    &WaterConstants<T>::qz,         &WaterConstants<T>::qrx,        &WaterConstants<T>::qry,
    &WaterConstants<T>::qrz,        &WaterConstants<T>::scale_mass, &WaterConstants<T>::scale_first_moment,
    &WaterConstants<T>::scale_polar};

/// Water constants in another number format.
template <class T>
constexpr WaterConstants<T> converted(const WaterConstants<double>& c) {
  WaterConstants<T> result;
  for (std::size_t i = 0; i < sizeof(water_numbers<T>) / sizeof(water_numbers<T>[0]); ++i)
    result.*water_numbers<T>[i] = NumberTraits<T>::constant(c.*water_numbers<double>[i]);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>

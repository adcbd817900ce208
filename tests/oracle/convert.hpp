// Conversion of chains and values from one number type to another.
#pragma once

#include <oracle/chain.hpp>

namespace oracle {

/// A right angle stays a right angle.
template <class To, class From>
To convert_angle(From angle) {
  int quarters = 0;
  return is_right_angle(angle, quarters) ? To(quarters) * right_angle<To>() : static_cast<To>(angle);
}
template <class To, class From>
Vec3<To> convert(const Vec3<From>& v) {
  return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.z)};
}
template <class To, class From>
Mat3<To> convert(const Mat3<From>& M) {
  return {convert<To>(M.c0), convert<To>(M.c1), convert<To>(M.c2)};
}
template <class To, class From>
Pose<To> convert(const Pose<From>& X) {
  return {convert<To>(X.rotation), convert<To>(X.position)};
}
template <class To, class From>
Wrench<To> convert(const Wrench<From>& w) {
  return {convert<To>(w.force), convert<To>(w.moment)};
}
template <class To, class From>
Load<To> convert(const Load<From>& load) {
  Load<To> result{load.friction, convert<To>(load.tip), load.springs, {}};
  for (const auto& wrench : load.links)
    result.links.push_back(convert<To>(wrench));
  return result;
}
template <class To, class From>
Matrix<To> convert(const Matrix<From>& A) {
  Matrix<To> result(A.rows(), A.columns());
  for (int i = 0; i < A.rows(); ++i)
    for (int j = 0; j < A.columns(); ++j)
      result(i, j) = static_cast<To>(A(i, j));
  return result;
}
template <class To, class From>
Vector<To> convert(const Vector<From>& v) {
  Vector<To> result;
  for (const From& x : v)
    result.push_back(static_cast<To>(x));
  return result;
}
template <class To, class From>
Chain<To> convert(const Chain<From>& source) {
  Chain<To> result;
  for (const Link<From>& l : source.links)
    result.links.push_back({l.type,
                            l.parent,
                            convert_angle<To>(l.alpha),
                            static_cast<To>(l.a),
                            static_cast<To>(l.d),
                            convert_angle<To>(l.theta),
                            convert_angle<To>(l.gamma),
                            static_cast<To>(l.b),
                            static_cast<To>(l.mass),
                            convert<To>(l.com),
                            convert<To>(l.inertia),
                            static_cast<To>(l.rotor_inertia),
                            static_cast<To>(l.gear),
                            static_cast<To>(l.viscous),
                            static_cast<To>(l.coulomb_forward),
                            static_cast<To>(l.coulomb_backward),
                            static_cast<To>(l.static_friction),
                            static_cast<To>(l.stribeck_speed),
                            static_cast<To>(l.smooth_speed),
                            static_cast<To>(l.spring_stiffness),
                            static_cast<To>(l.spring_rest)});
  result.gravity = convert<To>(source.gravity);
  result.base = convert<To>(source.base), result.tool = convert<To>(source.tool);
  return result;
}

}  // namespace oracle

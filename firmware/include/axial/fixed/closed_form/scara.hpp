// Ranges, formats and errors of the SCARA's closed form in fixed point.
#pragma once

#include <axial/closed_form/scara.hpp>
#include <axial/fixed/links/fixed_links.hpp>
#include <axial/fixed/links/separated_terms.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace closed_form {
namespace detail {

/// The closed form on Balls. One "link" holds what is common; errors of the efforts are a joint's.
template <class S>
constexpr Ranges<3> scara_ranges(const Rounding& r, const int (&effort)[3]) {
  constexpr ScaraConstants k = scara_constants<S>();
  constexpr auto& links = robot_of<S>::chain.links;
  const double v1 = links[0].speed_limit, v2 = links[1].speed_limit;
  const double a1 = links[0].acceleration_limit, a2 = links[1].acceleration_limit, a3 = links[2].acceleration_limit;
  const double swing = magnitude(k.swing), s11 = k.shoulder + 2.0 * swing, s12 = k.elbow + swing;
  Ranges<3> all;
  LinkFormat& f = all.format[0];
  f.joint_inertia = r.exponent(s11), f.rotational_inertia = r.exponent(s12 > swing ? s12 : swing);
  f.angular_velocity = r.exponent(2.0 * v1 + v2);
  const double cross = v2 * (2.0 * v1 + v2);
  f.angular_acceleration = r.exponent(cross > v1 * v1 ? cross : v1 * v1);
  const int fi = f.rotational_inertia, fj = f.joint_inertia, fv = f.angular_velocity, fa = f.angular_acceleration,
            unit = r.bits - 2;
  const Ball moved{swing, swing * r.turn_error + r.sum(fi, {Factor{k.swing, unit, 1.0}})};
  const Ball m11{s11, 2.0 * moved.error + 3.0 * r.store(fj)}, m12{s12, moved.error + 2.0 * r.store(fi)};
  const int e1 = r.exponent(v1), e2 = r.exponent(v2);
  const Ball twice{2.0 * v1 + v2, 3.0 * r.store(fv)};
  Ball crossed = Ball{v2, 0.0} * twice;
  crossed.error += r.products(1, e2, fv, fa);
  const Ball square{v1 * v1, r.products(1, e1, e1, fa)};
  const int x1 = r.exponent(a1), x2 = r.exponent(a2), x3 = r.exponent(a3);
  Ball shoulder = m11 * Ball{a1, 0.0} + m12 * Ball{a2, 0.0} + moved * crossed;
  Ball elbow = m12 * Ball{a1, 0.0} + (k.elbow + k.elbow_rotor) * Ball{a2, 0.0} + moved * square;
  Ball slide{magnitude(k.lift) * a3 + magnitude(k.weight), 0.0};
  shoulder.error += r.products(1, fj, x1, effort[0]) + r.products(2, fi, axial::detail::smaller(x2, fa), effort[0]);
  elbow.error += r.sum(effort[1], {Factor{k.elbow + k.elbow_rotor, x2, a2}}) +
                 r.products(2, fi, axial::detail::smaller(x1, fa), effort[1]);
  slide.error += r.sum(effort[2], {Factor{k.lift, x3, a3}}) + r.store(effort[2]);
  all.range[0].joint_effort = shoulder, all.range[1].joint_effort = elbow, all.range[2].joint_effort = slide;
  for (int i = 0; i < 3; ++i)
    all.format[i].joint_effort = effort[i];
  return all;
}

/// Formats of a scene's closed form in arithmetic A.
template <class S, class A>
struct ScaraTable {
  static constexpr Ranges<3> value =
      scara_ranges<S>(rounding_of<A>(), axial::detail::exponents_of<S, typename A::Word, role::Effort>.of);
  static constexpr int parent(int) { return -1; }
};

/// How the closed form rounds in its formats.
template <class S, class Word>
struct ScaraRounding<S, Stored<Word>>
    : axial::detail::FormatRounding<axial::detail::ArithmeticOf<scene_of<S>, Word>,
                                    ScaraTable<S, axial::detail::ArithmeticOf<scene_of<S>, Word>>, 0>,
      FixedValues<scene_of<S>, axial::detail::ArithmeticOf<scene_of<S>, Word>> {
  using Scalar = axial::detail::ArithmeticOf<scene_of<S>, Word>;
};

}  // namespace detail
}  // namespace closed_form
}  // namespace axial

#include <axial/options/end.hpp>

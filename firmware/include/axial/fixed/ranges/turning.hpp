// How balls turn from link to link, and what rounding adds there.
#pragma once

#include <axial/fixed/ranges/shared_formats.hpp>
#include <axial/fixed/ranges/split_ball.hpp>

namespace axial {
namespace detail {

/// The turns of link i as they round.
template <int N>
struct Turning {
  const Mechanism<N>& m;
  const Rounding& r;

  // Whether a constant turn is none by quarters; a table's turns are sines and cosines as any other.
  constexpr bool rounds(double sine, double cosine) const {
    return (sine < 0.0 || sine > 0.0) && (m.steps.shared || cosine < 0.0 || cosine > 0.0);
  }
  // By the joint's sine and cosine, whose own error turns what is across.
  constexpr SplitBall by_joint(int i, SplitBall v, int format) const {
    if (m.links[i].prismatic)
      return rounds(m.factors(i).sin_theta, m.factors(i).cos_theta) ? rounded_across(v, constant_step(v, format)) : v;
    const Ball tilt{0.0, root2 * r.turn_error * v.across.reach()};
    v.across = v.across + tilt, v.whole = v.whole + tilt;
    return rounded_across(v, r.products(2, format, r.bits - 2, format));
  }
  constexpr SplitBall by_twist(int i, const SplitBall& v, int format) const {
    const auto& c = m.links[i];
    SplitBall turned = turned_about_x(v, c.sin_alpha, c.cos_alpha);
    const auto& k = m.factors(i);
    if (rounds(k.sin_alpha, k.cos_alpha)) turned = rounded(turned, constant_step(v, format));
    if (rounds(k.branch.sin_gamma, k.branch.cos_gamma)) turned = rounded_across(turned, constant_step(v, format));
    return turned;
  }
  constexpr SplitBall to_child(int i, const SplitBall& v, int format) const {
    return by_joint(i, by_twist(i, v, format), format);
  }

 private:
  constexpr double constant_step(const SplitBall& v, int format) const {
    if (m.steps.shared) return r.products(2, format, r.bits - 2, format) + r.ulp(r.bits - 2) * v.whole.size;
    return r.sum(format, {Factor{0.7071, format, v.whole.size}, Factor{0.7072, format, v.whole.size}});
  }
};

}  // namespace detail
}  // namespace axial

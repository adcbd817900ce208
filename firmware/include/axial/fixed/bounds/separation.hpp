// Sizes, formats and errors of the separated terms: their kernel, run on bounds.
#pragma once

#include <axial/fixed/bounds/dynamics.hpp>
#include <axial/fixed/bounds/kinematics.hpp>
#include <axial/separation/separation.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {
constexpr int outermost(int i, int j, int k) { return i > j ? (i > k ? i : k) : (j > k ? j : k); }
}  // namespace detail

namespace bounds {

/// What a joint's unit rate gives to its own link: the axis, a constant of the model.
///@{
template <class S, int N>
constexpr BoundedMotion unit_motion(Revolute, const BoundedLink<S, N>& link) {
  return {detail::unit_along(link.rounding()), {}};
}
template <class S, int N>
constexpr BoundedMotion unit_motion(Prismatic, const BoundedLink<S, N>& link) {
  return {{}, detail::unit_along(link.rounding())};
}
///@}

/// Coefficients of qd_i^2: the couple of the inertia and the first moment, each turned by a quarter.
constexpr ForceVector<BoundedVector, BoundedVector> square_force(Revolute, const CompositeBody& body) {
  const BoundedVector& h = body.first_moment;
  return {{detail::split(body.inertia.bound, {}), body.inertia.exponent, false, h.rounding},
          {detail::split(h.bound.across, {}), h.exponent, false, h.rounding}};
}

/// Coefficients of qd_j qd_i. Points r of the body accelerate with 2 w x (z x r): the moment is -2 z x (P w), P the
/// second moments (trace(J) / 2 - J), the force 2 (z (w . h) - h (w . z)). |P| <= 3 |J| / 2, for eigenvalues of J may
/// have any sign where parameters are regrouped.
template <class Link>
constexpr ForceVector<BoundedVector, BoundedVector> product_force(Revolute, const Link& link, const CompositeBody& body,
                                                                  const BoundedVector& w) {
  using namespace quantity;
  const BoundedVector h = detail::doubled(body.first_moment);
  const Ball second = 3.0 * body.inertia.bound;
  link.leave_room(RotationalInertia{}, second.size), link.leave_room(FirstMoment{}, h.bound.whole.size);
  const BoundedVector entry{{second, second, second}, body.inertia.exponent, false, h.rounding};
  VectorSum moment{detail::split(second * w.bound.whole, {}), {}, {}};
  detail::add_product(moment.across, 2, Part::across, w, Part::across, entry);
  detail::add_product(moment.across, 1, Part::along, w, Part::across, entry);
  VectorSum force{detail::split(w.bound.along * h.bound.across, w.bound.across * h.bound.across), {}, {}};
  detail::add_product(force.across, 1, Part::along, w, Part::across, h);
  detail::add_product(force.along, 2, Part::across, w, Part::across, h);
  return {link.sum(Moment{}, moment), link.sum(Force{}, force)};
}
/// Where joint i slides, points accelerate with 2 w x z.
template <class Link>
constexpr ForceVector<BoundedVector, BoundedVector> product_force(Prismatic, const Link& link,
                                                                  const CompositeBody& body, const BoundedVector& w) {
  const BoundedVector& h = body.first_moment;
  BoundedVector twice = detail::doubled(w);
  --twice.exponent;
  const SplitBall &a = twice.bound, &b = h.bound;
  VectorSum moment{detail::split(b.along * a.across, b.across * a.across), {}, {}};
  detail::add_product(moment.across, 1, Part::across, twice, Part::along, h);
  detail::add_product(moment.along, 2, Part::across, twice, Part::across, h);
  BoundedVector across = twice;
  across.bound = detail::split(a.across, {});
  return {link.sum(quantity::Moment{}, moment), link.sum(quantity::Force{}, body.mass * across)};
}

/// Effort that holds a composite body at an acceleration.
///@{
constexpr NumberSum weight(Revolute, const CompositeBody& body, const BoundedVector& a) {
  return axial_product(body.first_moment, a);
}
constexpr NumberSum weight(Prismatic, const CompositeBody& body, const BoundedVector& a) {
  return body.mass * axial_part(a);
}
///@}

/// Separated terms in bounds, coefficients as words of the exponents that they are stored at.
template <int N>
struct SeparatedBounds {
  static constexpr int pairs = N > 1 ? N*(N - 1) / 2 : 1;          ///< as in SeparatedB
  Number A[N][N] = {}, B[N][pairs] = {}, C[N][N] = {}, G[N] = {};  ///< as in Separated

  /// Index of the pair (j, k), as in SeparatedB.
  static constexpr int pair(int j, int k) {
    return j < k ? j * N - j * (j + 1) / 2 + k - j - 1 : k * N - k * (k + 1) / 2 + j - k - 1;
  }
};

/// Exponents of coefficients, by the outermost joint of their indices, and of efforts at rest.
template <int N>
struct SeparatedFormats {
  int coefficient[N] = {}, rest[N] = {};  ///< one per joint
};

/// Takes what the kernel hands over, and notes what coefficients have to have room for.
template <class Links, int N>
struct CollectedBounds {
  const Links& links;                  ///< of the run
  const SeparatedFormats<N>& formats;  ///< of what is stored
  SeparatedBounds<N>& out;             ///< what is filled

  /// Coefficients as Collected takes them.
  ///@{
  template <class V>
  constexpr void inertia(int i, int j, const V& value) const {
    out.A[i][j] = out.A[j][i] = kept(i, j, j, value);
  }
  template <class V>
  constexpr void product(int i, int j, int k, const V& value) const {
    out.B[i][out.pair(j, k)] = kept(i, j, k, value);
  }
  template <class V>
  constexpr void square(int i, int j, const V& value) const {
    out.C[i][j] = kept(i, j, j, value);
  }
  template <class V>
  constexpr void rest(int i, const V& value) const {
    out.G[i] = stored(value, formats.rest[i]);
  }
  ///@}

 private:
  template <class V>
  constexpr Number kept(int i, int j, int k, const V& value) const {
    const int last = axial::detail::outermost(i, j, k);
    links.link(last).leave_room(quantity::JointInertia{}, term_of(value).bound.size);
    return stored(value, formats.coefficient[last]);
  }
  template <class V>
  constexpr Number stored(const V& value, int exponent) const {
    NumberSum sum = term_of(value);
    sum.bound.error += sum.terms.rounding(exponent, links.link(0).rounding());
    return word_of(sum.bound, exponent);
  }
};

namespace detail {

template <class Scene, int N>
constexpr void separate_once(Account<N>& account, const SeparatedFormats<N>& formats, SeparatedBounds<N>& all) {
  const KernelStart<Scene, N> start(account);
  const CollectedBounds<BoundedLinks<Scene, N>, N> terms{start.links, formats, all};
  separation::run(start.links, start.in, start.at.q, start.screws(), terms);
}
template <int N>
constexpr SeparatedBounds<N> separate(Account<N>& account, const SeparatedFormats<N>& formats) {
  SeparatedBounds<N> all;
  if (account.mechanism.loads.payload_mass > 0.0)  // wrenches have no place here
    separate_once<BoundedScene<true, false>>(account, formats, all);
  else
    separate_once<NoLoads>(account, formats, all);
  return all;
}

}  // namespace detail

/// Bounds of the separated terms in the formats of `ranges`, stored at `formats`.
template <int N>
constexpr SeparatedBounds<N> separated_bounds(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges,
                                              const SeparatedFormats<N>& formats) {
  auto account = account_in_formats(m, r, ranges);
  return detail::separate(account, formats);
}

}  // namespace bounds

/// Ranges and formats of the separated terms. LinearAcceleration is that of points at unit rates (m); JointInertia
/// holds every coefficient of which this joint is the outermost.
template <int N>
constexpr Ranges<N> separation_ranges_of(const Mechanism<N>& m, const WordRounding& r) {
  return bounds::detail::ranges_by(m, r, Wanted::formats, [](bounds::Account<N>& account) {
    bounds::detail::separate(account, bounds::SeparatedFormats<N>{});
  });
}

}  // namespace axial

#include <axial/options/end.hpp>

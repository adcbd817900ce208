// The looped form in fixed point: one format per quantity for all links, from the formats that each would have alone.
#pragma once

#include <axial/fixed/bounds/mechanism.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// The exponent of a column of constants, by what it holds. Turns of the model are sines and cosines like a joint's.
struct ColumnExponents {
  LinkFormat format{};
  int unit = 0, rotor = 0;

  template <class T>
  constexpr int of(T LinkConstants<T>::*member) const {
    using C = LinkConstants<T>;
    if (member == &C::cos_alpha || member == &C::sin_alpha || member == &C::cos_theta || member == &C::sin_theta)
      return unit;
    if (member == &C::a || member == &C::d) return format.length;
    if (member == &C::mass) return format.mass;
    if (member == &C::hx || member == &C::hy || member == &C::hz) return format.first_moment;
    return member == &C::rotor ? rotor : format.rotational_inertia;
  }
  template <class T>
  constexpr int of(T BranchConstants<T>::*member) const {
    return member == &BranchConstants<T>::b ? format.length : unit;
  }
};

constexpr double larger(double a, double b) { return a > b ? a : b; }

template <int N>
constexpr LinkFormat coarsest(const LinkFormat (&formats)[N]) {
  LinkFormat shared = formats[0];
  for (const LinkFormat& format : formats)
    for (const auto quantity : all_quantities<int>)
      shared.*quantity = smaller(shared.*quantity, format.*quantity);
  return shared;
}

// A length of a table or of a joint: d, q and their sum, a and b.
template <int N>
constexpr double longest(const Mechanism<N>& m) {
  double most = 1.0;
  for (int i = 0; i < N; ++i) {
    const auto& c = m.links[i];
    most = larger(larger(most, m.joints[i].travel + magnitude(c.d)), larger(magnitude(c.a), magnitude(c.branch.b)));
  }
  return most;
}

template <int N>
constexpr double largest_rotor(const Mechanism<N>& m) {
  double most = 0.0;
  for (const auto& c : m.links)
    most = m.loads.rotors ? larger(most, magnitude(c.rotor)) : 0.0;
  return most;
}

template <int N>
constexpr double largest_viscous(const Mechanism<N>& m) {
  double most = 0.0;
  for (const auto& drive : m.drives)
    most = m.loads.friction ? larger(most, drive.viscous) : 0.0;
  return most;
}

template <int N>
constexpr ColumnExponents column_exponents(const Mechanism<N>& m, const WordRounding& r, const LinkFormat& format) {
  return {format, r.bits - 2, fitting_exponent(largest_rotor(m), r.capacity())};
}

/// A robot whose links share the formats of an analysis of it.
template <int N>
constexpr Mechanism<N> sharing(Mechanism<N> m, const WordRounding& r, const Ranges<N>& apart) {
  SharedSteps& s = m.steps;
  s.shared = true;
  s.format = coarsest(apart.format);
  s.format.length = smaller(s.format.length, r.exponent(longest(m)));
  s.viscous = largest_viscous(m);
  return m;
}

}  // namespace axial::detail

#include <axial/options/end.hpp>

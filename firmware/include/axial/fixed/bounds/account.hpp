// What a kernel run on bounds finds out, and the scene that it sees. In the looped form one format per quantity serves
// all links, from the formats that each would have alone.
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

/// The largest of what `get` has for each row, 0 of none.
template <class Rows, class Get>
constexpr double largest_of(const Rows& rows, const Get& get) {
  double most = 0.0;
  for (const auto& row : rows)
    most = larger(most, get(row));
  return most;
}

template <int N>
constexpr ColumnExponents column_exponents(const Mechanism<N>& m, const WordRounding& r, const LinkFormat& format) {
  const auto rotor = [&m](const auto& link) { return m.loads.rotors ? magnitude(link.rotor) : 0.0; };
  return {format, r.bits - 2, fitting_exponent(largest_of(m.links, rotor), r.capacity())};
}

/// A robot whose links share the formats of an analysis of it.
template <int N>
constexpr Mechanism<N> sharing(Mechanism<N> m, const WordRounding& r, const Ranges<N>& apart) {
  SharedSteps& s = m.steps;
  s.shared = true;
  s.format = coarsest(apart.format);
  s.format.length = smaller(s.format.length, r.exponent(longest(m)));
  if (m.loads.friction) s.viscous = largest_of(m.drives, [](const auto& drive) { return drive.viscous; });
  return m;
}

}  // namespace axial::detail

namespace axial::bounds {

/// The largest size of each quantity of a link, SI; negative until one is noted.
struct LinkSizes : axial::detail::PerQuantity<double> {
  constexpr LinkSizes() {
    for (const auto quantity : all_quantities<double>)
      this->*quantity = -1.0;
  }
};

/// Room that a quantity needs, as a multiple of its norm. Two entries of a matrix' diagonal may have opposite signs,
/// those of an inertia where parameters are regrouped: their difference is what a turn multiplies.
template <class Quantity>
inline constexpr double room_for =
    std::is_same_v<Quantity, quantity::RotationalInertia> || std::is_same_v<Quantity, quantity::FlowMoment> ? 2.0 : 1.0;

/// What a kernel in bounds finds out: the size that each quantity of each link has to have room for, and how large and
/// how exact it is at last. Run once to size the formats, and again to add up errors in them.
template <int N>
struct Account {
  Mechanism<N> mechanism;        ///< the robot
  const WordRounding& rounding;  ///< of the arithmetic
  bool sizing = true;            ///< whether formats are still to be found
  bool quiet = false;            ///< whether sizes are left unnoted, for another way bounds them better
  Ranges<N> ranges{};            ///< what is known by now
  LinkSizes widest[N] = {};      ///< of each link

  /// Formats from the sizes that were noted.
  constexpr void choose_formats() {
    constexpr const auto& sizes = all_quantities<double>;
    constexpr const auto& formats = all_quantities<int>;
    for (int i = 0; i < N; ++i)
      for (int k = 0; k < axial::detail::AllQuantities::count; ++k)
        if (const double size = widest[i].*sizes[k]; size >= 0.0)
          ranges.format[i].*formats[k] = mechanism.format(rounding, formats[k], size);
    for (int i = 0; i < N && !mechanism.steps.shared; ++i)
      if (mechanism.joints[i].effort_format != JointRange::unknown)
        ranges.format[i].joint_effort = mechanism.joints[i].effort_format;
    sizing = false;
  }
  /// Whether all links of a table have the same 0, 1 or -1, which is then a type.
  template <class Value>
  constexpr bool is_common(const Value& value) const {
    const double first = value(mechanism.links[0]);
    bool common = first == 0.0 || first == 1.0 || first == -1.0;
    for (const auto& link : mechanism.links)
      common = common && value(link) == first;
    return common;
  }
};

/// An account of errors in the formats that `ranges` say.
template <int N>
constexpr Account<N> account_in_formats(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges) {
  return {r.tabled ? axial::detail::sharing(m, r, ranges) : m, r, false, false, ranges};
}

/// What a scene of bounds names: all that costs nothing where it is zero, payload and wrench where there are any.
template <bool payload, bool wrench>
struct BoundedScene {
  /// Whether the kernel sees a feature.
  template <class Feature>
  static constexpr bool has = std::is_same_v<Feature, Gravity> || std::is_same_v<Feature, RotorInertia> ||
                              std::is_same_v<Feature, Friction> || (std::is_same_v<Feature, Payload> && payload) ||
                              (std::is_same_v<Feature, TipWrench> && wrench);
};

}  // namespace axial::bounds

#include <axial/options/end.hpp>

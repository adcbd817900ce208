// What a kernel run on bounds finds out, and the scene that it sees.
#pragma once

#include <axial/fixed/bounds/shared_formats.hpp>

#include <axial/options/begin.hpp>

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

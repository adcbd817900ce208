// What all links of a table have in common: in the looped form such a constant is a type as well.
#pragma once

#include <cstddef>
#include <limits>

#include <axial/model/base_parameters.hpp>
#include <axial/model/link_constants.hpp>

namespace axial {
namespace detail {

/// A table that is filled at run time: nothing is known.
struct UnknownColumns {
  static constexpr bool any_revolute = true, any_prismatic = true;
  template <class T>
  static constexpr double common(T LinkConstants<T>::*) {
    return std::numeric_limits<double>::quiet_NaN();
  }
};

/// The table of a robot. `Constants::table.links` is an array of LinkConstants<double>.
template <class Constants>
struct KnownColumns {
  static constexpr bool any(bool prismatic) {
    bool found = false;
    for (const auto& link : Constants::table.links)
      found = found || link.prismatic == prismatic;
    return found;
  }
  static constexpr bool any_revolute = any(false), any_prismatic = any(true);

  /// The value of a constant if it is the same for every link, else NaN.
  template <class T>
  static constexpr double common(T LinkConstants<T>::*member) {
    std::size_t i = 0;
    while (link_numbers<T>[i] != member)
      ++i;
    const auto column = link_numbers<double>[i];
    const double first = Constants::table.links[0].*column;
    for (const auto& link : Constants::table.links)
      if (link.*column < first || link.*column > first) return std::numeric_limits<double>::quiet_NaN();
    return first;
  }
};

}  // namespace detail
}  // namespace axial

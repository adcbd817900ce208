// What all links of a table have in common: in the looped form such a constant is a type as well.
#pragma once

#include <axial/links/base_parameters.hpp>
#include <axial/links/link_constants.hpp>

#include <cstddef>
#include <limits>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// A table that is filled at run time: nothing is known, but that no link has a branch where the scene says so.
template <bool branches = true>
struct UnknownColumns {
  static constexpr bool any_revolute = true, any_prismatic = true, any_branch = branches;
  template <class T>
  using Row = TreeLinkConstants<T>;
  template <class Member>
  static constexpr double common(Member) {
    return std::numeric_limits<double>::quiet_NaN();
  }
};

/// The table of a robot. `Constants::table.links` is an array of TreeLinkConstants<double>.
template <class Constants>
struct CommonConstants {
  static constexpr bool any(bool prismatic) {
    bool found = false;
    for (const auto& link : Constants::table.links)
      found = found || link.prismatic == prismatic;
    return found;
  }
  static constexpr bool any_revolute = any(false), any_prismatic = any(true);

  static constexpr bool has_branch() {
    bool found = false;
    for (const auto& link : Constants::table.links)
      found = found || link.branches();
    return found;
  }
  static constexpr bool any_branch = has_branch();
  /// Row of the table on the target: without branches the constants of one are not stored.
  template <class T>
  using Row = std::conditional_t<any_branch, TreeLinkConstants<T>, LinkConstants<T>>;

  /// The value of a constant if it is the same for every link, else NaN.
  template <class T>
  static constexpr double common(T LinkConstants<T>::*member) {
    std::size_t i = 0;
    while (link_numbers<T>[i] != member)
      ++i;
    const auto column = link_numbers<double>[i];
    return same([column](const auto& link) { return link.*column; });
  }
  template <class T>
  static constexpr double common(T BranchConstants<T>::*member) {
    std::size_t i = 0;
    while (branch_numbers<T>[i] != member)
      ++i;
    const auto column = branch_numbers<double>[i];
    return same([column](const auto& link) { return link.branch.*column; });
  }

 private:
  template <class Get>
  static constexpr double same(Get get) {
    const double first = get(Constants::table.links[0]);
    for (const auto& link : Constants::table.links)
      if (get(link) < first || get(link) > first) return std::numeric_limits<double>::quiet_NaN();
    return first;
  }
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

// How an algorithm sees a link through a row of a table: the looped form. A constant that all links of a table have in
// common is a type there as well.
#pragma once

#include <axial/links/base_parameters.hpp>
#include <axial/links/link_constants.hpp>
#include <axial/links/link_view.hpp>

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

/// What rows of any numbers share. `Source` is what the table holds; the view says by number<M>(x) what that is to a
/// kernel, unless all links have the same 0, 1 or -1.
template <class View, class Source, class Columns>
class TableRow : public LinkAccess<View, Source> {
 public:
  static constexpr bool unrolled = false;
  static constexpr bool branches = Columns::any_branch;
  static constexpr bool has_axial_mass = false;
  using Constants = typename Columns::template Row<Source>;
  const Constants& row;
  const DriveConstants<Source>* drives;  ///< of this link; null where the scene names none
  bool is_last;

  AXIAL_INLINE constexpr TableRow(const Constants& constants, const DriveConstants<Source>* own, bool last)
      : row(constants), drives(own), is_last(last) {}

  template <Member<Source> M>
  AXIAL_INLINE constexpr auto get() const {
    return common_or<M>([this]() AXIAL_INLINE { return row.*M; });
  }
  template <BranchMember<Source> M>
  AXIAL_INLINE constexpr auto branch() const {
    return common_or<M>([this]() AXIAL_INLINE { return row.branch.*M; });
  }
  template <Member<Source>>
  AXIAL_INLINE static constexpr AnyTurn beyond_45_degrees() {
    return {};
  }
  template <BranchMember<Source>>
  AXIAL_INLINE static constexpr AnyTurn branch_beyond_45_degrees() {
    return {};
  }
  template <class F>
  AXIAL_INLINE constexpr auto on_joint(const F& f) const {
    if constexpr (!Columns::any_prismatic) {
      return f(Revolute{});
    } else if constexpr (!Columns::any_revolute) {
      return f(Prismatic{});
    } else {
      if (row.prismatic) return f(Prismatic{});
      return f(Revolute{});
    }
  }

 private:
  template <auto M, class Read>
  AXIAL_INLINE constexpr auto common_or(const Read& read) const {
    constexpr double common = Columns::common(M);
    if constexpr (common == 0.0 || common == 1.0 || common == -1.0)
      return Int<static_cast<int>(common)>{};
    else
      return static_cast<const View*>(this)->template number<M>(read());
  }
};

}  // namespace detail

/// Row of a table of links: plain numbers. One step serves all links, so results are kept as plain numbers too.
template <class SceneType, class T, class Source, class Columns>
class TableLink : public detail::TableRow<TableLink<SceneType, T, Source, Columns>, Source, Columns>, public Plain {
  using Base = detail::TableRow<TableLink, Source, Columns>;

 public:
  using Scene = SceneType;                    ///< what the link belongs to
  using Scalar = T;                           ///< the number that kernels compute with
  static constexpr bool adds_angles = false;  ///< theta is added by turning the pair of q, not to the angle
  using Base::Base;

  /// A number of the table.
  template <auto M>
  AXIAL_INLINE static constexpr T number(const Source& x) {
    if constexpr (std::is_same_v<T, Source>)
      return x;
    else
      return NumberTraits<T>::constant(x);
  }
  /// A constant of the drive; zero by type where no link of the robot has any.
  template <detail::DriveMember<Source> M>
  AXIAL_INLINE constexpr auto drive() const {
    if constexpr (detail::any_drive_has<typename Scene::Robot, Source, M>())
      return number<M>(this->drives->*M);
    else
      return Zero{};
  }
  /// The form in which this view keeps a result: as plain numbers.
  template <class V>
  AXIAL_INLINE static constexpr auto shape(const V& v) {
    if constexpr (is_scalar_v<V>)
      return T(v);
    else
      return v.template dense<T>();
  }
};

}  // namespace axial

#include <axial/options/end.hpp>

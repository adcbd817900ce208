// Links of the looped form in fixed point: rows of integers, columns of one exponent each, one rounding for all links.
#pragma once

#include <axial/fixed/links/shared_view.hpp>
#include <axial/links/table_link.hpp>
#include <axial/spatial/pose.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// The formats that all links of a scene share in a recursion.
template <class Scene, class Parameters, class S, class Recursion>
struct SharedFormats {
  using Arithmetic = S;
  static constexpr const auto& value = ranges_of<Scene, Parameters, S, Recursion, Wanted::formats>;
  static constexpr const auto& mechanism = mechanism_of<Scene, Parameters>;
  static constexpr const LinkFormat& format = value.format[0];
  static constexpr ColumnExponents columns = column_exponents(mechanism, rounding_of<S>(true), format);
  static constexpr int parent(int i) { return i; }  // one for all
};

/// What kernels keep where links share formats: each quantity in its own.
template <class Formats>
struct InSharedFormats {};

}  // namespace detail

template <class Formats, class Quantity>
struct KeptAs<detail::InSharedFormats<Formats>, Quantity> {
  using type = Fx<Formats::format.of(Quantity{}), typename Formats::Arithmetic>;
};
template <class Formats>
struct KeptAs<detail::InSharedFormats<Formats>, quantity::Turn> {
  using type = Fx<Formats::Arithmetic::unit, typename Formats::Arithmetic>;
};

namespace detail {

/// Numbers of a table as integers. The angle theta is in units of 2^-32 of a turn.
using TableWord = std::int32_t;

constexpr TableWord table_word(double value, int exponent) {
  return static_cast<TableWord>(nearest_integer(value * power_of_two(exponent)));
}

template <class Formats>
struct FixedTable {
  static constexpr const auto& links = Formats::mechanism.links;
  static constexpr const auto& drives = Formats::mechanism.drives;
  static constexpr int size = static_cast<int>(sizeof(links) / sizeof(links[0]));

  // Whether a column has an exponent: theta is an angle, and rotors may be none of the scene's.
  static constexpr bool has_column(double LinkConstants<double>::*member) {
    using C = LinkConstants<double>;
    return member != &C::theta && (member != &C::rotor || Formats::mechanism.loads.rotors);
  }
  template <class Row>
  static constexpr Row row(const TreeLinkConstants<double>& c) {
    Row r{};
    r.prismatic = c.prismatic, r.parent = c.parent;
    for (std::size_t i = 0; i < sizeof(link_numbers<double>) / sizeof(link_numbers<double>[0]); ++i)
      if (has_column(link_numbers<double>[i]))
        r.*link_numbers<TableWord>[i] =
            table_word(c.*link_numbers<double>[i], Formats::columns.of(link_numbers<double>[i]));
    r.theta = static_cast<TableWord>(static_cast<std::uint32_t>(nearest_integer(c.theta * bam_per_radian)));
    if constexpr (std::is_same_v<Row, TreeLinkConstants<TableWord>>)
      for (std::size_t i = 0; i < sizeof(branch_numbers<double>) / sizeof(branch_numbers<double>[0]); ++i)
        r.branch.*branch_numbers<TableWord>[i] =
            table_word(c.branch.*branch_numbers<double>[i], Formats::columns.of(branch_numbers<double>[i]));
    return r;
  }

  /// Exponents of the drives' columns, by what they hold at most; unused ones hold zeros.
  static constexpr double largest_drive(std::size_t column) {
    double most = 0.0;
    for (const auto& drive : drives)
      most = larger(most, magnitude(drive.*drive_numbers<double>[column]));
    return most;
  }
  static constexpr int drive_exponent(std::size_t column) {
    const auto member = drive_numbers<double>[column];
    if (member == &DriveConstants<double>::coulomb_forward || member == &DriveConstants<double>::coulomb_backward)
      return Formats::format.joint_effort;
    return fitting_exponent(largest_drive(column), Formats::Arithmetic::capacity);
  }
  static constexpr std::size_t drive_column(TableWord DriveConstants<TableWord>::*member) {
    std::size_t column = 0;
    while (drive_numbers<TableWord>[column] != member)
      ++column;
    return column;
  }
  static constexpr DriveConstants<TableWord> drive_row(const DriveConstants<double>& c) {
    DriveConstants<TableWord> r;
    for (std::size_t i = 0; i < sizeof(drive_numbers<double>) / sizeof(drive_numbers<double>[0]); ++i)
      r.*drive_numbers<TableWord>[i] = table_word(c.*drive_numbers<double>[i], drive_exponent(i));
    return r;
  }
};

template <class Row, int size>
struct FixedRows {
  Row links[size];
};
template <class Row, class Get, int... I>
constexpr FixedRows<Row, sizeof...(I)> fixed_rows(const Get& get, std::integer_sequence<int, I...>) {
  return {{get(I)...}};
}
template <class Row, class Formats>
inline constexpr auto fixed_table =
    fixed_rows<Row>([](int i) { return FixedTable<Formats>::template row<Row>(FixedTable<Formats>::links[i]); },
                    std::make_integer_sequence<int, FixedTable<Formats>::size>{});
template <class Formats>
inline constexpr auto fixed_drives = fixed_rows<DriveConstants<TableWord>>(
    [](int i) { return FixedTable<Formats>::drive_row(FixedTable<Formats>::drives[i]); },
    std::make_integer_sequence<int, FixedTable<Formats>::size>{});

}  // namespace detail

/// Row of a table of integers.
template <class SceneType, class S, class Columns, class Formats>
class FixedTableLink
    : public detail::TableRow<FixedTableLink<SceneType, S, Columns, Formats>, detail::TableWord, Columns>,
      public detail::FormatRounding<S, Formats, 0> {
  using Base = detail::TableRow<FixedTableLink, detail::TableWord, Columns>;
  using Table = detail::FixedTable<Formats>;

 public:
  using Scene = SceneType;                   ///< what the links belong to
  using Scalar = S;                          ///< arithmetic
  static constexpr bool adds_angles = true;  ///< a theta that is no quarter turn is added to the angle of a joint
  using Base::Base;

  /// A word of the table as a number at its column's exponent.
  template <auto M>
  AXIAL_INLINE static constexpr auto number(detail::TableWord x) {
    return Fx<Formats::columns.of(M), S>{static_cast<typename S::Word>(x)};
  }
  /// A constant of the drive; zero by type where no link has any.
  template <detail::DriveMember<detail::TableWord> M>
  AXIAL_INLINE constexpr auto drive() const {
    constexpr std::size_t column = Table::drive_column(M);
    if constexpr (Table::largest_drive(column) > 0.0)
      return Fx<Table::drive_exponent(column), S>{static_cast<typename S::Word>(this->drives->*M)};
    else
      return Zero{};
  }
  /// A joint's angle with the constant part of its turn.
  AXIAL_INLINE constexpr Bam<S> with_offset(const Bam<S>& q) const { return q + Bam<S>{this->row.theta}; }
  /// Results in the formats that all links share.
  template <class V>
  AXIAL_INLINE static constexpr auto shape(const V& v) {
    return v.template dense<detail::InSharedFormats<Formats>>();
  }
};

/// The links of a scene over a constexpr table of integers.
template <class SceneType, class S, class ParametersType, class FormatsType>
struct FixedTableLinks : SharedValues<FixedTableLinks<SceneType, S, ParametersType, FormatsType>, SceneType, S> {
  using Scene = SceneType;                         ///< what the links belong to
  using Robot = typename Scene::Robot;             ///< of the scene
  using Scalar = S;                                ///< arithmetic
  using Formats = FormatsType;                     ///< shared by all links
  using Dense = detail::InSharedFormats<Formats>;  ///< what kernels keep
  /// what all links have in common
  using SharedColumns = detail::CommonConstants<detail::RobotConstants<Robot, ParametersType>>;
  using Link = FixedTableLink<Scene, S, SharedColumns, Formats>;  ///< one type for all
  static constexpr bool unrolled = false;                         ///< a loop walks over them
  static constexpr int capacity = Robot::chain.size;              ///< number of links

  AXIAL_INLINE static constexpr int size() { return capacity; }  ///< number of links
  /// Link i as algorithms see it.
  AXIAL_INLINE static constexpr auto link(int i) { return Link(rows().links[i], drives(i), i + 1 == capacity); }
  /// index of the link that carries joint i, negative for the base
  AXIAL_INLINE static constexpr int parent_index(int i) { return rows().links[i].parent; }
  AXIAL_INLINE static constexpr int last() { return capacity - 1; }  ///< index of the last link
  /// Acceleration of the base that stands for gravity, -g in frame 0.
  AXIAL_INLINE static constexpr auto base_acceleration() {
    using A = Kept<Dense, quantity::LinearAcceleration>;
    using N = NumberTraits<A>;
    constexpr auto& g = Robot::chain.gravity;
    if constexpr (Scene::template has<Gravity>)
      return Vec3{N::constant(-g.x), N::constant(-g.y), N::constant(-g.z)};
    else
      return ZeroVec3{};
  }
  /// Pose of frame 0 in the world.
  AXIAL_INLINE static constexpr auto base_pose() {
    return detail::constant_pose<Scalar>([] { return Robot::chain.base.pose; });
  }
  /// Pose of the tool in the last link's frame.
  AXIAL_INLINE static constexpr auto tool_pose() {
    return detail::constant_pose<Scalar>([] { return Robot::chain.tool.pose; });
  }

 private:
  AXIAL_INLINE static constexpr const auto& rows() { return detail::fixed_table<typename Link::Constants, Formats>; }
  AXIAL_INLINE static constexpr const DriveConstants<detail::TableWord>* drives(int i) {
    if constexpr (Scene::template has<Friction>)
      return detail::fixed_drives<Formats>.links + i;
    else
      return nullptr;
  }
};

}  // namespace axial

#include <axial/options/end.hpp>

// How an algorithm sees the base body, a link without a joint, and the water about it or about a link: as types and
// literals, or as a row of numbers.
#pragma once

#include <axial/links/links.hpp>
#include <axial/links/run_time_model.hpp>
#include <axial/links/water_constants.hpp>
#include <axial/spatial/articulated_inertia.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// A robot whose only link is the base body of another, so that one view serves both.
template <class Robot>
struct BaseBodyOf {
  static constexpr auto chain = [] {
    Chain<1> body;
    body.links[0] = Robot::chain.base_body;
    return body;
  }();
};

/// Whether a body that floats is declared.
template <class Robot>
constexpr auto check_base_body() {
  if constexpr (is_described<Robot>)
    static_assert(Robot::chain.has_base_body,
                  "axial: FloatingBase needs the inertia of the body that floats; add "
                  "axial::base_body().mass(kg).com(x, y, z).inertia_com(...) to the robot's chain");
}

template <class Scene, class Robot>
struct SceneOnRobot;
template <class Old, class... Features, class Robot>
struct SceneOnRobot<Scene<Old, Features...>, Robot> {
  using type = Scene<Robot, Features...>;
};

}  // namespace detail

/// The base body: mass, first moment and inertia about the origin of frame 0, in its axes. Constants are types and
/// literals, in the looped form too; a run-time model's are its own numbers.
template <class Links>
AXIAL_INLINE constexpr auto base_link(const Links& links) {
  using Scene = typename Links::Scene;
  using Robot = typename Scene::Robot;
  if constexpr (IsModel<Robot>::value)
    return links.base_link();
  else
    return StaticLink<typename detail::SceneOnRobot<Scene, detail::BaseBodyOf<Robot>>::type, 0, typename Links::Scalar,
                      FullParameters>{};
}

namespace detail {

template <class T>
using WaterMember = T WaterConstants<T>::*;

/// Accessors over `get<member>()` of the view.
template <class View, class Source>
class WaterAccess {
  using C = WaterConstants<Source>;
  template <WaterMember<Source> M>
  AXIAL_INLINE constexpr auto at() const {
    return static_cast<const View&>(*this).template get<M>();
  }

 public:
  AXIAL_INLINE constexpr auto centre() const { return Vec3{at<&C::cx>(), at<&C::cy>(), at<&C::cz>()}; }
  AXIAL_INLINE constexpr auto displaced() const { return at<&C::displaced>(); }
  AXIAL_INLINE constexpr auto displaced_moment() const { return Vec3{at<&C::hx>(), at<&C::hy>(), at<&C::hz>()}; }
  AXIAL_INLINE constexpr auto added_mass() const { return Vec3{at<&C::mx>(), at<&C::my>(), at<&C::mz>()}; }
  AXIAL_INLINE constexpr auto added_inertia() const { return Vec3{at<&C::ix>(), at<&C::iy>(), at<&C::iz>()}; }
  /// (mz - my, mx - mz, my - mx), and of the inertias alike.
  AXIAL_INLINE constexpr auto mass_differences() const {
    return Vec3{at<&C::mz_my>(), at<&C::mx_mz>(), at<&C::my_mx>()};
  }
  AXIAL_INLINE constexpr auto inertia_differences() const {
    return Vec3{at<&C::iz_iy>(), at<&C::ix_iz>(), at<&C::iy_ix>()};
  }
  AXIAL_INLINE constexpr auto linear_drag() const { return Vec3{at<&C::lx>(), at<&C::ly>(), at<&C::lz>()}; }
  AXIAL_INLINE constexpr auto linear_turning_drag() const { return Vec3{at<&C::lrx>(), at<&C::lry>(), at<&C::lrz>()}; }
  AXIAL_INLINE constexpr auto quadratic_drag() const { return Vec3{at<&C::qx>(), at<&C::qy>(), at<&C::qz>()}; }
  AXIAL_INLINE constexpr auto quadratic_turning_drag() const {
    return Vec3{at<&C::qrx>(), at<&C::qry>(), at<&C::qrz>()};
  }
  /// Added mass as a 6x6 inertia about the origin of the frame.
  AXIAL_INLINE constexpr auto inertia() const {
    constexpr Zero o;
    auto m = added_mass();
    return ArticulatedInertia{
        Sym3{at<&C::jxx>(), at<&C::jyy>(), at<&C::jzz>(), at<&C::jxy>(), at<&C::jxz>(), at<&C::jyz>()},
        Mat3{Vec3{o, at<&C::c_xy>(), at<&C::c_xz>()}, Vec3{at<&C::c_yx>(), o, at<&C::c_yz>()},
             Vec3{at<&C::c_zx>(), at<&C::c_zy>(), o}},
        Sym3{m.x, m.y, m.z, o, o, o}};
  }
  AXIAL_INLINE constexpr auto scale_mass() const { return at<&C::scale_mass>(); }
  AXIAL_INLINE constexpr auto scale_first_moment() const { return at<&C::scale_first_moment>(); }
  AXIAL_INLINE constexpr auto scale_polar() const { return at<&C::scale_polar>(); }
};

/// The water of a robot's links, and of its base body last; instantiated only by scenes that name Underwater.
template <class Robot, class T, int... I>
constexpr auto all_waters(std::integer_sequence<int, I...>) {
  struct Table {
    WaterConstants<T> links[sizeof...(I) + 1];
  };
  return Table{{water_constants<T>(Robot::chain.links[I].water)..., water_constants<T>(Robot::chain.base_body.water)}};
}
template <class Robot, class T>
inline constexpr auto robot_waters = all_waters<Robot, T>(std::make_integer_sequence<int, Robot::chain.size>{});

}  // namespace detail

/// The water about link I of a robot, or about its base body where I is the number of its links.
template <class Robot, int I, class T>
struct StaticWater : detail::WaterAccess<StaticWater<Robot, I, T>, double> {
  /// A constant, as a type or a literal.
  template <detail::WaterMember<double> M>
  AXIAL_INLINE static constexpr auto get() {
    return literal<T>([] { return detail::robot_waters<Robot, double>.links[I].*M; });
  }
};

/// The water about a link or a base body, from a row of a table.
template <class T, class Source>
struct TableWater : detail::WaterAccess<TableWater<T, Source>, Source> {
  const WaterConstants<Source>& row;  ///< of the table

  /// Refers to the row.
  AXIAL_INLINE constexpr explicit TableWater(const WaterConstants<Source>& constants) : row(constants) {}
  /// A constant of the row.
  template <detail::WaterMember<Source> M>
  AXIAL_INLINE constexpr T get() const {
    if constexpr (std::is_same_v<T, Source>)
      return row.*M;
    else
      return NumberTraits<T>::constant(row.*M);
  }
};

/// The water about link i.
template <class Links, class I>
AXIAL_INLINE constexpr auto water_of(const Links& links, I i) {
  using T = typename Links::Scalar;
  using Robot = typename Links::Scene::Robot;
  if constexpr (IsModel<Robot>::value)
    return TableWater<T, double>(links.water(i));
  else if constexpr (Links::unrolled)
    return StaticWater<Robot, I::value, T>{};
  else
    return TableWater<T, Lane<T>>(detail::robot_waters<Robot, Lane<T>>.links[i]);
}
/// The water about the base body.
template <class Links>
AXIAL_INLINE constexpr auto water_of_base(const Links& links) {
  using Robot = typename Links::Scene::Robot;
  if constexpr (IsModel<Robot>::value)
    return TableWater<typename Links::Scalar, double>(links.base_water());
  else
    return StaticWater<Robot, Robot::chain.size, typename Links::Scalar>{};
}

}  // namespace axial

#include <axial/options/end.hpp>

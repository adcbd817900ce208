// How an algorithm sees a link: through constants known to the compiler (unrolled) or through a table (looped).
#pragma once

#include <axial/links/base_parameters.hpp>
#include <axial/links/link_constants.hpp>
#include <axial/scalar/rounding.hpp>
#include <axial/scene/joints.hpp>
#include <axial/spatial/congruence.hpp>

#include <utility>

#include <axial/options/begin.hpp>

namespace axial {

/// Index of a link as a type, usable as an int.
template <int I>
using Index = std::integral_constant<int, I>;

namespace detail {

template <int N>
struct ConstantsTable {
  TreeLinkConstants<double> links[N];
};

template <class Robot, class Parameters, int... I>
constexpr auto all_constants(std::integer_sequence<int, I...>) {
  constexpr int size = sizeof...(I);
  ConstantsTable<size> table{{link_constants(Robot::chain.links[I], Robot::chain.parent(I))...}};
  if constexpr (!std::is_same_v<Parameters, FullParameters>) regroup_as<Parameters>(table.links, size);
  return table;
}

/// The derived constants of a robot, computed by the compiler.
template <class Robot, class Parameters = FullParameters>
inline constexpr auto robot_constants =
    all_constants<Robot, Parameters>(std::make_integer_sequence<int, Robot::chain.size>{});
template <class Robot, class Parameters>
struct RobotConstants {
  static constexpr const auto& table = robot_constants<Robot, Parameters>;
};

template <class Robot, class T, int... I>
constexpr auto all_drives(std::integer_sequence<int, I...>) {
  struct Table {
    DriveConstants<T> links[sizeof...(I)];
  };
  return Table{{converted<T>(drive_constants(Robot::chain.links[I]))...}};
}
/// Friction and springs of a robot; instantiated only by scenes that name them.
template <class Robot, class T>
inline constexpr auto robot_drives = all_drives<Robot, T>(std::make_integer_sequence<int, Robot::chain.size>{});

template <class T>
using Member = T LinkConstants<T>::*;
template <class T>
using DriveMember = T DriveConstants<T>::*;
template <class T>
using BranchMember = T BranchConstants<T>::*;

// Whether a link of a robot declares this; a run-time model may.
template <class Robot, class T, DriveMember<T> M>
constexpr bool any_drive_has() {
  if constexpr (is_described<Robot>)
    for (const auto& drive : robot_drives<Robot, T>.links)
      if (drive.*M < T(Zero{}) || drive.*M > T(Zero{})) return true;
  return !is_described<Robot>;
}

// A joint's position as the kind of the joint reads it.
template <class Q>
AXIAL_INLINE constexpr const Q& joint_angle(const Q& q) {
  return q;
}
template <class Q>
AXIAL_INLINE constexpr const Q& joint_length(const Q& q) {
  return q;
}

/// What both views share: the accessors, written over `get<member>()` of the view.
template <class View, class Source>
class LinkAccess {
  using C = LinkConstants<Source>;
  using D = DriveConstants<Source>;
  using B = BranchConstants<Source>;
  AXIAL_INLINE constexpr const View& self() const { return static_cast<const View&>(*this); }

 public:
  /// The constant way from the parent's frame to the joint's axis: the x-screw, behind a branch's z-screw.
  AXIAL_INLINE constexpr auto x() const {
    if constexpr (View::branches)
      return BranchScrew{z_screw(self().template branch<&B::cos_gamma>(), self().template branch<&B::sin_gamma>(),
                                 self().template branch<&B::b>())
                             .with_turn(self().template branch_beyond_45_degrees<&B::sin_gamma>()),
                         twist()};
    else
      return twist();
  }
  /// The same for what the link sends to its parent; the identity where nobody reads it.
  AXIAL_INLINE constexpr auto x_inboard() const {
    if constexpr (View::is_heard)
      return x();
    else
      return x_screw(One{}, Zero{}, Zero{});
  }
  AXIAL_INLINE constexpr auto mass() const { return mass_as<View::has_axial_mass>(self().template get<&C::mass>()); }
  AXIAL_INLINE constexpr auto first_moment() const {
    return Vec3{self().template get<&C::hx>(), self().template get<&C::hy>(), self().template get<&C::hz>()};
  }
  AXIAL_INLINE constexpr auto inertia() const {
    return Sym3{self().template get<&C::jxx>(), self().template get<&C::jyy>(), self().template get<&C::jzz>(),
                self().template get<&C::jxy>(), self().template get<&C::jxz>(), self().template get<&C::jyz>()};
  }
  AXIAL_INLINE constexpr auto body() const { return RigidInertia{mass(), first_moment(), inertia()}; }
  /// (Jzz - Jyy, Jxx - Jzz, Jyy - Jxx).
  AXIAL_INLINE constexpr auto inertia_differences() const {
    return Vec3{self().template get<&C::jzz_jyy>(), self().template get<&C::jxx_jzz>(),
                self().template get<&C::jyy_jxx>()};
  }
  AXIAL_INLINE constexpr auto rotor() const {
    if constexpr (View::Scene::template has<RotorInertia>)
      return self().template get<&C::rotor>();
    else
      return Zero{};
  }
  AXIAL_INLINE constexpr auto viscous() const { return self().template drive<&D::viscous>(); }
  AXIAL_INLINE constexpr auto coulomb_forward() const { return self().template drive<&D::coulomb_forward>(); }
  AXIAL_INLINE constexpr auto coulomb_backward() const { return self().template drive<&D::coulomb_backward>(); }
  AXIAL_INLINE constexpr auto stribeck_forward() const { return self().template drive<&D::stribeck_forward>(); }
  AXIAL_INLINE constexpr auto stribeck_backward() const { return self().template drive<&D::stribeck_backward>(); }
  AXIAL_INLINE constexpr auto inverse_stribeck_speed2() const {
    return self().template drive<&D::inverse_stribeck_speed2>();
  }
  AXIAL_INLINE constexpr auto inverse_smooth_speed() const { return self().template drive<&D::inverse_smooth_speed>(); }
  AXIAL_INLINE constexpr auto spring_stiffness() const { return self().template drive<&D::spring_stiffness>(); }
  AXIAL_INLINE constexpr auto spring_rest() const { return self().template drive<&D::spring_rest>(); }

  /// Turn and shift of the joint at position q: about z by theta + q (rad), or along z by d + q (m).
  template <class Q>
  AXIAL_INLINE constexpr auto z(const Q& q) const {
    return self().on_joint([&](auto joint) AXIAL_INLINE { return self().shape(joint_screw(joint, q)); });
  }
  /// Overload with the sine and cosine of q (without theta), which only a revolute joint looks at.
  template <class Q, class T>
  AXIAL_INLINE constexpr auto z(const Q& q, const SinCos<T>& turn) const {
    return self().on_joint([&](auto joint) AXIAL_INLINE {
      if constexpr (std::is_same_v<decltype(joint), Revolute>)
        return self().shape(turned_screw(turn));
      else
        return self().shape(joint_screw(joint, q));
    });
  }

 private:
  AXIAL_INLINE constexpr auto twist() const {
    return x_screw(self().template get<&C::cos_alpha>(), self().template get<&C::sin_alpha>(),
                   self().template get<&C::a>())
        .with_turn(self().template beyond_45_degrees<&C::sin_alpha>());
  }
  template <class T>
  AXIAL_INLINE constexpr auto turned_screw(const SinCos<T>& q) const {
    auto ct = self().template get<&C::cos_theta>();
    auto st = self().template get<&C::sin_theta>();
    return z_screw(turned(ct * q.cos - st * q.sin), turned(st * q.cos + ct * q.sin), self().template get<&C::d>());
  }
  template <class Q>
  AXIAL_INLINE constexpr auto joint_screw(Revolute, const Q& q) const {
    if constexpr (is_structural_v<decltype(self().template get<&C::cos_theta>())> || !View::adds_angles) {
      // Exact for quarter turns. Floating point never adds theta to q: of many turns the sum would lose digits.
      return turned_screw(sincos(joint_angle(q)));
    } else {
      auto pair = sincos(self().with_offset(joint_angle(q)));
      return z_screw(pair.cos, pair.sin, self().template get<&C::d>());
    }
  }
  template <class Q>
  AXIAL_INLINE constexpr auto joint_screw(Prismatic, const Q& q) const {
    return z_screw(self().template get<&C::cos_theta>(), self().template get<&C::sin_theta>(),
                   self().sum(quantity::Length{}, self().template get<&C::d>(), joint_length(q)))
        .with_turn(self().template beyond_45_degrees<&C::sin_theta>());
  }
};

}  // namespace detail

/// Link I of a scene's robot: every constant that is 0 or +-1 is a type, the rest are literals of T.
template <class SceneType, int I, class T, class Parameters, class Rounder = Plain>
class StaticLink : public detail::LinkAccess<StaticLink<SceneType, I, T, Parameters, Rounder>, double>, public Rounder {
  static constexpr const auto& own = detail::robot_constants<typename SceneType::Robot, Parameters>.links[I];

 public:
  using Scene = SceneType;                ///< what the link belongs to
  using Scalar = T;                       ///< the number, or what a number system computes by
  static constexpr bool unrolled = true;  ///< every link has its own type
  /// a theta that is no quarter turn is added to the angle of a joint: exact in binary angles alone
  static constexpr bool adds_angles = !is_number_v<T>;
  /// whether it is the chain's last link, which bears payload and tip wrench
  static constexpr bool is_last = I + 1 == Scene::Robot::chain.size;

  /// whether its parent bears its mass across the joint's direction
  static constexpr bool has_axial_mass =
      std::is_same_v<Parameters, BaseParametersAndAxialMasses> &&
      detail::has_axial_mass(detail::robot_constants<typename Scene::Robot>.links, Scene::Robot::chain.size, I);
  /// A constant of the link, as a type or a literal.
  template <detail::Member<double> M>
  AXIAL_INLINE static constexpr auto get() {
    return detail::literal_of_bits<T, detail::bits_of(own.*M)>();
  }
  /// whether it has a branch's z-screw
  static constexpr bool branches = own.branches();
  /// A constant of the link's branch, as a type or a literal.
  template <detail::BranchMember<double> M>
  AXIAL_INLINE static constexpr auto branch() {
    return detail::literal_of_bits<T, detail::bits_of(own.branch.*M)>();
  }
  /// A constant of the link's drive, as a type or a literal.
  template <detail::DriveMember<double> M>
  AXIAL_INLINE static constexpr auto drive() {
    return detail::literal_of_bits<T,
                                   detail::bits_of(detail::robot_drives<typename Scene::Robot, double>.links[I].*M)>();
  }
  /// A joint's binary angle with the constant part of its turn.
  template <class Q>
  AXIAL_INLINE static constexpr auto with_offset(const Q& q) {
    return turned_by(q, [] { return own.theta; });
  }
  /// Whether a constant turn is nearer to a quarter turn than to none, as a type.
  template <detail::Member<double> Sine>
  AXIAL_INLINE static constexpr auto beyond_45_degrees() {
    return std::bool_constant<(own.*Sine * own.*Sine > 0.5)>{};
  }
  /// Whether a branch's constant turn is nearer to a quarter turn than to none, as a type.
  template <detail::BranchMember<double> Sine>
  AXIAL_INLINE static constexpr auto branch_beyond_45_degrees() {
    return std::bool_constant<(own.branch.*Sine * own.branch.*Sine > 0.5)>{};
  }
  /// Calls f with the kind of this joint.
  template <class F>
  AXIAL_INLINE static constexpr auto on_joint(const F& f) {
    if constexpr (own.prismatic)
      return f(Prismatic{});
    else
      return f(Revolute{});
  }
  /// The form in which this view keeps a result: with its structural zeros.
  template <class V>
  AXIAL_INLINE static constexpr const V& shape(const V& v) {
    return v;
  }
};

}  // namespace axial

#include <axial/options/end.hpp>

// Rotors as bodies that spin on the links that carry them: constants, and how an algorithm sees them.
#pragma once

#include <axial/links/links.hpp>
#include <axial/links/run_time_model.hpp>
#include <axial/scalar/math.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Rotor of one joint: gear J along its axis, in axes of the link that carries it. Times the joint's speed that is what
/// its spin adds to the carrier's angular momentum.
template <class T>
struct RotorConstants {
  int carrier = -1;  ///< index of the link that carries it, inboard of its joint; negative for the base
  T x{}, y{}, z{};   ///< kg m^2; of a slide kg m
};

/// Rotor constants from a link's description; `parent` is the index of the link that carries its joint.
constexpr RotorConstants<double> rotor_constants(const LinkParameters& p, int parent) {
  const auto& given = p.rotor_axis;
  const double size = square_root(given[0] * given[0] + given[1] * given[1] + given[2] * given[2]);
  const double spin = p.gear * p.rotor_inertia;
  const int carrier = p.rotor_carrier == LinkParameters::previous ? parent : p.rotor_carrier;
  if (size > 0.0) return {carrier, spin * (given[0] / size), spin * (given[1] / size), spin * (given[2] / size)};
  return {carrier, spin * p.gamma.sin * p.alpha.sin, -spin * p.gamma.cos * p.alpha.sin, spin * p.alpha.cos};
}

/// Rotor constants in another number format.
template <class T>
constexpr RotorConstants<T> converted(const RotorConstants<double>& c) {
  using N = NumberTraits<T>;
  return {c.carrier, N::constant(c.x), N::constant(c.y), N::constant(c.z)};
}

namespace detail {

template <class Robot, class T, int... I>
constexpr auto all_rotors(std::integer_sequence<int, I...>) {
  struct Table {
    RotorConstants<T> links[sizeof...(I)];
  };
  return Table{{converted<T>(rotor_constants(Robot::chain.links[I], Robot::chain.parent(I)))...}};
}
/// Rotors of a robot; instantiated only by scenes that name RotorDynamics.
template <class Robot, class T>
inline constexpr auto robot_rotors = all_rotors<Robot, T>(std::make_integer_sequence<int, Robot::chain.size>{});

template <class Robot>
constexpr bool rotors_are_inboard() {
  for (int i = 0; i < Robot::chain.size; ++i) {
    const int carrier = robot_rotors<Robot, double>.links[i].carrier;
    int inboard = Robot::chain.parent(i);
    while (inboard > carrier)
      inboard = Robot::chain.parent(inboard);
    if (inboard != carrier) return false;
  }
  return true;
}

}  // namespace detail

/// Rotor of joint I of a robot, as types and literals of T.
template <class Robot, int I, class T>
struct StaticRotor {
  static_assert(detail::rotors_are_inboard<Robot>(),
                "axial: a rotor turns on a link between its joint and the base; name such a link in rotor_axis(), or "
                "none for the joint's own parent");
  /// index of the link that carries it
  AXIAL_INLINE static constexpr int carrier() { return detail::robot_rotors<Robot, double>.links[I].carrier; }
  /// gear J along its axis
  AXIAL_INLINE static constexpr auto spin() {
    return Vec3{literal<T>([] { return detail::robot_rotors<Robot, double>.links[I].x; }),
                literal<T>([] { return detail::robot_rotors<Robot, double>.links[I].y; }),
                literal<T>([] { return detail::robot_rotors<Robot, double>.links[I].z; })};
  }
};

/// Rotor of a joint from a row of a table.
template <class T, class Source>
struct TableRotor {
  const RotorConstants<Source>& row;  ///< of the table

  AXIAL_INLINE constexpr int carrier() const { return row.carrier; }  ///< index of the link that carries it
  /// gear J along its axis
  AXIAL_INLINE constexpr Vec3<T> spin() const {
    if constexpr (std::is_same_v<T, Source>)
      return {row.x, row.y, row.z};
    else
      return {NumberTraits<T>::constant(row.x), NumberTraits<T>::constant(row.y), NumberTraits<T>::constant(row.z)};
  }
};

/// The rotor of joint i.
struct RotorOf {
  /// its constants
  template <class Links, class I>
  AXIAL_INLINE static constexpr auto run(const Links& links, I i) {
    using T = typename Links::Scalar;
    using Robot = typename Links::Scene::Robot;
    if constexpr (IsModel<Robot>::value)
      return TableRotor<T, double>{links.rotor(i)};
    else if constexpr (Links::unrolled)
      return StaticRotor<Robot, I::value, T>{};
    else
      return TableRotor<T, Lane<T>>{detail::robot_rotors<Robot, Lane<T>>.links[i]};
  }
};
/// The same over any links.
template <class Links, class I>
AXIAL_INLINE constexpr auto rotor_of(const Links& links, I i) {
  return execute<RotorOf>(links, i);
}

}  // namespace axial

#include <axial/options/end.hpp>

// Views of a robot of two links, written by hand: the members that firmware/include/axial/links/README.md lists, and no
// other.
#pragma once

#include <axial/links/link_view.hpp>
#include <axial/robot/chain.hpp>
#include <axial/spatial/screw.hpp>

#include <cmath>

namespace minimal {

using namespace axial;

// A turning joint, and a slide along an axis that leans by 0.3 rad. Both numbers of a pair are by link.
struct Numbers {
  static constexpr double a[] = {0.0, 0.5}, alpha[] = {0.0, 0.3}, d[] = {0.1, 0.2}, mass[] = {2.0, 1.0};
  static constexpr double com_x[] = {0.25, 0.0}, com_z[] = {0.0, 0.125}, inertia[] = {0.03125, 0.0625};
  static constexpr double rotor[] = {0.5, 0.75}, viscous[] = {1.5, 2.5}, coulomb[] = {0.25, 0.5};
  static constexpr double breakaway[] = {0.75, 1.0}, stribeck_speed[] = {0.5, 0.25}, smooth_speed[] = {0.125, 0.125};
  static constexpr double stiffness[] = {3.0, 4.0}, rest[] = {0.125, 0.25};
  static constexpr bool slides[] = {false, true};

  static constexpr auto described(const Link& joint, int i) {
    return joint.a(a[i]).alpha(alpha[i]).mass(mass[i]).com(com_x[i], 0.0, com_z[i]);
  }
  static constexpr auto driven(const Link& link, int i) {
    return link.inertia_com(inertia[i], inertia[i], inertia[i])
        .rotor_inertia(rotor[i], 1.0)
        .viscous(viscous[i])
        .coulomb(coulomb[i])
        .stribeck(breakaway[i], stribeck_speed[i])
        .smooth_speed(smooth_speed[i])
        .spring(stiffness[i], rest[i]);
  }
};
struct Arm {
  static constexpr auto chain = axial::chain(
      gravity(0.0, 1.0, -9.75), Numbers::driven(Numbers::described(revolute().d(Numbers::d[0]), 0), 0),
      Numbers::driven(Numbers::described(prismatic().d(Numbers::d[1]), 1), 1), payload_limit(2.0, 0.5, 1.0));
};

// What both forms have in common. `Place` is an int, or a type with one.
template <class SceneType, bool is_unrolled, class Place>
struct MinimalLink {
  using Scene = SceneType;
  using Scalar = double;
  static constexpr bool unrolled = is_unrolled;
  static constexpr bool ranged = false;
  const Place i;

  template <class F>
  constexpr auto on_joint(const F& f) const {
    if constexpr (!unrolled) {
      if (Numbers::slides[i]) return f(Prismatic{});
      return f(Revolute{});
    } else if constexpr (Numbers::slides[Place{}]) {
      return f(Prismatic{});
    } else {
      return f(Revolute{});
    }
  }
  auto x() const {
    return x_screw(std::cos(Numbers::alpha[i]), std::sin(Numbers::alpha[i]), Numbers::a[i]).with_turn(AnyTurn{});
  }
  auto x_inboard() const { return x(); }
  auto z(double q) const { return z(q, SinCos<double>{std::sin(q), std::cos(q)}); }
  auto z(double q, const SinCos<double>& turn) const {
    const bool slides = Numbers::slides[i];
    return z_screw(slides ? 1.0 : turn.cos, slides ? 0.0 : turn.sin, Numbers::d[i] + (slides ? q : 0.0))
        .with_turn(AnyTurn{});
  }
  constexpr auto body() const {
    const double m = Numbers::mass[i], cx = Numbers::com_x[i], cz = Numbers::com_z[i], j = Numbers::inertia[i];
    return RigidInertia{
        m, Vec3<double>{m * cx, 0.0, m * cz},
        Sym3<double>{j + m * cz * cz, j + m * (cx * cx + cz * cz), j + m * cx * cx, 0.0, -m * cx * cz, 0.0}};
  }
  constexpr auto inertia_differences() const {
    const auto j = body().inertia;
    return Vec3<double>{j.zz - j.yy, j.xx - j.zz, j.yy - j.xx};
  }
  constexpr double rotor() const { return Numbers::rotor[i]; }
  constexpr double viscous() const { return Numbers::viscous[i]; }
  constexpr double coulomb_forward() const { return Numbers::coulomb[i]; }
  constexpr double coulomb_backward() const { return -Numbers::coulomb[i]; }
  constexpr double stribeck_forward() const { return Numbers::breakaway[i] - Numbers::coulomb[i]; }
  constexpr double stribeck_backward() const { return Numbers::coulomb[i] - Numbers::breakaway[i]; }
  constexpr double inverse_stribeck_speed2() const {
    return 1.0 / (Numbers::stribeck_speed[i] * Numbers::stribeck_speed[i]);
  }
  constexpr double inverse_smooth_speed() const { return 1.0 / Numbers::smooth_speed[i]; }
  constexpr double spring_stiffness() const { return Numbers::stiffness[i]; }
  constexpr double spring_rest() const { return Numbers::rest[i]; }

  template <class V>
  constexpr auto shape(const V& v) const {
    if constexpr (is_scalar_v<V>)
      return static_cast<double>(v);
    else
      return v.template dense<double>();
  }
  template <class Quantity, class... Terms>
  constexpr auto sum(Quantity, const Terms&... terms) const {
    return (... + terms);
  }
  template <class Quantity, class Inverse, class X>
  constexpr auto quotient(Quantity, const Inverse& inverse, const X& x) const {
    return inverse * x;
  }
  template <class Quantity, class... Terms>
  constexpr auto limited(Quantity, bool&, const Terms&... terms) const {
    return (... + terms);
  }
  template <class D, class U, class M>
  constexpr auto gated_drive(bool&, const D&, const U& u, M) const {
    return u;
  }
  template <class Inertia>
  constexpr auto formatted(const Inertia& inertia) const {
    return inertia;
  }
  template <class A, class B>
  constexpr auto add(const A& a, const B& b) const {
    return a + b;
  }
  template <class A, class B>
  constexpr auto subtract(const A& force, const B& other) const {
    return force - other;
  }
  constexpr Plain outer() const { return {}; }
};
template <class SceneType>
struct LoopedLink : MinimalLink<SceneType, false, int> {
  const bool is_last = this->i == 1;
};
template <class SceneType, int I>
struct UnrolledLink : MinimalLink<SceneType, true, Index<I>> {
  static constexpr bool is_last = I == 1;
};

// What both forms of links have in common.
template <class SceneType>
struct MinimalLinks {
  using Scene = SceneType;
  using Scalar = double;
  static constexpr int capacity = 2;
  static constexpr Status::Code lost_code = Status::Code::near_singular;

  constexpr int size() const { return 2; }
  constexpr int parent_index(int i) const { return i - 1; }
  constexpr Vec3<double> base_acceleration() const { return {0.0, -1.0, 9.75}; }
  constexpr Pose<Mat3<Vec3<double>>, Vec3<double>> base_pose() const {
    return {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, {0.0, 0.0, 0.0}};
  }
  constexpr auto tool_pose() const { return base_pose(); }
  template <class Values>
  constexpr const Values& read(const Values& values) const {
    return values;
  }
  constexpr auto no_efforts() const { return Efforts<Arm, double>{}; }
  template <class Values, class I, class X>
  constexpr void write(Values& values, I i, const X& x) const {
    values[i] = static_cast<double>(x);
  }
  template <class Values, class I, class X>
  constexpr void write_limited(Values& values, I i, const X& x, bool&) const {
    values[i] = static_cast<double>(x);
  }
  template <class Values, class I, class X, class Y>
  constexpr void write_difference(Values& values, I i, const X& x, const Y& y) const {
    values[i] = static_cast<double>(x - y);
  }
  template <class V>
  constexpr auto stored(const V& v) const {
    return v.template dense<double>();
  }
};
template <class SceneType>
struct LoopedLinks : MinimalLinks<SceneType> {
  using Dense = double;
  static constexpr bool unrolled = false;
  constexpr auto link(int i) const { return LoopedLink<SceneType>{{i}}; }
  constexpr int last() const { return 1; }
};
template <class SceneType>
struct UnrolledLinks : MinimalLinks<SceneType>,
                       IndexedLinks<UnrolledLinks<SceneType>, std::make_integer_sequence<int, 2>> {
  static constexpr bool unrolled = true;
  using Parameters = FullParameters;
  template <int I>
  static constexpr int parent_of = I - 1;
  template <int I>
  constexpr auto link(Index<I>) const {
    return UnrolledLink<SceneType, I>{};
  }
  constexpr auto last() const { return Index<1>{}; }
};

}  // namespace minimal

// Joint efforts as a linear function of the links' inertial parameters, and of rotors and friction.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Inertial parameters of a link, in the order of a regressor's columns: mass (kg), first moment m c (kg m), inertia
/// about the origin of the link's frame (kg m^2, elements of the tensor), in the axes of that frame.
enum class InertialParameter { mass, hx, hy, hz, xx, yy, zz, xy, xz, yz };

namespace regressor {

/// Columns of rotors: gear^2 J of a joint's own drive, of which nothing acts on other joints.
template <class S, class T, bool present = scene_of<S>::template has<RotorInertia>>
struct RotorColumns {
  Accelerations<robot_of<S>, T> rotor{};  ///< d tau_i / d (gear^2 J of drive i): rad/s^2 or m/s^2
};
/// No columns of rotors: a scene without RotorInertia.
template <class S, class T>
struct RotorColumns<S, T, false> {};
/// Columns of friction, of which nothing acts on other joints; static friction, the Stribeck speed and the smooth speed
/// are the robot's.
template <class S, class T, bool present = scene_of<S>::template has<Friction>>
struct FrictionColumns {
  Velocities<robot_of<S>, T> viscous{};       ///< d tau_i / d viscous_i: rad/s or m/s
  Joints<robot_of<S>, T> coulomb_forward{};   ///< d tau_i / d (Coulomb effort of moving forward)
  Joints<robot_of<S>, T> coulomb_backward{};  ///< d tau_i / d (that of moving backward, which is negative)
};
/// No columns of friction: a scene without Friction.
template <class S, class T>
struct FrictionColumns<S, T, false> {};

}  // namespace regressor

/// Y of tau = Y pi, with the columns that stand on the diagonal apart: `rotor` where the scene names RotorInertia;
/// `viscous`, `coulomb_forward`, `coulomb_backward` where it names Friction.
template <class S, class T>
struct TorqueRegressor : regressor::RotorColumns<S, T>, regressor::FrictionColumns<S, T> {
  static constexpr int size = joint_count<S>;        ///< number of joints, and of rows
  static constexpr int parameters = 10;              ///< of a link: see InertialParameter
  static constexpr int columns = parameters * size;  ///< those of link 0 first
  T values[size * columns] = {};                     ///< row by row; zero for links that the joint does not carry

  /// d tau_i / d pi_column, column = 10 k + p for parameter p of link k.
  AXIAL_INLINE constexpr T& operator()(int i, int column) { return values[i * columns + column]; }
  /// d tau_i / d pi_column.
  AXIAL_INLINE constexpr const T& operator()(int i, int column) const { return values[i * columns + column]; }
  /// d tau_i / d of parameter p of link k.
  AXIAL_INLINE constexpr const T& operator()(int i, int k, InertialParameter p) const {
    return (*this)(i, parameters * k + static_cast<int>(p));
  }
};

namespace regressor {

/// What a body's parameters do along an axis.
template <class M, class H, class J>
struct BodyRow {
  M mass{};          ///< of the mass
  H first_moment{};  ///< of the first moment, a Vec3
  J inertia{};       ///< of the inertia, a Sym3
};
template <class M, class H, class J>
BodyRow(M, H, J) -> BodyRow<M, H, J>;

/// Power on `axis`, a motion of the link, of the force that gives a body its motion `m`: newton_euler() with unit
/// parameters, in 36M 26A for all ten.
template <class S, class M>
AXIAL_INLINE constexpr auto body_row(const S& axis, const M& m) {
  const auto& s = axis.angular;
  const auto& dw = m.dw;
  const auto& p = m.p;
  const auto& u = m.u;
  return BodyRow{
      dot(axis.linear, m.a), transpose_times(u, axis.linear) + cross(m.a, s),
      Sym3{s.x * dw.x + s.y * p.y - s.z * p.z, s.y * dw.y + s.z * p.z - s.x * p.x, s.z * dw.z + s.x * p.x - s.y * p.y,
           s.y * u.z.y - s.x * u.z.x + times_difference(s.z, u.x.x, u.y.y, u.z.z),
           s.x * u.y.x - s.z * u.y.z + times_difference(s.y, u.z.z, u.x.x, u.y.y),
           s.z * u.x.z - s.y * u.x.y + times_difference(s.x, u.y.y, u.z.z, u.x.x)}};
}

/// Writes the entries of joint i by the parameters of link k.
template <class Y, class I, class K, class Row>
AXIAL_INLINE constexpr void write(Y& y, I i, K k, const Row& row) {
  using T = std::decay_t<decltype(y(0, 0))>;
  const auto& h = row.first_moment;
  const auto& j = row.inertia;
  const T entries[] = {T(row.mass), T(h.x), T(h.y), T(h.z), T(j.xx), T(j.yy), T(j.zz), T(j.xy), T(j.xz), T(j.yz)};
  for (int p = 0; p < Y::parameters; ++p)
    y(i, Y::parameters * k + p) = entries[p];
}

/// Carries the axis of joint i from the frame of link j to all links that it carries beyond.
template <class Links, class Screws, class Motions, class I, class J, class Axis, class Y>
AXIAL_INLINE constexpr void descend(const Links& links, const Screws& screws, const Motions& motions, I i, J j,
                                    const Axis& axis, Y& y) {
  write(y, i, j, body_row(axis, motions[j]));
  for_each_link(links, [&](auto k) AXIAL_INLINE {
    if constexpr (Links::template parent_of<decltype(k)::value> == J::value)
      descend(links, screws, motions, i, k, to_child(screws[k], to_child(links.link(k).x(), axis)), y);
  });
}
/// Overload for the looped form, where the axis is zero in links of other branches.
template <class Links, class Screws, class Motions, class Axis, class Y>
AXIAL_INLINE constexpr void descend(const Links& links, const Screws& screws, const Motions& motions, int i, int,
                                    const Axis& axis, Y& y) {
  Row<Axis, Links::capacity> axes;
  axes[i] = axis;
  write(y, i, i, body_row(axis, motions[i]));
  for (int k = i + 1; k < links.size(); ++k) {
    const int parent = links.parent_index(k);
    if (parent < i) continue;
    axes[k] = links.link(k).shape(to_child(screws[k], to_child(links.link(k).x(), axes[parent])));
    write(y, i, k, body_row(axes[k], motions[k]));
  }
}

/// d friction_effort() / d Coulomb effort of one direction, `forward` and `backward` being what is counted of either.
/// Where a link declares a static effort, that stays: as much as the Coulomb effort grows the Stribeck effect shrinks.
template <class Link, class V, class F, class B>
AXIAL_INLINE constexpr auto coulomb_column(const Link& link, const V& qd, F forward, B backward) {
  const auto dry = [&](auto sign) AXIAL_INLINE {
    auto scale = link.inverse_stribeck_speed2();
    auto back = sign * backward;
    if constexpr (is_zero_v<decltype(scale)>) {
      return detail::dry_friction(link, qd, forward, back, Zero{}, Zero{});
    } else {
      const V fixed = select(V(scale) > V(Zero{}), V(One{}), V(Zero{}));
      return detail::dry_friction(link, qd, forward, back, -(forward * fixed), -(back * fixed));
    }
  };
  if constexpr (is_zero_v<decltype(link.inverse_smooth_speed())>)
    return dry(One{});
  else
    return dry(MinusOne{}) * detail::sign_of_speed(link, qd);
}

/// Writes the columns of the drives that the scene names.
template <class Links, class V, class A, class Y>
AXIAL_INLINE constexpr void write_drives(const Links& links, const V& qd, const A& qdd, Y& y) {
  using Scene = typename Links::Scene;
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    if constexpr (Scene::template has<RotorInertia>) y.rotor[i] = qdd[i];
    if constexpr (Scene::template has<Friction>) {
      auto link = links.link(i);
      y.viscous[i] = qd[i];
      y.coulomb_forward[i] = coulomb_column(link, qd[i], One{}, Zero{});
      y.coulomb_backward[i] = coulomb_column(link, qd[i], Zero{}, One{});
    }
  });
}

/// The algorithm over any form of links.
template <class Links, class Input, class Q, class V, class A, class Y>
AXIAL_INLINE constexpr void run(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd, Y& y) {
  auto screws = joint_screws(links, in, q);
  auto motions = rnea::link_motions(links, in, screws, qd, qdd);
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    link.on_joint([&](auto joint)
                      AXIAL_INLINE { descend(links, screws, motions, i, i, link.shape(along_axis(joint, One{})), y); });
  });
  write_drives(links, qd, qdd, y);
}

}  // namespace regressor
namespace detail {

// Scenes and numbers that a regressor is offered for.
template <class Scene, class T>
constexpr void check_linear() {
  static_assert(is_number_v<T>, "axial: a regressor has no formats in fixed point; compute it in float");
  static_assert(!Scene::template has<Underwater>, "axial: a regressor has no water; take Underwater out of the scene");
  static_assert(!Scene::template has<RotorDynamics>,
                "axial: a regressor has no rotors as bodies; take RotorDynamics out of the scene");
}

}  // namespace detail

/// Regressor Y(q, qd, qdd) of inverse_dynamics(): tau = Y pi + rotor, viscous and Coulomb columns times their
/// parameters, where the scene names these. Ten columns per link, in the order of InertialParameter; Y(i, 10 k + p) is
/// zero unless joint i carries link k, so that Y of a chain is block upper triangular. What is not linear in them or
/// given apart is not in it: wrenches, springs, static friction; a payload acts by the columns of the last link.
/// Gravity and a base that moves as the scene has them. Motion of the links as in inverse_dynamics(); then each joint's
/// axis is carried to the links outboard, where ten products with what a unit parameter needs are 36M 26A.
/// Source: Atkeson, An and Hollerbach 1986, IJRR 5(3), eqs. (14) to (18), in link frames. In floating point; NaN and
/// infinities propagate.
template <class S, class T>
[[nodiscard]] constexpr TorqueRegressor<S, T> torque_regressor(const Positions<robot_of<S>, T>& q,
                                                               const Velocities<robot_of<S>, T>& qd,
                                                               const Accelerations<robot_of<S>, T>& qdd,
                                                               const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_linear<scene_of<S>, T>();
  TorqueRegressor<S, T> y{};
  if constexpr (!detail::is_word<T>) regressor::run(links_of<S, T>(), in, q, qd, qdd, y);  // else the message alone
  return y;
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr TorqueRegressor<M, T> torque_regressor(const Model<N, F...>& model, const Positions<M, T>& q,
                                                               const Velocities<M, T>& qd,
                                                               const Accelerations<M, T>& qdd,
                                                               const Inputs<M, T>& in = no_inputs<M, T>()) {
  detail::check_linear<scene_of<M>, T>();
  TorqueRegressor<M, T> y{};
  regressor::run(model.template links<T>(), in, q, qd, qdd, y);
  return y;
}

}  // namespace axial

#include <axial/options/end.hpp>

// Ranges and errors of the recursive Newton-Euler algorithm, on norms. doc/ranges.md is the proof.
#pragma once

#include <axial/model/ranges.hpp>

namespace axial {
namespace detail {

constexpr double root2 = 1.4142135623730951, root3 = 1.7320508075688772;

/// The same recursion as dynamics/inverse_dynamics.hpp on Balls: bounds first, for they give the formats, then errors.
template <int N>
class NewtonEulerAnalysis {
 public:
  constexpr NewtonEulerAnalysis(const Mechanism<N>& mechanism, const Rounding& rounding) : m_(mechanism), r_(rounding) {
    for (int i = 0; i < N; ++i)
      move(i);
    for (int i = N; i-- > 0;)
      load(i);
    for (int i = N; i-- > 0;)
      bear(i);
  }
  constexpr const Ranges<N>& ranges() const { return all_; }

 private:
  const Mechanism<N>& m_;
  const Rounding& r_;
  Ranges<N> all_{};
  Ball spin_[N] = {};  // U r per metre of r: |dw| + w^2
  Ball turn_[N] = {};  // dw alone

  // A turn by a joint's sine and cosine, or by a constant one: two rounded components.
  constexpr Ball turned(const Ball& v, double trigonometry, int format, bool joint) const {
    const double step = joint ? r_.products(2, format, r_.bits - 2, format)
                              : r_.sum(format, {Factor{0.7071, format, v.size}, Factor{0.7072, format, v.size}});
    return {v.size, v.error + root2 * trigonometry * v.reach() + root2 * step};
  }
  constexpr bool any_turn(double sine, double cosine) const {
    return !(sine < 0.0 || sine > 0.0) || !(cosine < 0.0 || cosine > 0.0) ? false : true;
  }
  /// Through the constant turns of link i.
  constexpr Ball twisted(int i, Ball v, int format) const {
    const auto& c = m_.links[i];
    if (any_turn(c.sin_alpha, c.cos_alpha)) v = turned(v, 0.0, format, false);
    if (any_turn(c.branch.sin_gamma, c.branch.cos_gamma)) v = turned(v, 0.0, format, false);
    return v;
  }
  /// Through the joint's own turn.
  constexpr Ball jointed(int i, const Ball& v, int format) const {
    const auto& c = m_.links[i];
    if (!c.prismatic) return turned(v, r_.turn_error, format, true);
    return any_turn(c.sin_theta, c.cos_theta) ? turned(v, 0.0, format, false) : v;
  }
  constexpr Ball brought(int i, const Ball& v, int format) const { return jointed(i, twisted(i, v, format), format); }
  constexpr double stored(double size, int components, int& format) const {
    format = r_.exponent(size);
    return square_root(static_cast<double>(components)) * r_.store(format);
  }

  constexpr void move(int i) {
    const auto& c = m_.links[i];
    const auto& j = m_.joints[i];
    const int p = m_.parent(i);
    LinkRange& own = all_.range[i];
    LinkFormat& format = all_.format[i];
    const LinkRange base{};
    const LinkRange& up = p < 0 ? base : all_.range[p];
    const LinkFormat& from = p < 0 ? format : all_.format[p];
    const Ball spin = p < 0 ? Ball{} : spin_[p], turn = p < 0 ? Ball{} : turn_[p];
    const bool moves = p >= 0;  // the base is at rest: what it adds is zero by type
    const double rate = c.prismatic ? 0.0 : j.speed, pull = c.prismatic ? 0.0 : j.acceleration;

    // Angular velocity.
    own.angular_velocity.size = up.angular_velocity.size + rate;
    format.angular_velocity = r_.exponent(own.angular_velocity.size);
    const Ball turning = moves ? brought(i, up.angular_velocity, from.angular_velocity) : Ball{};
    own.angular_velocity.error = turning.error + root3 * 2.0 * r_.store(format.angular_velocity);
    const Ball& w = own.angular_velocity;

    // Angular acceleration and the products of velocities.
    turn_[i].size = turn.size + turning.size * rate + pull;
    const double most = turn_[i].size + w.size * w.size;
    format.angular_acceleration = r_.exponent(most);
    const double product = r_.products(2, format.angular_velocity, format.angular_velocity, format.angular_acceleration);
    const double moved = 2.0 * r_.store(format.angular_acceleration);
    const Ball direct = moves ? brought(i, turn, from.angular_acceleration) : Ball{};
    const Ball column = moves ? brought(i, spin, from.angular_acceleration) : Ball{};
    const double coriolis = (turning * Ball{rate, 0.0}).error;
    const double general = direct.error + coriolis + root2 * product + root3 * moved;
    const double by_column = column.error + (w * w).error + direct.error + root2 * product + root3 * moved;
    turn_[i].error = general > by_column ? general : by_column;
    spin_[i] = {most, turn_[i].error + 2.0 * w.size * w.error + w.error * w.error + 3.0 * product +
                          root2 * moved};
    own.angular_acceleration = spin_[i];

    // Acceleration of the origin.
    const double along = c.prismatic ? j.travel : magnitude(c.d), apart = length_of(c.a, c.branch.b, 0.0);
    const double offset = c.prismatic ? magnitude(c.branch.b) + square_root(c.a * c.a + along * along) : m_.reach(i);
    const double slide = c.prismatic ? 2.0 * w.size * j.speed + j.acceleration : 0.0;
    const double start = p < 0 ? m_.loads.gravity : up.linear_acceleration.size;
    own.linear_acceleration.size = start + spin.size * offset + slide;
    const double widest = start + spin.size * apart > own.linear_acceleration.size ? start + spin.size * apart
                                                                                  : own.linear_acceleration.size;
    format.linear_acceleration = r_.exponent(widest);
    const int a_format = format.linear_acceleration;
    const double first =
        root3 * (r_.sum(a_format, {Factor{c.a, from.angular_acceleration, spin.size},
                                   Factor{c.a, from.angular_acceleration, spin.size},
                                   Factor{c.branch.b, from.angular_acceleration, spin.size}}) +
                 r_.store(a_format));
    Ball a{start, up.linear_acceleration.error + (spin * Ball{apart, 0.0}).error + first};
    a = brought(i, {widest, a.error}, a_format);
    double second = c.prismatic ? r_.products(3, format.angular_acceleration, r_.exponent(along), a_format)
                                : r_.sum(a_format, {Factor{c.d, format.angular_acceleration, most}});
    if (c.prismatic) second += r_.products(2, format.angular_velocity, r_.exponent(j.speed), a_format);
    own.linear_acceleration.error = a.error + (spin_[i] * Ball{along, c.prismatic ? r_.store(r_.exponent(along)) : 0.0}).error +
                                    (c.prismatic ? 2.0 * (w * Ball{j.speed, 0.0}).error : 0.0) +
                                    root3 * (second + r_.store(a_format));
    format.length = r_.exponent(along > 0.0 ? along : 1.0);
  }

  // A link's own force and moment.
  constexpr void load(int i) {
    const auto& c = m_.links[i];
    LinkRange& own = all_.range[i];
    LinkFormat& format = all_.format[i];
    double mass = magnitude(c.mass), arm = length_of(c.hx, c.hy, c.hz), inertia = norm_of(c);
    if (i + 1 == N) mass += m_.loads.payload_mass, arm += m_.loads.payload_moment, inertia += m_.loads.payload_inertia;
    const Ball &a = own.linear_acceleration, &u = spin_[i];
    own.force.size += mass * a.size + arm * u.size;
    own.moment.size += inertia * u.size + arm * a.size;
    if (i + 1 == N) own.force.size += m_.loads.tip_force, own.moment.size += m_.loads.tip_moment;
    format.force = r_.exponent(own.force.size);
    own.force.error = mass * a.error + arm * u.error;
    own.moment.error = inertia * u.error + arm * a.error;
    if (const int p = m_.parent(i); p >= 0) {
      all_.range[p].force.size += own.force.size;
      all_.range[p].moment.size += own.moment.size + m_.reach(i) * own.force.size;
    }
    const double behind_joint = own.moment.size + m_.joints[i].travel * own.force.size;
    format.moment = r_.exponent(behind_joint);
  }

  // Rounding of link i's own force and moment, and what it and its children send.
  constexpr void bear(int i) {
    const auto& c = m_.links[i];
    LinkRange& own = all_.range[i];
    const LinkFormat& format = all_.format[i];
    const int au = format.angular_acceleration, al = format.linear_acceleration;
    const double u = spin_[i].size, a = own.linear_acceleration.size;
    own.force.error += root3 * r_.sum(format.force, {Factor{c.mass, al, a}, Factor{c.hx, au, u}, Factor{c.hy, au, u},
                                                     Factor{c.hz, au, u}});
    own.moment.error +=
        root3 * r_.sum(format.moment, {Factor{c.jxx, au, u}, Factor{c.jzz_jyy, au, u}, Factor{c.jxy, au, u},
                                       Factor{c.jxz, au, u}, Factor{c.jyz, au, u}, Factor{c.hx, al, a},
                                       Factor{c.hy, al, a}, Factor{c.hz, al, a}, Factor{c.jyy, au, u},
                                       Factor{c.jzz, au, u}, Factor{c.jxx_jzz, au, u}, Factor{c.jyy_jxx, au, u}});
    drive(i);
    const int p = m_.parent(i);
    if (p < 0) return;
    const LinkFormat& outer = all_.format[p];
    Ball force = own.force, moment = own.moment;
    const double along = m_.joints[i].travel;
    moment.size += along * force.size;
    moment.error += along * force.error;
    if (along > 0.0)
      moment.error += root2 * (c.prismatic ? r_.products(1, format.force, format.length, format.moment)
                                           : r_.sum(format.moment, {Factor{c.d, format.force, force.size}}));
    moment = jointed(i, moment, format.moment);
    force = jointed(i, force, format.force);
    moment.error += magnitude(c.a) * force.error + magnitude(c.branch.b) * force.error;
    moment.error += root3 * r_.sum(outer.moment, {Factor{c.a, format.force, force.size}, Factor{c.branch.b, format.force, force.size}});
    moment = twisted(i, moment, outer.moment);
    force = twisted(i, force, format.force);
    force.error += root3 * r_.move(format.force, outer.force);
    all_.range[p].force.error += force.error;
    all_.range[p].moment.error += moment.error;
  }

  // Effort of joint i.
  constexpr void drive(int i) {
    const auto& c = m_.links[i];
    const auto& j = m_.joints[i];
    LinkRange& own = all_.range[i];
    LinkFormat& format = all_.format[i];
    const Ball& borne = c.prismatic ? own.force : own.moment;
    const double rotor = m_.loads.rotors ? c.rotor : 0.0;
    own.joint_effort.size = borne.size + rotor * j.acceleration;
    format.joint_effort = j.effort_format == JointRange::unknown ? r_.exponent(own.joint_effort.size) : j.effort_format;
    own.joint_effort.error = borne.error + r_.sum(format.joint_effort, {Factor{rotor, r_.exponent(j.acceleration), j.acceleration}}) + r_.store(format.joint_effort);
  }
};

}  // namespace detail

/// Ranges, formats and errors of inverse dynamics (and of its bias and gravity parts).
template <int N>
constexpr Ranges<N> newton_euler_ranges(const Mechanism<N>& mechanism, const Rounding& rounding) {
  return detail::NewtonEulerAnalysis<N>(mechanism, rounding).ranges();
}

}  // namespace axial

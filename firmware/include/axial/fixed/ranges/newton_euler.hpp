// Ranges and errors of the recursive Newton-Euler algorithm, on norms. doc/ranges.md is the proof.
#pragma once

#include <axial/fixed/ranges/shared_formats.hpp>
#include <axial/fixed/ranges/split_ball.hpp>
#include <axial/fixed/ranges/turning.hpp>

namespace axial {
namespace detail {

/// The same recursion as dynamics/inverse_dynamics.hpp on Balls: bounds first, for they give the formats, then errors.
template <int N>
class NewtonEulerAnalysis {
 public:
  constexpr NewtonEulerAnalysis(const Mechanism<N>& mechanism, const Rounding& rounding)
      : m_(mechanism), r_(rounding), turn_{mechanism, rounding} {
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
  Turning<N> turn_;
  Ranges<N> all_{};
  SpinBall spin_[N] = {};
  SplitBall a_[N] = {}, force_[N] = {}, moment_[N] = {};

  // From the parent's motion to link i's.
  constexpr void move(int i) {
    const int p = m_.parent(i);
    const SpinBall parent = p < 0 ? SpinBall{} : spin_[p];
    rotate(i, parent, p);
    accelerate(i, parent, p);
    LinkRange& own = all_.range[i];
    own.turns_across = spin_[i].w.across.size > 0.0;
    own.angular_velocity = spin_[i].w.whole, own.angular_acceleration = spin_[i].strength();
    own.linear_acceleration = a_[i].whole;
  }

  // The base turns by no number: where it is the parent nothing is rounded.
  constexpr SplitBall brought(int i, int p, const SplitBall& v, int format) const {
    return p < 0 ? SplitBall{} : turn_.to_child(i, v, format);
  }

  constexpr void rotate(int i, const SpinBall& parent, int p) {
    const auto& c = m_.links[i];
    const Ball rate = c.prismatic ? Ball{} : m_.speed(r_, i), pull = c.prismatic ? Ball{} : m_.acceleration(r_, i);
    const LinkFormat none = m_.base_format();
    const LinkFormat& from = p < 0 ? none : all_.format[p];
    LinkFormat& to = all_.format[i];
    SpinBall& own = spin_[i];
    const SplitBall turning = brought(i, p, parent.w, from.angular_velocity);
    own.w = turning + split({}, rate);
    to.angular_velocity = m_.format(r_, &LinkFormat::angular_velocity, own.w.whole.size);
    own.w = rounded(own.w, 2.0 * r_.store(to.angular_velocity));

    const SplitBall gyration = split(rate * turning.across, {});
    own.dw = brought(i, p, parent.dw, from.angular_acceleration) + gyration + split({}, pull);
    to.angular_acceleration = m_.format(r_, &LinkFormat::angular_acceleration, own.strength().size);
    own.entry = r_.products(1, to.angular_velocity, to.angular_velocity, to.angular_acceleration) +
                r_.store(to.angular_acceleration);
    own.dw =
        larger_error(rounded(own.dw, own.entry + 2.0 * r_.store(to.angular_acceleration)), by_column(i, p, parent));
  }
  // Where the axis is one of the parent's, dw across it follows from U's third column and the products of w.
  constexpr SplitBall by_column(int i, int p, const SpinBall& parent) const {
    if (p < 0) return {};
    const Ball strength = parent.strength();
    const SplitBall column = brought(i, p, {strength, strength, strength}, all_.format[p].angular_acceleration);
    const SplitBall products = split(spin_[i].w.across * spin_[i].w.along, {});
    SplitBall dw = rounded(column + products, spin_[i].entry + 2.0 * r_.store(all_.format[i].angular_acceleration));
    dw.along = {};
    return dw;
  }
  static constexpr SplitBall larger_error(SplitBall v, const SplitBall& other) {
    v.across.error = other.across.error > v.across.error ? other.across.error : v.across.error;
    v.whole.error = hypotenuse(v.across.error, v.along.error);
    return v;
  }

  constexpr void accelerate(int i, const SpinBall& parent, int p) {
    const auto &c = m_.links[i], &k = m_.factors(i);
    const auto& j = m_.joints[i];
    const LinkFormat none = m_.base_format();
    const LinkFormat& from = p < 0 ? none : all_.format[p];
    LinkFormat& to = all_.format[i];
    const double fall = m_.steps.shared ? r_.store(none.linear_acceleration) : 0.0;
    const Ball start{m_.loads.gravity_across, root2 * fall}, falls{m_.loads.gravity_along, fall};
    const SplitBall at_parent = p < 0 ? split(start, falls) : a_[p];
    SplitBall a = at_parent + parent.times(magnitude(c.a), magnitude(c.branch.b));
    const double along = c.prismatic ? j.travel : magnitude(c.d);
    const Ball slip = c.prismatic ? 2.0 * m_.speed(r_, i) * spin_[i].w.across : Ball{};
    const SplitBall joint = split(slip, c.prismatic ? m_.acceleration(r_, i) : Ball{});
    const SplitBall offset = spin_[i].times(0.0, along);
    const double widest = a.whole.size + (offset + joint).whole.size;
    to.linear_acceleration = m_.format(r_, &LinkFormat::linear_acceleration, widest);
    to.length = m_.format(r_, &LinkFormat::length, along > 0.0 ? along : 1.0);
    const int format = to.linear_acceleration;
    const double strength = parent.strength().size;
    a = rounded(a, r_.sum(format, {Factor{k.a, from.angular_acceleration, strength},
                                   Factor{k.a, from.angular_acceleration, strength},
                                   Factor{k.branch.b, from.angular_acceleration, strength}}) +
                       r_.store(format));
    a_[i] = turn_.to_child(i, a, format) + offset + joint;
    double step = r_.store(format);
    if (c.prismatic || m_.steps.shared)
      step += r_.products(3, to.angular_acceleration, to.length, format) +
              shift_rounding(to) * spin_[i].strength().size +
              r_.products(2, to.angular_velocity, r_.exponent(m_.speed_reach(i)), format);
    else
      step += r_.sum(format, {Factor{c.d, to.angular_acceleration, spin_[i].strength().size}});
    a_[i] = rounded(a_[i], step);
  }

  // Of a joint's shift; a table's d and the position that is read into its format round each.
  constexpr double shift_rounding(const LinkFormat& f) const {
    return (m_.steps.shared ? 2.0 : 1.0) * r_.store(f.length);
  }

  // Sizes of what link i bears; its children have been here before.
  constexpr void load(int i) {
    const auto& c = m_.links[i];
    double mass = magnitude(c.mass), side = hypotenuse(c.hx, c.hy), height = magnitude(c.hz);
    const SpinBall& s = spin_[i];
    SplitBall force = mass * a_[i] + s.times(side, height);
    SplitBall moment = rotational(c, s) + split(side * a_[i].along + height * a_[i].across, side * a_[i].across);
    if (i + 1 == N) add_tip(i, force, moment);
    all_.format[i].mass = m_.format(r_, &LinkFormat::mass, mass + m_.loads.payload_mass);
    all_.format[i].first_moment =
        m_.format(r_, &LinkFormat::first_moment, 2.0 * (hypotenuse(side, height) + m_.loads.payload_moment));
    all_.format[i].rotational_inertia =
        m_.format(r_, &LinkFormat::rotational_inertia, 2.0 * (norm_of(c) + m_.loads.payload_inertia));
    force_[i] = force_[i] + force, moment_[i] = moment_[i] + moment;
    const double travel = m_.joints[i].travel;
    const SplitBall shifted = moment_[i] + cross_along_z(travel, force_[i]);
    all_.format[i].force = m_.format(r_, &LinkFormat::force, force_[i].whole.size);
    all_.format[i].moment = m_.format(r_, &LinkFormat::moment, shifted.whole.size);
    const int p = m_.parent(i);
    if (p < 0) return;
    const SplitBall arrives = turned_about_x(force_[i], c.sin_alpha, c.cos_alpha);
    const SplitBall sent = turned_about_x(shifted, c.sin_alpha, c.cos_alpha) + cross_along_x(c.a, arrives) +
                           cross_along_z(magnitude(c.branch.b), arrives);
    force_[p] = force_[p] + without_error(arrives), moment_[p] = moment_[p] + without_error(sent);
  }
  static constexpr SplitBall without_error(SplitBall v) {
    v.across.error = v.along.error = v.whole.error = 0.0;
    return v;
  }
  // J dw + w x J w, J in blocks across and along the axis.
  static constexpr SplitBall rotational(const TreeLinkConstants<double>& c, const SpinBall& s) {
    const double mean = 0.5 * (c.jxx + c.jyy), skew = hypotenuse(0.5 * (c.jxx - c.jyy), c.jxy);
    const double block = magnitude(mean) + skew, apart = magnitude(c.jzz - mean) + skew;
    const double couple = hypotenuse(c.jxz, c.jyz), axis = magnitude(c.jzz);
    const Ball wo = s.w.across * s.w.across, wz = s.w.across * s.w.along, zz = s.w.along * s.w.along;
    SplitBall n = split(block * s.dw.across + couple * s.dw.along + apart * wz + couple * (zz + wo),
                        couple * s.dw.across + axis * s.dw.along + skew * wo + couple * wz);
    const double entries = (2.0 * block + axis + 4.0 * couple + 2.0 * skew + 2.0 * apart) * s.entry;
    return rounded(n, entries);
  }
  // What a payload and the environment add at the tip.
  constexpr void add_tip(int i, SplitBall& force, SplitBall& moment) const {
    const LoadRange& l = m_.loads;
    const Ball u = spin_[i].strength(), a = a_[i].whole;
    const Ball f = l.payload_mass * a + l.payload_moment * u + Ball{l.tip_force, 0.0};
    const Ball n = l.payload_inertia * u + l.payload_moment * a + Ball{l.tip_moment, 0.0};
    force = force + SplitBall{f, f, f}, moment = moment + SplitBall{n, n, n};
  }

  // Rounding of link i's own force and moment, of what it sends, and its joint's effort.
  constexpr void bear(int i) {
    const auto& c = m_.factors(i);
    const LinkFormat& format = all_.format[i];
    const int au = format.angular_acceleration, al = format.linear_acceleration;
    const double u = spin_[i].strength().size, a = a_[i].whole.size;
    force_[i] = rounded(force_[i], r_.sum(format.force, {Factor{c.mass, al, a}, Factor{c.hx, au, u},
                                                         Factor{c.hy, au, u}, Factor{c.hz, au, u}}));
    moment_[i] = rounded(
        moment_[i],
        r_.sum(format.moment, {Factor{c.jxx, au, u}, Factor{c.jyy, au, u}, Factor{c.jzz, au, u}, Factor{c.jxy, au, u},
                               Factor{c.jxz, au, u}, Factor{c.jyz, au, u}, Factor{c.hx, al, a}, Factor{c.hy, al, a},
                               Factor{c.hz, al, a}, Factor{largest(c.jzz_jyy, c.jxx_jzz, c.jyy_jxx), au, u}}));
    if (i + 1 == N && m_.loads.payload_mass > 0.0) carry_payload(i, u, a);
    if (i + 1 == N && m_.steps.shared && m_.loads.tip_force + m_.loads.tip_moment > 0.0)
      force_[i] = rounded(force_[i], r_.store(format.force)), moment_[i] = rounded(moment_[i], r_.store(format.moment));
    all_.range[i].force = force_[i].whole, all_.range[i].moment = moment_[i].whole;
    drive(i);
    if (const int p = m_.parent(i); p >= 0) send(i, p);
  }
  // Rounding of a run-time payload's body, and of products that no longer have a constant factor.
  constexpr void carry_payload(int i, double u, double a) {
    const LinkFormat& f = all_.format[i];
    const double mass = 2.0 * r_.store(f.mass);
    const double moment =
        root3 * (r_.products(1, r_.bits - 2, r_.bits - 2, f.first_moment) + 2.0 * r_.store(f.first_moment));
    const double inertia = 3.0 * (3.0 * r_.store(f.rotational_inertia) + moment);
    force_[i] = rounded(force_[i], mass * a + moment * u + r_.products(4, f.mass, f.linear_acceleration, f.force) +
                                       r_.products(4, f.first_moment, f.angular_acceleration, f.force));
    moment_[i] = rounded(moment_[i], inertia * u + moment * a +
                                         r_.products(6, f.rotational_inertia, f.angular_acceleration, f.moment) +
                                         r_.products(2, f.first_moment, f.linear_acceleration, f.moment));
  }
  static constexpr double largest(double a, double b, double c) {
    const double ab = magnitude(a) > magnitude(b) ? magnitude(a) : magnitude(b);
    return ab > magnitude(c) ? ab : magnitude(c);
  }
  constexpr void send(int i, int p) {
    const auto &c = m_.links[i], &k = m_.factors(i);
    const LinkFormat &format = all_.format[i], &outer = all_.format[p];
    const double along = m_.joints[i].travel, f = force_[i].whole.size;
    SplitBall moment = moment_[i] + cross_along_z(along, force_[i]);
    if (along > 0.0) {
      const double step = c.prismatic || m_.steps.shared
                              ? r_.products(1, format.force, format.length, format.moment) + shift_rounding(format) * f
                              : r_.sum(format.moment, {Factor{c.d, format.force, f}});
      moment = rounded_across(moment, step);
    }
    moment = turn_.by_joint(i, moment, format.moment);
    SplitBall force = turn_.by_joint(i, force_[i], format.force);
    moment = rounded(moment, r_.sum(outer.moment, {Factor{k.a, format.force, f}, Factor{k.branch.b, format.force, f}}));
    moment = turn_.by_twist(i, moment, outer.moment);
    force = turn_.by_twist(i, force, format.force);
    moment = moment + cross_along_x(c.a, force) + cross_along_z(magnitude(c.branch.b), force);
    force = rounded(force, r_.move(format.force, outer.force));
    add_errors(force_[p], force), add_errors(moment_[p], moment);
  }
  static constexpr void add_errors(SplitBall& to, const SplitBall& v) {
    to.across.error += v.across.error, to.along.error += v.along.error, to.whole.error += v.whole.error;
    to = tightened(to);
  }

  constexpr void drive(int i) {
    const auto& c = m_.links[i];
    const auto& j = m_.joints[i];
    const Ball borne = c.prismatic ? force_[i].along : moment_[i].along;
    const double rotor = m_.loads.rotors ? c.rotor : 0.0, rotor_factor = m_.loads.rotors ? m_.factors(i).rotor : 0.0;
    const Ball passive = passive_effort(i);
    Ball& effort = all_.range[i].joint_effort;
    int& format = all_.format[i].joint_effort;
    effort = borne + rotor * m_.acceleration(r_, i) + passive;
    format = j.effort_format == JointRange::unknown ? r_.exponent(effort.size) : j.effort_format;
    if (m_.steps.shared) format = m_.steps.format.joint_effort;
    const double viscous = m_.loads.friction ? m_.viscous_factor(i) : 0.0;
    effort.error += r_.store(format) +
                    r_.sum(format, {Factor{viscous, r_.exponent(m_.speed_reach(i)), j.speed},
                                    Factor{rotor_factor, r_.exponent(m_.acceleration_reach(i)), j.acceleration}}) +
                    r_.store(format);
  }
  constexpr Ball passive_effort(int i) const {
    if (!m_.loads.friction) return {};
    const auto& d = m_.drives[i];
    const double dry = larger_of(d.coulomb_forward + magnitude(d.stribeck_forward),
                                 magnitude(d.coulomb_backward) + magnitude(d.stribeck_backward));
    const double step = m_.steps.shared ? 2.0 * r_.store(m_.steps.format.joint_effort) : 0.0;
    return d.viscous * m_.speed(r_, i) + Ball{dry, step};
  }
  static constexpr double larger_of(double a, double b) { return a > b ? a : b; }
};

}  // namespace detail

/// Ranges, formats and errors of inverse dynamics (and of its bias and gravity parts).
template <int N>
constexpr Ranges<N> newton_euler_ranges(const Mechanism<N>& mechanism, const Rounding& rounding) {
  return detail::ranges_by(mechanism, rounding, [&rounding](const Mechanism<N>& m) {
    return detail::NewtonEulerAnalysis<N>(m, rounding).ranges();
  });
}

}  // namespace axial

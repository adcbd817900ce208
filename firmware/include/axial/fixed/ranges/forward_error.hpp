// The certified error of forward dynamics: every rounding is a change of some link's inertia, of a force or of an
// effort, and the energy norms of M and of its inverse say what such changes can do. doc/guides/forward_ranges.md is
// the proof.
#pragma once

#include <axial/fixed/ranges/declared_motion.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// The least inertia of a link about any axis that it turns about: about its centre of mass, and about the joint's axis
/// where nothing else turns the link.
constexpr double inertia_against_turning(const TreeLinkConstants<double>& c, bool turns_across) {
  if (turns_across) return least_inertia(c);
  return c.mass > 0.0 ? c.jzz - (c.hx * c.hx + c.hy * c.hy) / c.mass : c.jzz;
}

/// Errors of the split form. `ranges` are its sizes and formats, `motion` those of the bias.
template <int N>
class ForwardErrorAnalysis {
 public:
  constexpr ForwardErrorAnalysis(const Mechanism<N>& mechanism, const WordRounding& rounding, const Ranges<N>& ranges,
                                 const Ranges<N>& motion)
      : m_(mechanism), r_(rounding), all_(ranges), bodies_(composite_ranges(mechanism)) {
    double energy = 0.0;
    for (int i = 0; i < N; ++i)
      energy += all_.range[i].share, propagate_sizes(i, motion);
    for (int i = N; i-- > 0;)
      receive(i);
    for (int i = 0; i < N; ++i)
      relate(i);
    const double left = 1.0 - relative_;
    for (int i = 0; i < N; ++i)
      efforts_ += speed_[i].joint * (motion.range[i].joint_effort.error + 3.0 * store(&LinkFormat::joint_effort, i));
    const double solved = left > 0.0 ? (efforts_ + forces_ + relative_ * square_root(energy)) / left : unknown_size;
    for (int i = 0; i < N; ++i)
      errors_.of[i] = answer(i, solved);
  }
  constexpr double of(int i) const { return errors_.of[i]; }
  /// Square root of the largest (M^-1)_ii, from above where D is proved.
  constexpr double mobility(int i) const { return speed_[i].joint; }

 private:
  /// How fast a link can turn and its origin and its joint can move for one unit of sqrt(qd^T M qd): square roots of
  /// mobilities, from above. (M^-1)_ii is the square of `joint`.
  struct Speed {
    double turn = 0.0, shift = 0.0, joint = 0.0;
  };
  /// Roundings of a link's articulated inertia, and of the force that it bears.
  struct Change {
    double inertia = 0.0, first = 0.0, mass = 0.0, moment = 0.0, force = 0.0;
  };
  const Mechanism<N>& m_;
  const WordRounding& r_;
  const Ranges<N>& all_;
  CompositeRanges<N> bodies_;
  Speed speed_[N] = {};
  Change change_[N] = {};
  double relative_ = 0.0, forces_ = 0.0, efforts_ = 0.0, accelerations_[N] = {};
  PerJoint<N> errors_{};

  constexpr double store(int LinkFormat::*quantity, int i) const { return r_.store(all_.format[i].*quantity); }
  static constexpr double reciprocal_error = 9.4e-10;  // of a mantissa of 31 bits, and the product with it

  // A link moves as its own inertia allows, or as its parent and the joint make it; the joint likewise as its D and the
  // parent's motion, as its rotor, or as the two links allow.
  constexpr void propagate_sizes(int i, const Ranges<N>& motion) {
    const auto& c = m_.links[i];
    const int p = m_.parent(i);
    const Speed up = p < 0 ? Speed{} : speed_[p];
    const LinkRange& own = all_.range[i];
    Speed& speed = speed_[i];
    const double carried = up.shift + m_.origin_distance(i) * up.turn, rotor = m_.loads.rotors ? c.rotor : 0.0;
    speed.joint = 1.0 / square_root(own.least) + own.angular_gain.size * up.turn + own.linear_gain.size * carried;
    if (rotor > 0.0) speed.joint = least(speed.joint, 1.0 / square_root(rotor));
    const double centre = c.mass > 0.0 ? length_of(c.hx, c.hy, c.hz) / c.mass : 0.0;
    const double inertia = inertia_against_turning(c, motion.range[i].turns_across);
    const double freely = inertia > 0.0 ? 1.0 / square_root(inertia) : unknown_size;
    if (!c.prismatic) speed.joint = least(speed.joint, freely + up.turn);
    speed.turn = least(freely, up.turn + (c.prismatic ? 0.0 : speed.joint));
    speed.shift = carried + (c.prismatic ? speed.joint : 0.0);
    if (c.mass > 0.0) speed.shift = least(speed.shift, 1.0 / square_root(c.mass) + centre * speed.turn);
  }

  // Roundings of the child's reflection and of the way to its parent, all in the parent.
  constexpr void receive(int i) {
    const LinkRange& own = all_.range[i];
    Change& mine = change_[i];
    mine.inertia += 3.0 * store(&LinkFormat::rotational_inertia, i),
        mine.first += 3.0 * store(&LinkFormat::first_moment, i);
    mine.mass += 3.0 * store(&LinkFormat::mass, i);
    const int p = m_.parent(i);
    if (p < 0) return;
    const CompositeRange& b = bodies_.behind[i];
    const double effective = own.joint_inertia.size;
    const double ka = own.angular_gain.size * reciprocal_error + 1.5 * store(&LinkFormat::angular_gain, i);
    const double kl = own.linear_gain.size * reciprocal_error + 1.5 * store(&LinkFormat::linear_gain, i);
    const double ua = square_root(b.inertia * effective), ul = square_root(b.mass * effective);
    Change on_parent{3.0 * (2.0 * ua * ka), 3.0 * (ua * kl + ul * ka), 3.0 * (2.0 * ul * kl), 0.0, 0.0};
    const double u = own.joint_effort.size;
    on_parent.moment = root3 * (ka * u + 2.0 * own.angular_gain.size * store(&LinkFormat::joint_effort, i));
    on_parent.force = root3 * (kl * u + 2.0 * own.linear_gain.size * store(&LinkFormat::joint_effort, i));
    screw(on_parent, i, i, m_.links[i].prismatic ? 0.0 : r_.turn_error, m_.joints[i].travel);
    screw(on_parent, i, p, 0.0, magnitude(m_.links[i].a));
    if (magnitude(m_.links[i].branch.b) > 0.0 || magnitude(m_.links[i].branch.sin_gamma) > 0.0)
      screw(on_parent, i, p, 0.0, magnitude(m_.links[i].branch.b));
    Change& up = change_[p];
    up.inertia += on_parent.inertia, up.first += on_parent.first, up.mass += on_parent.mass;
    up.moment += on_parent.moment, up.force += on_parent.force;
  }
  // One screw of link i in the formats of link f: turn by the double angle, shift, and their roundings.
  constexpr void screw(Change& c, int i, int f, double tilt, double shift) const {
    const LinkRange& own = all_.range[i];
    const CompositeRange& b = bodies_.behind[i];
    const double angle = 2.0 * (4.0 * tilt + 6.0 * r_.store(r_.bits - 2));
    const double j = 8.0 * store(&LinkFormat::rotational_inertia, f), h = 8.0 * store(&LinkFormat::first_moment, f),
                 m = 8.0 * store(&LinkFormat::mass, f);
    c.inertia += angle * b.inertia + j + shift * (2.0 * (c.first + h) + shift * (c.mass + m));
    c.first += angle * b.moment + h + shift * (c.mass + m);
    c.mass += angle * b.mass + m;
    const double moment = 4.0 * store(&LinkFormat::moment, f), force = 4.0 * store(&LinkFormat::force, f);
    c.force += root2 * tilt * own.force.size + root3 * force;
    c.moment += root2 * tilt * (own.moment.size + shift * own.force.size) + root3 * moment + shift * c.force;
  }
  // What a link's changes do to M relative to M, and to the drive.
  constexpr void relate(int i) {
    const Speed& v = speed_[i];
    const Change& c = change_[i];
    relative_ += c.inertia * v.turn * v.turn + 2.0 * c.first * v.turn * v.shift + c.mass * v.shift * v.shift;
    forces_ += c.moment * v.turn + c.force * v.shift;
  }
  // Joint i's own roundings, those of the accelerations inboard of it, and what the solve as a whole is off.
  constexpr double answer(int i, double solved) {
    const LinkRange& own = all_.range[i];
    const LinkFormat& format = all_.format[i];
    const int p = m_.parent(i);
    const LinkRange base{};
    const LinkRange& up = p < 0 ? base : all_.range[p];
    const double turn = up.angular_acceleration.size,
                 carried = up.linear_acceleration.size + m_.origin_distance(i) * turn;
    const double tilt = m_.links[i].prismatic ? 0.0 : root2 * r_.turn_error;
    const double angular = tilt * turn + root3 * 4.0 * r_.store(format.angular_acceleration);
    const double linear =
        tilt * carried + m_.origin_distance(i) * angular + root3 * 5.0 * r_.store(format.linear_acceleration);
    const double ka = own.angular_gain.size * reciprocal_error + 1.5 * r_.store(format.angular_gain);
    const double kl = own.linear_gain.size * reciprocal_error + 1.5 * r_.store(format.linear_gain);
    const double joint = ka * turn + kl * carried + own.joint_acceleration.size * reciprocal_error +
                         3.0 * r_.store(format.joint_acceleration);
    const CompositeRange& b = bodies_.behind[i];
    const bool slides = m_.links[i].prismatic;
    accelerations_[i] =
        (p < 0 ? 0.0 : accelerations_[p] + square_root(b.inertia) * angular + square_root(b.mass) * linear);
    const double error = speed_[i].joint * (solved + accelerations_[i]) + joint;
    accelerations_[i] += square_root(slides ? b.mass : b.inertia) * joint;
    return error;
  }
};

}  // namespace detail

/// How far the second, magnified solve of the split form may be from the first, in units of the first's accelerations
/// (fixed/dynamics/split_answer.hpp); in 32-bit words.
inline constexpr std::int32_t second_solve_tolerance = 1024;

/// Fills in the errors of the joint accelerations of the split form, the drive being halved as often as the
/// declared efforts and the bias may need (excess_of_drive).
template <int N>
constexpr void certify_forward(const Mechanism<N>& m, const WordRounding& r, const detail::PerJoint<N>& drive,
                               Ranges<N>& ranges) {
  const Ranges<N> motion = newton_euler_ranges(m, r);
  Ranges<N> first = ranges;  // a halved drive in the formats is the whole one in coarser ones
  for (LinkFormat& format : first.format)
    for (const auto& quantity : detail::driven_quantities)
      format.*quantity.format -= ranges.halvings;
  const detail::ForwardErrorAnalysis<N> errors(m, r, first, motion);
  const double excess = detail::excess_of_drive(m, motion, drive);
  double doublings = 1.0;
  while (doublings < excess)
    doublings *= 2.0;
  const double tolerance = second_solve_pays(m, r, ranges) ? second_solve_tolerance : 0.0;
  for (int i = 0; i < N; ++i)
    ranges.range[i].joint_acceleration.error =
        doublings * (errors.of(i) + tolerance * r.ulp(first.format[i].joint_acceleration));
}

/// Ranges of the split form: the structure at rest under tau - bias, driven by at most `drive` (usual_drive) without
/// halvings. Errors are not filled in.
template <int N>
constexpr Ranges<N> articulated_at_rest_sizes(const Mechanism<N>& m, const WordRounding& r,
                                              const detail::PerJoint<N>& drive) {
  const auto least = detail::least_inertias(m);
  const Ranges<N> ranges = detail::ArticulatedAnalysis<N>(m, r, drive.of, least, nullptr).ranges();
  if (!declared_formats_pay(m, r, ranges)) return ranges;
  const auto usual = detail::resisting(m, least);
  return fitted_to_declared_motion(m, r, detail::ArticulatedAnalysis<N>(m, r, drive.of, usual, nullptr).ranges());
}

/// Ranges and errors of the split form.
template <int N>
constexpr Ranges<N> articulated_at_rest_ranges(const Mechanism<N>& m, const WordRounding& r,
                                               const detail::PerJoint<N>& drive, Wanted wanted) {
  Ranges<N> ranges = articulated_at_rest_sizes(m, r, drive);
  if (wanted == Wanted::errors) certify_forward(m, r, drive, ranges);
  return ranges;
}

}  // namespace axial

#include <axial/options/end.hpp>

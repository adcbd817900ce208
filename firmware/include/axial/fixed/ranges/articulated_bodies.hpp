// Ranges of the articulated-body algorithm on full parameters: 0 <= I* <= I^c in the Loewner order.
// doc/guides/forward_ranges.md.
#pragma once

#include <axial/fixed/bounds/account.hpp>
#include <axial/fixed/bounds/dynamics.hpp>
#include <axial/fixed/ranges/composite_bodies.hpp>
#include <axial/fixed/ranges/usual_inertia.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// The least inertia that a joint can feel: its own link's about the axis, and its rotor.
template <int N>
constexpr double least_joint_inertia(const Mechanism<N>& m, int i) {
  const auto& c = m.links[i];
  return (c.prismatic ? c.mass : c.jzz) + (m.loads.rotors ? c.rotor : 0.0);
}

/// Smallest eigenvalue of a link's inertia about its centre of mass, from below: det / (l2 l3), l2 l3 <= (trace / 2)^2.
constexpr double least_inertia(const TreeLinkConstants<double>& c) {
  if (!(c.mass > 0.0)) return 0.0;
  const double x = c.hx / c.mass, y = c.hy / c.mass, z = c.hz / c.mass;
  const double xx = c.jxx - c.mass * (y * y + z * z), yy = c.jyy - c.mass * (x * x + z * z),
               zz = c.jzz - c.mass * (x * x + y * y);
  const double xy = c.jxy + c.mass * x * y, xz = c.jxz + c.mass * x * z, yz = c.jyz + c.mass * y * z;
  const double det = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const double trace = xx + yy + zz;
  return det > 0.0 && trace > 0.0 ? 4.0 * det / (trace * trace) : 0.0;
}

/// What each joint feels whatever the position. What feels nothing was refused (links/fixed_links.hpp).
template <int N>
constexpr PerJoint<N> least_inertias(const Mechanism<N>& m) {
  return per_joint<N>([&m](int i) { return least_joint_inertia(m, i) > 0.0 ? least_joint_inertia(m, i) : 1.0; });
}

inline constexpr double unknown_size = 1e300;

/// The structure driven by efforts: bounds by the sum G = qdd^T M qdd = sum of u_j^2 / D_j, which no recursion
/// inflates. A joint's share u^2 / D is held below `share` at run time (admitted() in formats/link_formats.hpp); what
/// is outboard of a link has at most the sum of its shares.
template <int N>
class ArticulatedAnalysis {
 public:
  /// `given` are the efforts left to the joints, `least` the inertias that they feel at least; `moving` the ranges of
  /// the motion whose bias travels with them, or null at rest.
  constexpr ArticulatedAnalysis(const Mechanism<N>& mechanism, const WordRounding& rounding, const double (&given)[N],
                                const PerJoint<N>& least, const Ranges<N>* moving)
      : m_(mechanism), r_(rounding), bodies_(composite_ranges(mechanism)) {
    for (int i = 0; i < N; ++i)
      all_.range[i].least = least.of[i];
    set_inertia_formats(m_, bodies_, r_, all_);
    drive(given);
    for (int i = N; i-- > 0;)
      bound_force(i, given[i]);
    for (int i = 0; i < N; ++i)
      move(i);
    for (int i = 0; moving != nullptr && i < N; ++i)
      add(i, *moving);
    for (int i = 0; i < N; ++i)
      choose(i, moving);
  }
  constexpr const Ranges<N>& ranges() const { return all_; }

 private:
  const Mechanism<N>& m_;
  const WordRounding& r_;
  CompositeRanges<N> bodies_;
  Ranges<N> all_{};
  double drive_[N] = {};     // effort of a joint and the largest reaction that reaches it
  double outboard_[N] = {};  // G of what is outboard of link i, its joint included
  double whole_ = 0.0;       // sqrt(G) of all

  constexpr double rotor(int i) const { return m_.loads.rotors ? m_.links[i].rotor : 0.0; }

  constexpr void drive(const double (&given)[N]) {
    double reaction[N] = {}, sum = 0.0;
    for (int i = N; i-- > 0;) {
      const double least = all_.range[i].least;
      all_.range[i].drive = given[i];
      drive_[i] = given[i] + reaction[i];
      all_.range[i].share = 2.0 * drive_[i] * drive_[i] / least;
      outboard_[i] += all_.range[i].share, sum += all_.range[i].share;
      const int p = m_.parent(i);
      if (p < 0) continue;
      outboard_[p] += outboard_[i];
      const bool same = m_.links[p].prismatic == m_.links[i].prismatic;
      const double reacted = same ? drive_[i] : m_.links[i].prismatic ? drive_[i] * m_.origin_distance(i) : 0.0;
      reaction[p] = reacted > reaction[p] ? reacted : reaction[p];
    }
    whole_ = square_root(sum);
  }
  // Force that a link bears, by Cauchy and Schwarz: |p| <= sqrt(|I^c|) sqrt(G), and the joint's own effort.
  constexpr void bound_force(int i, double given) {
    const auto& c = m_.links[i];
    LinkRange& own = all_.range[i];
    const CompositeRange& b = bodies_.behind[i];
    const double root = square_root(outboard_[i]);
    own.moment.size = square_root(b.inertia) * root + given, own.force.size = square_root(b.mass) * root + given;
    own.joint_effort.size = given + square_root(own.joint_inertia.size * outboard_[i]);
    // |K| <= sqrt(|I^c|) sqrt(s) / (s + rotor) for s = I_ss, s >= least.
    const double least = larger(c.prismatic ? c.mass : c.jzz, own.least - rotor(i));
    const double steep = least > rotor(i) ? square_root(least) / (least + rotor(i)) : 0.5 / square_root(rotor(i));
    own.angular_gain.size = larger(square_root(b.inertia) * steep, 1.0);
    own.linear_gain.size = larger(square_root(b.mass) * steep, 1.0);
  }
  // Joint accelerations are below twice the drive over the least inertia; links' follow, or sum a_k^T I_k a_k <= G.
  constexpr void move(int i) {
    const auto& c = m_.links[i];
    LinkRange& own = all_.range[i];
    const int p = m_.parent(i);
    const LinkRange base{};
    const LinkRange& up = p < 0 ? base : all_.range[p];
    const double turn = up.angular_acceleration.size, least = all_.range[i].least;
    const double carried = up.linear_acceleration.size + m_.origin_distance(i) * turn;
    const double spins = least_inertia(c) > 0.0 ? whole_ / square_root(least_inertia(c)) : unknown_size;
    const double free = energy_share(i) / square_root(least);
    const double rigorous = free + own.angular_gain.size * turn + own.linear_gain.size * carried;
    const bool alike = p >= 0 && m_.links[p].prismatic == c.prismatic;
    // What is held at the format may exceed it 2^8-fold before that goes unseen (saturated()): half of it is used.
    const double usual = free + (alike ? up.joint_acceleration.size : 0.0);
    const double joint = larger(detail::least(rigorous, usual), rigorous / 128.0);
    own.joint_acceleration.size = joint;
    own.angular_acceleration.size = detail::least(turn + (c.prismatic ? 0.0 : joint), spins);
    own.linear_acceleration.size = carried + (c.prismatic ? joint : 0.0);
    if (!(c.mass > 0.0)) return;
    const double centre = length_of(c.hx, c.hy, c.hz) / c.mass;
    own.linear_acceleration.size = detail::least(own.linear_acceleration.size,
                                                 whole_ / square_root(c.mass) + centre * own.angular_acceleration.size);
  }
  constexpr double energy_share(int i) const { return square_root(all_.range[i].share); }

  // What the motion at hand adds in the classical form.
  constexpr void add(int i, const Ranges<N>& moving) {
    LinkRange& own = all_.range[i];
    const LinkRange& more = moving.range[i];
    const bool slides = m_.links[i].prismatic;
    own.angular_velocity.size = more.angular_velocity.size;
    own.angular_acceleration.size += more.angular_acceleration.size;
    own.linear_acceleration.size += more.linear_acceleration.size;
    own.moment.size += more.moment.size + m_.joints[i].travel * more.force.size, own.force.size += more.force.size;
    if (const int format = m_.joints[i].effort_format; format != JointRange::unknown) {  // any word may be given
      const double given = r_.capacity() * power_of_two(-format);
      own.joint_effort.size = larger(own.joint_effort.size, given + square_root(own.joint_inertia.size * outboard_[i]));
    }
    own.joint_effort.size += slides ? more.force.size : more.moment.size;
    own.joint_acceleration.size += slides ? more.linear_acceleration.size : more.angular_acceleration.size;
  }
  // On the way to a link its parent's acceleration is shifted: formats hold both.
  constexpr void choose(int i, const Ranges<N>* moving) {
    const LinkRange& own = all_.range[i];
    LinkFormat& format = all_.format[i];
    const int p = m_.parent(i);
    double linear = own.linear_acceleration.size, angular = own.angular_acceleration.size;
    if (p >= 0) {
      const LinkRange& up = all_.range[p];
      linear = larger(linear, up.linear_acceleration.size + m_.origin_distance(i) * up.angular_acceleration.size);
      angular = larger(angular, up.angular_acceleration.size);
    }
    if (p < 0 && moving != nullptr) linear += m_.loads.gravity_across + m_.loads.gravity_along;
    format.angular_velocity = moving == nullptr ? 0 : moving->format[i].angular_velocity;
    format.angular_acceleration = r_.exponent(angular);
    format.linear_acceleration = r_.exponent(linear);
    format.moment = r_.exponent(own.moment.size + m_.joints[i].travel * own.force.size);
    format.force = r_.exponent(own.force.size);
    format.joint_effort = r_.exponent(own.joint_effort.size);
    format.joint_acceleration = r_.exponent(own.joint_acceleration.size);
    format.angular_gain = r_.exponent(own.angular_gain.size);
    format.linear_gain = r_.exponent(own.linear_gain.size);
  }
};

/// Efforts that forward dynamics leaves to the joints: declared, or of the declared motion, and the bias.
template <int N>
constexpr PerJoint<N> given_efforts(const Mechanism<N>& m, const Ranges<N>& newton_euler, bool with_bias) {
  PerJoint<N> given;
  for (int i = 0; i < N; ++i) {
    const double motion = newton_euler.range[i].joint_effort.size;
    given.of[i] = m.joints[i].effort < unknown_size ? m.joints[i].effort : motion;
    if (with_bias) given.of[i] += motion;
  }
  return given;
}

/// What drives the joints without halvings: the declared efforts and as much again as gravity needs.
template <int N>
constexpr PerJoint<N> usual_drive(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& newton_euler) {
  Mechanism<N> still = m;
  for (JointRange& joint : still.joints)
    joint.speed = joint.acceleration = 0.0;
  const Ranges<N> rest = newton_euler_ranges(still, r, Wanted::formats);
  PerJoint<N> drive = given_efforts(m, newton_euler, false);
  for (int i = 0; i < N; ++i)
    drive.of[i] += rest.range[i].joint_effort.size;
  return drive;
}

/// How far efforts within the declared ones and the bias can drive the joints beyond what formats are made for.
template <int N>
constexpr double excess_of_drive(const Mechanism<N>& m, const Ranges<N>& newton_euler, const PerJoint<N>& alone) {
  const PerJoint<N> all = given_efforts(m, newton_euler, true);
  double excess = 1.0;
  for (int i = 0; i < N; ++i)
    excess = all.of[i] > excess * alone.of[i] ? all.of[i] / alone.of[i] : excess;
  return excess;
}

}  // namespace detail

/// Ranges of the classical form: the bias travels with the efforts.
template <int N>
constexpr Ranges<N> articulated_ranges(const Mechanism<N>& m, const WordRounding& r) {
  const Ranges<N> motion = newton_euler_ranges(m, r, Wanted::formats);
  return detail::ArticulatedAnalysis<N>(m, r, detail::given_efforts(m, motion, true).of, detail::least_inertias(m),
                                        &motion)
      .ranges();
}

}  // namespace axial

#include <axial/options/end.hpp>

// Ranges of composite bodies: what everything outboard of a link can weigh about it. doc/ranges.md is the proof.
#pragma once

#include <axial/fixed/ranges/shared_formats.hpp>
#include <axial/fixed/ranges/split_ball.hpp>

namespace axial {

/// Mass, first moment and inertia (norms) of all that a link carries: about its own origin, and behind its joint's
/// shift.
struct CompositeRange {
  double mass = 0.0, moment = 0.0, inertia = 0.0;  ///< kg, kg m, kg m^2

  /// About a point at a distance of r (m) at most.
  constexpr CompositeRange seen_from(double r) const {
    return {mass, moment + r * mass, inertia + r * (2.0 * moment + r * mass)};
  }
};
/// Two bodies about one point.
constexpr CompositeRange operator+(const CompositeRange& a, const CompositeRange& b) {
  return {a.mass + b.mass, a.moment + b.moment, a.inertia + b.inertia};
}

/// One composite body a link.
template <int N>
struct CompositeRanges {
  CompositeRange own[N] = {};     ///< about the link's origin, everything outboard included
  CompositeRange behind[N] = {};  ///< the same behind the shift of its joint
};

/// Parallel axes, link by link from the tips: whatever the joint angles.
template <int N>
constexpr CompositeRanges<N> composite_ranges(const Mechanism<N>& m) {
  CompositeRanges<N> all;
  for (int i = N; i-- > 0;) {
    const auto& c = m.links[i];
    CompositeRange link{magnitude(c.mass), detail::length_of(c.hx, c.hy, c.hz), detail::norm_of(c)};
    if (i + 1 == N) link = link + CompositeRange{m.loads.payload_mass, m.loads.payload_moment, m.loads.payload_inertia};
    all.own[i] = all.own[i] + link;
    all.behind[i] = all.own[i].seen_from(m.joints[i].travel);
    if (const int p = m.parent(i); p >= 0) all.own[p] = all.own[p] + all.own[i].seen_from(m.reach(i));
  }
  return all;
}

/// Formats of composite bodies: sums of two first moments occur, so they keep a bit to spare.
template <int N>
constexpr void set_inertia_formats(const Mechanism<N>& m, const CompositeRanges<N>& bodies, const Rounding& r,
                                   Ranges<N>& all) {
  for (int i = 0; i < N; ++i) {
    const CompositeRange& b = bodies.behind[i];
    all.range[i].mass.size = b.mass, all.range[i].first_moment.size = b.moment;
    all.range[i].rotational_inertia.size = b.inertia;
    all.format[i].mass = m.format(r, &LinkFormat::mass, b.mass);
    all.format[i].first_moment = m.format(r, &LinkFormat::first_moment, 2.0 * b.moment);
    all.format[i].rotational_inertia = m.format(r, &LinkFormat::rotational_inertia, b.inertia);
    const double rotor = m.loads.rotors ? m.links[i].rotor : 0.0;
    const CompositeRange& own = bodies.own[i];
    all.range[i].joint_inertia.size = (m.links[i].prismatic ? own.mass : own.inertia) + rotor;
    all.format[i].joint_inertia = m.format(r, &LinkFormat::joint_inertia, all.range[i].joint_inertia.size);
    all.format[i].length = m.format(r, &LinkFormat::length, m.joints[i].travel > 0.0 ? m.joints[i].travel : 1.0);
  }
}

namespace detail {

/// The recursion of dynamics/mass_matrix.hpp on Balls: composite bodies towards the base, then each joint's unit force
/// on its way there. Moment and Force are those of unit accelerations.
template <int N>
class CompositeBodyAnalysis {
 public:
  constexpr CompositeBodyAnalysis(const Mechanism<N>& mechanism, const Rounding& rounding)
      : m_(mechanism), r_(rounding), bodies_(composite_ranges(mechanism)) {
    set_inertia_formats(m_, bodies_, r_, all_);
    for (int i = 0; i < N; ++i)  // of regrouped parameters two diagonal entries may have opposite signs
      all_.format[i].rotational_inertia =
          m_.format(r_, &LinkFormat::rotational_inertia, 2.0 * bodies_.behind[i].inertia);
    for (int i = N; i-- > 0;)
      reach(i);
    for (int i = 0; i < N; ++i)
      all_.format[i].force = m_.format(r_, &LinkFormat::force, all_.range[i].force.size),
      all_.format[i].moment = m_.format(r_, &LinkFormat::moment, all_.range[i].moment.size);
    for (int i = N; i-- > 0;)
      gather(i);
    for (int i = 0; i < N; ++i)
      climb(i);
  }
  constexpr const Ranges<N>& ranges() const { return all_; }

 private:
  struct Force {
    Ball moment{}, force{};
  };
  const Mechanism<N>& m_;
  const Rounding& r_;
  CompositeRanges<N> bodies_;
  Ranges<N> all_{};
  Ball first_[N] = {}, inertia_[N] = {};  // of what a link carries, in its frame; `turned_` behind its joint
  Ball turned_first_[N] = {}, turned_inertia_[N] = {};

  static constexpr double larger_of(double a, double b) { return a > b ? a : b; }
  constexpr double arm(int i) const { return magnitude(m_.links[i].a) + magnitude(m_.links[i].branch.b); }

  // Sizes of unit forces that come by link i, its own among them.
  constexpr void reach(int i) {
    const CompositeRange& b = bodies_.behind[i];
    double &moment = all_.range[i].moment.size, &force = all_.range[i].force.size;
    force = larger_of(force, m_.links[i].prismatic ? b.mass : b.moment);
    moment = larger_of(moment, m_.links[i].prismatic ? b.moment : b.inertia) + m_.joints[i].travel * force;
    const int p = m_.parent(i);
    if (p < 0) return;
    all_.range[p].force.size = larger_of(all_.range[p].force.size, force);
    all_.range[p].moment.size = larger_of(all_.range[p].moment.size, moment + arm(i) * force);
  }

  constexpr double turn_error(int i) const { return m_.links[i].prismatic ? 0.0 : r_.turn_error; }
  // What a length at its format is off, and a sine of the model in a table.
  constexpr double length_error(int i, const LinkFormat& f) const {
    return m_.steps.shared ? 2.0 * r_.store(f.length) : m_.links[i].prismatic ? r_.store(f.length) : 0.0;
  }
  constexpr double constant_length_error(const LinkFormat& f) const {
    return m_.steps.shared ? r_.store(f.length) : 0.0;
  }
  constexpr double constant_turn_error() const { return m_.steps.shared ? r_.store(r_.bits - 2) : 0.0; }
  // What is on and beyond link i weighs, rounded link by link where a run-time payload is in it.
  constexpr Ball mass(int i) const {
    Ball all{bodies_.own[i].mass, 0.0};
    for (int k = i; k < N && m_.loads.payload_mass > 0.0; ++k)
      all.error += 2.0 * r_.store(all_.format[k].mass);
    return all;
  }
  // A body through one screw at the formats f: a turn by the double angle, and a shift that is off by `slip`.
  constexpr void screw(Ball& first, Ball& inertia, const Ball& weight, double tilt, double shift, double slip,
                       const LinkFormat& f) const {
    const double mass = weight.size;
    const double step =
        root3 * (r_.products(2, r_.bits - 2, f.first_moment, f.first_moment) + 2.0 * r_.store(f.first_moment));
    const double entry = r_.products(2, r_.bits - 2, f.rotational_inertia, f.rotational_inertia) +
                         r_.products(2, f.first_moment, f.length, f.rotational_inertia) +
                         2.0 * r_.store(f.rotational_inertia);
    const double angle = 4.0 * tilt + 4.0 * r_.store(r_.bits - 2);
    first.error += root2 * tilt * first.reach() + step + slip * mass + shift * weight.error;
    inertia.error += 2.0 * angle * inertia.reach() + 2.0 * shift * first.error + 6.0 * entry +
                     2.0 * slip * (first.reach() + shift * mass);
    first.size += shift * mass, inertia.size += shift * (2.0 * first.size + shift * mass);
  }
  constexpr void gather(int i) {
    const auto& c = m_.links[i];
    const LinkFormat& own = all_.format[i];
    first_[i].size = bodies_.own[i].moment, inertia_[i].size = bodies_.own[i].inertia;
    first_[i].error += root3 * r_.store(own.first_moment), inertia_[i].error += 3.0 * r_.store(own.rotational_inertia);
    turned_first_[i] = first_[i], turned_inertia_[i] = inertia_[i];
    screw(turned_first_[i], turned_inertia_[i], mass(i), turn_error(i), m_.joints[i].travel, length_error(i, own), own);
    all_.range[i].rotational_inertia = inertia_[i], all_.range[i].first_moment = first_[i];
    const int p = m_.parent(i);
    if (p < 0) return;
    Ball first = turned_first_[i], inertia = turned_inertia_[i];
    const LinkFormat& outer = all_.format[p];
    const double tilt = constant_turn_error(), slip = constant_length_error(outer);
    screw(first, inertia, mass(i), tilt, magnitude(c.a), slip, outer);
    if (c.branch.b < 0.0 || c.branch.b > 0.0 || c.branch.sin_gamma < 0.0 || c.branch.sin_gamma > 0.0)
      screw(first, inertia, mass(i), tilt, magnitude(c.branch.b), slip, outer);
    first_[p].error += first.error, inertia_[p].error += inertia.error;
  }
  // Errors of row i of the matrix: the largest is kept with the joint.
  constexpr void climb(int i) {
    const bool slides = m_.links[i].prismatic;
    Force f{slides ? turned_first_[i] : turned_inertia_[i], slides ? mass(i) : turned_first_[i]};
    Ball& entry = all_.range[i].joint_inertia;
    if (m_.steps.shared)
      f.moment.error += r_.store(all_.format[i].moment), f.force.error += r_.store(all_.format[i].force);
    entry.error = (slides ? f.force : f.moment).error + 2.0 * r_.store(all_.format[i].joint_inertia);
    for (int k = i; m_.parent(k) >= 0; k = m_.parent(k)) {
      const int p = m_.parent(k);
      if (k != i) carry(f, turn_error(k), m_.joints[k].travel, length_error(k, all_.format[k]), all_.format[k]);
      carry(f, constant_turn_error(), arm(k), 2.0 * constant_length_error(all_.format[p]), all_.format[p]);
      const double error = (m_.links[p].prismatic ? f.force : f.moment).error;
      entry.error = larger_of(entry.error, error + r_.store(all_.format[p].moment));
    }
  }
  constexpr void carry(Force& f, double tilt, double shift, double slip, const LinkFormat& to) const {
    const double force = r_.products(2, r_.bits - 2, to.force, to.force) + r_.store(to.force);
    const double moment = r_.products(2, r_.bits - 2, to.moment, to.moment) +
                          r_.products(2, to.force, to.length, to.moment) + r_.store(to.moment);
    f.moment.error += root2 * tilt * f.moment.reach() + shift * f.force.error + slip * f.force.reach() + root3 * moment;
    f.force.error += root2 * tilt * f.force.reach() + root3 * force;
    f.moment.size += shift * f.force.size;
  }
};

}  // namespace detail

/// Ranges and errors of the mass matrix by composite bodies: joint_inertia of joint i bounds what is on and before the
/// diagonal in row i.
template <int N>
constexpr Ranges<N> composite_body_ranges(const Mechanism<N>& m, const Rounding& r) {
  return detail::ranges_by(m, r,
                           [&r](const Mechanism<N>& of) { return detail::CompositeBodyAnalysis<N>(of, r).ranges(); });
}

}  // namespace axial

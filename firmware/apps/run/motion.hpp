#pragma once
/// A smooth motion inside the limits that a robot declares: every joint a sine about the middle of its range. Where
/// joints share drives every drive, so far as the joints may go.

#include <axial/axial.hpp>

#include "../states.hpp"

namespace axial::apps::run {

constexpr double period_s = 4.0;  ///< of the slowest joint
constexpr double used = 0.8;      ///< of what the limits allow
constexpr int samples = 41;       ///< one period, both ends included
constexpr double step_s = period_s / (samples - 1);

/// Where one joint stands at time t (s): rad or m, and its first two derivatives.
struct Motion {
  double q = 0.0, qd = 0.0, qdd = 0.0;
};

constexpr double least(double a, double b) { return a < b ? a : b; }

/// Joint i's turn rate: joints are out of step with each other, so that every pair of speeds occurs.
constexpr double rate(int i) { return 6.283185307179586476925 / period_s * (1.0 + 0.25 * (i % 4)); }

/// By joint i's own limits. Those that are missing are those of states.hpp.
template <class Robot>
constexpr double own_amplitude(int i) {
  const auto& limits = reach_of<Robot>.joints[i];
  const double w = rate(i);
  return used * least(static_cast<double>(limits.position),
                      least(static_cast<double>(limits.speed) / w, static_cast<double>(limits.acceleration) / (w * w)));
}

/// Where drives that joints share stand in the middle, and how much of their amplitudes is left to them: so that joints
/// stand in the middle of their ranges too, and stay inside their limits.
template <class Robot>
struct SharedCourse {
  static constexpr int drives = joint_count<Robot>, links = link_count<Robot>;
  double middle[drives] = {}, share = 1.0;

  constexpr SharedCourse() {
    for (int i = 0; i < drives; ++i) {
      middle[i] = static_cast<double>(reach_of<Robot>.joints[i].middle);
      Joints<Robot, double> unit{};
      unit[i] = 1.0;
      const auto moved = joint_rates<Robot>(unit);
      for (int j = 0; j < links; ++j)
        ratio[j][i] = moved[j];
    }
    const auto zero = joint_positions<Robot>(Joints<Robot, double>{});
    for (int j = 0; j < links; ++j)
      offset[j] = zero[j];
    for (int sweep = 0; sweep < 20; ++sweep)
      for (int j = 0; j < links; ++j)
        centre(j);
    for (int i = 0; i < drives; ++i) {
      const auto& own = reach_of<Robot>.joints[i];
      fit(static_cast<double>(own.position) - size_of(middle[i] - static_cast<double>(own.middle)), amplitude(i));
    }
    for (int j = 0; j < links; ++j)
      keep_inside(j);
  }

 private:
  double ratio[links][drives] = {}, offset[links] = {};  // of joints by drives

  static constexpr const LinkParameters& link(int j) { return robot_of<Robot>::chain.links[j]; }
  static constexpr double amplitude(int i) { return own_amplitude<Robot>(i); }
  static constexpr double size_of(double x) { return x < 0.0 ? -x : x; }
  constexpr double position(int j) const {
    double sum = offset[j];
    for (int i = 0; i < drives; ++i)
      sum += ratio[j][i] * middle[i];
    return sum;
  }
  /// Moves the drives as little as brings joint j to its middle (Kaczmarz 1937).
  constexpr void centre(int j) {
    if (!(link(j).position_max < LinkParameters::unlimited && link(j).position_min > -LinkParameters::unlimited))
      return;
    double squares = 0.0;
    for (int i = 0; i < drives; ++i)
      squares += ratio[j][i] * ratio[j][i];
    const double off = 0.5 * (link(j).position_min + link(j).position_max) - position(j);
    for (int i = 0; i < drives; ++i)
      middle[i] += squares > 0.0 ? off * ratio[j][i] / squares : 0.0;
  }
  constexpr void keep_inside(int j) {
    double reach = 0.0, speed = 0.0, acceleration = 0.0;
    for (int i = 0; i < drives; ++i) {
      const double by = size_of(ratio[j][i]) * amplitude(i);
      reach += by, speed += rate(i) * by, acceleration += rate(i) * rate(i) * by;
    }
    fit(least(link(j).position_max - position(j), position(j) - link(j).position_min), reach);
    fit(link(j).speed_limit, speed), fit(link(j).acceleration_limit, acceleration);
  }
  constexpr void fit(double most, double taken) {
    if (taken > 0.0 && most > 0.0) share = least(share, used * most / taken);
  }
};

template <class Robot>
constexpr Motion motion(int i, double t) {
  double middle = static_cast<double>(reach_of<Robot>.joints[i].middle), amplitude = own_amplitude<Robot>(i);
  if constexpr (detail::shares_drives_in<typename scene_of<Robot>::Robot>) {
    constexpr SharedCourse<Robot> course;
    middle = course.middle[i], amplitude *= course.share;
  }
  const double w = rate(i);
  auto wave = sincos(w * t);
  if (wave.cos < 1e-9 && wave.cos > -1e-9)
    wave.cos = 0.0;  // at rest in every number system: friction depends on the sign
  return {middle + amplitude * wave.sin, amplitude * w * wave.cos, -amplitude * w * w * wave.sin};
}

}  // namespace axial::apps::run

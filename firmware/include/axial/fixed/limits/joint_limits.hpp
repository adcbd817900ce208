// Limits of joints that share drives, in words of the drives: what G makes of them held against the joints' own limits.
#pragma once

#include <axial/fixed/limits/fixed_limits.hpp>
#include <axial/fixed/links/fixed_links.hpp>
#include <axial/fixed/words/wide_words.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// A limit as an integer; units of rounding are allowed, so that the limit itself is inside.
constexpr std::int64_t shared_limit(double limit, double unit) {
  constexpr double farthest = 4e18;
  constexpr std::int64_t allowed = 4;
  return limit * unit < farthest ? nearest_integer(limit * unit) + allowed : static_cast<std::int64_t>(farthest);
}

/// Limits of the joints of a scene whose drives are inside their own limits.
template <class S, class Word>
struct SharedLimits {
  using T = Stored<Word>;
  using Links = decltype(links_of<S, T>());
  using Declared = JointCoordinates<robot_of<S>>;  ///< the limits, without the room that formats have
  using Within = typename Links::JointRobot;
  static constexpr int size = Links::size;

  /// One joint: ends of its range, which counts turns, in units of 2^-32 turns or of its word; the largest rates.
  struct Limit {
    std::int64_t low = 0, high = 0, speed = 0, acceleration = 0;
  };
  static constexpr Row<Limit, size> limits = [] {
    Row<Limit, size> all{};
    for (int i = 0; i < size; ++i) {
      const LinkParameters& p = Declared::chain.links[i];
      const bool turns = p.type == JointType::revolute;
      const double unit = turns ? bam_per_radian : power_of_two(Positions<Within, T>::exponent(i));
      all[i].low = -shared_limit(-p.position_min, unit), all[i].high = shared_limit(p.position_max, unit);
      all[i].speed = shared_limit(p.speed_limit, power_of_two(Velocities<Within, T>::exponent(i)));
      all[i].acceleration = shared_limit(p.acceleration_limit, power_of_two(Accelerations<Within, T>::exponent(i)));
    }
    return all;
  }();

  /// The first joint beyond its limits, by the drive that moves it, and which. The same instructions for all words.
  template <class V, class A>
  static constexpr Status status(const Positions<robot_of<S>, T>& u, const V& ud, const A& udd) {
    const auto qd = Links::rates(ud);
    const auto qdd = Links::rates(udd);  // or nothing
    First first;
    Links::each_joint([&](auto i) {
      constexpr const Limit& limit = limits[i];
      const bool there = is_there(position<decltype(i)::value>(u), limit);
      const bool slow = inside(qd, i, limit.speed), gentle = inside(qdd, i, limit.acceleration);
      constexpr int beyond = static_cast<int>(Status::Code::position_limit),
                    fast = static_cast<int>(Status::Code::speed_limit),
                    hasty = static_cast<int>(Status::Code::acceleration_limit);
      first.see(!(there & slow & gentle), select(there, select(slow, hasty, fast), beyond), Links::matrix.mover_of(i));
    });
    return first.status();
  }
  /// Status of positions alone; with `slides_only` no more than formats need.
  static constexpr Status of_position(const Positions<robot_of<S>, T>& u, bool slides_only = false) {
    First first;
    Links::each_joint([&](auto i) {
      constexpr const Limit& limit = limits[i];
      constexpr bool slides = Declared::chain.links[i].type == JointType::prismatic;
      const bool looked_at = slides | !slides_only;
      first.see(looked_at & !is_there(position<decltype(i)::value>(u), limit),
                static_cast<int>(Status::Code::position_limit), Links::matrix.mover_of(i));
    });
    return first.status();
  }

 private:
  // What is found first.
  struct First {
    int code = static_cast<int>(Status::Code::ok), joint = -1;
    constexpr void see(bool found, int own, int drive) {
      const bool taken = found & is_negative(joint);
      code = select(taken, own, code), joint = select(taken, drive, joint);
    }
    constexpr Status status() const { return status_from(code, joint); }
  };
  static constexpr bool is_there(std::int64_t q, const Limit& limit) {
    const bool low = !is_less_wide(q, limit.low), high = !is_less_wide(limit.high, q);
    return low & high;
  }
  static constexpr bool inside(const NoMotion&, int, std::int64_t) { return true; }
  template <class Values>
  static constexpr bool inside(const Values& values, int i, std::int64_t most) {
    const bool high = !is_less_wide(most, values[i].raw), low = !is_less_wide(values[i].raw, -most);
    return high & low;
  }
  // Position of joint I without a turn lost.
  template <int I>
  static constexpr std::int64_t position(const Positions<robot_of<S>, T>& u) {
    constexpr bool turns = Declared::chain.links[I].type == JointType::revolute;
    constexpr double unit = turns ? bam_per_radian : power_of_two(Positions<Within, T>::exponent(I));
    std::int64_t sum = nearest_integer(unit * Links::matrix.offset[I]);
    Links::each_drive([&](auto k) {
      constexpr double ratio = Links::matrix.ratio[I][decltype(k)::value];
      if constexpr (ratio != 0.0) {
        constexpr int from = Positions<robot_of<S>, T>::exponent(decltype(k)::value);
        constexpr double scale = unit * ratio * power_of_two(-from);
        constexpr int shift = smaller(fitting_exponent(scale, 1073741823.0), 30);
        static_assert(shift >= 0, "axial: a drive's unit moves its joint by many turns");
        constexpr auto factor = static_cast<std::int32_t>(nearest_integer(scale * power_of_two(shift)));
        sum += integer::multiply(factor, u[decltype(k)::value].raw) >> shift;
      }
    });
    return sum;
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>

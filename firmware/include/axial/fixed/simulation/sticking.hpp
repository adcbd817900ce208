// Dry friction that sticks and end stops that do not yield, in fixed point: joints that are held, exactly.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/dynamics/driven_forward_dynamics.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/end_stops.hpp>
#include <axial/simulation/sticking.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Whether a drive meets end stops; the drive itself.
///@{
template <class Drive>
inline constexpr bool meets_stops = false;
template <class Drive>
AXIAL_INLINE constexpr const auto& driving(const Drive& drive) {
  if constexpr (meets_stops<Drive>)
    return drive.drive();
  else
    return drive;
}
///@}

/// A positive constant that words are multiplied by, rounded down; to 2^-29 of itself.
struct WordFactor {
  std::int32_t mantissa = 0;
  int down = 0, up = 0;

  static constexpr WordFactor of(double x) {
    constexpr int digits = 30, most = 61;
    if (!(x > power_of_two(digits - most))) return {};
    const int shift = digits - 1 - binary_exponent(x);
    return {static_cast<std::int32_t>(nearest_integer(x * power_of_two(shift))), larger(shift, 0), larger(-shift, 0)};
  }
  AXIAL_INLINE constexpr std::int64_t operator()(std::int32_t word) const {
    return wide_raised(wide_shifted_by(integer::multiply(word, mantissa), down), up);
  }

 private:
  static constexpr int larger(int a, int b) { return a > b ? a : b; }
};

/// Exponents of accelerations in a step of h seconds: speeds within their limits change by no more.
template <class S, class Stiff>
inline constexpr auto step_exponents = per_joint<joint_count<S>>([](int k) {
  return joint_rounding<std::int32_t>.exponent(2.0 * scene_of<S>::Robot::chain.links[k].speed_limit / Stiff::step);
});
template <class S, class Stiff>
struct StepAccelerations {
  Fixed32 values[joint_count<S>] = {};
  static constexpr int exponent(int k) { return step_exponents<S, Stiff>.of[k]; }
};

/// What of a step no state changes, of each joint.
template <class S, class Stiff>
struct HeldConstants {
  using T = Fixed32;
  using H = typename StiffScene<S, Stiff>::type;
  static constexpr int size = joint_count<S>;
  WordFactor speed[size] = {};                  ///< words of speeds of words of accelerations: h a
  WordFactor acceleration[size] = {};           ///< and of half a change of speed: 2 c / h
  WordFactor reach[size] = {};                  ///< words of speeds of words of a position: c / h
  WordFactor stiff[size] = {};                  ///< words of efforts of words of speeds: h K v
  std::int32_t furthest[size] = {};             ///< word of a position that no speed reaches in a step, about
  int forward[size] = {}, backward[size] = {};  ///< Coulomb's efforts, in words
  int coarser[size] = {};                       ///< halvings of a word of an effort to that of H

  static constexpr HeldConstants chosen() {
    HeldConstants all;
    for (int k = 0; k < size; ++k)
      all.choose(k, scene_of<S>::Robot::chain.links[k]);
    return all;
  }

 private:
  constexpr void choose(int k, const LinkParameters& link) {
    constexpr double h = Stiff::step;
    const int effort = EffortsOf<S, T>::exponent(k);
    const double change = power_of_two(StepAccelerations<S, Stiff>::exponent(k)),
                 rate = power_of_two(Velocities<robot_of<S>, T>::exponent(k)), force = power_of_two(effort),
                 place = turns_of<typename scene_of<S>::Robot>.of[k]
                             ? 1.0 / bam_per_radian
                             : power_of_two(-Positions<robot_of<S>, T>::exponent(k));
    speed[k] = WordFactor::of(h * rate / change), acceleration[k] = WordFactor::of(2.0 * change / rate / h);
    reach[k] = WordFactor::of(place * rate / h);
    const double most = 2.0 * link.speed_limit * h / place;
    furthest[k] = most < 2147483647.0 ? static_cast<std::int32_t>(most) : 2147483647;
    if constexpr (scene_of<S>::template has<Friction>)
      forward[k] = static_cast<int>(nearest_integer(link.coulomb_forward * force)),
      backward[k] = static_cast<int>(nearest_integer(link.coulomb_backward * force));
    coarser[k] = effort - EffortsOf<H, T>::exponent(k);
    stiff[k] = WordFactor::of(h * declared_stiffness<S, Stiff>(k) * force / rate);
  }
};

/// -1, 0 or 1 as x is.
AXIAL_INLINE constexpr int sign_of_word(int x) {
  return (x >> 31) | static_cast<int>((0U - static_cast<unsigned>(x)) >> 31);
}

/// Which joints are held.
template <int size>
struct HeldJoints {
  bool of[size] = {};
  AXIAL_INLINE constexpr bool operator()(int k) const { return of[k]; }
};

/// A step of joints as StickingEuler has it, in words: what sticks is left out of M as it is solved, and so is, with
/// `stops`, a joint that would pass its position limit: its speed is the one that takes it there. A stop only pushes.
/// Words are `int` here, which select() takes without a branch.
template <class S, class Stiff, bool stops>
class HeldStep {
  using T = Fixed32;
  using A = ArithmeticOf<scene_of<S>, std::int32_t>;
  using H = typename StiffScene<S, Stiff>::type;
  using Accelerations = StepAccelerations<S, Stiff>;
  using Units = DriveUnits<H, std::int32_t, Accelerations>;
  static constexpr int size = joint_count<S>;
  static constexpr auto constants = HeldConstants<S, Stiff>::chosen();

 public:
  static_assert(
      drive_units<H, std::int32_t, Units>.resisted,
      "axial: words lose a joint that moves by itself a hundred thousand times more easily than with all that it "
      "carries; give its link an inertia, or rotor_inertia() and name RotorInertia; or compute in float");

  template <class X>
  AXIAL_INLINE constexpr HeldStep(const X& x, const Driven<S, T>& driven) {
    EffortsOf<S, T> bias{};
    execute<rnea::InverseDynamics>(links_of<scene_of<S>, T, BaseParameters, recursion::NewtonEuler>(), driven.in, x.q,
                                   x.qd, NoMotion{}, bias);
    execute<crba::CompositeMatrix>(links_of<scene_of<H>, T, BaseParameters, recursion::CompositeBodies>(),
                                   __builtin_bit_cast(Inputs<H, T>, driven.in),
                                   same_values<Positions<robot_of<H>, T>>(x.q), m_);
    for (int k = 0; k < size; ++k) {
      qd_[k] = x.qd.values[k].raw;
      way_[k] = sign_of_word(qd_[k]);
      left_[k] = std::int64_t{driven.tau.values[k].raw} - bias.values[k].raw + sliding(k) - constants.stiff[k](qd_[k]);
    }
    if constexpr (stops)
      SummationOf<X>::each(size,
                           [&](auto i) AXIAL_INLINE { look<decltype(i)::value>(x.q.values[decltype(i)::value].raw); });
  }
  /// Finds who sticks and who stops, for which one solve is exact enough; what cannot be answered.
  AXIAL_INLINE constexpr Status solve() {
    Status status{};
    for (int left = StickingFor<Stiff>::evaluations; left-- > 0;) {
      status = accelerate(left > 0 ? 1 : Units::solves);
      for (int k = 0; left > 0 && k < size; ++k)
        change(k);
    }
    return status;
  }
  template <class X>
  AXIAL_INLINE constexpr void move(X& x, const FixedStep& h) const {
    using Sums = SummationOf<X>;
    Accelerations a{};
    for (int k = 0; k < size; ++k)
      a.values[k].raw = a_[k];
    Sums::each(size, [&](auto i) AXIAL_INLINE {
      constexpr int k = decltype(i)::value;
      const bool still = sticks(k), turns = turned(k), rubbing = rubs(k);
      const bool rests = (stop_[k] == 0) & (still | (rubbing & turns));
      const int v = select(rests, 0, within(k));
      const bool given = rests | (stop_[k] != 0) | (v != v_[k]);
      Sums::add_velocity(x, i, h, a);
      x.qd.values[k].raw = select(given, v, int{x.qd.values[k].raw});
      x.qd_rest[k] = select(given, 0, int{x.qd_rest[k]});
      Sums::add_position(x, i, h, x.qd);
    });
  }

 private:
  MassMatrixOf<H, T> m_{};
  std::int64_t left_[size] = {};                        // efforts but for dry friction
  int qd_[size] = {}, v_[size] = {}, pull_[size] = {};  // speeds before and after; efforts that hold must bear
  int above_[size] = {}, below_[size] = {};             // speeds that lead to the position limits
  int way_[size] = {}, stop_[size] = {};                // where it slides, 0 where it sticks; which stop holds it
  std::int32_t a_[size] = {};

  AXIAL_INLINE static constexpr int narrow(std::int64_t x) {
    bool lost = false;
    return held_in_word<A>(lost, x);
  }
  /// Dry friction of joint k on its way.
  AXIAL_INLINE constexpr int sliding(int k) const {
    return select(is_negative(-way_[k]), constants.forward[k], select(is_negative(way_[k]), constants.backward[k], 0));
  }
  /// The speed that it is held at.
  AXIAL_INLINE constexpr int wanted(int k) const {
    return select(is_negative(-stop_[k]), above_[k], select(is_negative(stop_[k]), -below_[k], 0));
  }
  /// Without dry friction nothing sticks.
  AXIAL_INLINE constexpr bool sticks(int k) const { return rubs(k) & (way_[k] == 0); }
  AXIAL_INLINE constexpr bool turned(int k) const { return is_negative(sign_of_word(v_[k]) * way_[k]); }
  AXIAL_INLINE static constexpr bool rubs(int k) { return (constants.forward[k] | constants.backward[k]) != 0; }
  AXIAL_INLINE constexpr int within(int k) const {
    if constexpr (stops)
      return select(is_less(above_[k], v_[k]), above_[k], select(is_less(v_[k], -below_[k]), -below_[k], v_[k]));
    else
      return v_[k];
  }

  /// How fast joint I, at q, may go either way.
  template <int I>
  AXIAL_INLINE constexpr void look(std::int32_t q) {
    constexpr const auto& range = fixed_limits_of<S, std::int32_t>.joints[I];
    constexpr bool ends = !range.wraps || range.span != (std::numeric_limits<std::uint32_t>::max)();
    constexpr int any_speed = (std::numeric_limits<int>::max)();
    above_[I] = below_[I] = any_speed;
    if constexpr (ends) {
      const std::uint32_t over = gap(q, range.max), under = gap(range.min, q);
      const bool low = range.wraps ? is_less_wide(under, over) : is_less(q, range.min);
      const bool inside = range.outside({q}) == 0;
      above_[I] = select(inside, speed_to(I, gap(range.max, q)), select(low, any_speed, 0));
      below_[I] = select(inside, speed_to(I, gap(q, range.min)), select(low, 0, any_speed));
    }
  }
  AXIAL_INLINE static constexpr std::uint32_t gap(std::int32_t to, std::int32_t from) {
    return static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from);
  }
  // Rounded down: a step ends at the limit or less than a word before it.
  AXIAL_INLINE static constexpr int speed_to(int k, std::uint32_t gap) {
    const std::int64_t most = constants.furthest[k];
    return narrow(constants.reach[k](static_cast<std::int32_t>(select_wide(is_less_wide(gap, most), gap, most))));
  }

  AXIAL_INLINE constexpr Status accelerate(int solves) {
    HeldJoints<size> held{};
    std::int64_t given[size] = {}, left[size] = {};
    for (int k = 0; k < size; ++k) {
      held.of[k] = sticks(k) | (stop_[k] != 0);
      const std::int64_t change = std::int64_t{wanted(k)} - qd_[k];
      a_[k] = select(held(k), narrow(constants.acceleration[k](static_cast<std::int32_t>(change >> 1))), 0);
      given[k] = wide_shifted_by(left_[k] - select(held(k), 0, sliding(k)), constants.coarser[k]);
    }
    const DriveSolve<H, std::int32_t, Units, HeldJoints<size>> solve(m_, held);
    int spilt = -1;
    for (; solves > 0; --solves)
      solve.improve(given, a_, spilt);
    solve.residual(given, a_, left);
    for (int k = 0; k < size; ++k) {
      pull_[k] = narrow(wide_raised(narrow(wide_shifted_by(left[k], solve.u.given[k])), constants.coarser[k]));
      v_[k] = select(held(k), wanted(k), narrow(qd_[k] + constants.speed[k](a_[k])));
    }
    using Code = Status::Code;
    const bool is_lost = !is_negative(solve.lost()), is_spilt = !is_negative(spilt);
    return status_from(select(is_lost, static_cast<int>(Code::near_singular),
                              select(is_spilt, static_cast<int>(Code::saturated), static_cast<int>(Code::ok))),
                       select(is_lost, solve.lost(), spilt));
  }

  /// Where a joint slides that sticks: the way in which it is pulled by more than friction.
  AXIAL_INLINE constexpr int broken(int k) const {
    return select(is_less(constants.forward[k], pull_[k]), 1, select(is_less(pull_[k], constants.backward[k]), -1, 0));
  }
  /// Who is broken away slides, whom friction would turn around sticks, who would pass a limit is stopped; and who
  /// leaves a stop goes on if it only arrives there, or sticks, or breaks away.
  AXIAL_INLINE constexpr void change(int k) {
    const bool free = stop_[k] == 0, arrives = wanted(k) != 0;
    const int pull = sign_of_wide(std::int64_t{pull_[k]} - select(arrives, sliding(k), 0));
    const bool stays = !free & !is_negative(pull * stop_[k]);
    const int slides = select(rubs(k), select(turned(k), 0, way_[k]), sign_of_word(v_[k]));
    const int next = select(free & !sticks(k), slides, select(arrives, way_[k], broken(k)));
    const bool up = is_negative(-next), down = is_negative(next), over = !is_less(v_[k], above_[k]),
               under = !is_less(-below_[k], v_[k]), reaches = stops & free & ((up & over) | (down & under));
    way_[k] = select(stays | reaches, way_[k], next);
    stop_[k] = select(stays, stop_[k], select(reaches, next, 0));
  }
  AXIAL_INLINE static constexpr int sign_of_wide(std::int64_t x) {
    return static_cast<int>(x >> 63) | static_cast<int>((std::uint64_t{0} - static_cast<std::uint64_t>(x)) >> 63);
  }
};

template <class Stiff, class S>
struct StepHeld<Stiff, S, Fixed32> {
  template <class System, class X, class Drive>
  [[nodiscard]] static constexpr Status run(const System&, X& x, const FixedStep& h, const Drive& drive) {
    using Sums = SummationOf<X>;
    constexpr bool stops = meets_stops<Drive>;
    static_assert(scene_of<S>::template has<Friction> || stops,
                  "axial: what is held is held by dry friction or by end stops; name Friction in the scene, or give "
                  "advance() WithEndStops");
    const auto driven = ask<S, Fixed32>(driving(drive), {x.q, x.qd, x.time(h)});
    const StateCheck<S, Fixed32> check(driven.in, x.q, x.qd);
    HeldStep<S, Stiff, stops> joints(x, driven);
    Status status = joints.solve();
    check.name(status);
    Sums::name_lost(status, x.q, x.qd);
    joints.move(x, h);
    return status;
  }
};

}  // namespace detail

/// In fixed point stops do not yield, whatever their stiffness: for StickingFor alone.
template <class S, class Word, class Drive>
class WithEndStops<S, Stored<Word>, Drive> {
 public:
  /// `drive` as advance() takes it
  constexpr WithEndStops(const Drive& drive, const EndStops&) : drive_(drive) {}
  constexpr const Drive& drive() const { return drive_; }  ///< without the stops

  /// Refused: a method that would not see the stops.
  template <class Where>
  constexpr void operator()(const Where&, EffortsOf<S, Stored<Word>>&, Inputs<S, Stored<Word>>&) const {
    static_assert(!std::is_same_v<Where, Where>,
                  "axial: end stops in fixed point are met by StickingFor; take that, or leave WithEndStops out");
  }

 private:
  const Drive& drive_;
};

namespace detail {
template <class S, class Word, class Drive>
inline constexpr bool meets_stops<WithEndStops<S, Stored<Word>, Drive>> = true;
}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>

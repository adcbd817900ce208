#pragma once
/// A loop closed around the feed-forward: its torque, and a proportional-derivative one of the tracking error.

#include <firmware/apps/feedforward/controller.hpp>

#include "encoders.hpp"

namespace axial::apps {

/// Set-points and measurements come at this rate.
constexpr int control_Hz = 1000;
/// Of the feedback on each joint by itself: critically damped.
constexpr double bandwidth_Hz = 4.0;

template <int N>
struct Gains {
  double stiffness[N], damping[N];  ///< N m/rad and N m s/rad, N/m and N s/m
};

/// w^2 M_ii and 2 w M_ii in the middle of the travel of the joints, or of the drives that they share.
template <class Scene>
constexpr auto tracking_gains() {
  using Values = typename scene_of<Scene>::Robot;
  constexpr double w = 2.0 * 3.14159265358979323846 * bandwidth_Hz;
  Joints<robot_of<Scene>, double> middle{};
  for (int i = 0; i < Values::chain.size; ++i)
    middle[i] = 0.5 * (Values::chain.links[i].position_min + Values::chain.links[i].position_max);
  const auto mass = mass_matrix<Scene>(middle);
  Gains<Values::chain.size> gains{};
  for (int i = 0; i < Values::chain.size; ++i)
    gains.stiffness[i] = w * w * mass(i, i), gains.damping[i] = 2.0 * w * mass(i, i);
  return gains;
}

/// Feed-forward and feedback: tau + Kp e + Kd (e - e_last) 1/s, cut to the declared efforts. The derivative is that of
/// the error, so wanted and measured motion lag alike. In float or, by integers alone, in fixed point. A set-point
/// without a measurement of its own is refused, for feedback of an old one grows without end. Feedback is part of the
/// torque that the fall-back holds and lets fade; it begins without a derivative after each pause. A measurement that
/// jumps, or leaves so large an error that feedback alone asks for twice the declared effort, is that of a broken
/// encoder: it and all that follow count as none, until a session begins.
template <class Scene, class Number = float>
class TrackingController : public Controller<Scene, Number> {
  using Base = Controller<Scene, Number>;
  using typename Base::Q;
  using typename Base::Real;
  using typename Base::Robot;
  using typename Base::Tau;
  static constexpr int n = joint_count<Scene>;
  static constexpr Gains<n> gains = tracking_gains<Scene>();
  static constexpr bool slides(int i) { return Encoders<Scene, Number>::slides(i); }
  static constexpr float turn = 6.28318530717958647692F;
  using Error = std::conditional_t<is_stored_v<Number>, std::int32_t, float>;

 public:
  void measure(const hal::link::Measurement& measurement) {
    broken_ = broken_ || (ever_measured_ && this->phase() == DrivePhase::running &&
                          Encoders<Scene, Number>::jumps(position_, measurement.position));
    if (broken_) return;
    position_ = measurement.position;
    feeds_forward_ = measurement.feeds_forward != 0;
    measured_ = ever_measured_ = true;
  }

  void compute() {
    Base::compute();
    sum_ = this->result_.tau;
    if (this->met()) add_feedback();
  }

  void settle(const hal::link::SetPoint& request) {
    if (this->met() && measured_ && !broken_)
      this->follow(sum_);
    else
      refuse(request);
    measured_ = false;
  }

  void advance(std::uint32_t ticks) {
    Base::advance(ticks);
    if (this->phase() != DrivePhase::running) started_ = false;
  }

  void restart() {
    Base::restart();
    measured_ = ever_measured_ = started_ = broken_ = false;
  }

 protected:
  // --- wanted less measured: rad or m, or units of the position's format

  template <int I>
  Error tracking_error() const {
    const std::int32_t counts = position_[static_cast<std::size_t>(I)];
    if constexpr (!is_stored_v<Number>) {
      if constexpr (slides(I)) return this->request_.q[I] - static_cast<float>(counts) * (1.0F / slide_counts);
      const float e = this->request_.q[I] - static_cast<float>(counts) * (turn / 4294967296.0F);
      return e > 0.5F * turn ? e - turn : e < -0.5F * turn ? e + turn : e;
    } else if constexpr (slides(I)) {
      using Encoder = LinearEncoder<slide_counts>;
      return difference(this->request_.q[I].raw,
                        Encoder::template position<Positions<Robot, Number>, I>(counts).value.raw);
    } else {
      return difference(this->request_.q[I].raw, counts);
    }
  }

  /// The error at which feedback alone asks for twice the declared effort.
  template <int I>
  static constexpr Error largest_error() {
    constexpr double error = 2.0 * scene_of<Scene>::Robot::chain.links[I].effort_limit / gains.stiffness[I];
    double unit = 1.0;
    if constexpr (is_stored_v<Number>)
      unit = slides(I) ? detail::power_of_two(Positions<Robot, Number>::exponent(I)) : 4294967296.0 / 6.283185307179586;
    constexpr double most = is_stored_v<Number> ? 2147483647.0 : 1e30;
    return static_cast<Error>(error * unit < most ? error * unit : most);
  }
  /// Adds the feedback to `sum_`.
  void add_feedback() { add_all(std::make_integer_sequence<int, n>{}); }
  /// The next set-point is refused as one without a measurement.
  void forget_measurement() { measured_ = false; }

  Error last_[n] = {};
  Tau sum_{};
  bool feeds_forward_ = true, started_ = false;

 private:
  /// Holds at the request's position, else at what the encoders said last.
  void refuse(const hal::link::SetPoint& request) {
    const bool good = this->met();
    const bool held = this->hold_at(request);
    if (!held && ever_measured_)
      (void)this->fall_back_.hold_at(Encoders<Scene, Number>::positions(position_),
                                     this->in_);  // or it is held already
    if (good) this->status_ = hal::link::TorqueStatus::not_measured;
    started_ = false;
  }

  template <int... I>
  void add_all(std::integer_sequence<int, I...>) {
    (add<I>(), ...);
    (void)detail::clamp_efforts<Scene>(sum_);  // what the wire tells is whether the feed-forward was cut
    started_ = true;
  }

  template <int I>
  void add() {
    const Error error = tracking_error<I>();
    const Error change = started_ ? difference(error, last_[I]) : Error{};
    broken_ = broken_ || (started_ && (error > largest_error<I>() || error < -largest_error<I>()));
    last_[I] = error;
    if constexpr (is_stored_v<Number>)
      sum_[I] = {feedback<I>(error, change)};
    else
      sum_[I] = (feeds_forward_ ? sum_[I] : 0.0F) + static_cast<float>(gains.stiffness[I]) * error +
                static_cast<float>(gains.damping[I] * control_Hz) * change;
  }

  // --- float

  static float difference(float a, float b) { return a - b; }

  // --- fixed point

  static std::int32_t difference(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
  }
  // Units of the effort's format a unit of the error, of either term.
  template <int I>
  struct StiffnessFactor {
    static constexpr double unit = slides(I) ? detail::power_of_two(-Positions<Robot, Fixed32>::exponent(I))
                                             : 2.0 * 3.14159265358979323846 / 4294967296.0;
    static constexpr double value =
        gains.stiffness[I] * unit * detail::power_of_two(EffortsOf<Scene, Fixed32>::exponent(I));
  };
  template <int I>
  struct DampingFactor {
    static constexpr double value = StiffnessFactor<I>::value * gains.damping[I] / gains.stiffness[I] * control_Hz;
  };
  template <int I>
  std::int32_t feedback(std::int32_t error, std::int32_t change) const {
    constexpr std::int32_t whole = std::numeric_limits<std::int32_t>::max();
    bool ignored = false;
    const std::int64_t ff = feeds_forward_ ? std::int64_t{sum_[I].raw} : 0;
    const std::int64_t tau = ff + detail::scaled<StiffnessFactor<I>>(error, whole, ignored) +
                             detail::scaled<DampingFactor<I>>(change, whole, ignored);
    return detail::nearest_word<std::int32_t>(tau);
  }

  std::array<std::int32_t, hal::link::max_joints> position_{};
  bool measured_ = false, ever_measured_ = false, broken_ = false;
};

}  // namespace axial::apps

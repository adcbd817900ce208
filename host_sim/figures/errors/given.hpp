// Seeded states of a robot as a kernel is given them in numbers T, and exactly what it was given.
#pragma once

#include <firmware/apps/number_systems.hpp>
#include <firmware/apps/states.hpp>
#include <host_sim/figures/errors/reference.hpp>
#include <host_sim/robots/robots/driven_robot.hpp>

#include <cmath>

namespace errors {

using host_sim::DrivesOf;

/// What the algorithms of firmware/apps/size read.
template <class R, class T>
struct Given {
  using Number = T;
  axial::Positions<R, T> q{};
  axial::Velocities<R, T> qd{};
  axial::Accelerations<R, T> qdd{};
  axial::Efforts<R, T> tau{};
  axial::Joints<R, axial::SinCos<T>> turns{};
};

/// A word of fixed point as it is: an integer times a power of two; or a number.
template <class Value>
quad exact(const Value& value, int exponent) {
  if constexpr (axial::is_stored_v<Value>)
    return quad(value.raw) * quad(std::ldexp(1.0, -exponent));
  else
    return quad(value);
}
template <class Values>
quad exact_of(const Values& values, int i) {
  if constexpr (axial::is_stored_v<std::decay_t<decltype(values[i])>>)
    return exact(values[i], Values::exponent(i));
  else
    return exact(values[i], 0);
}
template <class R, class Values>
quad exact_position(const Values& values, int i) {
  if constexpr (axial::is_stored_v<std::decay_t<decltype(values[i])>>)
    if (DrivesOf<R>::chain.links[i].type == axial::JointType::revolute)
      return quad(values[i].raw) * oracle::right_angle<quad>() / quad(0x1p30);
  return exact_of(values, i);
}

/// Speeds, accelerations and slides are drawn from what 16 bits hold, so every number system is given the same ones; an
/// angle is a float, in fixed point the nearest 32-bit angle. Efforts are those of the drawn accelerations, in 24 bits
/// of the 16-bit format's range; 16 bits round them once more.
template <class R>
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : random_(seed) {}

  Given<R, double> next() {
    using namespace axial;
    auto m = apps::next_state<R, float>(random_);
    auto qd = apps::nearest<Velocities<R, Fixed16>>(m.qd);
    auto qdd = apps::nearest<Accelerations<R, Fixed16>>(m.qdd);
    auto slides = apps::nearest_positions<R, Fixed32>(m.q);
    if constexpr (detail::shares_drives_in<DrivesOf<R>>) hold_joints(slides, qd, qdd);
    Given<R, double> given;
    for (int i = 0; i < joint_count<R>; ++i) {
      slides[i].raw &= ~0xffff;
      const bool turns = DrivesOf<R>::chain.links[i].type == JointType::revolute;
      given.q[i] = turns ? static_cast<double>(m.q[i]) : static_cast<double>(exact_of(slides, i));
      given.qd[i] = static_cast<double>(exact_of(qd, i)), given.qdd[i] = static_cast<double>(exact_of(qdd, i));
    }
    add_efforts(given);
    return given;
  }

 private:
  /// Joints that share drives stay inside limits of their own: rates are scaled back, slides by the drive that moves
  /// them.
  template <class Positions, class Speeds, class Accelerations>
  static void hold_joints(Positions& u, Speeds& ud, Accelerations& udd) {
    constexpr const auto& g = axial::detail::drive_matrix<R>;
    const auto at = [&](const auto& words, int i) {
      double sum = 0.0;
      for (int k = 0; k < g.drives; ++k)
        sum += g.ratio[i][k] * static_cast<double>(exact_of(words, k));
      return sum;
    };
    double speed = 1.0, acceleration = 1.0;
    for (int i = 0; i < R::chain.size; ++i) {
      const auto& limit = R::chain.links[i];
      speed = std::fmin(speed, limit.speed_limit / std::fabs(at(ud, i)));
      acceleration = std::fmin(acceleration, limit.acceleration_limit / std::fabs(at(udd, i)));
      if (limit.type == axial::JointType::revolute) continue;
      const int k = g.mover_of(i);
      const double q = at(u, i) + g.offset[i], to = std::fmin(limit.position_max, std::fmax(limit.position_min, q));
      u[k].raw += static_cast<std::int32_t>(std::ldexp((to - q) / g.ratio[i][k], u.exponent(k)));
    }
    for (int k = 0; k < g.drives; ++k) {
      ud[k].raw = static_cast<std::int16_t>(ud[k].raw * speed);
      udd[k].raw = static_cast<std::int16_t>(udd[k].raw * acceleration);
    }
  }
  void add_efforts(Given<R, double>& given) const {
    Vector q, qd, qdd;
    for (int i = 0; i < axial::joint_count<R>; ++i)
      q.push_back(given.q[i]), qd.push_back(given.qd[i]), qdd.push_back(given.qdd[i]);
    const Vector tau = robot_.inverse_dynamics(q, qd, qdd);
    for (int i = 0; i < axial::joint_count<R>; ++i) {
      const int finest = axial::EffortsOf<axial::scene_of<R>, axial::Fixed16>::exponent(i) + 8;
      given.tau[i] = std::ldexp(std::round(std::ldexp(static_cast<double>(tau[std::size_t(i)]), finest)), -finest);
    }
  }

  axial::apps::Random random_;
  oracle::DrivenChain<quad> robot_ = host_sim::driven_robot<quad, R>();
};

/// The same state in numbers T.
template <class R, class T>
Given<R, T> in_numbers(const Given<R, double>& state) {
  using namespace axial;
  Given<R, T> given;
  given.q = apps::nearest_positions<R, T>(state.q);
  given.qd = apps::nearest<Velocities<R, T>>(state.qd);
  given.qdd = apps::nearest<Accelerations<R, T>>(state.qdd);
  const auto tau = apps::nearest<EffortsOf<scene_of<R>, T>>(state.tau);
  for (int i = 0; i < axial::joint_count<R>; ++i)
    given.tau[i] = tau[i];
  if constexpr (is_number_v<T>)
    for (int i = 0; i < axial::joint_count<R>; ++i)
      given.turns[i] = {static_cast<T>(oracle::sin(quad(given.q[i]))), static_cast<T>(oracle::cos(quad(given.q[i])))};
  return given;
}

template <class R, class T>
Inputs exactly(const Given<R, T>& given) {
  axial::EffortsOf<axial::scene_of<R>, T> tau;
  Inputs in;
  for (int i = 0; i < axial::joint_count<R>; ++i) {
    tau[i] = given.tau[i];
    in.q.push_back(exact_position<R>(given.q, i));
    in.qd.push_back(exact_of(given.qd, i)), in.qdd.push_back(exact_of(given.qdd, i)),
        in.tau.push_back(exact_of(tau, i));
  }
  return in;
}

inline constexpr int states = 2000;
inline constexpr std::uint32_t seed = 0x20160401;

/// The states of robot R and their exact results, made once for all kernels in numbers of the same words.
template <class R, class Words>
class States {
 public:
  static States& all() {
    static States the;
    return the;
  }
  const std::vector<Given<R, double>>& drawn() const { return drawn_; }
  Reference& reference() { return reference_; }
  /// True where the drives can exert the efforts: fixed point rescales others, and says so.
  bool declared(std::size_t state) const {
    for (int i = 0; i < axial::joint_count<R>; ++i)
      if (std::fabs(drawn_[state].tau[i]) > 0.99 * DrivesOf<R>::chain.links[i].effort_limit) return false;
    return true;
  }

 private:
  States() {
    Draw<R> draw(seed);
    std::vector<Inputs> inputs;
    for (int k = 0; k < states; ++k) {
      drawn_.push_back(draw.next());
      inputs.push_back(exactly<R, Words>(in_numbers<R, Words>(drawn_.back())));
    }
    reference_ = Reference(host_sim::driven_robot<quad, R>(), std::move(inputs), compliance());
  }
  static Vector compliance() {
    Vector all;
    for (const auto& link : R::chain.links)
      all.push_back(link.stiffness < axial::LinkParameters::unlimited ? quad(1) / quad(link.stiffness) : quad(0));
    return all;
  }
  std::vector<Given<R, double>> drawn_;
  Reference reference_{{}, {}};
};

/// float and double are given the same.
template <class T>
using WordsOf = std::conditional_t<axial::is_stored_v<T>, T, float>;

}  // namespace errors

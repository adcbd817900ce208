// One combination: a state and inputs for it in its own numbers, and the same situation for the reference.
#pragma once

#include <axial/axial.hpp>
#include <axial/control/payload_estimator.hpp>
#include <axial/cost.hpp>
#include <axial/fixed.hpp>
#include <axial/simulation/step_limit.hpp>

#include <cmath>
#include <cstdio>

#include "reference.hpp"

namespace combinations {

template <class T>
inline constexpr bool is_fixed = axial::is_stored_v<T>;

/// A word of fixed point that is nearest to x, and what it is worth.
template <class Word>
void give(axial::Stored<Word>& to, double x, int exponent) {
  to.raw = static_cast<Word>(std::lround(std::ldexp(x, exponent)));
}
template <class T>
void give(T& to, double x, int) {
  to = static_cast<T>(x);
}
template <class Word>
double worth(const axial::Stored<Word>& x, int exponent) {
  return std::ldexp(static_cast<double>(x.raw), -exponent);
}
template <class T>
double worth(const T& x, int) {
  return static_cast<double>(x);
}
template <class T>
void give(axial::Vec3<T>& to, const axial::Vec3<double>& x, int exponent) {
  give(to.x, x.x, exponent), give(to.y, x.y, exponent), give(to.z, x.z, exponent);
}
template <class T>
axial::Vec3<double> worth(const axial::Vec3<T>& x, int exponent) {
  return {worth(x.x, exponent), worth(x.y, exponent), worth(x.z, exponent)};
}

/// Joint values as real numbers.
template <class Robot, class T>
axial::Joints<Robot, double> real(const axial::Joints<Robot, T, void>& x) {
  axial::Joints<Robot, double> all{};
  for (int i = 0; i < all.size; ++i)
    all[i] = static_cast<double>(x[i]);
  return all;
}
template <class S, class Word, class Role>
auto real(const axial::Joints<S, axial::Stored<Word>, Role>& x) {
  return axial::to_real<double>(x);
}
template <class Values, class Robot>
Values in_numbers(const axial::Joints<Robot, double>& x) {
  if constexpr (is_fixed<std::decay_t<decltype(std::declval<Values>().values[0])>>) {
    return axial::to_fixed<Values>(x).values;
  } else {
    Values all{};
    for (int i = 0; i < all.size; ++i)
      give(all[i], x[i], 0);
    return all;
  }
}

/// C gives: `number`, `Robot` (a type with a chain), `Subject` (a Robot, a Scene or a Model), `Number`.
template <class C>
class At {
 public:
  using S = typename C::Subject;
  using T = typename C::Number;
  using Scene = axial::scene_of<S>;
  using Owner = axial::robot_of<S>;  // whose joint values there are: the robot, or the model
  static constexpr int joints = C::Robot::chain.size;
  static constexpr bool is_model = axial::IsModel<S>::value;
  template <class Tag>
  static constexpr bool has = Scene::template has<Tag>;

  axial::Positions<Owner, T> q{};
  axial::Velocities<Owner, T> qd{};
  axial::Accelerations<Owner, T> qdd{};
  axial::Inputs<S, T> in{};
  S model{};       // of a run-time model: the robot in it
  Situation same;  // for the reference
  Numbers wanted;  // its efforts

  At() {
    describe();
    if constexpr (!(is_model && is_fixed<T>)) {  // refused
      move();
      load();
    }
    wanted = efforts(same);
  }

  /// q with the sine-cosine pairs that belong to it.
  axial::Inputs<S, T> inputs_at(const axial::Positions<Owner, T>& position) const {
    auto inputs = in;
    if constexpr (has<axial::SineCosines>) inputs.turns = sine_cosines(position);
    (void)position;
    return inputs;
  }
  axial::Joints<Owner, axial::SinCos<T>> sine_cosines(const axial::Positions<Owner, T>& position) const {
    if constexpr (is_model)
      return axial::sine_cosines(model, position);
    else
      return axial::sine_cosines<S>(position);
  }

  /// Largest of n wanted values, not less than 1: what rounding errors are relative to.
  static double scale(const Numbers& x) {
    double most = 1.0;
    for (const double value : x.of)
      most = std::fmax(most, std::fabs(value));
    return most;
  }
  /// Tolerance of a floating-point result of `roundings` roundings one after the other.
  static double tolerance(double roundings, double size) {
    if constexpr (is_fixed<T>)
      return 0.0;
    else
      return roundings * static_cast<double>(std::numeric_limits<T>::epsilon()) * size;
  }
  /// Says so where `got` is not within `most` of `want`.
  void expect(const char* what, int index, double got, double want, double most) {
    if (std::fabs(got - want) <= most) return;
    std::printf("%s %d: %.17g, not %.17g (at most %.3g apart)\n", what, index, got, want, most);
    ++failures;
  }
  void expect(const char* what, bool holds) { expect(what, 0, holds ? 1.0 : 0.0, 1.0, 0.0); }
  int failures = 0;

 private:
  void describe() {
    constexpr const auto& chain = C::Robot::chain;
    same.joints = joints;
    for (int i = 0; i < joints; ++i)
      same.links[i] = seen(chain.links[i]);
    same.base = chain.base.pose, same.tool = chain.tool.pose;
    if constexpr (has<axial::Gravity>) same.gravity = {chain.gravity.x, chain.gravity.y, chain.gravity.z};
    if constexpr (is_model) {
      for (const auto& link : chain.links)
        expect("the model takes the link", model.add(link));
      model.set_gravity(chain.gravity.x, chain.gravity.y, chain.gravity.z);
      model.set_base(chain.base.pose), model.set_tool(chain.tool.pose);
      model.set_base_body(chain.base_body);
    }
  }
  /// A link as the scene sees it.
  static axial::LinkParameters seen(axial::LinkParameters link) {
    if (!has<axial::RotorInertia>) link.rotor_inertia = 0.0;
    if (!has<axial::JointSprings>) link.spring_stiffness = 0.0;
    if (!has<axial::Underwater>) link.water = {};
    if (!has<axial::Friction>) link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
    return link;
  }
  void move() {
    constexpr double positions[] = {0.3125, -0.4375, 0.25, 0.375}, speeds[] = {0.75, -1.0, 0.5, 0.625},
                     rates[] = {1.5, -2.0, 1.0, -0.5};
    axial::Joints<Owner, double> x{}, v{}, a{};
    for (int i = 0; i < joints; ++i)
      x[i] = positions[i], v[i] = speeds[i], a[i] = rates[i];
    q = in_numbers<decltype(q)>(x), qd = in_numbers<decltype(qd)>(v), qdd = in_numbers<decltype(qdd)>(a);
    x = real(q), v = real(qd), a = real(qdd);
    for (int i = 0; i < joints; ++i)
      same.q[i] = x[i], same.qd[i] = v[i], same.qdd[i] = a[i];
  }
  void load() {
    if constexpr (has<axial::RuntimeGravity>)
      give_both(in.gravity, same.gravity, {1.0, -2.0, -9.0}, gravity_exponent());
    if constexpr (has<axial::BaseMotion> || has<axial::FloatingBase>) {
      give_both(in.base_motion.angular_velocity, same.base_motion.angular_velocity, {0.5, -0.25, 0.75}, 0);
      give_both(in.base_motion.angular_acceleration, same.base_motion.angular_acceleration, {-1.0, 0.5, 2.0}, 0);
      give_both(in.base_motion.linear_acceleration, same.base_motion.linear_acceleration, {2.0, -1.0, 0.5}, 0);
    }
    if constexpr (has<axial::VelocityThroughWater>)
      give_both(in.velocity_through_water, same.through_water, {0.25, 0.5, -0.375}, 0);
    if constexpr (has<axial::TipWrench>) {
      auto& tip = same.wrenches[joints - 1];
      give_both(in.tip_wrench.moment, tip.moment, {0.5, -0.25, 0.75}, moment_exponent());
      give_both(in.tip_wrench.force, tip.force, {3.0, -2.0, 4.0}, force_exponent());
    }
    if constexpr (has<axial::ExternalWrenches>)
      for (int i = 0; i < joints; ++i) {
        const double k = i;
        give(in.wrenches[i].moment, {0.5 * k, -1.0, 0.25}, 0), give(in.wrenches[i].force, {2.0, k, -1.5}, 0);
        auto& all = same.wrenches[i];
        all.moment = all.moment + axial::Vec3<double>{0.5 * k, -1.0, 0.25};
        all.force = all.force + axial::Vec3<double>{2.0, k, -1.5};
      }
    if constexpr (has<axial::BaseWrench>) give(in.base_wrench.force, {5.0, -3.0, 20.0}, 0);
    if constexpr (has<axial::Payload>) carry();
    if constexpr (has<axial::SineCosines>) in.turns = sine_cosines(q);
  }
  void carry() {
    const auto e = payload_exponents();
    auto& load = in.payload;
    auto& all = same.payload;
    give(load.mass, 0.5, e.mass), all.mass = worth(load.mass, e.mass);
    give_both(load.com, all.com, {0.03125, -0.0625, 0.015625}, e.com);
    give(load.inertia_com.xx, 0.005, e.inertia), all.inertia_com.xx = worth(load.inertia_com.xx, e.inertia);
    give(load.inertia_com.yy, 0.004, e.inertia), all.inertia_com.yy = worth(load.inertia_com.yy, e.inertia);
    give(load.inertia_com.zz, 0.006, e.inertia), all.inertia_com.zz = worth(load.inertia_com.zz, e.inertia);
  }
  template <class V>
  static void give_both(V& to, axial::Vec3<double>& also, const axial::Vec3<double>& x, int exponent) {
    give(to, x, exponent);
    also = worth(to, exponent);
  }
  struct PayloadExponents {
    int mass = 0, com = 0, inertia = 0;
  };
  static constexpr PayloadExponents payload_exponents() {
    if constexpr (is_fixed<T>) {
      using F = axial::InputFormats<Owner, T>;
      return {F::payload_mass, F::payload_com, F::payload_inertia};
    } else {
      return {};
    }
  }
  static constexpr int gravity_exponent() {
    if constexpr (is_fixed<T>)
      return axial::InputFormats<Owner, T>::gravity;
    else
      return 0;
  }
  static constexpr int force_exponent() {
    if constexpr (is_fixed<T>)
      return axial::InputFormats<Owner, T>::tip_force;
    else
      return 0;
  }
  static constexpr int moment_exponent() {
    if constexpr (is_fixed<T>)
      return axial::InputFormats<Owner, T>::tip_moment;
    else
      return 0;
  }
};

/// Runs one algorithm of a combination and says its name where something is wrong.
template <class Algorithm, class C>
void run(At<C>& at, const char* name) {
  const int before = at.failures;
  Algorithm::run(at);
  if (at.failures != before) std::printf("failed: %s\n", name);
}

}  // namespace combinations

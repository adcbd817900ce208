// The quantities that ranges bound, in double, and how near a search brings them to their bounds.
#pragma once

#include <host_sim/figures/exhaustive/fixed_errors.hpp>

namespace exhaustive {

/// Norms of one link's quantities in inverse dynamics.
struct Norms {
  double angular_velocity, angular_acceleration, linear_acceleration, force, moment, effort;
};

template <class X>
double number(const X& x) {
  if constexpr (std::is_arithmetic_v<X>)
    return static_cast<double>(x);
  else
    return static_cast<double>(X::value);
}
template <class X, class Y, class Z>
double norm(const axial::Vec3<X, Y, Z>& v) {
  const double x = number(v.x), y = number(v.y), z = number(v.z);
  return std::sqrt(x * x + y * y + z * z);
}

/// The recursion of dynamics/inverse_dynamics.hpp in double, its intermediate quantities kept.
template <class R>
std::array<Norms, R::chain.size> norms_at(const FixedState<R, axial::Fixed32>& fixed) {
  using namespace axial;
  const auto s = exact_state(fixed);
  const auto links = links_of<R, double, BaseParameters>();
  const Inputs<R, double> in{};
  std::array<Norms, R::chain.size> all{};
  const auto at = links.read(s.q);
  const auto screws = joint_screws(links, in, at);
  const auto qd = links.read(s.qd), qdd = links.read(s.qdd);
  const auto motions = rnea::link_motions(links, in, screws, qd, qdd);
  const auto water = immersions(links, in, screws, qd);
  const auto own = [&](auto i) { return rnea::own_force(links, in, motions, water, i); };
  inward(links, own, [&](auto i, const auto& force) {
    Norms& link = all[static_cast<std::size_t>(static_cast<int>(i))];
    const auto& m = motions[i];
    link.angular_velocity = norm(m.w), link.angular_acceleration = norm(m.dw), link.linear_acceleration = norm(m.a);
    link.force = norm(force.force), link.moment = norm(force.moment);
    link.effort = std::fabs(number(rnea::joint_effort(links, i, force, at, qd, qdd)));
    return rnea::InwardResult{rnea::force_on_parent(links, screws, i, force)};
  });
  return all;
}

/// A quantity by name, its value and its bound.
struct Bounded {
  const char* name;
  double Norms::*norm;
  axial::Ball axial::LinkRange::*ball;
};
inline constexpr Bounded bounded[] = {
    {"angular velocity", &Norms::angular_velocity, &axial::LinkRange::angular_velocity},
    {"angular acceleration", &Norms::angular_acceleration, &axial::LinkRange::angular_acceleration},
    {"linear acceleration", &Norms::linear_acceleration, &axial::LinkRange::linear_acceleration},
    {"force", &Norms::force, &axial::LinkRange::force},
    {"moment", &Norms::moment, &axial::LinkRange::moment},
    {"effort", &Norms::effort, &axial::LinkRange::joint_effort}};

/// How near to its bound a search brings a quantity of link i; 0 where the bound is 0.
template <class R>
double nearness(const Bounded& quantity, int i, int steps, std::uint64_t seed) {
  using namespace axial;
  using Arithmetic = detail::ArithmeticOf<scene_of<R>, std::int32_t>;
  constexpr const auto& ranges = detail::ranges_of<scene_of<R>, detail::with_rotors<scene_of<R>, BaseParameters>,
                                                   Arithmetic, recursion::NewtonEuler>;
  const double bound = (ranges.range[i].*quantity.ball).size;
  return climb<FixedState<R, Fixed32>>(seed, steps, 3 * R::chain.size, [&](const FixedState<R, Fixed32>& state) {
    const double found = norms_at<R>(state)[static_cast<std::size_t>(i)].*quantity.norm;
    return bound > 0.0 ? found / bound : found;
  });
}

}  // namespace exhaustive

// Hostile states: how many, and where their numbers come from.
#pragma once

#include <host_sim/figures/exhaustive/fixed_states.hpp>

#include <cmath>
#include <cstdlib>
#include <string>

namespace property {

/// States of a run: AXIAL_HOSTILE_STATES, which all the tests of these programs share, or `few`, which take a second.
inline std::uint64_t hostile_states(std::uint64_t few, std::uint64_t tests) {
  const char* wanted = std::getenv("AXIAL_HOSTILE_STATES");
  return wanted == nullptr ? few : std::strtoull(wanted, nullptr, 10) / tests;
}
inline constexpr std::uint64_t hostile_seed = 18;

/// Numbers that no sensor gives: NaN, infinite, denormal, any bits, powers of ten; some are harmless.
template <class T>
T hostile_number(exhaustive::Random& random) {
  using Limits = std::numeric_limits<T>;
  constexpr T ends[] = {Limits::quiet_NaN(),
                        Limits::infinity(),
                        -Limits::infinity(),
                        Limits::denorm_min(),
                        -Limits::denorm_min(),
                        Limits::max(),
                        Limits::lowest(),
                        Limits::min(),
                        T(0.0),
                        T(-0.0),
                        T(512.0),
                        T(-512.0)};
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  const std::int64_t kind = random.between(0, 3);
  if (kind == 0) return ends[random.between(0, 11)];
  if (kind == 1) return __builtin_bit_cast(T, static_cast<Bits>(random.bits()));
  const T fraction = static_cast<T>(static_cast<double>(random.between(-1000000, 1000000)) * 1e-6);
  return kind == 2 ? fraction * static_cast<T>(std::pow(10.0, static_cast<double>(random.between(-38, 38))))
                   : fraction * T(8.0);
}

/// A tree of four joints with a slide on each of its branches, one of them on the base's turn and one beyond an elbow.
struct SlidingTree {
  static constexpr const char* name = "sliding_tree";
  // clang-format off
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81), axial::payload_limit(1.0, 0.1, 0.01), axial::tip_wrench_limit(20.0, 5.0),
      axial::revolute().d(0.3)
          .mass(6.0).com(0.02, 0.01, -0.1).inertia_com(0.08, 0.07, 0.05, 0.002, 0.0, -0.001).rotor_inertia(2e-5, 100.0)
          .viscous(1.0).coulomb(0.5)
          .position_limits(-2.0, 2.5).speed_limit(3.0).acceleration_limit(15.0).effort_limit(90.0),
      axial::prismatic().parent(0).a(0.2).alpha_deg(90)
          .mass(2.0).com(0.01, 0.0, 0.05).inertia_com(0.006, 0.006, 0.002)
          .position_limits(0.05, 0.4).speed_limit(0.8).acceleration_limit(8.0).effort_limit(60.0),
      axial::revolute().parent(0).branch_deg(120.0, 0.1).a(0.25).alpha_deg(-90).theta_deg(90)
          .mass(2.5).com(0.1, 0.0, 0.02).inertia_com(0.004, 0.02, 0.018).rotor_inertia(1e-5, 80.0)
          .position_limits(-1.5, 1.5).speed_limit(4.0).acceleration_limit(25.0).effort_limit(30.0),
      axial::prismatic().a(0.15).alpha(0.4)
          .mass(1.2).com(0.0, 0.02, 0.03).inertia_com(0.003, 0.0025, 0.001)
          .position_limits(-0.1, 0.2).speed_limit(1.0).acceleration_limit(10.0).effort_limit(40.0),
      axial::tool(0.0, 0.0, 0.1));
  // clang-format on
};

/// What was answered wrongly: how often, and the first case in words.
struct Wrong {
  std::uint64_t count = 0;
  std::string first;
  void note(bool right, const char* what, std::uint64_t state, double is, double should) {
    if (right) return;
    if (count++ == 0)
      first = std::string(what) + " in state " + std::to_string(state) + ": " + std::to_string(is) + " instead of " +
              std::to_string(should);
  }
};

}  // namespace property

// A robot that nobody tuned for, in words and in double precision.
#pragma once

#include <gtest/gtest.h>
#include <cmath>
#include <cstdlib>
#include <host_sim/figures/exhaustive/fixed_search.hpp>

#include "untuned_robots.hpp"

namespace property {

/// States of each robot: AXIAL_UNTUNED_STATES asks for more.
inline std::uint64_t untuned_states() {
  const char* asked = std::getenv("AXIAL_UNTUNED_STATES");
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : 2000;
}

/// Its states in words, and what they stand for, of a model that knows nothing of fixed point.
template <class R, class... Features>
class UntunedReference {
 public:
  using T = axial::Fixed32;
  using Model = axial::Model<8>;
  using Values = axial::Joints<Model, double>;
  /// Counts overflows.
  using Checked = axial::Scene<R, axial::Gravity, axial::RotorInertia, axial::RangeCheck, Features...>;
  using State = exhaustive::FixedState<Checked, T>;
  static constexpr int joints = R::chain.size;

  UntunedReference() {
    for (const auto& link : R::chain.links)
      EXPECT_TRUE(model_.add(link));
    model_.set_gravity(R::chain.gravity.x, R::chain.gravity.y, R::chain.gravity.z);
  }
  const Model& model() const { return model_; }

  /// Brings angles, anywhere on their circle, inside the limits.
  static void hold_positions(State& state) {
    for (int i = 0; i < joints; ++i)
      if (State::turns(i)) {
        const auto& link = R::chain.links[i];
        const double share = state.q[i].raw * 0x1p-32 + 0.5;
        const double angle = link.position_min + (link.position_max - link.position_min) * share;
        state.q[i].raw = static_cast<std::int32_t>(angle * 0.9999999 * axial::detail::bam_per_radian);
      }
  }
  template <class From>
  static Values values(const From& from, bool positions = false) {
    Values to{};
    for (int i = 0; i < joints; ++i)
      to[i] = positions && State::turns(i) ? from[i].raw / axial::detail::bam_per_radian : real(from, i);
    return to;
  }
  template <class From>
  static double real(const From& from, int i) {
    return from[i].raw * axial::detail::power_of_two(-from.exponent(i));
  }

 private:
  Model model_;
};

}  // namespace property

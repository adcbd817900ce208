// What a run-time payload and a wrench at the tip are in bounds, from the limits that a robot declares.
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace axial;

// Grams to tons, millimetres to metres: mass, reach and inertia are what was declared, and their words hold them.
TEST(Loads, AreAsLargeAsDeclared) {
  constexpr WordRounding r{32, true, false, 0.0};
  for (const double mass : {1e-3, 0.4, 1.0, 2.5, 800.0})
    for (const double reach : {1e-3, 0.2, 1.0, 3.0})
      for (const double inertia : {1e-7, 0.02, 5.0}) {
        LoadRange range;
        range.payload_mass = mass, range.payload_moment = mass * reach;
        range.payload_inertia = 3.0 * inertia + mass * reach * reach;
        range.tip_moment = reach, range.tip_force = mass;
        const bounds::GivenLoads loads = bounds::detail::given_loads(range, r);
        EXPECT_EQ(loads.payload.mass.bound.size, mass);
        EXPECT_NEAR(loads.payload.com_reach, reach, 1e-12 * reach);
        EXPECT_NEAR(loads.payload.inertia, inertia, 1e-12 * range.payload_inertia);
        EXPECT_EQ(loads.tip_wrench.moment.bound.whole.size, reach);
        EXPECT_EQ(loads.tip_wrench.force.bound.whole.size, mass);
        const auto is_held = [&](double size, int exponent) {
          return std::ldexp(size, exponent) <= r.capacity() && std::ldexp(size, exponent + 1) > r.capacity();
        };
        EXPECT_TRUE(is_held(mass, loads.payload.mass.exponent)) << mass;
        EXPECT_TRUE(is_held(loads.payload.com_reach, loads.payload.com_exponent)) << reach;
        EXPECT_TRUE(is_held(loads.payload.inertia, loads.payload.inertia_exponent)) << inertia;
        EXPECT_TRUE(is_held(reach, loads.tip_wrench.moment.exponent)) << reach;
        EXPECT_TRUE(is_held(mass, loads.tip_wrench.force.exponent)) << mass;
      }
}

// Without a payload there is no centre of mass to be anywhere.
TEST(Loads, OfNothingReachNowhere) {
  const bounds::GivenLoads none = bounds::detail::given_loads({}, WordRounding{32, true, false, 0.0});
  EXPECT_EQ(none.payload.com_reach, 0.0);
  EXPECT_EQ(none.payload.mass.bound.size, 0.0);
}

}  // namespace

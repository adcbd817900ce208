// Massless links with rotors, and geared arms.
#include "untuned.hpp"

namespace property {

// 6 rad/s^2 of its first joint take 500 units of an effort that may reach 1.2e7 N m.
template <>
inline constexpr bool certifiable<Drawn<4, 7, 4>> = false;

namespace {

using Robots = testing::Types<Drawn<4, 7, 4>, Drawn<5, 2, 1>, Drawn<5, 3, 2>, Drawn<5, 4, 3>, Drawn<5, 6, 4>,
                              Drawn<5, 7, 5>, Drawn<6, 4, 1>, Drawn<6, 6, 2>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Rotors, UntunedRobot, Robots);

}  // namespace
}  // namespace property

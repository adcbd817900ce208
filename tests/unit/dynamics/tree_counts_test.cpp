// What a branch costs in every algorithm: a tree of generic links with a branch, less the same tree without it.
#include <gtest/gtest.h>

#include <axial/cost.hpp>
#include <cstdio>
#include <ostream>

#include "generic_robots.hpp"

using namespace axial;

namespace axial {
static void PrintTo(const Operations& o, std::ostream* out) {
  *out << o.mul << "M " << o.add << "A " << o.div << "D " << o.sincos << "T";
}
}  // namespace axial

namespace {

/// Links 0 to 2 in a row, 3 to 5 another row on link 1; link 3 leaves it by (GammaDeg, b). Nothing else is 0 or 1.
template <int GammaDeg, bool Shifted>
struct Tree {
  static constexpr auto tree() {
    auto c = generic::chain<6>(37.0, false);
    for (int i = 0; i < 6; ++i)  // a twist that occurs twice would be computed once for both branches
      c.links[i].alpha = Angle::from_degrees(i == 0 ? 0.0 : 33.0 + 4.0 * i);
    c.links[3].parent = 1;
    c.links[3].gamma = Angle::from_degrees(GammaDeg);
    c.links[3].b = Shifted ? 0.29 : 0.0;
    return c;
  }
  static constexpr auto chain = tree();
};
using Without = Tree<0, false>;
using General = Tree<53, true>;
using QuarterTurn = Tree<90, true>;
using ShiftAlone = Tree<0, true>;

template <class R>
using Articulated = Scene<R, Gravity, RotorInertia, ArticulatedBody>;
template <class R>
using Composite = Scene<R, Gravity, RotorInertia, CompositeBody>;

template <class With, class Base, class Algorithm>
Operations extra(const char* name, Algorithm algorithm) {
  constexpr auto with = cost<With>(Algorithm{}), without = cost<Base>(Algorithm{});
  static_cast<void>(algorithm);
  const Operations more{with.mul - without.mul, with.add - without.add, with.div - without.div,
                        with.sincos - without.sincos};
  std::printf("%-28s a branch adds %dM %dA\n", name, more.mul, more.add);
  return more;
}
}  // namespace

// The inertia's constant z-screw takes 38M 40A, the force's and the acceleration's 10M 6A each, the angular velocity's
// 4M 2A, the acceleration of the branch's foot 10M 8A. McMillan and Orin 1995 give 32M 37A for the inertia, which holds
// for one with a zero row (tests/unit/spatial): joint and branch together stay below their 102M 108A.
TEST(BranchCounts, OfTheArticulatedBodyAlgorithm) {
  EXPECT_EQ((extra<Articulated<General>, Articulated<Without>>("articulated body", algorithm::forward_dynamics)),
            (Operations{38 + 10 + 10 + 4 + 10, 40 + 6 + 6 + 2 + 8, 0, 0}));
}
TEST(BranchCounts, OfTheOtherAlgorithms) {
  EXPECT_EQ((extra<General, Without>("inverse dynamics", algorithm::inverse_dynamics)), (Operations{28, 18, 0, 0}));
  EXPECT_EQ((extra<General, Without>("gravity", algorithm::gravity)), (Operations{8, 4, 0, 0}));
  EXPECT_EQ((extra<General, Without>("mass matrix", algorithm::mass_matrix)), (Operations{45, 32, 0, 0}));
  EXPECT_EQ((extra<Composite<General>, Composite<Without>>("composite body", algorithm::forward_dynamics)),
            (Operations{73, 50, 0, 0}));
  EXPECT_EQ((extra<General, Without>("forward kinematics", algorithm::forward_kinematics)), (Operations{14, 9, 0, 0}));
}
// A turn by a right angle is an exchange of signs; what is left is the shift.
TEST(BranchCounts, OfAQuarterTurnAreThoseOfItsShift) {
  const Operations shift{17, 21, 0, 0};
  EXPECT_EQ(
      (extra<Articulated<QuarterTurn>, Articulated<Without>>("articulated body, 90 deg", algorithm::forward_dynamics)),
      shift);
  EXPECT_EQ(
      (extra<Articulated<ShiftAlone>, Articulated<Without>>("articulated body, b alone", algorithm::forward_dynamics)),
      shift);
}

// When a joint's inertia is lost, and when the compiler knows that it cannot be.
#include <gtest/gtest.h>
#include <axial/dynamics/composite_body.hpp>
#include <axial/links/model.hpp>
#include <axial/recursion/resistance.hpp>
#include <axial/robot/chain.hpp>
#include <limits>

using namespace axial;

namespace {

template <class T>
class ResistanceOf : public testing::Test {
 public:
  static constexpr T eps = std::numeric_limits<T>::epsilon();
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(ResistanceOf, Reals);

struct Rods {  // a rod of 1 m on a rod of 1 m, moving in a plane
  static constexpr auto chain = axial::chain(revolute().mass(3).com(0.5, 0, 0).inertia_com(0, 0.25, 0.25),
                                             revolute().a(1).mass(3).com(0.5, 0, 0).inertia_com(0, 0.25, 0.25));
};
struct Rotored {
  static constexpr auto chain = axial::chain(revolute().rotor_inertia(0.5, 2), prismatic().a(1).mass(2));
};
struct Hollow {  // the first link is massless
  static constexpr auto chain = axial::chain(revolute(), revolute().mass(1).inertia_com(1, 1, 1));
};
struct Impossible {  // determinant below 0, though every minor is positive
  static constexpr auto chain =
      axial::chain(revolute().mass(1).inertia_com(1, 1, 1, 0.9, 0.9, -0.9).accept(as_published));
};
struct Swinging {  // the slide moves its mass away from the first axis
  static constexpr auto chain =
      axial::chain(revolute().mass(1).inertia_com(1, 1, 1), prismatic().alpha_deg(90).mass(1).inertia_com(1, 1, 1));
};

template <class R, class... Features>
constexpr auto shares = detail::own_shares_of<Scene<R, Features...>>;

}  // namespace

TYPED_TEST(ResistanceOf, BelowSixteenEpsilonsAJointIsNearSingularAndStillSolved) {
  using T = TypeParam;
  for (const T scale : {T(1), T(8), T(0.125)}) {
    const auto sound = resistance(T(17) * this->eps * scale, scale),
               lost = resistance(T(15) * this->eps * scale, scale);
    EXPECT_FALSE(sound.singular);
    EXPECT_TRUE(lost.singular);
    EXPECT_TRUE(lost.left);
    EXPECT_NEAR(lost.inverse * T(15) * this->eps * scale, T(1), T(4) * this->eps);
  }
}

TYPED_TEST(ResistanceOf, WhereNothingIsLeftTheJointIsHeld) {
  using T = TypeParam;
  for (const T d : {T(0), T(-1), T(0.5) * this->eps * this->eps, std::numeric_limits<T>::quiet_NaN()}) {
    const auto nothing = resistance(d, T(1));
    EXPECT_TRUE(nothing.singular) << d;
    EXPECT_FALSE(nothing.left) << d;
    EXPECT_EQ(nothing.inverse, T(0)) << d;
  }
  EXPECT_TRUE(resistance(T(2) * this->eps * this->eps, T(1)).left);
}

TEST(Resistance, ByTypeIsKnown) {
  static_assert(!decltype(resistance(One{}, 1.0).singular)::value && decltype(resistance(One{}, 1.0).left)::value);
  static_assert(decltype(resistance(Zero{}, 1.0).singular)::value && !decltype(resistance(Zero{}, 1.0).left)::value);
  SUCCEED();
}

TEST(OwnShares, AreOfTheLinksOwnInertiaInABoundOfTheCompositeOne) {
  // Polar moments are half the trace or more: 1 about the end of a rod; the inner rod carries the outer one 1 m out.
  constexpr auto rods = shares<Rods>;
  EXPECT_GT(rods.of[1], 0.0);
  EXPECT_LE(rods.of[1], 1.0);
  EXPECT_GT(rods.of[0], 0.0);
  EXPECT_LT(rods.of[0], 1.0 / 5.0) << "of 1 + 1 + 3 + 2 * 1.5 kg m^2 about the first axis, 1 is its own";
}

TEST(OwnShares, CountRotorsWhereTheSceneNamesThem) {
  EXPECT_GT((shares<Rotored, RotorInertia>.of[0]), 0.0);
  EXPECT_EQ(shares<Rotored>.of[0], 0.0);
  EXPECT_EQ(shares<Rotored>.of[1], 1.0) << "a slide's mass is its own";
}

TEST(OwnShares, AreNoneWhereTheCompilerDoesNotKnow) {
  EXPECT_EQ(shares<Hollow>.of[0], 0.0);
  EXPECT_EQ(shares<Impossible>.of[0], 0.0);
  EXPECT_EQ(shares<Swinging>.of[0], 0.0);
  EXPECT_GT(shares<Swinging>.of[1], 0.0);
  EXPECT_EQ((shares<Rods, Payload>.of[1]), 0.0);
}

TEST(OwnShares, OfAnInertiaThatNoBodyHasAreNone) {
  LinkParameters p;
  p.mass = 1.0, p.inertia_com[0] = p.inertia_com[1] = p.inertia_com[2] = 1.0;
  EXPECT_TRUE(detail::resists_every_way(p));
  for (int k = 0; k < 6; ++k) {
    LinkParameters broken = p;
    broken.inertia_com[k] = k < 3 ? -0.1 : 1.1;
    EXPECT_FALSE(detail::resists_every_way(broken)) << k;
  }
  p.mass = -1.0;
  EXPECT_FALSE(detail::resists_every_way(p));
  EXPECT_FALSE(detail::resists_every_way(Impossible::chain.links[0]));
}

TEST(EliminationLoss, IsTheSumOfCompositeOverRemainingInertia) {
  using Code = Status::Code;
  crba::Loss<float, false> loss;
  loss.see(100.0F, 1.0F), loss.see(2.0F, 14.0F);
  EXPECT_EQ(static_cast<Code>(loss.code()), Code::ok) << "128 is the most";
  loss.see(1.0F, 0.001F);
  EXPECT_EQ(static_cast<Code>(loss.code()), Code::inaccurate);
  crba::Loss<float, true> little;
  little.see(1e9F, 1e9F);
  EXPECT_EQ(static_cast<Code>(little.code()), Code::ok) << "the compiler knows";
}

TEST(Pivot, IsLostBelowSixteenEpsilonsOfTheCompositeInertia) {
  Model<1> model;
  ASSERT_TRUE(model.add(revolute().mass(1)));
  const auto link = model.links<double>().link(0);
  const double eps = std::numeric_limits<double>::epsilon();
  const auto sound = crba::pivot(link, 34 * eps, 2.0), lost = crba::pivot(link, 30 * eps, 2.0);
  EXPECT_FALSE(sound.singular);
  EXPECT_NEAR(sound.inverse * 34 * eps, 1.0, 1e-15);
  EXPECT_TRUE(lost.singular);
  EXPECT_FALSE(lost.left) << "what is left is rounding";
  EXPECT_EQ(lost.inverse, 0.0);
}

// Derivatives of forward dynamics in 32 bits by one step for all links: inside their proved bounds, and nothing
// overflows. Links that share formats say less of the smallest: an answer with ok is right to 5e-4 there.
#include <robots/robots.hpp>

#include <property/untuned/untuned_forward_derivatives.hpp>

namespace property {

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ForwardDerivedRobots);

namespace {

/// Share of motions inside all limits that one format for all links leaves without an answer, at most.
template <class R>
constexpr double looped_refusals = 0.02;
/// Its links' scales lie a hundred apart.
template <>
constexpr double looped_refusals<Drawn<3, 4, 3>> = 0.45;

/// Times the largest error that a bound is, at most.
constexpr double looped_bounds = 100.0;

template <class R>
class LoopedForwardDerivatives : public testing::Test {};
TYPED_TEST_SUITE_P(LoopedForwardDerivatives);
TYPED_TEST_P(LoopedForwardDerivatives, StayInsideTheirProvedBounds) {
  const std::uint64_t percent = expect_forward_derivatives_inside_their_bounds<TypeParam, axial::Looped>(
      5e-4, looped_refusals<TypeParam>, looped_bounds);
  EXPECT_GT(percent, 10U) << "hardly any answer is ok";
}
REGISTER_TYPED_TEST_SUITE_P(LoopedForwardDerivatives, StayInsideTheirProvedBounds);

using Some = testing::Types<robots::Scara, robots::Puma560, robots::Panda, robots::Indy7, robots::TwoArm,
                            Drawn<6, 4, 1>, Drawn<3, 4, 3>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Some, LoopedForwardDerivatives, Some);

#ifdef AXIAL_EVERY_UNTUNED
using Others = testing::Types<robots::ScaraRrpr, robots::RoarmM2, Drawn<0, 2, 2>, Drawn<0, 5, 5>, Drawn<2, 5, 3>,
                              Drawn<3, 5, 4>, Drawn<5, 4, 3>, Drawn<5, 6, 4>, Wrist<-10>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Others, LoopedForwardDerivatives, Others);
#endif

// Its joints' inertias are from 2e-8 to 2e-2 kg m^2, which one format cannot tell apart: bounds hold, and a status says
// that they are wide.
TEST(LoopedForwardDerivativesOfExtremes, SayWhereOneFormatIsTooCoarse) {
  EXPECT_EQ((expect_forward_derivatives_inside_their_bounds<Drawn<1, 6, 4>, axial::Looped>(1e-4, 1.0, looped_bounds)),
            0U);
}

}  // namespace
}  // namespace property

// Derivatives in 32 bits by one step for all links: inside their certified errors, no farther from the unrolled ones
// than both bounds, and nothing overflows.
#include <robots/robots.hpp>

#include <property/untuned/untuned_derivatives.hpp>

namespace property {
namespace {

template <class R>
class LoopedDerivatives : public testing::Test {};
TYPED_TEST_SUITE_P(LoopedDerivatives);
TYPED_TEST_P(LoopedDerivatives, StayInsideTheirCertifiedErrors) {
  expect_derivatives_inside_their_bounds<TypeParam, axial::Looped>();
}
REGISTER_TYPED_TEST_SUITE_P(LoopedDerivatives, StayInsideTheirCertifiedErrors);

using Some = testing::Types<robots::ScaraRrpr, robots::Puma560, robots::Panda, robots::TwoArm, Drawn<2, 5, 3>,
                            Drawn<3, 5, 4>, Drawn<6, 4, 1>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Some, LoopedDerivatives, Some);

#ifdef AXIAL_EVERY_UNTUNED
using Others = testing::Types<robots::Scara, robots::RoarmM2, robots::Indy7, Drawn<0, 2, 2>, Drawn<0, 5, 5>,
                              Drawn<1, 6, 4>, Drawn<3, 4, 3>, Drawn<5, 4, 3>, Drawn<5, 6, 4>, Wrist<-10>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Others, LoopedDerivatives, Others);
#endif

}  // namespace
}  // namespace property

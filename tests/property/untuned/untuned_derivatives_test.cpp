// Derivatives in 32 bits of known arms, and of robots that nobody tuned for.
#include <robots/robots.hpp>

#include "untuned_derivatives.hpp"

namespace property {
namespace {

template <class R>
class DerivedRobots : public testing::Test {};
TYPED_TEST_SUITE_P(DerivedRobots);
TYPED_TEST_P(DerivedRobots, StayInsideTheirCertifiedErrors) { expect_derivatives_inside_their_bounds<TypeParam>(); }
REGISTER_TYPED_TEST_SUITE_P(DerivedRobots, StayInsideTheirCertifiedErrors);

using Some = testing::Types<robots::Scara, robots::ScaraRrpr, robots::Puma560, robots::Panda, robots::RoarmM2,
                            Drawn<2, 5, 3>, Drawn<6, 4, 1>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Some, DerivedRobots, Some);

#ifdef AXIAL_EVERY_UNTUNED
using Others = testing::Types<robots::Indy7, Drawn<0, 2, 2>, Drawn<0, 5, 5>, Drawn<1, 6, 4>, Drawn<3, 4, 3>,
                              Drawn<5, 4, 3>, Drawn<5, 6, 4>, Wrist<-10>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Others, DerivedRobots, Others);
#endif

}  // namespace
}  // namespace property

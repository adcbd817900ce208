// Derivatives of forward dynamics in 32 bits of known arms, and of robots that nobody tuned for.
#include <robots/robots.hpp>

#include "untuned_forward_derivatives.hpp"

namespace property {
namespace {

using Some =
    testing::Types<robots::Scara, robots::Puma560, robots::Panda, robots::RoarmM2, Drawn<6, 4, 1>, Drawn<1, 6, 4>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Some, ForwardDerivedRobots, Some);

#ifdef AXIAL_EVERY_UNTUNED
using Others = testing::Types<robots::ScaraRrpr, robots::Indy7, Drawn<0, 2, 2>, Drawn<0, 5, 5>, Drawn<2, 5, 3>,
                              Drawn<3, 4, 3>, Drawn<5, 4, 3>, Drawn<5, 6, 4>, Wrist<-10>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Others, ForwardDerivedRobots, Others);
#endif

}  // namespace
}  // namespace property

// One robot of each kind under all sanitizers, where the others run under those of arithmetic.
#include "untuned.hpp"

namespace property {
namespace {

using Robots = testing::Types<Drawn<0, 3, 3>, Drawn<2, 5, 3>, Drawn<3, 4, 3>, Drawn<5, 4, 3>, Wrist<-10>>;
INSTANTIATE_TYPED_TEST_SUITE_P(OfEachKind, UntunedRobot, Robots);

}  // namespace
}  // namespace property

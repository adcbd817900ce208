// Arms of the stability scenarios ST4, ST5, ST6, ST8 and ST16.
#include "untuned.hpp"

namespace property {
namespace {

using Robots = testing::Types<SixJoints<4, 0>, SixJoints<4, -2>, SixJoints<5, -10>, SixJoints<5, -13>,
                              SixJoints<8, -10>, SixJoints<8, 0>, Wrist<-10>, HeavyAndLight<6>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Scenarios, UntunedRobot, Robots);

}  // namespace
}  // namespace property

// Links of unlike scales, and joints of very unlike limits.
#include "untuned.hpp"

namespace property {
namespace {

using Robots = testing::Types<Drawn<3, 2, 1>, Drawn<3, 3, 2>, Drawn<3, 4, 3>, Drawn<3, 5, 4>, Drawn<3, 6, 5>,
                              Drawn<4, 3, 1>, Drawn<4, 4, 2>, Drawn<4, 6, 3>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Limits, UntunedRobot, Robots);

}  // namespace
}  // namespace property

// Arms of one to eight joints.
#include "untuned.hpp"

namespace property {
namespace {

using Robots = testing::Types<Drawn<0, 1, 1>, Drawn<0, 2, 2>, Drawn<0, 3, 3>, Drawn<0, 4, 4>, Drawn<0, 5, 5>,
                              Drawn<0, 6, 6>, Drawn<0, 7, 7>, Drawn<0, 8, 8>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Arms, UntunedRobot, Robots);

}  // namespace
}  // namespace property

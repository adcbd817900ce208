// Arms of grams and millimetres, and of tonnes.
#include "untuned.hpp"

namespace property {
namespace {

using Robots = testing::Types<Drawn<1, 2, 1>, Drawn<1, 3, 2>, Drawn<1, 4, 3>, Drawn<1, 6, 4>, Drawn<2, 2, 1>,
                              Drawn<2, 3, 2>, Drawn<2, 5, 3>, Drawn<2, 6, 4>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Sizes, UntunedRobot, Robots);

}  // namespace
}  // namespace property

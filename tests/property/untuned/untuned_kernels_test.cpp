// Every kernel in 32 bits of robots that nobody tuned for.
#include "untuned_kernels.hpp"

namespace property {
namespace {

using Some =
    testing::Types<Drawn<0, 2, 2>, Drawn<0, 5, 5>, Drawn<1, 3, 2>, Drawn<1, 6, 4>, Drawn<2, 5, 3>, Drawn<3, 4, 3>,
                   Drawn<3, 5, 4>, Drawn<4, 6, 3>, Drawn<5, 4, 3>, Drawn<6, 4, 1>, SixJoints<4, 0>, HeavyAndLight<6>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Some, UntunedRobotsKernels, Some);

#ifdef AXIAL_EVERY_UNTUNED
using Others =
    testing::Types<Drawn<0, 1, 1>, Drawn<0, 3, 3>, Drawn<0, 4, 4>, Drawn<0, 6, 6>, Drawn<0, 7, 7>, Drawn<0, 8, 8>,
                   Drawn<1, 2, 1>, Drawn<1, 4, 3>, Drawn<2, 2, 1>, Drawn<2, 3, 2>, Drawn<2, 6, 4>, Drawn<3, 2, 1>,
                   Drawn<3, 3, 2>, Drawn<3, 6, 5>, Drawn<4, 3, 1>, Drawn<4, 4, 2>, Drawn<4, 7, 4>, Drawn<5, 2, 1>,
                   Drawn<5, 3, 2>, Drawn<5, 6, 4>, Drawn<5, 7, 5>, Drawn<6, 6, 2>, SixJoints<4, -2>, SixJoints<5, -10>,
                   SixJoints<5, -13>, SixJoints<8, -10>, SixJoints<8, 0>, Wrist<-10>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Others, UntunedRobotsKernels, Others);
#endif

}  // namespace
}  // namespace property

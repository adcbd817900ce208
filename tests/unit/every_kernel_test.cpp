// Every kernel under the address sanitizer: what reads or writes beside its arrays or states ends this program. Values
// are judged elsewhere.
#include <axial/axial.hpp>
#include <axial/batch.hpp>
#include <axial/control/payload_estimator.hpp>
#include <axial/cost.hpp>
#include <axial/fixed.hpp>
#include <axial/fixed/c_interface/fixed_calls.hpp>
// Behind the plug-in, which serves it.
#include <gtest/gtest.h>
#include <axial/c_interface/derivatives.hpp>
#include <axial/c_interface/elastic.hpp>
#include <axial/c_interface/export.hpp>
#include <axial/simulation/integrators.hpp>
#include <axial/simulation/step_limit.hpp>

#include "builds/every_kernel.cpp"

#if AXIAL_KERNELS_OF == 1
TEST(EveryKernel, StaysInsideItsMemoryInFloat) { static_cast<void>(in_float()); }
#elif AXIAL_KERNELS_OF == 2
TEST(EveryKernel, StaysInsideItsMemoryInDouble) { static_cast<void>(in_double()); }
#else
TEST(EveryKernel, StaysInsideItsMemoryInFixedPoint) { static_cast<void>(in_fixed_point()); }
#endif

// The block of doc/guides/batch.md.
#include <gtest/gtest.h>

#include <axial/batch.hpp>
#include <robots/planar2r.hpp>

namespace {

using Arm = robots::Planar2r;
#include "batch-1.inc"

// As one state at a time; a last group that fills no batch is left out.
TEST(BatchPage, AnswersEveryState) {
  constexpr int states = 9, whole = states - states % axial::native_lanes<double>;
  axial::Joints<Arm, double> q[states], tau[states];
  for (int k = 0; k < states; ++k)
    q[k] = {0.1 * k, 0.5 - 0.2 * k};
  torques(q, q, q, tau, states);
  for (int k = 0; k < states; ++k) {
    const auto one = axial::inverse_dynamics<Arm>(q[k], q[k], q[k]);
    for (int i = 0; i < one.size; ++i)
      EXPECT_NEAR(tau[k][i], k < whole ? one[i] : 0.0, 1e-12);
  }
}

}  // namespace

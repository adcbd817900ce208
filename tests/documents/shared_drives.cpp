// doc/guides/shared_drives.md.
#include <gtest/gtest.h>
#include <axial/axial.hpp>

namespace {

#include "shared_drives-1.inc"

TEST(SharedDrivesGuide, ItsLinesCompileAndAgree) {
#include "shared_drives-2.inc"
  EXPECT_FLOAT_EQ(q[1], u[1] - u[0]);
  EXPECT_FLOAT_EQ(q[2], (u[2] + u[3]) / 2);
#include "shared_drives-3.inc"
  EXPECT_EQ(axial::joint_count<Arm>, 4);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(of_drives[k], tau[k], 1e-5F) << "at rest rotors have no part in it";
}

}  // namespace

// What a matrix of drives says of itself, and the drives as links of their own.
#include <axial/axial.hpp>
#include <axial/transmissions/shared_drives.hpp>

#include <gtest/gtest.h>

namespace {

using axial::DriveMatrix;
using axial::LinkParameters;
using axial::RowStep;

DriveMatrix<3> matrix(const double (&rows)[3][3]) {
  DriveMatrix<3> g;
  g.drives = 3;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      g.owner[i] = i, g.ratio[i][k] = rows[i][k];
  return g;
}

TEST(DriveMatrix, FactorsAreThoseThatAllEntriesOfARowShare) {
  const auto g = matrix({{0.5, -0.5, 0.0}, {0.0, 0.25, 0.0}, {0.5, 0.5, 0.25}});
  EXPECT_EQ(g.common_factor(0), 0.5);
  EXPECT_EQ(g.common_factor(1), 1.0) << "one entry is a product whatever it is";
  EXPECT_EQ(g.common_factor(2), 1.0);
  EXPECT_EQ(matrix({{0.5, -0.5, 0.5}, {}, {}}).common_factor(0), 0.5);
  EXPECT_EQ(matrix({{0.5, 0.25, 0.5}, {}, {}}).common_factor(0), 1.0);
}

// A row by an earlier one, its sign turned or not, where that leaves one number that is not multiplied.
TEST(DriveMatrix, RowsFollowFromEarlierOnes) {
  const auto step = [](const double(&rows)[3][3], int joint) { return matrix(rows).joint_step(joint); };
  const auto expect = [](const RowStep& found, int from, double sign, int at, double unit) {
    EXPECT_EQ(found.from, from);
    if (from < 0) return;
    EXPECT_EQ(found.sign, sign);
    EXPECT_EQ(found.at, at);
    EXPECT_EQ(found.unit, unit);
  };
  const double differential[3][3] = {{0.5, 0.5, 0.0}, {0.5, -0.5, 0.0}, {-0.5, 0.5, 0.0}};
  expect(step(differential, 0), -1, 0, 0, 0);
  expect(step(differential, 1), 0, 1.0, 1, -1.0);
  expect(step(differential, 2), 0, 1.0, 0, -1.0);
  expect(step({{0.5, 0.5, 0.0}, {-0.5, -0.5, 1.0}, {}}, 1), 0, -1.0, 2, 1.0);
  expect(step({{0.25, 0.5, 0.0}, {-0.25, 0.5, 0.0}, {}}, 1), 0, -1.0, 1, 1.0);
  expect(step({{0.25, 0.5, 0.0}, {0.75, 0.5, 0.0}, {}}, 1), -1, 0, 0, 0);    // a half is left
  expect(step({{0.25, 0.5, 0.0}, {1.0, 0.5, -1.0}, {}}, 1), -1, 0, 0, 0);    // one product
  expect(step({{0.25, 0.5, 0.0}, {-0.75, -0.5, 1.0}, {}}, 1), -1, 0, 0, 0);  // two numbers are left
}

TEST(DriveMatrix, AJointIsAloneWithADriveOfItsOwnOneToOne) {
  const auto g = matrix({{1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.5, 0.0, 1.0}});
  EXPECT_TRUE(g.is_alone(0));
  EXPECT_FALSE(g.is_alone(1)) << "geared";
  EXPECT_FALSE(g.is_alone(2)) << "moved by another one too";
}

// Limits of a drive are what is said of the drive; those of the joint that it alone moves, too: the narrower.
TEST(DriveCoordinates, ADriveHasTheLimitsOfItsJointWhereNothingElseMovesThat) {
  LinkParameters joint;
  joint.position_min = -1.0, joint.position_max = 2.0, joint.speed_limit = 3.0, joint.acceleration_limit = 4.0;
  joint.drive_min = -2.0, joint.drive_max = 1.0, joint.drive_speed_limit = 5.0, joint.drive_acceleration_limit = 3.5;
  joint.rotor_inertia = 0.25, joint.gear = 50.0, joint.viscous = 0.5, joint.effort_limit = 7.0;
  joint.coulomb_forward = 0.1, joint.coulomb_backward = -0.2, joint.static_friction = 0.4, joint.stribeck_speed = 0.3;
  joint.smooth_speed = 0.05;
  const LinkParameters shared = axial::detail::drive_by_itself(joint, false);
  EXPECT_EQ(shared.position_min, -2.0);
  EXPECT_EQ(shared.position_max, 1.0);
  EXPECT_EQ(shared.speed_limit, 5.0);
  EXPECT_EQ(shared.acceleration_limit, 3.5);
  const LinkParameters alone = axial::detail::drive_by_itself(joint, true);
  EXPECT_EQ(alone.position_min, -1.0);
  EXPECT_EQ(alone.position_max, 1.0);
  EXPECT_EQ(alone.speed_limit, 3.0);
  EXPECT_EQ(alone.acceleration_limit, 3.5);
  for (const auto field :
       {&LinkParameters::rotor_inertia, &LinkParameters::gear, &LinkParameters::viscous, &LinkParameters::effort_limit,
        &LinkParameters::coulomb_forward, &LinkParameters::coulomb_backward, &LinkParameters::static_friction,
        &LinkParameters::stribeck_speed, &LinkParameters::smooth_speed})
    EXPECT_EQ(shared.*field, joint.*field);
}

}  // namespace

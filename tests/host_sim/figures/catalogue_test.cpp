// The boards and robots that the host knows.
#include <host_sim/boards/emulator/board.hpp>
#include <host_sim/robots/robots/robot.hpp>
#include <host_sim/robots/trajectory/files.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace {

std::string error_of(void (*action)()) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Catalogue, EveryBoardCanBeRead) {
  const auto names = host_sim::board_names();
  EXPECT_FALSE(names.empty());
  for (const std::string& name : names) {
    const host_sim::Board board = host_sim::read_board(name);
    EXPECT_GT(board.flash_bytes, board.ram_bytes);
    EXPECT_GT(board.emulator.size(), 2u);
  }
}

TEST(Catalogue, ABoardThatOnlyMeasuresIsNotOffered) {
  for (const std::string& name : host_sim::board_names())
    EXPECT_NE(name, "mps2_an500");
  EXPECT_FALSE(error_of([] { host_sim::read_board("mps2_an500"); }).empty());
}

TEST(Catalogue, AnUnknownBoardIsAnsweredWithTheKnownOnes) {
  EXPECT_NE(error_of([] { host_sim::read_board("z80"); }).find("stm32f405"), std::string::npos);
  EXPECT_NE(error_of([] { host_sim::read_board("../boards/stm32f405"); }).find("stm32f405"), std::string::npos);
}

TEST(Catalogue, AnUnknownRobotIsAnsweredWithTheKnownOnes) {
  EXPECT_NE(error_of([] { host_sim::find_robot("r2d2"); }).find("puma560"), std::string::npos);
}

TEST(Catalogue, EveryRobotHasACycleInsideItsLimits) {
  for (const std::string& name : host_sim::robot_names()) {
    const host_sim::Robot robot = host_sim::find_robot(name);
    const std::string file = std::string(AXIAL_ROOT) + "/host_sim/robots/trajectories/" + name + ".json";
    EXPECT_GT(host_sim::load_trajectory(file, name, robot.limits).size(), 1000u) << name;
  }
}

TEST(Catalogue, EveryRobotOfSharedDrivesHasACycleInsideTheLimitsOfBoth) {
  for (const std::string& name : host_sim::driven_robot_names()) {
    SCOPED_TRACE(name);
    const host_sim::Robot robot = host_sim::find_robot(name);
    const std::string file = std::string(AXIAL_ROOT) + "/host_sim/robots/trajectories/shared_drives/" + name + ".json";
    const auto trajectory = host_sim::load_trajectory(file, name, robot.limits, [&](const host_sim::Cycle& cycle) {
      return host_sim::plan_of_drives(cycle, robot.limits, robot.moved,
                                      [&](const auto& u) { return host_sim::joint_positions(robot, u); });
    });
    EXPECT_GT(trajectory.size(), 1000u);
    for (const auto& point : trajectory) {
      ASSERT_EQ(point.q.size(), robot.limits.size());
      const auto q = host_sim::joint_positions(robot, point.q);
      ASSERT_EQ(q.size(), robot.moved.size());
      for (std::size_t i = 0; i < q.size(); ++i) {
        EXPECT_GE(q[i], robot.moved[i].position_min - 1e-12) << i;
        EXPECT_LE(q[i], robot.moved[i].position_max + 1e-12) << i;
      }
    }
  }
}

/// The nut of a screw of 20 mm lead carries what hangs on the quill, and turns; the spline carries nothing at rest.
TEST(Catalogue, ValuesOfSharedDrivesAreTheDrives) {
  const host_sim::Robot robot = host_sim::find_robot("scara_quill");
  EXPECT_EQ(std::string(robot.noun()), "drive");
  const double lead = 0.020 / (2.0 * std::acos(-1.0));
  const std::vector<double> u = {0.3, -0.4, 20.0, 0.0}, rest(4, 0.0);
  EXPECT_NEAR(host_sim::joint_positions(robot, u)[2], lead * 20.0, 1e-15);
  const auto torque = host_sim::exact_torque(robot, {0.0, u, rest, rest, {}, {}});
  EXPECT_NEAR(torque[2], -(0.95 + 0.60) * 9.81 * lead, 1e-12);
  EXPECT_EQ(std::string(robot.effort_unit(2)), "N m");
  EXPECT_EQ(std::string(host_sim::find_robot("gripper").effort_unit(1)), "N") << "a finger's own drive";
  EXPECT_EQ(host_sim::find_robot("palletiser").joints(), 4);
  EXPECT_EQ(std::string(host_sim::find_robot("scara").noun()), "joint");
}

/// At rest the SCARA's quill carries its own weight and the arms carry nothing: m3 g along the joint, downwards
/// positive.
TEST(Catalogue, TheOracleHoldsTheScarasQuill) {
  const host_sim::Robot robot = host_sim::find_robot("scara");
  const auto torque = host_sim::exact_torque(robot, {0.0, {0.3, -0.4, 0.1}, {0, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(torque[0], 0.0);
  EXPECT_EQ(torque[1], 0.0);
  EXPECT_DOUBLE_EQ(torque[2], -1.25 * 9.8125);
}

}  // namespace

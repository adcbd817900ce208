// The boards and robots that the host knows.
#include <host_sim/emulator/board.hpp>
#include <host_sim/robots/robot.hpp>
#include <host_sim/trajectory/files.hpp>

#include <gtest/gtest.h>

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
    const std::string file = std::string(AXIAL_ROOT) + "/host_sim/trajectories/" + name + ".json";
    EXPECT_GT(host_sim::load_trajectory(file, name, robot.limits).size(), 1000u) << name;
  }
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

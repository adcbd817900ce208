// What a header's robot is called, by the comments of the header.
#include <gtest/gtest.h>

#include <host_sim/description/own_names.hpp>

#include <filesystem>
#include <fstream>

namespace {

TEST(OwnNames, AreThoseOfTheCommentsAndNameNoFolder) {
  const auto folder = std::filesystem::temp_directory_path() / "axial_own_names_test";
  std::filesystem::create_directories(folder);
  const auto header = folder / "my_arm.hpp";
  std::ofstream(header) << "      // 0: shoulder moves upper arm\n// 1: elbow moves forearm\n// 2: wrist moves hand\n";
  description::Description robot;
  robot.links.resize(2);
  description::take_names(robot, header.string());
  EXPECT_EQ(robot.source, "my_arm.hpp");
  EXPECT_EQ(robot.links[0].joint, "shoulder");
  EXPECT_EQ(robot.links[0].name, "upper arm");
  EXPECT_EQ(robot.links[1].joint, "elbow");
  EXPECT_EQ(robot.links[1].name, "forearm");
  std::filesystem::remove_all(folder);
}

}  // namespace

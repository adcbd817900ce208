#include <host_sim/robots/trajectory/files.hpp>

#include "temporary_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

using host_sim::load_trajectory;
using host_sim::test::TemporaryFile;

const std::vector<host_sim::JointLimits> limits = {{-1.0, 1.0, 3.0, 20.0}, {-1.5, 1.5, 5.0, 40.0}};

std::string error_of(const std::string& ending, const std::string& content, const std::string& robot = "arm") {
  const TemporaryFile file(ending, content);
  try {
    load_trajectory(file.path(), robot, limits);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(TrajectoryFiles, ReadsWayPoints) {
  const TemporaryFile file(".json", R"({"robot": "arm", "tick_s": 0.002, "way_points": [
      {"name": "a", "q": [0, 0]}, {"name": "b", "q": [0.5, -0.5], "dwell_s": 0.1}]})");
  const auto cycle = host_sim::read_cycle(file.path());
  EXPECT_EQ(cycle.tick, 0.002);
  ASSERT_EQ(cycle.way_points.size(), 2u);
  EXPECT_EQ(cycle.way_points[1].dwell, 0.1);
  const auto trajectory = load_trajectory(file.path(), "arm", limits);
  EXPECT_EQ(trajectory.back().q, cycle.way_points[1].q);
}

TEST(TrajectoryFiles, ReadsSetPoints) {
  const TemporaryFile file(".csv",
                           "time,q1,q2,qd1,qd2,qdd1,qdd2\n0,0.1,0.2,0.3,0.4,0.5,0.6\n0.001, 0.2,0,0,0,0,-1e-3\n");
  const auto trajectory = load_trajectory(file.path(), "arm", limits);
  ASSERT_EQ(trajectory.size(), 2u);
  EXPECT_EQ(trajectory[0].qd, (std::vector<double>{0.3, 0.4}));
  EXPECT_EQ(trajectory[1].qdd, (std::vector<double>{0.0, -1e-3}));
}

TEST(TrajectoryFiles, SaysWhatIsWrong) {
  EXPECT_NE(error_of(".json", "{").find("not a cycle of way-points"), std::string::npos);
  EXPECT_NE(error_of(".json", R"({"robot": "arm"})").find("way_points"), std::string::npos);
  EXPECT_NE(error_of(".json", R"({"robot": "other", "way_points": []})").find("is for other"), std::string::npos);
  EXPECT_NE(error_of(".json", R"({"robot": "arm", "tick_s": 0, "way_points": []})").find("tick_s"), std::string::npos);
  EXPECT_NE(error_of(".csv", "header\n0,1,2\n").find("line 2"), std::string::npos);
  EXPECT_NE(error_of(".csv", "header\n0,0,0,0,0,0,0\n0,0,0,0,0,0,x\n").find("line 3"), std::string::npos);
  EXPECT_NE(error_of(".csv", "header\n0,0,0,0,0,0,nan\n").find("line 2"), std::string::npos);
  EXPECT_NE(error_of(".csv", "header\n").find("no set-points"), std::string::npos);
  EXPECT_NE(error_of(".csv", "header\n0,1.1,0,0,0,0,0\n").find("joint 1 is outside"), std::string::npos);
  EXPECT_NE(error_of(".csv", "header\n0,0,0,0,0,0,0\n0.5,0,-1.6,0,0,0,0\n")
                .find("joint 2 is outside its position limits at 0.5"),
            std::string::npos);
}

TEST(TrajectoryFiles, SaysThatAFileIsMissing) {
  EXPECT_THROW(load_trajectory("/nowhere/at/all.json", "arm", limits), std::runtime_error);
}

}  // namespace

// An arm of a board's image beside the host's plant, and a line that fails. The boards themselves: host_sim.Hil.*.
#include <host_sim/plants/loop/cycle.hpp>
#include <host_sim/plants/loop/on_host.hpp>
#include <host_sim/plants/two_boards/faulty_line.hpp>
#include <host_sim/plants/two_boards/same_source.hpp>

#include <firmware/apps/tracking/controller.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <sys/socket.h>
#include <robots/scara.hpp>

namespace {

using namespace host_sim;
namespace link = axial::hal::link;
using namespace std::chrono_literals;
using robots::Scara;
using two_boards::Bytes;

loop::Case of_seconds(double seconds) {
  loop::Case situation;
  situation.seconds = seconds;
  return situation;
}

loop::OnHost<axial::apps::TrackingController<Scara, axial::Fixed32>> controller() { return {}; }

axial::Vec3<double> tool_of(const std::vector<double>& q) {
  simulation::Values<double> values{};
  std::copy(q.begin(), q.end(), values.values);
  return axial::forward_kinematics(simulation::robot_model("scara"), values, {}).tool.position;
}

/// Both ends of a line.
struct Line {
  SerialLine near, far;
  Line() {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    near = SerialLine(Descriptor(ends[0])), far = SerialLine(Descriptor(ends[1]));
  }
};
Bytes read_all(SerialLine& line) {
  Bytes all(64);
  all.resize(line.read(all.data(), all.size(), 100ms));
  return all;
}

}  // namespace

TEST(TwoBoards, AnImagesArmTracksAsTheHostsPlant) {
  const loop::Case situation = of_seconds(2.0);
  const Trajectory cycle = loop::cycle_of("scara");
  auto one = controller(), other = controller();
  two_boards::SameSourceArm<Scara> image(cycle.front(), tool_of);
  const auto plant =
      loop::arm_on_host(situation, cycle.front(), simulation::robot_model("scara"), simulation::robot_links("scara"));
  const loop::Tracking of_image = loop::follow(situation, cycle, 0, image, one);
  const loop::Tracking of_plant = loop::follow(situation, cycle, 0, *plant, other);
  EXPECT_EQ(of_image.refused + of_plant.refused, 0);
  EXPECT_GT(of_image.tool_rms, 1e-6);
  EXPECT_NEAR(of_image.tool_rms / of_plant.tool_rms, 1.0, 1e-3);
  EXPECT_NEAR(of_image.tool_largest / of_plant.tool_largest, 1.0, 1e-3);
}

TEST(TwoBoards, TheSameLoopBySituationOrByArm) {
  loop::Case situation = of_seconds(0.5);
  auto one = controller(), other = controller();
  const Trajectory cycle = loop::cycle_of("scara");
  const auto plant =
      loop::arm_on_host(situation, cycle.front(), simulation::robot_model("scara"), simulation::robot_links("scara"));
  EXPECT_EQ(loop::follow(situation, one).rms, loop::follow(situation, cycle, 0, *plant, other).rms);
}

TEST(TwoBoards, AControllerIsToldWhatEncodersSay) {
  link::Encoders seen{};
  seen.joints = 2, seen.position = {7, -9};
  const auto told = two_boards::measurement_of(seen);
  EXPECT_EQ(told.joints, 2U);
  EXPECT_EQ(told.position, seen.position);
  EXPECT_EQ(told.feeds_forward, 1);
  const auto command = two_boards::command_of(link::ArmAction::push, {0.5, -1.0});
  EXPECT_EQ(command.joints, 2U);
  EXPECT_EQ(command.values[1], -1.0F);
  EXPECT_EQ(command.action, 1);
}

TEST(FaultyLine, ChangesWhatGoesOutAndWhatComesIn) {
  Line line;
  two_boards::FaultyLine faulty(line.near);
  const Bytes sent{1, 2, 3};
  faulty.write(sent.data(), sent.size());
  EXPECT_EQ(read_all(line.far), sent);
  faulty.outward = [](Bytes& bytes) { bytes.clear(); };
  faulty.write(sent.data(), sent.size());
  EXPECT_TRUE(read_all(line.far).empty());
  line.far.write(sent.data(), sent.size());
  EXPECT_EQ(read_all(faulty), sent);
  faulty.inward = [](Bytes& bytes) { bytes[1] = 9, bytes.push_back(4); };
  line.far.write(sent.data(), sent.size());
  std::array<std::uint8_t, 2> part{};
  EXPECT_EQ(faulty.read(part.data(), part.size(), 100ms), 2U);
  EXPECT_EQ(part[1], 9);
}

TEST(FaultyLine, HandsOverWhatDoesNotFitAtOnce) {
  Line line;
  two_boards::FaultyLine faulty(line.near);
  faulty.inward = [](Bytes& bytes) { bytes.insert(bytes.end(), {7, 8, 9}); };
  const std::uint8_t one = 6;
  line.far.write(&one, 1);
  Bytes all;
  std::array<std::uint8_t, 2> part{};
  for (int k = 0; k < 2; ++k) {
    const std::size_t count = faulty.read(part.data(), part.size(), 100ms);
    all.insert(all.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count));
  }
  EXPECT_EQ(all, (Bytes{6, 7, 8, 9}));
}

// How a header's robot is moved by ./axial hil, and what an arm on this host tells of itself.
#include <firmware/apps/run/motion.hpp>
#include <host_sim/plants/two_boards/same_source.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <robots/gripper.hpp>
#include <robots/palletiser.hpp>
#include <robots/scara.hpp>
#include <robots/scara_quill.hpp>
#include <robots/wrist_arm.hpp>

namespace {

using namespace host_sim;
using robots::Scara;

struct LateScara : Scara {
  struct Mechanics {
    static constexpr int encoder_delay = 1;
  };
};

template <class R>
void expect_inside_its_limits() {
  double most = 0.0;  // of the way that a joint has
  for (int k = 0; k < 4000; ++k) {
    axial::Joints<R, double> u{}, ud{};
    for (int i = 0; i < axial::joint_count<R>; ++i) {
      const auto motion = axial::apps::run::motion<R>(i, k * 1e-3);
      const auto& drive = axial::scene_of<R>::Robot::chain.links[i];
      u[i] = motion.q, ud[i] = motion.qd;
      EXPECT_GT(motion.q, drive.position_min);
      EXPECT_LT(motion.q, drive.position_max);
      EXPECT_LT(std::fabs(motion.qd), drive.speed_limit);
    }
    const auto q = axial::joint_positions<R>(u), qd = axial::joint_rates<R>(ud);
    for (int j = 0; j < axial::link_count<R>; ++j) {
      const auto& joint = R::chain.links[j];
      EXPECT_GT(q[j], joint.position_min) << j << " at " << k;
      EXPECT_LT(q[j], joint.position_max) << j << " at " << k;
      EXPECT_LT(std::fabs(qd[j]), joint.speed_limit) << j << " at " << k;
      most = std::max(most, std::fabs(qd[j]) / joint.speed_limit);
    }
  }
  EXPECT_GT(most, 0.1);
}

}  // namespace

// Joints that share drives are inside their limits too, where the drives' own would let them leave.
TEST(TwoBoards, AMotionByDrivesKeepsJointsInsideTheirLimits) {
  expect_inside_its_limits<robots::ScaraQuill>();
  expect_inside_its_limits<robots::WristArm>();
  expect_inside_its_limits<robots::Palletiser>();
  expect_inside_its_limits<robots::Gripper>();
}

// What is compared is what encoders say on either side: an arm that answers late is off by as much.
TEST(TwoBoards, AnArmOnTheHostSaysWhatItsEncodersSay) {
  SetPoint start;
  start.q = {0.3, -0.4, 0.1};
  two_boards::SameSourceArm<LateScara> late(start, {});
  two_boards::SameSourceArm<Scara> prompt(start, {});
  axial::hal::link::Torque pushed{};
  pushed.joints = 3, pushed.tau[0] = 5.0F, pushed.phase = 1;
  std::vector<double> before;
  for (int k = 0; k < 30; ++k) {
    before = prompt.state().q;
    late.run(pushed), prompt.run(pushed);
  }
  EXPECT_EQ(late.state().q, before);
  EXPECT_NE(late.state().q, prompt.state().q);
}

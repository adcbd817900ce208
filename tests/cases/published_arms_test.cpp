// robots::Published against the descriptions that they were carried over from: where the links are, by homogeneous
// transforms of the description as it stands, and torques, by Orocos KDL on the description's own frames.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cases/arm_description.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <oracle/convert.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/random_chain.hpp>
#include <robots/robots.hpp>

namespace cases {
namespace {

using oracle::quad;
using Pose = oracle::Pose<quad>;
using Vec3 = oracle::Vec3<quad>;

constexpr unsigned seed = 24;
constexpr int states = 100;
constexpr double right_angle = 1.57079632679489661923;
constexpr double rounded = 2e-15;    // metres or radians: ten roundings of the numbers in a header
constexpr double agreement = 1e-12;  // of a joint's largest torque

double size(const Vec3& v) { return static_cast<double>(sqrtq(dot(v, v))); }

Vec3 in_quad(const oracle::Vec3<double>& v) { return {v.x, v.y, v.z}; }

/// About the axes x (0), y (1) or z (2).
oracle::Mat3<quad> turn(int axis, quad angle) {
  quad s, c;
  oracle::sincos_of_constant(angle, s, c);
  if (axis == 0) return {{1, 0, 0}, {0, c, s}, {0, -s, c}};
  if (axis == 1) return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
  return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
}

/// Poses of the joint frames in the foot's.
std::vector<Pose> poses(const ArmDescription& arm, const oracle::Vector<double>& q) {
  std::vector<Pose> result;
  Pose last;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const DescribedJoint& j = arm.joints[i];
    const auto quarter = oracle::right_angle<quad>();
    const auto fixed = turn(2, j.yaw * quarter) * turn(1, j.pitch * quarter) * turn(0, j.roll * quarter);
    last = last * Pose{fixed * turn(2, quad(q[i])), in_quad(j.origin)};
    result.push_back(last);
  }
  return result;
}

KDL::Vector kdl(const oracle::Vec3<double>& v) { return {v.x, v.y, v.z}; }

KDL::Chain kdl(const ArmDescription& arm) {
  KDL::Chain chain;
  for (const DescribedJoint& j : arm.joints) {
    const auto fixed = KDL::Rotation::RPY(j.roll * right_angle, j.pitch * right_angle, j.yaw * right_angle);
    const KDL::Joint joint(kdl(j.origin), fixed.UnitZ(), KDL::Joint::RotAxis);
    const auto& I = j.inertia;
    const KDL::RotationalInertia about_com(I.c0.x, I.c1.y, I.c2.z, I.c0.y, I.c0.z, I.c1.z);
    chain.addSegment(
        KDL::Segment(joint, KDL::Frame(fixed, kdl(j.origin)), KDL::RigidBodyInertia(j.mass, kdl(j.com), about_com)));
  }
  return chain;
}

KDL::JntArray kdl(const oracle::Vector<double>& values) {
  KDL::JntArray result(static_cast<unsigned>(values.size()));
  for (unsigned i = 0; i < values.size(); ++i)
    result(i) = values[i];
  return result;
}

KDL::JntArray torques(const KDL::Chain& model, const oracle::Vector<double>& q, const oracle::Vector<double>& qd,
                      const oracle::Vector<double>& qdd) {
  KDL::ChainIdSolver_RNE solver(model, KDL::Vector(0.0, 0.0, -9.81));
  KDL::JntArray result(model.getNrOfJoints());
  EXPECT_EQ(solver.CartToJnt(kdl(q), kdl(qd), kdl(qdd), KDL::Wrenches(model.getNrOfSegments()), result), 0);
  return result;
}

template <class R>
axial::Joints<R, double> joints(const oracle::Vector<double>& values) {
  axial::Joints<R, double> result{};
  for (int i = 0; i < R::chain.size; ++i)
    result[i] = values[static_cast<std::size_t>(i)];
  return result;
}

/// The same axis, centre of mass and inertia, all in the foot's axes.
void expect_same_link(const DescribedJoint& described, const Pose& at, const oracle::Link<quad>& link,
                      const Pose& pose) {
  const Vec3 axis = at.rotation.c2;
  EXPECT_LE(size(pose.rotation.c2 - axis), rounded);
  EXPECT_LE(size(cross(pose.position - at.position, axis)), rounded);
  EXPECT_EQ(link.mass, quad(described.mass));
  EXPECT_LE(size(pose.rotation * link.com + pose.position - at.rotation * in_quad(described.com) - at.position),
            rounded);
  const oracle::Mat3<quad> inertia{in_quad(described.inertia.c0), in_quad(described.inertia.c1),
                                   in_quad(described.inertia.c2)};
  const auto difference =
      pose.rotation * link.inertia * transpose(pose.rotation) - at.rotation * inertia * transpose(at.rotation);
  const double scale = size(inertia.c0) + size(inertia.c1) + size(inertia.c2);
  EXPECT_LE(size(difference.c0) + size(difference.c1) + size(difference.c2), rounded * scale);
}

bool quarter_turn(const axial::Angle& angle) { return angle.sin == 0.0 || angle.cos == 0.0; }

template <class R>
class PublishedArm : public testing::Test {
 protected:
  static constexpr int n = R::chain.size;
  const ArmDescription described = load_arm(R::name);
  oracle::RandomChains random{seed};
};
using Arms = testing::Types<robots::Indy7, robots::RoarmM2>;
TYPED_TEST_SUITE(PublishedArm, Arms);

TYPED_TEST(PublishedArm, HasEveryLinkWhereTheDescriptionHasIt) {
  const auto chain = oracle::of_robot<quad, TypeParam>();
  ASSERT_EQ(chain.links.size(), this->described.joints.size());
  for (int k = 0; k < states; ++k) {
    const auto q = this->random.vector(chain.size(), 3.0);
    const auto expected = poses(this->described, q);
    const auto actual = oracle::link_poses(chain, oracle::convert<quad>(q));
    for (std::size_t i = 0; i < actual.size(); ++i)
      expect_same_link(this->described.joints[i], expected[i], chain.links[i], chain.base * actual[i]);
    const auto tool = oracle::tool_pose(chain, oracle::convert<quad>(q));
    EXPECT_LE(size(tool.position - expected.back().position), rounded);
    EXPECT_LE(size(tool.rotation.c0 - expected.back().rotation.c0), rounded);
  }
}

TYPED_TEST(PublishedArm, HasTheTorquesOfItsDescription) {
  constexpr int n = TestFixture::n;
  const auto model = kdl(this->described);
  const auto chain = oracle::of_robot<quad, TypeParam>();
  double error[n] = {}, largest[n] = {}, worst = 0.0;
  for (int k = 0; k < states; ++k) {
    const auto q = this->random.vector(n, 3.0), qd = this->random.vector(n, 3.0), qdd = this->random.vector(n, 6.0);
    const auto expected = torques(model, q, qd, qdd);
    const auto lagrange = oracle::inverse_dynamics(chain, oracle::convert<quad>(q), oracle::convert<quad>(qd),
                                                   oracle::convert<quad>(qdd));
    const auto tau =
        axial::inverse_dynamics<TypeParam>(joints<TypeParam>(q), joints<TypeParam>(qd), joints<TypeParam>(qdd));
    for (std::size_t i = 0; i < n; ++i) {
      const double truth = expected(static_cast<unsigned>(i));
      const double ours = std::fabs(tau[static_cast<int>(i)] - truth);
      error[i] = std::fmax(error[i], std::fmax(ours, std::fabs(static_cast<double>(lagrange[i]) - truth)));
      largest[i] = std::fmax(largest[i], std::fabs(truth));
    }
  }
  for (int i = 0; i < n; ++i) {
    EXPECT_LE(error[i], agreement * largest[i]) << "joint " << i;
    worst = std::fmax(worst, error[i] / largest[i]);
  }
  std::printf("worst difference relative to a joint's largest torque: %.1e\n", worst);
}

TYPED_TEST(PublishedArm, HasTheLimitsOfItsDescription) {
  for (int i = 0; i < TestFixture::n; ++i) {
    const auto& link = TypeParam::chain.links[i];
    const auto& joint = this->described.joints[static_cast<std::size_t>(i)];
    EXPECT_EQ(link.position_min, joint.position_min);
    EXPECT_EQ(link.position_max, joint.position_max);
    EXPECT_EQ(link.speed_limit, this->described.speed);
    EXPECT_EQ(link.acceleration_limit, this->described.acceleration);
  }
}

TYPED_TEST(PublishedArm, HasExactTwists) {
  for (const auto& link : TypeParam::chain.links)
    EXPECT_TRUE(quarter_turn(link.alpha));
}
TEST(Indy7, HasExactOffsets) {
  for (const auto& link : robots::Indy7::chain.links)
    EXPECT_TRUE(quarter_turn(link.theta));
}

TEST(PandaSlow, IsThePandaAtOtherLimits) {
  using robots::Panda, robots::PandaSlow;
  for (int i = 0; i < Panda::chain.size; ++i) {
    const auto &slow = PandaSlow::chain.links[i], &whole = Panda::chain.links[i];
    EXPECT_EQ(slow.speed_limit, 0.5);
    EXPECT_EQ(slow.acceleration_limit, 1.0);
    EXPECT_EQ(slow.position_min, whole.position_min);
    EXPECT_EQ(slow.position_max, whole.position_max);
    EXPECT_EQ(slow.effort_limit, whole.effort_limit);
  }
  oracle::RandomChains random(seed);
  const auto q = random.vector(7, 3.0), qd = random.vector(7, 3.0), qdd = random.vector(7, 6.0);
  const auto slow =
      axial::inverse_dynamics<PandaSlow>(joints<PandaSlow>(q), joints<PandaSlow>(qd), joints<PandaSlow>(qdd));
  const auto whole = axial::inverse_dynamics<Panda>(joints<Panda>(q), joints<Panda>(qd), joints<Panda>(qdd));
  for (int i = 0; i < Panda::chain.size; ++i)
    EXPECT_EQ(slow[i], whole[i]);
}

}  // namespace
}  // namespace cases

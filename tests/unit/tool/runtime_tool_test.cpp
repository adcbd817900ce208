// A tool that changes at run time, and a payload given in its frame.
#include <cmath>

#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <robots/panda.hpp>

using namespace axial;

namespace {

using Code = Status::Code;
using R = robots::Panda;
using Changing = Scene<R, Gravity, RuntimeTool, Payload>;
using Given = Inputs<Changing, double>;

// A quarter turn about x behind 0.3 rad about z: no symmetry hides an axis.
constexpr double c3 = 0.9553364891256060, s3 = 0.2955202066613396;  // of 0.3 rad
constexpr FixedPose gripper{{c3, 0, s3, s3, 0, -c3, 0, 1, 0}, {0.05, -0.02, 0.15}};
struct Fitted {
  static constexpr auto chain = [] {
    auto c = R::chain;
    c.tool.pose = gripper;
    return c;
  }();
};

template <class T>
Pose<Mat3<Vec3<T>>, Vec3<T>> as_input(const FixedPose& pose) {
  const auto t = [&](int i) { return static_cast<T>(pose.rotation[i]); };
  return {{{t(0), t(1), t(2)}, {t(3), t(4), t(5)}, {t(6), t(7), t(8)}},
          {static_cast<T>(pose.position[0]), static_cast<T>(pose.position[1]), static_cast<T>(pose.position[2])}};
}

const Joints<R, double> q{0.3, -0.4, 0.5, -1.6, 0.7, 1.8, -0.9};
Joints<Fitted, double> same() {
  Joints<Fitted, double> out{};
  for (int i = 0; i < 7; ++i)
    out[i] = q[i];
  return out;
}

void expect_near(const Vec3<double>& a, const Vec3<double>& b) {
  EXPECT_NEAR(a.x, b.x, 1e-14);
  EXPECT_NEAR(a.y, b.y, 1e-14);
  EXPECT_NEAR(a.z, b.z, 1e-14);
}

}  // namespace

TEST(RuntimeTool, StartsAsTheRobotDeclaresIt) {
  const auto found = forward_kinematics<Changing>(q, Given{}).tool, declared = forward_kinematics<R>(q).tool;
  expect_near(found.position, declared.position);
  expect_near(found.rotation.y, declared.rotation.y);
}

TEST(RuntimeTool, IsTheToolThatARobotWouldDeclare) {
  Given in;
  in.tool = as_input<double>(gripper);
  const auto found = forward_kinematics<Changing>(q, in);
  const auto declared = forward_kinematics<Fitted>(same());
  EXPECT_TRUE(found.status.ok());
  expect_near(found.tool.position, declared.tool.position);
  expect_near(found.tool.rotation.x, declared.tool.rotation.x);
  expect_near(found.tool.rotation.y, declared.tool.rotation.y);
  expect_near(found.tool.rotation.z, declared.tool.rotation.z);
  const auto j = jacobian<Changing>(q, in);
  const auto wanted = jacobian<Fitted>(same());
  EXPECT_TRUE(j.status.ok());
  for (int i = 0; i < 7; ++i) {
    expect_near(j[i].angular, wanted[i].angular);
    expect_near(j[i].linear, wanted[i].linear);
  }
}

TEST(RuntimeTool, IsSeenByALoopedFormToo) {
  using Looping = Scene<R, RuntimeTool, Looped>;
  Inputs<Looping, double> in;
  in.tool = as_input<double>(gripper);
  expect_near(forward_kinematics<Looping>(q, in).tool.position, forward_kinematics<Fitted>(same()).tool.position);
}

TEST(RuntimeTool, ThatIsNoPoseIsRefused) {
  const auto status = [](auto change) {
    Given in;
    in.tool = as_input<double>(gripper);
    change(in.tool);
    const Status kinematics = forward_kinematics<Changing>(q, in).status, columns = jacobian<Changing>(q, in).status;
    EXPECT_EQ(kinematics.code, columns.code);
    EXPECT_EQ(columns.joint, -1);
    return columns.code;
  };
  EXPECT_EQ(status([](auto&) {}), Code::ok);
  for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)}) {
    EXPECT_EQ(status([&](auto& tool) { tool.position.y = bad; }), Code::input_limit);
    EXPECT_EQ(status([&](auto& tool) { tool.rotation.z.x = bad; }), Code::input_limit);
  }
  EXPECT_EQ(status([](auto& tool) { tool.position.z = 2000.0; }), Code::input_limit) << "millimetres, perhaps";
  EXPECT_EQ(status([](auto& tool) { tool.rotation.x.x += 0.01; }), Code::input_limit) << "not a unit vector";
  EXPECT_EQ(status([](auto& tool) { tool.rotation.z = -tool.rotation.z; }), Code::input_limit) << "a mirror";
  EXPECT_EQ(status([](auto& tool) { tool.rotation = {}; }), Code::input_limit) << "left out";
  EXPECT_EQ(status([](auto& tool) { tool.rotation.x.x += 1e-5; }), Code::ok) << "rounded";
}

TEST(RuntimeTool, OfARunTimeModelIsUnknownUntilItIsGiven) {
  using M = Model<2, RuntimeTool>;
  M model;
  ASSERT_TRUE(model.add(revolute().mass(1)) && model.add(revolute().a(1.0).mass(1)));
  const Joints<M, double> at{0.0, 0.0};
  Inputs<M, double> in;
  EXPECT_EQ(forward_kinematics(model, at, in).status.code, Code::input_limit);
  in.tool = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0.5, 0, 0}};
  EXPECT_TRUE(forward_kinematics(model, at, in).status.ok());
  EXPECT_EQ(forward_kinematics(model, at, in).tool.position.x, 1.5);
}

// The potential energy of a payload is m g z of its centre, which forward kinematics finds through the tool: its
// gradient is what the joints carry more.
TEST(MountedPayload, WeighsWhereTheToolHoldsIt) {
  Given in;
  in.tool = as_input<double>(gripper);
  const PayloadBody<double> held{2.0, {0.03, -0.04, 0.06}, {0.01, 0.02, 0.015, 0.001, -0.002, 0.003}};
  const auto empty = gravity_torque<Changing>(q, in);
  in.payload = mounted_payload(in.tool, held);
  const auto loaded = gravity_torque<Changing>(q, in);
  const auto height = [&](Joints<R, double> at) {
    const auto tool = forward_kinematics<Changing>(at, in).tool;
    return (tool.rotation * held.com + tool.position).z;
  };
  for (int i = 0; i < 7; ++i) {
    auto ahead = q, behind = q;
    ahead[i] += 1e-5, behind[i] -= 1e-5;
    const double slope = (height(ahead) - height(behind)) / 2e-5;
    EXPECT_NEAR(loaded[i] - empty[i], 2.0 * 9.81 * slope, 1e-8) << i;
  }
}

// The kinetic energy of the payload, from the motion of its centre and its turning in the tool's frame.
TEST(MountedPayload, HasTheEnergyThatTheToolGivesIt) {
  Given in;
  in.tool = as_input<double>(gripper);
  const PayloadBody<double> held{2.0, {0.03, -0.04, 0.06}, {0.01, 0.02, 0.015, 0.001, -0.002, 0.003}};
  const Joints<R, double> qd{0.5, -0.7, 0.9, 1.1, -0.8, 0.6, 1.3};
  const auto energy = [&] {
    const auto m = mass_matrix<Changing>(q, in);
    double sum = 0.0;
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < 7; ++j)
        sum += 0.5 * m(i, j) * qd[i] * qd[j];
    return sum;
  };
  const double empty = energy();
  const auto tool = forward_kinematics<Changing>(q, in).tool;
  const auto v = tool_velocity(jacobian<Changing>(q, in), qd);
  const auto centre = v.linear + cross(v.angular, tool.rotation * held.com);
  const auto w = transpose_times(tool.rotation, v.angular);
  const auto& j = held.inertia_com;
  const Vec3<double> momentum{j.xx * w.x + j.xy * w.y + j.xz * w.z, j.xy * w.x + j.yy * w.y + j.yz * w.z,
                              j.xz * w.x + j.yz * w.y + j.zz * w.z};
  in.payload = mounted_payload(in.tool, held);
  EXPECT_NEAR(energy() - empty, 0.5 * (2.0 * dot(centre, centre) + dot(w, momentum)), 1e-13);
}

TEST(MountedPayload, OfADeclaredToolNeedsNoInput) {
  const PayloadBody<double> held{2.0, {0.03, -0.04, 0.06}, {0.01, 0.02, 0.015, 0.001, -0.002, 0.003}};
  const auto given = mounted_payload(as_input<double>(gripper), held), declared = mounted_payload<Fitted>(held);
  expect_near(given.com, declared.com);
  EXPECT_EQ(given.inertia_com.yz, declared.inertia_com.yz);
  EXPECT_EQ(mounted_payload<R>(held).mass, 2.0);
}

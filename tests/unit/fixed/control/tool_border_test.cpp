// Tools and payloads in their frame, from real numbers to words: nearest, with a status, held to double.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <robots/panda.hpp>

#include <cmath>
#include <random>

using namespace axial;

namespace {

using Code = Status::Code;
using Word = std::int32_t;
using ToolPose = Pose<Mat3<Vec3<double>>, Vec3<double>>;

struct Arm {
  static constexpr auto chain = [] {
    auto c = robots::Panda::chain;
    c.payload_limit = payload_limit(3.0, 0.4, 0.05);
    c.tool_limit = tool_limit(7.0);
    return c;
  }();
};
struct Brim {
  static constexpr auto chain = [] {
    auto c = Arm::chain;
    c.payload_limit = payload_limit(3.0, 2147483646.4 / 4294967296.0, 0.05);
    return c;
  }();
};
using F = InputFormats<Arm, Fixed32>;

double real(const Fixed32& x, int exponent) { return std::ldexp(x.raw, -exponent); }
Vec3<double> real(const Vec3<Fixed32>& v, int exponent) {
  return {real(v.x, exponent), real(v.y, exponent), real(v.z, exponent)};
}
ToolPose real(const Pose<Mat3<Vec3<Fixed32>>, Vec3<Fixed32>>& tool) {
  const auto& r = tool.rotation;
  return {{real(r.x, F::sine_cosine), real(r.y, F::sine_cosine), real(r.z, F::sine_cosine)},
          real(tool.position, F::tool)};
}
PayloadBody<double> real(const PayloadBody<Fixed32>& load) {
  const auto& j = load.inertia_com;
  const auto of = [](const Fixed32& x) { return real(x, F::payload_inertia); };
  return {real(load.mass, F::payload_mass),
          real(load.com, F::payload_com),
          {of(j.xx), of(j.yy), of(j.zz), of(j.xy), of(j.xz), of(j.yz)}};
}

// A quarter turn about x behind `angle` about z: no symmetry hides an axis.
ToolPose gripper(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{c, 0, s}, {s, 0, -c}, {0, 1, 0}}, {0.05, -0.02, 0.15}};
}
const PayloadBody<double> can{2.0, {0.01, -0.02, 0.03}, {0.002, 0.003, 0.004, 0.0001, -0.0002, 0.0003}};

Code code_of(const ToolPose& tool) { return to_fixed_tool<Arm, Word>(tool).status.code; }

}  // namespace

TEST(FixedTool, IsTheNearestWords) {
  const ToolPose tool = gripper(0.3);
  const auto found = to_fixed_tool<Arm, Word>(tool);
  EXPECT_EQ(found.status.code, Code::ok);
  const ToolPose words = real(found.tool);
  const double turn = std::ldexp(0.5, -F::sine_cosine), length = std::ldexp(0.5, -F::tool);
  EXPECT_NEAR(words.rotation.x.x, tool.rotation.x.x, turn);
  EXPECT_NEAR(words.rotation.x.z, tool.rotation.x.z, turn);
  EXPECT_NEAR(words.rotation.y.z, tool.rotation.y.z, turn);
  EXPECT_NEAR(words.rotation.z.y, tool.rotation.z.y, turn);
  EXPECT_NEAR(words.position.x, tool.position.x, length);
  EXPECT_NEAR(words.position.y, tool.position.y, length);
  EXPECT_NEAR(words.position.z, tool.position.z, length);
}

TEST(FixedTool, ThatIsNoneHasAStatus) {
  ToolPose tool = gripper(0.3);
  EXPECT_EQ(code_of(tool), Code::ok);
  tool.position = {0.0, 7.0, 0.0};
  EXPECT_EQ(code_of(tool), Code::ok);
  tool.position = {0.0, 7.0, 0.1};
  EXPECT_EQ(code_of(tool), Code::input_limit);
  tool.position = {700.0, 0.0, 0.0};
  EXPECT_EQ(code_of(tool), Code::input_limit);
  const double skew = 1.0 / 256.0;  // axes of one length, the volume is 1 to 2^-17
  tool = {{{std::cos(skew), std::sin(skew), 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, {}};
  EXPECT_EQ(code_of(tool), Code::input_limit);
  tool = gripper(0.3), tool.rotation.z.y = std::nan("");
  EXPECT_EQ(code_of(tool), Code::not_finite);
  tool = gripper(0.3), tool.position.z = HUGE_VAL;
  EXPECT_EQ(code_of(tool), Code::not_finite);
  tool = gripper(0.3), tool.rotation.z.y = -1.0;
  EXPECT_EQ(code_of(tool), Code::input_limit);
}

TEST(FixedMountedPayload, IsThatOfItsWords) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  double worst_com = 0.0, worst_inertia = 0.0;
  for (int k = 0; k < 2000; ++k) {
    ToolPose tool = gripper(3.0 * any(random));
    tool.position = {0.15 * any(random), 0.15 * any(random), 0.15 * any(random)};
    PayloadBody<double> load = can;
    load.com = {0.08 * any(random), 0.08 * any(random), 0.08 * any(random)};
    const auto words = to_fixed_tool<Arm, Word>(tool);
    const auto held = to_fixed_payload<Arm, Word>(load);
    ASSERT_TRUE(words.status.ok() && held.status.ok());
    const auto found = mounted_payload<Arm>(words.tool, held.load);
    ASSERT_TRUE(found.status.ok());
    const auto exact = mounted_payload(real(words.tool), real(held.load)), mounted = real(found.load);
    EXPECT_EQ(mounted.mass, exact.mass);
    const double com[] = {mounted.com.x - exact.com.x, mounted.com.y - exact.com.y, mounted.com.z - exact.com.z};
    const auto &a = mounted.inertia_com, &b = exact.inertia_com;
    const double inertia[] = {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
    for (const double off : com)
      worst_com = std::fmax(worst_com, std::fabs(std::ldexp(off, F::payload_com)));
    for (const double off : inertia)
      worst_inertia = std::fmax(worst_inertia, std::fabs(std::ldexp(off, F::payload_inertia)));
  }
  EXPECT_LE(worst_com, 0.5 + 1e-6);  // units
  EXPECT_GT(worst_com, 0.4);
  EXPECT_LE(worst_inertia, 5.0);
  EXPECT_GT(worst_inertia, 1.0);
}

TEST(FixedMountedPayload, BeyondWhatTheRobotDeclaresHasAStatus) {
  const auto code = [](ToolPose tool, PayloadBody<double> load) {
    const auto words = to_fixed_tool<Arm, Word>(tool);
    const auto held = to_fixed_payload<Arm, Word>(load);
    EXPECT_TRUE(words.status.ok() && held.status.ok());
    return mounted_payload<Arm>(words.tool, held.load).status.code;
  };
  ToolPose tool = gripper(0.3);
  PayloadBody<double> load = can;
  EXPECT_EQ(code(tool, load), Code::ok);
  // R com + p: along z of the last link that is p.z + com.y.
  tool.position = {0.0, 0.0, 0.3}, load.com = {0.0, 0.0999, 0.0};
  EXPECT_EQ(code(tool, load), Code::ok);
  load.com.y = 0.1001;
  EXPECT_EQ(code(tool, load), Code::payload_limit);
  for (double away = 0.5; away < 7.0; away *= 1.07) {  // no wrapped word is taken for a payload
    tool.position.z = away;
    EXPECT_EQ(code(tool, load), Code::payload_limit) << away;
  }
  // An inertia that is within the limit along its own axes, and beyond along the last link's.
  tool = gripper(0.25 * 3.14159265358979), load = can;
  load.inertia_com = {0.045, 0.045, 0.045, 0.0, 0.04, 0.0};
  EXPECT_EQ(code(tool, load), Code::payload_limit);
}

// Where the declared reach is the largest word, what fits none is not taken for it.
TEST(FixedMountedPayload, BeyondTheLargestWordHasAStatus) {
  const auto tool = to_fixed_tool<Brim, Word>(ToolPose{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0.0, 0.0, 0.45}});
  PayloadBody<double> load = can;
  load.com = {0.0, 0.0, 0.2};
  const auto held = to_fixed_payload<Brim, Word>(load);
  ASSERT_TRUE(tool.status.ok() && held.status.ok());
  EXPECT_EQ(mounted_payload<Brim>(tool.tool, held.load).status.code, Code::payload_limit);
}

TEST(FixedMountedPayload, ByNoToolHasAStatus) {
  const auto held = to_fixed_payload<Arm, Word>(can);
  auto words = to_fixed_tool<Arm, Word>(gripper(0.3)).tool;
  words.rotation.x.x.raw += std::int32_t{1} << 22;
  EXPECT_EQ(mounted_payload<Arm>(words, held.load).status.code, Code::input_limit);
  for (Fixed32* each : {&words.rotation.x.x, &words.rotation.y.y, &words.position.z})
    each->raw = (std::numeric_limits<std::int32_t>::min)();
  EXPECT_EQ(mounted_payload<Arm>(words, held.load).status.code, Code::input_limit);
}

// J^T w and tools that change in fixed point: against integers of 128 bits, word by word, and against the oracle's
// poses and Jacobians in quadruple precision, within the certified errors.
#include <random>

#include <axial/fixed.hpp>
#include <robots/panda.hpp>
#include <robots/scara.hpp>

#include <property/support.hpp>

namespace {

using namespace axial;
using oracle::quad;

constexpr int states = 20'000;
constexpr unsigned seed = 2024;
using T = Fixed32;
using Push = ForceVector<Vec3<T>, Vec3<T>>;

/// A robot with a declared wrench at its tip, a tool beside the last axis, and room for others.
template <class R, int reach_mm = 300>
struct Pushed {
  static constexpr auto chain = [] {
    auto c = R::chain;
    c.tip_wrench_limit = tip_wrench_limit(60.0, 12.0);
    c.tool = tool(0.05, -0.02, 0.15);
    c.tool_limit = tool_limit(reach_mm / 1000.0);
    return c;
  }();
};

template <class R>
class FixedToolOf : public testing::Test {
 protected:
  std::mt19937 random{seed};

  std::int32_t word() { return static_cast<std::int32_t>(random()); }
  double unit() { return std::uniform_real_distribution<>(-1.0, 1.0)(random); }

  /// Anywhere within the limits.
  Positions<R, T> position() {
    Positions<R, T> q;
    for (int i = 0; i < q.size; ++i) {
      const auto& link = R::chain.links[i];
      const double mean = 0.5 * (link.position_min + link.position_max), half = link.position_max - mean;
      q[i].raw = link.type == JointType::revolute
                     ? word()
                     : static_cast<std::int32_t>(std::ldexp(mean + 0.999 * half * unit(), q.exponent(i)));
    }
    return q;
  }
  static quad value(const Positions<R, T>& q, int i) {
    const quad two_pi = quad(6.283185307179586232) + quad(2.449293598294706414e-16);  // to 106 bits
    return R::chain.links[i].type == JointType::revolute ? two_pi * quad(q[i].raw) / quad(4294967296.0)
                                                         : quad(std::ldexp(q[i].raw, -q.exponent(i)));
  }
  /// As long as declared, any way.
  Vec3<T> vector(double most, int exponent) {
    const double x = unit(), y = unit(), z = unit(), length = std::hypot(x, y, z);
    const auto part = [&](double v) { return T{static_cast<std::int32_t>(std::ldexp(most * v / length, exponent))}; };
    return {part(x), part(y), part(z)};
  }
  static quad part(const Vec3<T>& v, int i, int exponent) {
    return quad(std::ldexp(i == 0 ? v.x.raw : i == 1 ? v.y.raw : v.z.raw, -exponent));
  }
  template <class S>
  void expect_tool_within_bounds();
  static quad found(const WrenchEfforts<R, T>& tau, int i) { return quad(std::ldexp(tau[i].raw, -tau.exponent(i))); }
};
using Robots = testing::Types<Pushed<robots::Scara>, Pushed<robots::Panda>, Pushed<robots::Scara, 14000>>;  // a boom
TYPED_TEST_SUITE(FixedToolOf, Robots);

/// Words at the ends of their range and in it: nothing overflows, and the product of the words is rounded once.
TYPED_TEST(FixedToolOf, TransposeTimesIsTheProductOfItsWordsWhateverTheyAre) {
  using R = TypeParam;
  using F = InputFormats<R, T>;
  constexpr int turn = direction_exponent<T>, length = length_exponent<R, T>;
  constexpr std::int32_t ends[] = {(std::numeric_limits<std::int32_t>::max)(),
                                   (std::numeric_limits<std::int32_t>::min)()};
  quad worst = 0;
  for (int k = 0; k < states; ++k) {
    const auto j = jacobian<R>(this->position());
    const auto any = [&] { return T{k % 2 == 0 ? ends[this->word() & 1] : this->word()}; };
    const Push w{{any(), any(), any()}, {any(), any(), any()}};
    const auto tau = transpose_times(j, w);
    for (int i = 0; i < joint_count<R>; ++i) {
      quad exact = 0;
      for (int c = 0; c < 3; ++c)
        exact += this->part(j[i].angular, c, turn) * this->part(w.moment, c, F::tip_moment) +
                 this->part(j[i].linear, c, length) * this->part(w.force, c, F::tip_force);
      const quad off = (this->found(tau, i) - exact) * quad(std::ldexp(1.0, tau.exponent(i)));
      worst = off > worst ? off : -off > worst ? -off : worst;
    }
  }
  EXPECT_LE(static_cast<double>(worst), 0.5 + 1e-6) << "units of the result";
  EXPECT_GT(static_cast<double>(worst), 0.4);
}

TYPED_TEST(FixedToolOf, TransposeTimesStaysWithinItsCertifiedError) {
  using R = TypeParam;
  using F = InputFormats<R, T>;
  constexpr auto bound = error_bound<R, T>(algorithm::TransposeTimes{});
  const auto chain = oracle::of_robot<quad, R>();
  std::array<quad, joint_count<R>> worst{};
  for (int k = 0; k < states / 10; ++k) {
    const auto q = this->position();
    const Push w{this->vector(F::wrench.moment, F::tip_moment), this->vector(F::wrench.force, F::tip_force)};
    const auto j = jacobian<R>(q);
    ASSERT_TRUE(j.status.ok());
    const auto tau = transpose_times(j, w);
    oracle::Vector<quad> at;
    for (int i = 0; i < joint_count<R>; ++i)
      at.push_back(this->value(q, i));
    const auto exact = oracle::tool_jacobian(chain, at);
    for (int i = 0; i < joint_count<R>; ++i) {
      quad effort = 0;
      for (int c = 0; c < 3; ++c)
        effort += exact.angular(c, i) * this->part(w.moment, c, F::tip_moment) +
                  exact.linear(c, i) * this->part(w.force, c, F::tip_force);
      const quad off = this->found(tau, i) - effort;
      auto& most = worst[std::size_t(i)];
      most = off > most ? off : -off > most ? -off : most;
    }
  }
  for (int i = 0; i < joint_count<R>; ++i) {
    const double share = static_cast<double>(worst[std::size_t(i)]) / bound[i];
    EXPECT_LE(share, 1.0) << "joint " << i;
    EXPECT_GT(share, 0.01) << "joint " << i;
    this->RecordProperty("share_of_joint_" + std::to_string(i), std::to_string(share));
  }
}

/// What a rotation's words and a vector's say.
using ToolWords = Pose<Mat3<Vec3<T>>, Vec3<T>>;
template <class R>
using Changing = Scene<R, Gravity, RuntimeTool>;

oracle::Vec3<quad> spoken(const Vec3<T>& v, int exponent) {
  const auto part = [&](const T& x) { return quad(std::ldexp(x.raw, -exponent)); };
  return {part(v.x), part(v.y), part(v.z)};
}
/// A frame turned by three angles, at `most` from the origin; words rounded to nearest.
ToolWords turned(const double (&a)[3], const Vec3<T>& position) {
  const double c[] = {std::cos(a[0]), std::cos(a[1]), std::cos(a[2])},
               s[] = {std::sin(a[0]), std::sin(a[1]), std::sin(a[2])};
  const auto word = [](double x) {
    return T{static_cast<std::int32_t>(std::llround(std::ldexp(x, direction_exponent<T>)))};
  };
  return {{{word(c[0] * c[1]), word(c[0] * s[1] * s[2] - s[0] * c[2]), word(c[0] * s[1] * c[2] + s[0] * s[2])},
           {word(s[0] * c[1]), word(s[0] * s[1] * s[2] + c[0] * c[2]), word(s[0] * s[1] * c[2] - c[0] * s[2])},
           {word(-s[1]), word(c[1] * s[2]), word(c[1] * c[2])}},
          position};
}
template <class R>
oracle::Chain<quad> with_tool(const ToolWords& tool) {
  auto chain = oracle::of_robot<quad, R>();
  const auto x = spoken(tool.rotation.x, direction_exponent<T>), y = spoken(tool.rotation.y, direction_exponent<T>),
             z = spoken(tool.rotation.z, direction_exponent<T>);
  chain.tool = {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}, spoken(tool.position, InputFormats<R, T>::tool)};
  return chain;
}
quad larger(quad a, quad b) { return b > a ? b : -b > a ? -b : a; }
quad distance(const oracle::Vec3<quad>& a, const oracle::Vec3<quad>& b) {
  const auto off = a - b;
  return std::hypot(static_cast<double>(off.x), static_cast<double>(off.y), static_cast<double>(off.z));
}

template <class R>
template <class S>
void FixedToolOf<R>::expect_tool_within_bounds() {
  using F = InputFormats<R, T>;
  constexpr auto of_columns = error_bound<S, T>(algorithm::Jacobian{});
  constexpr auto of_tool = error_bound<S, T>(algorithm::ToolPose{});
  constexpr auto of_efforts = error_bound<S, T>(algorithm::TransposeTimes{});
  std::array<quad, joint_count<R>> column{}, effort{};
  quad position = 0, rotation = 0;
  for (int k = 0; k < states / 10; ++k) {
    const auto q = this->position();
    Inputs<S, T> in;
    in.tool = turned({3.0 * this->unit(), 3.0 * this->unit(), 3.0 * this->unit()},
                     this->vector(F::tool_limit.reach, F::tool));
    const Push w{this->vector(F::wrench.moment, F::tip_moment), this->vector(F::wrench.force, F::tip_force)};
    const auto chain = with_tool<R>(in.tool);
    oracle::Vector<quad> at;
    for (int i = 0; i < joint_count<R>; ++i)
      at.push_back(this->value(q, i));
    const auto j = jacobian<S>(q, in);
    const auto pose = forward_kinematics<S>(q, in);
    ASSERT_TRUE(j.status.ok() && pose.status.ok());
    const auto tau = transpose_times(j, w);
    const auto exact = oracle::tool_jacobian(chain, at);
    const auto there = oracle::tool_pose(chain, at);
    position = larger(position, distance(spoken(pose.tool.position, length_exponent<S, T>), there.position));
    const auto& axes = pose.tool.rotation;
    const Vec3<T> rows[] = {axes.x, axes.y, axes.z};
    const oracle::Vec3<quad> columns[] = {there.rotation.c0, there.rotation.c1, there.rotation.c2};
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        rotation = larger(rotation, this->part(rows[r], c, direction_exponent<T>) - (r == 0   ? columns[c].x
                                                                                     : r == 1 ? columns[c].y
                                                                                              : columns[c].z));
    for (int i = 0; i < joint_count<R>; ++i) {
      auto& most = column[std::size_t(i)];
      const oracle::Vec3<quad> linear{exact.linear(0, i), exact.linear(1, i), exact.linear(2, i)};
      most = larger(most, distance(spoken(j[i].linear, length_exponent<S, T>), linear));
      quad exerted = 0;
      for (int c = 0; c < 3; ++c)
        exerted += exact.angular(c, i) * this->part(w.moment, c, F::tip_moment) +
                   exact.linear(c, i) * this->part(w.force, c, F::tip_force);
      effort[std::size_t(i)] = larger(effort[std::size_t(i)], this->found(tau, i) - exerted);
    }
  }
  EXPECT_LE(static_cast<double>(position), of_tool.position);
  EXPECT_GT(static_cast<double>(position), 0.02 * of_tool.position);
  EXPECT_LE(static_cast<double>(rotation), of_tool.rotation);
  EXPECT_GT(static_cast<double>(rotation), 0.02 * of_tool.rotation);
  for (int i = 0; i < joint_count<R>; ++i) {
    SCOPED_TRACE(i);
    EXPECT_LE(static_cast<double>(column[std::size_t(i)]), of_columns[i]);
    EXPECT_LE(static_cast<double>(effort[std::size_t(i)]), of_efforts[i]);
    EXPECT_GT(static_cast<double>(effort[std::size_t(i)]), 0.01 * of_efforts[i]);
  }
}

TYPED_TEST(FixedToolOf, RuntimeToolStaysWithinItsCertifiedErrors) {
  this->template expect_tool_within_bounds<Changing<TypeParam>>();
}
TYPED_TEST(FixedToolOf, RuntimeToolByUpperWordsAndInALoopStaysWithinItsCertifiedErrors) {
  this->template expect_tool_within_bounds<Scene<TypeParam, Gravity, RuntimeTool, HighWord, Looped>>();
}

/// Two booms whose lengths have one format: what the turns of the arm are off, a quarter of a unit at least, is off the
/// further, the longer a tool may be.
TEST(FixedTool, ErrorsGrowWithTheDeclaredReach) {
  using Short = Changing<Pushed<robots::Scara, 8000>>;
  using Long = Changing<Pushed<robots::Scara, 14000>>;
  static_assert(length_exponent<Short, T> == length_exponent<Long, T>);
  const double unit = std::ldexp(1.0, -direction_exponent<T>);
  EXPECT_GT(error_bound<Long>(algorithm::ToolPose{}).position,
            error_bound<Short>(algorithm::ToolPose{}).position + 6.0 * 0.25 * unit);
  EXPECT_GT(error_bound<Long>(algorithm::Jacobian{})[0],
            error_bound<Short>(algorithm::Jacobian{})[0] + 6.0 * 0.25 * unit);
}

TYPED_TEST(FixedToolOf, RuntimeToolStartsAsTheRobotDeclaresIt) {
  using R = TypeParam;
  using S = Changing<R>;
  static_assert(length_exponent<S, T> == length_exponent<R, T>, "a Jacobian does not say which tool it is of");
  const auto near = [](const T& a, const T& b) { EXPECT_NEAR(a.raw, b.raw, 2); };
  for (int k = 0; k < 100; ++k) {
    const auto q = this->position();
    const auto found = forward_kinematics<S>(q, {}), declared = forward_kinematics<R>(q);
    near(found.tool.position.x, declared.tool.position.x), near(found.tool.position.z, declared.tool.position.z);
    near(found.tool.rotation.y.x, declared.tool.rotation.y.x);
  }
}

TYPED_TEST(FixedToolOf, RuntimeToolThatIsNoneOrTooFarIsRefused) {
  using R = TypeParam;
  using S = Changing<R>;
  using F = InputFormats<R, T>;
  const auto q = this->position();
  constexpr std::int32_t one = std::int32_t{1} << direction_exponent<T>;
  const auto code = [&](const auto& change) {
    Inputs<S, T> in;
    in.tool = turned({0.3, -0.4, 0.5}, in.tool.position);
    change(in.tool);
    const auto found = jacobian<S>(q, in).status.code;
    EXPECT_EQ(found, forward_kinematics<S>(q, in).status.code);
    return found;
  };
  using Code = Status::Code;
  const auto reach = static_cast<std::int32_t>(std::ldexp(F::tool_limit.reach, F::tool));
  EXPECT_EQ(code([](auto&) {}), Code::ok);
  EXPECT_EQ(code([&](auto& tool) { tool.position = {{0}, {reach}, {0}}; }), Code::ok);
  EXPECT_EQ(code([&](auto& tool) { tool.position = {{0}, {reach}, {reach / 1000}}; }), Code::input_limit);
  EXPECT_EQ(code([&](auto& tool) { tool.position.x.raw = (std::numeric_limits<std::int32_t>::min)(); }),
            Code::input_limit);
  EXPECT_EQ(code([](auto& tool) { std::swap(tool.rotation.x, tool.rotation.y); }), Code::input_limit);  // left-handed
  EXPECT_EQ(code([](auto& tool) { tool.rotation.z.z.raw += one / 500; }), Code::input_limit);
  EXPECT_EQ(code([](auto& tool) { tool.rotation = {}; }), Code::input_limit);
  EXPECT_EQ(code([](auto& tool) { tool.rotation.x = tool.rotation.y; }), Code::input_limit);
  for (int entry = 0; entry < 9; ++entry)  // as words at their ends, which no sum overflows with
    EXPECT_EQ(code([&](auto& tool) {
                T* const all[] = {&tool.rotation.x.x, &tool.rotation.x.y, &tool.rotation.x.z,
                                  &tool.rotation.y.x, &tool.rotation.y.y, &tool.rotation.y.z,
                                  &tool.rotation.z.x, &tool.rotation.z.y, &tool.rotation.z.z};
                for (int i = 0; i <= entry; ++i)
                  all[i]->raw = (std::numeric_limits<std::int32_t>::min)();
              }),
              Code::input_limit);
}

}  // namespace

// A robot on a free body: every form of forward dynamics against the oracle with six virtual joints, the base's wrench,
// and what says that the base is singular.
#include <cases/to_axial.hpp>
#include <oracle/floating_base.hpp>

#include <property/algorithms/scene_robot.hpp>

namespace {

using namespace axial;
using oracle::quad;
using property::Fill;
using property::joints;

template <class T>
constexpr double torque_tolerance = std::is_same_v<T, double> ? 1e-13 : 5e-6;
// The solution amplifies rounding by the conditioning of the whole mass matrix.
template <class T>
constexpr double acceleration_tolerance = std::is_same_v<T, double> ? 1e-11 : 1e-4;

struct Vehicle {
  static constexpr auto chain = [] {
    auto chain = property::Everything::chain;
    chain.base_body = base_body()
                          .mass(12.0)
                          .com(0.125, -0.0625, 0.25)
                          .inertia_com(1.5, 2.25, 1.75, 0.125, -0.25, 0.0625)
                          .parameters();
    chain.has_base_body = true;
    return chain;
  }();
};
/// The same with an arm on either side: two root links.
struct TwoArms {
  static constexpr auto chain = [] {
    auto chain = Vehicle::chain;
    chain.links[2].parent = LinkParameters::base;
    return chain;
  }();
};

template <class R, class... Features>
struct Named {
  using Robot = R;
  using Unrolled = Scene<R, FloatingBase, Features...>;
  using Compact = Scene<R, FloatingBase, Features..., Looped>;
  using RunTime = Model<4, FloatingBase, Features...>;
};

struct Sample {
  oracle::Vector<double> q, qd, tau, base;
};
Sample sample(oracle::RandomChains& random) {
  return {random.vector(4, 3.0), random.vector(4, 2.0), random.vector(4, 20.0), random.vector(12, 3.0)};
}

template <class S, class T>
Inputs<S, T> inputs(const Sample& s) {
  auto in = Fill::inputs<S, T>(joints<robot_of<S>, T>(s.q));
  const auto b = [&](int i) { return T(s.base[static_cast<std::size_t>(i)]); };
  in.base_motion.angular_velocity = {b(0), b(1), b(2)};
  if constexpr (scene_of<S>::template has<BaseWrench>) in.base_wrench = {{b(6), b(7), b(8)}, {b(9), b(10), b(11)}};
  return in;
}

oracle::Vec3<quad> at(const oracle::Vector<double>& v, std::size_t i) { return {v[i], v[i + 1], v[i + 2]}; }

/// The oracle's view of a sample: accelerations of the joints and of frame 0, in one vector.
template <class S, class Robot>
struct Reference {
  static oracle::Chain<quad> chain() {
    auto chain = Fill::chain<S, Robot>();
    for (int i = 0; i < 4; ++i)
      chain.links[static_cast<std::size_t>(i)].parent = Robot::chain.parent(i);
    return chain;
  }
  explicit Reference(const Sample& s)
      : floating(chain(), oracle::link_from_axial<quad>(Robot::chain.base_body, -1)), velocity{at(s.base, 0), {}} {
    const oracle::Wrench<quad> push{at(s.base, 9), at(s.base, 6)};
    load = floating.load(Fill::load<S>(), scene_of<S>::template has<BaseWrench> ? push : oracle::Wrench<quad>{});
    q = floating.positions(oracle::convert<quad>(s.q));
    qd = floating.rates(velocity, oracle::convert<quad>(s.qd));
  }
  oracle::Vector<quad> accelerations(const Sample& s) const {
    oracle::Vector<quad> tau(6, quad(0));
    tau.insert(tau.end(), s.tau.begin(), s.tau.end());
    const auto second = oracle::forward_dynamics(floating.whole(), q, qd, tau, load);
    const auto base = floating.acceleration(velocity, second);
    oracle::Vector<quad> all(second.begin() + 6, second.end());
    for (const auto& v : {base.angular, base.linear})
      all.insert(all.end(), {v.x, v.y, v.z});
    return all;
  }
  oracle::FloatingChain<quad> floating;
  oracle::BaseTwist<quad> velocity;
  oracle::Load<quad> load;
  oracle::Vector<quad> q, qd;
};

template <class T>
void append(oracle::Vector<T>& all, const Vec3<T>& v) {
  all.insert(all.end(), {v.x, v.y, v.z});
}
template <class Result>
auto all_of(const Result& result) {
  auto all = property::vector(result, 4);
  append(all, result.base_acceleration.angular);
  append(all, result.base_acceleration.linear);
  return all;
}

template <class T, class S, class Robot, class Forward, class Inverse, class Wrenching>
void expect_form(const Sample& s, Inputs<S, T> in, const Forward& forward, const Inverse& inverse,
                 const Wrenching& wrench) {
  using J = Joints<robot_of<S>, T>;
  const auto result = forward(in);
  EXPECT_TRUE(result.status.ok());
  EXPECT_LE(oracle::relative_error(all_of(result), Reference<S, Robot>(s).accelerations(s)), acceleration_tolerance<T>);
  in.base_motion.angular_acceleration = result.base_acceleration.angular;
  in.base_motion.linear_acceleration = result.base_acceleration.linear;
  const J qdd = result;
  EXPECT_LE(oracle::relative_error(property::vector(inverse(qdd, in), 4), s.tau), acceleration_tolerance<T>)
      << "inverse dynamics undoes it";
  const Wrench<T> left = wrench(qdd, in);
  const double scale = 12.0 * oracle::largest(all_of(result));  // kg: the body's mass and inertia are of that size
  for (const T x : {left.moment.x, left.moment.y, left.moment.z, left.force.x, left.force.y, left.force.z})
    EXPECT_LE(std::abs(double(x)), acceleration_tolerance<T> * scale) << "nothing pushes a free base";
}

template <class S, class Robot, class T>
void expect_scene(const Sample& s) {
  const auto q = joints<Robot, T>(s.q), qd = joints<Robot, T>(s.qd), tau = joints<Robot, T>(s.tau);
  expect_form<T, S, Robot>(
      s, inputs<S, T>(s), [&](const auto& in) { return forward_dynamics<S>(q, qd, tau, in); },
      [&](const auto& qdd, const auto& in) { return inverse_dynamics<S>(q, qd, qdd, in); },
      [&](const auto& qdd, const auto& in) { return base_wrench<S>(q, qd, qdd, in); });
}
template <class M, class Robot>
void expect_model(const Sample& s) {
  M model;
  for (const auto& link : Robot::chain.links)
    ASSERT_TRUE(model.add(link));
  model.set_base_body(Robot::chain.base_body);
  const auto q = joints<M, double>(s.q), qd = joints<M, double>(s.qd), tau = joints<M, double>(s.tau);
  expect_form<double, M, Robot>(
      s, inputs<M, double>(s), [&](const auto& in) { return forward_dynamics(model, q, qd, tau, in); },
      [&](const auto& qdd, const auto& in) { return inverse_dynamics(model, q, qd, qdd, in); },
      [&](const auto& qdd, const auto& in) { return base_wrench(model, q, qd, qdd, in); });
}

template <class N>
class FloatingBases : public testing::Test {};
using All = testing::Types<Named<Vehicle>, Named<Vehicle, RuntimeGravity, RotorInertia>,
                           Named<TwoArms, RuntimeGravity, BaseWrench>,
                           Named<Vehicle, RuntimeGravity, RotorInertia, Friction, JointSprings, TipWrench,
                                 ExternalWrenches, SineCosines, BaseWrench, ArticulatedBody>>;
TYPED_TEST_SUITE(FloatingBases, All);

}  // namespace

TYPED_TEST(FloatingBases, EqualTheOracleInEveryForm) {
  using Robot = typename TypeParam::Robot;
  oracle::RandomChains random(41);
  for (int k = 0; k < 25; ++k) {
    SCOPED_TRACE(k);
    const Sample s = sample(random);
    expect_scene<typename TypeParam::Unrolled, Robot, double>(s);
    expect_scene<typename TypeParam::Compact, Robot, double>(s);
    expect_scene<typename TypeParam::Compact, Robot, float>(s);
    expect_model<typename TypeParam::RunTime, Robot>(s);
  }
}

// For any motion, not only the free one.
TEST(BaseWrench, EqualsTheOracle) {
  using S = Scene<TwoArms, FloatingBase, RuntimeGravity, RotorInertia, axial::BaseWrench, TipWrench>;
  oracle::RandomChains random(42);
  for (int k = 0; k < 25; ++k) {
    SCOPED_TRACE(k);
    const Sample s = sample(random);
    const auto qdd = random.vector(4, 4.0), base = random.vector(6, 4.0);
    const Reference<S, TwoArms> reference(s);
    const oracle::BaseTwist<quad> acceleration{at(base, 0), at(base, 3)};
    const auto generalised = oracle::inverse_dynamics(
        reference.floating.whole(), reference.q, reference.qd,
        reference.floating.second_rates(reference.velocity, acceleration, oracle::convert<quad>(qdd)), reference.load);
    const auto expected = reference.floating.wrench(generalised);
    auto in = inputs<S, double>(s);
    in.base_motion.angular_acceleration = {base[0], base[1], base[2]};
    in.base_motion.linear_acceleration = {base[3], base[4], base[5]};
    const auto w =
        base_wrench<S>(joints<TwoArms, double>(s.q), joints<TwoArms, double>(s.qd), joints<TwoArms, double>(qdd), in);
    oracle::Vector<double> ours;
    append(ours, w.moment), append(ours, w.force);
    const auto& [n, f] = expected;
    EXPECT_LE(oracle::relative_error(ours, oracle::Vector<quad>{n.x, n.y, n.z, f.x, f.y, f.z}),
              torque_tolerance<double>);
  }
}

// The same force is what a fixed mount bears; at rest that is the weight.
TEST(BaseWrench, OfAFixedRobotAtRestIsItsWeight) {
  using S = Scene<property::Everything, Gravity>;
  const Joints<property::Everything, double> q{0.3, -0.4, 1.1, 0.7}, still{};
  const auto w = base_wrench<S>(q, still, still);
  double mass = 0.0;
  for (const auto& link : property::Everything::chain.links)
    mass += link.mass;
  const auto& g = property::Everything::chain.gravity;
  EXPECT_NEAR(w.force.x, -mass * g.x, 1e-12);
  EXPECT_NEAR(w.force.y, -mass * g.y, 1e-12);
  EXPECT_NEAR(w.force.z, -mass * g.z, 1e-12);
}

namespace {

/// A point mass at the end of a slide on a body that has mass, and inertia only about two axes.
struct Needle {
  static constexpr auto chain =
      axial::chain(base_body().mass(2.0).inertia_com(0.5, 0.5, 0.0), prismatic().mass(1.5).com(0.0, 0.0, 0.5));
};
struct Rod {
  static constexpr auto chain =
      axial::chain(base_body().mass(2.0).inertia_com(0.5, 0.5, 1e-6), prismatic().mass(1.5).com(0.0, 0.0, 0.5));
};

}  // namespace

TEST(FloatingBase, ThatNothingResistsIsNamed) {
  const Joints<Needle, double> q{0.25}, qd{}, tau{3.0};
  const auto needle = forward_dynamics<Scene<Needle, axial::FloatingBase>>(q, qd, tau, {});
  EXPECT_EQ(needle.status.code, Status::Code::near_singular);
  EXPECT_EQ(needle.status.joint, -1);
  EXPECT_NEAR(needle[0], 3.0 / 1.5 + 3.0 / 2.0, 1e-12) << "the rest is solved all the same";
  EXPECT_NEAR(needle.base_acceleration.linear.z, -3.0 / 2.0, 1e-12);
  const Joints<Rod, double> rod_q{0.25}, rod_qd{}, rod_tau{3.0};
  EXPECT_TRUE((forward_dynamics<Scene<Rod, axial::FloatingBase>>(rod_q, rod_qd, rod_tau, {}).status.ok()));
}

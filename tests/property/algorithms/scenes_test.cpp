// Every feature of a scene against the oracle: torques unrolled, looped and of a run-time model; ABA undoes them.
#include <cases/to_axial.hpp>

#include "scene_robot.hpp"

namespace {

using namespace axial;
using oracle::quad;
using property::Everything;
using property::Fill;
using property::joints;

template <class T>
constexpr double torque_tolerance = std::is_same_v<T, double> ? 1e-13 : 5e-6;
template <class T>
constexpr double acceleration_tolerance = std::is_same_v<T, double> ? 1e-11 : 1e-4;

template <class... Features>
struct Named {
  using Unrolled = Scene<Everything, Features...>;
  using Compact = Scene<Everything, Features..., Looped>;
  using RunTime = Model<4, Features..., Looped>;
};

struct Sample {
  oracle::Vector<double> q, qd, qdd;
};
// One joint at rest, one slower than every smooth speed.
Sample sample(oracle::RandomChains& random, int k) {
  Sample s{random.vector(4, 3.0), random.vector(4, 2.0), random.vector(4, 4.0)};
  s.qdd[0] += 5.0;
  s.qd[static_cast<std::size_t>(k) % 4] = 0.0;
  s.qd[static_cast<std::size_t>(k + 1) % 4] *= 0.125;
  return s;
}

template <class S>
oracle::Vector<quad> reference(const Sample& s) {
  using oracle::convert;
  return oracle::inverse_dynamics_on_moving_base(Fill::chain<S, Everything>(), Fill::base_motion<S>(),
                                                 convert<quad>(s.q), convert<quad>(s.qd), convert<quad>(s.qdd),
                                                 Fill::load<S>());
}

template <class T, class Dynamics>
void expect_undone(const Dynamics& result, const Sample& s) {
  EXPECT_TRUE(result.status.ok());
  EXPECT_LE(oracle::relative_error(oracle::Vector<T>(result.values, result.values + 4), s.qdd),
            acceleration_tolerance<T>);
}

template <class S, class T>
void expect_scene(const Sample& s) {
  const auto q = joints<Everything, T>(s.q), qd = joints<Everything, T>(s.qd), qdd = joints<Everything, T>(s.qdd);
  const auto in = Fill::inputs<S, T>(q);
  const auto tau = inverse_dynamics<S>(q, qd, qdd, in);
  EXPECT_LE(oracle::relative_error(property::vector(tau), reference<S>(s)), torque_tolerance<T>);
  expect_undone<T>(forward_dynamics<S>(q, qd, tau, in), s);
}

template <class M>
void expect_model(const Sample& s) {
  const M model = cases::to_model<M>(oracle::from_axial<double>(Everything::chain));
  const auto q = joints<M, double>(s.q), qd = joints<M, double>(s.qd), qdd = joints<M, double>(s.qdd);
  const auto in = Fill::inputs<M, double>(q);
  const auto tau = inverse_dynamics(model, q, qd, qdd, in);
  EXPECT_LE(oracle::relative_error(property::vector(tau), reference<M>(s)), torque_tolerance<double>);
  expect_undone<double>(forward_dynamics(model, q, qd, tau, in), s);
}

template <class N>
class Features : public testing::Test {};
using All =
    testing::Types<Named<FullParameters>, Named<RotorInertia>, Named<RuntimeGravity>, Named<Gravity, BaseMotion>,
                   Named<ExternalWrenches>, Named<TipWrench, ExternalWrenches>, Named<Friction>, Named<JointSprings>,
                   Named<SineCosines, Gravity>, Named<RuntimeGravity, BaseMotion, RotorInertia, BaseParameters>,
                   Named<RuntimeGravity, BaseMotion, RotorInertia, Friction, JointSprings, TipWrench, ExternalWrenches,
                         SineCosines, ArticulatedBody>,
                   Named<RuntimeGravity, BaseMotion, RotorInertia, Friction, JointSprings, TipWrench, ExternalWrenches,
                         SineCosines, SplitArticulatedBody>,
                   Named<RuntimeGravity, BaseMotion, RotorInertia, Friction, JointSprings, TipWrench, ExternalWrenches,
                         SineCosines, CompositeBody>>;
TYPED_TEST_SUITE(Features, All);

}  // namespace

TYPED_TEST(Features, EqualTheOracleAndAreUndoneInEveryForm) {
  oracle::RandomChains random(3);
  for (int k = 0; k < 40; ++k) {
    const Sample s = sample(random, k);
    SCOPED_TRACE(k);
    expect_scene<typename TypeParam::Unrolled, double>(s);
    expect_scene<typename TypeParam::Compact, double>(s);
    expect_model<typename TypeParam::RunTime>(s);
  }
}

TYPED_TEST(Features, EqualTheOracleAndAreUndoneInFloat) {
  oracle::RandomChains random(4);
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    expect_scene<typename TypeParam::Compact, float>(sample(random, k));
  }
}

// M(q) knows nothing of gravity, base motion, friction or springs.
TEST(Scenes, MassMatrixIsThatOfTheBareRobot) {
  using S = Scene<Everything, RuntimeGravity, BaseMotion, RotorInertia, Friction, JointSprings, SineCosines>;
  oracle::RandomChains random(5);
  const auto q = joints<Everything, double>(random.vector(4, 3.0));
  const auto m = mass_matrix<S>(q, Fill::inputs<S, double>(q)), bare = mass_matrix<Everything>(q);
  EXPECT_LE(oracle::relative_error(property::matrix(m), property::matrix(bare)), 1e-14);
}

TEST(Scenes, SineCosinesServeKinematicsToo) {
  using S = Scene<Everything, SineCosines>;
  oracle::RandomChains random(6);
  const auto q = joints<Everything, double>(random.vector(4, 3.0));
  Inputs<S, double> in;
  EXPECT_FALSE(is_finite(forward_kinematics<S>(q, in).tool.position.x)) << "pairs that nobody gave are not numbers";
  in.turns = sine_cosines<Everything>(q);
  const auto handed = forward_kinematics<S>(q, in), own = forward_kinematics<Everything>(q);
  EXPECT_NEAR(handed.tool.position.x, own.tool.position.x, 1e-15);
  EXPECT_NEAR(handed.tool.position.z, own.tool.position.z, 1e-15);
  EXPECT_NEAR(jacobian<S>(q, in)[0].linear.y, jacobian<Everything>(q)[0].linear.y, 1e-15);
}

// Links and a body underwater: every form against Lagrange's equations of chain and water, on a fixed base, a given one
// and a free one.
#include <oracle/floating_base.hpp>
#include <oracle/submerged.hpp>

#include <property/algorithms/scene_robot.hpp>

namespace {

using namespace axial;
using oracle::quad;
using property::Fill;
using property::joints;

template <class T>
constexpr double torque_tolerance = std::is_same_v<T, double> ? 1e-12 : 1e-5;
template <class T>
constexpr double acceleration_tolerance = std::is_same_v<T, double> ? 1e-11 : 2e-4;

constexpr void immerse(LinkParameters& p, int i) {
  const double k = 1.0 + 0.25 * i;
  Link water = revolute()
                   .added_mass(0.5 * k, 1.75, 2.5 * k, 0.0625, 0.125 * k, 0.03125)
                   .buoyancy(1.25 * k, 0.0625, -0.125, 0.03125 * k)
                   .drag_linear(2.0, 3.0 * k, 1.5, 0.25, 0.5, 0.125)
                   .drag_quadratic(8.0, 12.0, 16.0 * k, 0.5, 0.25, 0.125 * k);
  p.water = water.parameters().water;
}
struct Diver {
  static constexpr auto chain = [] {
    auto chain = property::Everything::chain;
    for (int i = 0; i < 4; ++i)
      immerse(chain.links[i], i);
    chain.base_body = base_body()
                          .mass(12.0)
                          .com(0.125, -0.0625, 0.25)
                          .inertia_com(1.5, 2.25, 1.75, 0.125, -0.25, 0.0625)
                          .parameters();
    immerse(chain.base_body, 8);
    chain.has_base_body = true;
    return chain;
  }();
};

template <class... Features>
struct Named {
  using Unrolled = Scene<Diver, Underwater, Features...>;
  using Compact = Scene<Diver, Underwater, Features..., Looped>;
  using RunTime = Model<4, Underwater, Features...>;
};

struct Sample {
  oracle::Vector<double> q, qd, qdd, base;
};
Sample sample(oracle::RandomChains& random) {
  return {random.vector(4, 3.0), random.vector(4, 2.0), random.vector(4, 4.0), random.vector(12, 2.0)};
}

template <class S>
constexpr bool moves = scene_of<S>::template has<BaseMotion> || scene_of<S>::template has<FloatingBase>;

template <class S, class T>
Inputs<S, T> inputs(const Sample& s) {
  auto in = Fill::inputs<S, T>(joints<robot_of<S>, T>(s.q));
  const auto vector = [&](std::size_t i) { return Vec3<T>{T(s.base[i]), T(s.base[i + 1]), T(s.base[i + 2])}; };
  if constexpr (moves<S>) in.base_motion = {vector(0), vector(6), vector(9)};
  if constexpr (scene_of<S>::template has<VelocityThroughWater>) in.velocity_through_water = vector(3);
  return in;
}

oracle::Vec3<quad> at(const oracle::Vector<double>& v, std::size_t i) { return {v[i], v[i + 1], v[i + 2]}; }

/// Chain and water with six virtual joints, which also carry a fixed base through a current.
template <class S>
struct Reference {
  static oracle::Chain<quad> dry_chain() { return Fill::chain<S, Diver>(); }
  static oracle::FloatingChain<quad> floating_chain() {
    auto body = oracle::link_from_axial<quad>(Diver::chain.base_body, -1);
    return {dry_chain(), body};
  }
  static oracle::Vector<oracle::Water<quad>> waters() {
    oracle::Vector<oracle::Water<quad>> all(6);
    all[5] = oracle::water_from_axial<quad>(Diver::chain.base_body.water);
    for (const auto& link : Diver::chain.links)
      all.push_back(oracle::water_from_axial<quad>(link.water));
    return all;
  }
  explicit Reference(const Sample& s) : floating(floating_chain()), wet(floating.whole(), waters()) {
    if (moves<S>) velocity.angular = at(s.base, 0), acceleration = {at(s.base, 6), at(s.base, 9)};
    if (scene_of<S>::template has<VelocityThroughWater>) velocity.linear = at(s.base, 3);
    q = floating.positions(oracle::convert<quad>(s.q));
    qd = floating.rates(velocity, oracle::convert<quad>(s.qd));
    load = floating.load(Fill::load<S>(), {});
  }
  oracle::Vector<quad> generalised(const oracle::Vector<quad>& second) const {
    auto tau = oracle::inverse_dynamics(floating.whole(), q, qd, second, load);
    const auto water = wet.torque(q, qd, second);
    for (std::size_t i = 0; i < tau.size(); ++i)
      tau[i] += water[i];
    return tau;
  }
  oracle::Vector<quad> torque(const Sample& s) const {
    const auto all = generalised(floating.second_rates(velocity, acceleration, oracle::convert<quad>(s.qdd)));
    return {all.begin() + 6, all.end()};
  }
  oracle::Matrix<quad> whole_mass() const {
    auto M = oracle::mass_matrix(floating.whole(), q);
    const auto added = wet.added_mass(q);
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j)
        M(i, j) += added(i, j);
    return M;
  }
  oracle::Matrix<quad> mass() const {
    const auto M = whole_mass();
    oracle::Matrix<quad> arm(4, 4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        arm(i, j) = M(i + 6, j + 6);
    return arm;
  }
  /// Of the joints and of a free base, when the joints are driven with s.qdd as efforts.
  oracle::Vector<quad> free_accelerations(const Sample& s) const {
    auto drive = generalised(oracle::Vector<quad>(10, quad(0)));
    for (std::size_t i = 0; i < 10; ++i)
      drive[i] = (i < 6 ? quad(0) : quad(s.qdd[i - 6])) - drive[i];
    const auto second = oracle::solve(whole_mass(), drive);
    const auto base = floating.acceleration(velocity, second);
    return {second[6],      second[7],      second[8],     second[9],     base.angular.x,
            base.angular.y, base.angular.z, base.linear.x, base.linear.y, base.linear.z};
  }

  oracle::FloatingChain<quad> floating;
  oracle::SubmergedChain<quad> wet;
  oracle::BaseTwist<quad> velocity{}, acceleration{};
  oracle::Load<quad> load;
  oracle::Vector<quad> q, qd;
};

template <class S, class T>
void expect_scene(const Sample& s) {
  const auto q = joints<Diver, T>(s.q), qd = joints<Diver, T>(s.qd), qdd = joints<Diver, T>(s.qdd);
  const auto in = inputs<S, T>(s);
  const Reference<S> reference(s);
  const auto tau = inverse_dynamics<S>(q, qd, qdd, in);
  EXPECT_LE(oracle::relative_error(property::vector(tau), reference.torque(s)), torque_tolerance<T>);
  EXPECT_EQ((joint_torque<S, 2>(q, qd, qdd, in)), tau[2]);
  EXPECT_LE(oracle::relative_error(oracle::elements(property::matrix(mass_matrix<S>(q, in))),
                                   oracle::elements(reference.mass())),
            torque_tolerance<T>);
  if constexpr (scene_of<S>::template has<FloatingBase>) {
    const auto free = forward_dynamics<S>(q, qd, qdd, in);
    const auto& [w, a] = free.base_acceleration;
    EXPECT_TRUE(free.status.ok());
    auto ours = property::vector(free);
    ours.insert(ours.end(), {w.x, w.y, w.z, a.x, a.y, a.z});
    EXPECT_LE(oracle::relative_error(ours, reference.free_accelerations(s)), acceleration_tolerance<T>);
    auto moved = in;
    moved.base_motion.angular_acceleration = w, moved.base_motion.linear_acceleration = a;
    const auto [n, f] = base_wrench<S>(q, qd, free, moved);
    const double scale = 20.0 * oracle::largest(ours);  // kg: body and water are of that size
    for (const T x : {n.x, n.y, n.z, f.x, f.y, f.z})
      EXPECT_LE(std::abs(double(x)), acceleration_tolerance<T> * scale) << "nothing else pushes a free base";
  } else {
    const auto back = forward_dynamics<S>(q, qd, tau, in);
    EXPECT_TRUE(back.status.ok());
    EXPECT_LE(oracle::relative_error(property::vector(back), s.qdd), acceleration_tolerance<T>);
  }
}
template <class M>
void expect_model(const Sample& s) {
  M model;
  for (const auto& link : Diver::chain.links)
    ASSERT_TRUE(model.add(link));
  model.set_base_body(Diver::chain.base_body);
  const auto& g = Diver::chain.gravity;
  model.set_gravity(g.x, g.y, g.z);
  const auto q = joints<M, double>(s.q), qd = joints<M, double>(s.qd), qdd = joints<M, double>(s.qdd);
  const auto in = inputs<M, double>(s);
  const auto tau = inverse_dynamics(model, q, qd, qdd, in);
  EXPECT_LE(oracle::relative_error(property::vector(tau), Reference<M>(s).torque(s)), torque_tolerance<double>);
  EXPECT_TRUE(forward_dynamics(model, q, qd, tau, in).status.ok());
}

template <class N>
class UnderwaterScenes : public testing::Test {};
using All = testing::Types<Named<>, Named<Gravity>, Named<Gravity, BaseParameters, RotorInertia>,
                           Named<RuntimeGravity, BaseMotion, VelocityThroughWater, SplitArticulatedBody>,
                           Named<Gravity, RotorInertia, Friction, JointSprings, TipWrench, ExternalWrenches,
                                 VelocityThroughWater, CompositeBody>,
                           Named<RuntimeGravity, FloatingBase, VelocityThroughWater, RotorInertia>>;
TYPED_TEST_SUITE(UnderwaterScenes, All);

}  // namespace

TYPED_TEST(UnderwaterScenes, EqualTheOracleInEveryForm) {
  oracle::RandomChains random(51);
  for (int k = 0; k < 12; ++k) {
    SCOPED_TRACE(k);
    const Sample s = sample(random);
    expect_scene<typename TypeParam::Unrolled, double>(s);
    expect_scene<typename TypeParam::Compact, double>(s);
    expect_scene<typename TypeParam::Compact, float>(s);
    expect_model<typename TypeParam::RunTime>(s);
  }
}

// What the robot declares about water is nothing to a scene that does not name it.
TEST(Underwater, UnnamedItDoesNothing) {
  oracle::RandomChains random(52);
  const Sample s = sample(random);
  const auto q = joints<Diver, double>(s.q), qd = joints<Diver, double>(s.qd), qdd = joints<Diver, double>(s.qdd);
  const auto wet = inverse_dynamics<Diver>(q, qd, qdd);
  using Dry = property::Everything;
  const auto dry =
      inverse_dynamics<Dry>(joints<Dry, double>(s.q), joints<Dry, double>(s.qd), joints<Dry, double>(s.qdd));
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(wet[i], dry[i]);
}

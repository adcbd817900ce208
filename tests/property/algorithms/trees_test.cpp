// Random trees of 1 to 20 mixed joints with branch screws, through the looped run-time model: every algorithm against
// the oracle.
#include <axial/links/model.hpp>
#include <cases/to_axial.hpp>
#include <robots/torso.hpp>

#include <property/support.hpp>

namespace {

using namespace axial;
using oracle::quad;
using property::joints;

constexpr int most = 20, trees = 60;
template <class... Route>
using ModelOf = Model<most, Gravity, RotorInertia, ExternalWrenches, Route...>;
using Plainest = ModelOf<>;

// Relative to the largest value of the vector or matrix. Forward dynamics amplifies the rounding of its inputs by the
// conditioning of the tree (up to 1e4 here).
constexpr double exact_double = 1e-13, exact_float = 5e-6;
constexpr double acceleration_double = 1e-12, acceleration_float = 2e-5;

struct Sample {
  oracle::Chain<double> chain;
  oracle::Vector<double> q, qd, qdd;
  oracle::Load<double> load;
};
Sample sample(oracle::RandomChains& random) {
  const int n = 1 + random.below(most);
  Sample s{random.branched_tree(n), random.vector(n, 3.0), random.vector(n, 2.0), random.vector(n, 4.0), {}};
  for (int i = 0; i < n; ++i)
    s.load.links.push_back(random.wrench(3.0));
  s.qdd[0] += s.qdd[0] < 0 ? -1.0 : 1.0;
  return s;
}

/// The same in quadruple precision, with what the oracle says.
struct Exact {
  explicit Exact(const Sample& s)
      : chain(oracle::convert<quad>(s.chain)),
        q(oracle::convert<quad>(s.q)),
        qd(oracle::convert<quad>(s.qd)),
        qdd(oracle::convert<quad>(s.qdd)),
        load(oracle::convert<quad>(s.load)) {}
  oracle::Vector<quad> torque() const { return oracle::inverse_dynamics(chain, q, qd, qdd, load); }
  oracle::Vector<quad> bias() const {
    return oracle::inverse_dynamics(chain, q, qd, oracle::Vector<quad>(q.size(), quad(0)), load);
  }
  oracle::Vector<quad> still() const {
    const oracle::Vector<quad> zero(q.size(), quad(0));
    return oracle::inverse_dynamics(chain, q, zero, zero, load);
  }
  oracle::Vector<quad> acceleration(const oracle::Vector<quad>& tau) const {
    return oracle::forward_dynamics(chain, q, qd, tau, load);
  }
  oracle::Chain<quad> chain;
  oracle::Vector<quad> q, qd, qdd;
  oracle::Load<quad> load;
};

template <class M, class T>
Inputs<M, T> inputs(const Sample& s) {
  Inputs<M, T> in;
  for (int i = 0; i < s.chain.size(); ++i) {
    const auto w = oracle::convert<T>(s.load.links[std::size_t(i)]);
    in.wrenches[i] = {{w.moment.x, w.moment.y, w.moment.z}, {w.force.x, w.force.y, w.force.z}};
  }
  return in;
}

template <class T>
void expect_torques(const Sample& s, const Exact& exact, double tolerance) {
  const auto model = cases::to_model<Plainest>(s.chain);
  const auto q = joints<Plainest, T>(s.q), qd = joints<Plainest, T>(s.qd), qdd = joints<Plainest, T>(s.qdd);
  const auto in = inputs<Plainest, T>(s);
  const int n = model.size();
  EXPECT_LE(oracle::relative_error(property::vector(inverse_dynamics(model, q, qd, qdd, in), n), exact.torque()),
            tolerance);
  EXPECT_LE(oracle::relative_error(property::vector(bias_torque(model, q, qd, in), n), exact.bias()), tolerance);
  EXPECT_LE(oracle::relative_error(property::vector(gravity_torque(model, q, in), n), exact.still()), tolerance);
  const auto m = property::matrix(mass_matrix(model, q, in), n);
  EXPECT_LE(oracle::relative_error(oracle::convert<quad>(m), oracle::mass_matrix(exact.chain, exact.q)), tolerance);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const bool coupled = s.chain.moves(i, j) || s.chain.moves(j, i);
      EXPECT_TRUE(coupled || m(i, j) == T(0)) << i << ' ' << j;
    }
}

// Against the acceleration that the effort, rounded to T, really gives: the forward error.
template <class T, class... Route>
double acceleration_error(const Sample& s, const Exact& exact, const oracle::Vector<quad>& tau) {
  using M = ModelOf<Route...>;
  const auto model = cases::to_model<M>(s.chain);
  const auto effort = joints<M, T>(oracle::convert<double>(tau));
  const auto ours = forward_dynamics(model, joints<M, T>(s.q), joints<M, T>(s.qd), effort, inputs<M, T>(s));
  EXPECT_TRUE(ours.status.ok()) << ours.status.joint;
  return oracle::relative_error(oracle::Vector<T>(ours.values, ours.values + model.size()),
                                exact.acceleration(oracle::convert<quad>(property::vector(effort, model.size()))));
}

struct Worst {
  const char* name;
  double tolerance, error = 0.0;
  void note(double e) {
    error = std::fmax(error, e);
    EXPECT_LE(e, tolerance) << name;
  }
};

double distance(const oracle::Vec3<quad>& a, const Vec3<double>& b) {
  const auto d = a - oracle::Vec3<quad>{quad(b.x), quad(b.y), quad(b.z)};
  return std::sqrt(static_cast<double>(dot(d, d)));
}
// Columns of the oracle's rotation against rows of ours.
double distance(const oracle::Mat3<quad>& a, const Mat3<Vec3<double>>& b) {
  return distance(a.c0, {b.x.x, b.y.x, b.z.x}) + distance(a.c1, {b.x.y, b.y.y, b.z.y}) +
         distance(a.c2, {b.x.z, b.y.z, b.z.z});
}

// Of a point of link k per unit rate of joint j.
oracle::Vec3<quad> expected_speed(const oracle::Chain<double>& chain, const std::vector<oracle::Pose<quad>>& poses,
                                  const oracle::Vec3<quad>& point, int j, int k) {
  const auto& pose = poses[std::size_t(j)];
  if (!chain.moves(j, k)) return {};
  return chain[j].type == oracle::Joint::revolute ? cross(pose.rotation.c2, point - pose.position) : pose.rotation.c2;
}

}  // namespace

TEST(BranchedTrees, TorquesEqualTheOracle) {
  oracle::RandomChains random(2020);
  for (int k = 0; k < trees; ++k) {
    const Sample s = sample(random);
    SCOPED_TRACE(testing::Message() << "tree " << k << " of " << s.q.size() << " joints");
    const Exact exact(s);
    expect_torques<double>(s, exact, exact_double);
    expect_torques<float>(s, exact, exact_float);
  }
}

TEST(BranchedTrees, EveryRouteOfForwardDynamicsEqualsTheOracle) {
  oracle::RandomChains random(2021);
  Worst worst[] = {{"articulated body, double", acceleration_double},
                   {"articulated body, float", acceleration_float},
                   {"split, double", acceleration_double},
                   {"split, float", acceleration_float},
                   {"composite body, double", acceleration_double},
                   {"composite body, float", acceleration_float}};
  for (int k = 0; k < trees; ++k) {
    const Sample s = sample(random);
    SCOPED_TRACE(testing::Message() << "tree " << k << " of " << s.q.size() << " joints");
    const Exact exact(s);
    const auto tau = exact.torque();
    worst[0].note(acceleration_error<double>(s, exact, tau));
    worst[1].note(acceleration_error<float>(s, exact, tau));
    worst[2].note(acceleration_error<double, SplitArticulatedBody>(s, exact, tau));
    worst[3].note(acceleration_error<float, SplitArticulatedBody>(s, exact, tau));
    worst[4].note(acceleration_error<double, CompositeBody>(s, exact, tau));
    worst[5].note(acceleration_error<float, CompositeBody>(s, exact, tau));
  }
  for (const auto& w : worst)
    std::printf("largest relative forward error, %s: %.1e\n", w.name, w.error);
}

TEST(BranchedTrees, PosesAndJacobianEqualTheOracle) {
  oracle::RandomChains random(2022);
  for (int k = 0; k < trees; ++k) {
    Sample s = sample(random);
    SCOPED_TRACE(testing::Message() << "tree " << k << " of " << s.q.size() << " joints");
    s.chain.tool.position = {0.25, -0.5, 0.125};
    const Exact exact(s);
    const auto model = cases::to_model<Plainest>(s.chain);
    const auto q = joints<Plainest, double>(s.q);
    const auto poses = forward_kinematics(model, q, {});
    const auto reference = oracle::link_poses(exact.chain, exact.q);
    for (int i = 0; i < model.size(); ++i) {
      EXPECT_LE(distance(reference[std::size_t(i)].position, poses.frames[i].position), 1e-13) << i;
      EXPECT_LE(distance(reference[std::size_t(i)].rotation, poses.frames[i].rotation), 1e-13) << i;
    }
    const auto J = jacobian(model, q, {});
    const auto columns = oracle::tool_jacobian(exact.chain, exact.q);
    const int hand = random.below(model.size());
    const auto of_link = jacobian(model, hand, q, {});
    const auto origin = reference[std::size_t(hand)].position;
    for (int j = 0; j < model.size(); ++j) {
      const auto &A = columns.angular, &L = columns.linear;
      EXPECT_LE(distance({A(0, j), A(1, j), A(2, j)}, J[j].angular), 1e-13) << j;
      EXPECT_LE(distance({L(0, j), L(1, j), L(2, j)}, J[j].linear), 1e-13) << j;
      EXPECT_LE(distance(expected_speed(s.chain, reference, origin, j, hand), of_link[j].linear), 1e-13) << j;
    }
  }
}

// A type with branches: unrolled, and in the loop over its own table.
TEST(BranchedTrees, ATorsoEqualsTheOracle) {
  using R = robots::Torso;
  using Compact = Scene<R, Gravity, RotorInertia, Looped, CompositeBody>;
  using CompactArticulated = Scene<R, Gravity, RotorInertia, Looped, ArticulatedBody>;
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(2023);
  for (int k = 0; k < 20; ++k) {
    const auto state = property::random_state<R>(random);
    const auto q = joints<R, double>(state.q), qd = joints<R, double>(state.qd), qdd = joints<R, double>(state.qdd);
    const auto tau = oracle::inverse_dynamics(chain, oracle::convert<quad>(state.q), oracle::convert<quad>(state.qd),
                                              oracle::convert<quad>(state.qdd));
    const auto M = oracle::mass_matrix(chain, oracle::convert<quad>(state.q));
    const auto ours = inverse_dynamics<R>(q, qd, qdd);
    EXPECT_LE(oracle::relative_error(property::vector(ours), tau), exact_double);
    EXPECT_LE(oracle::relative_error(property::vector(inverse_dynamics<Compact>(q, qd, qdd)), tau), exact_double);
    for (const auto& m : {mass_matrix<R>(q), mass_matrix<Compact>(q)})
      EXPECT_LE(oracle::relative_error(oracle::convert<quad>(property::matrix(m)), M), exact_double);
    for (const auto& a : {forward_dynamics<Compact>(q, qd, ours), forward_dynamics<CompactArticulated>(q, qd, ours)})
      EXPECT_LE(oracle::relative_error(property::vector<R>(a), state.qdd), acceleration_double);
  }
}

TEST(BranchedTrees, ATableWithoutBranchesRefusesOne) {
  Model<2, Gravity, Unbranched> model;
  EXPECT_TRUE(model.add(revolute().mass(1.0).branch_deg(360.0, 0.0)));  // a whole turn is none
  EXPECT_FALSE(model.add(revolute().mass(1.0).branch_deg(90.0, 0.0)));
  EXPECT_FALSE(model.add(revolute().mass(1.0).branch(0.0, 0.25)));
  EXPECT_EQ(model.size(), 1);
}

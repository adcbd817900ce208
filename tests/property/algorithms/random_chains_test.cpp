// Random chains and trees of 1 to 12 mixed joints through the looped run-time model, against the oracle.
#include <axial/links/model.hpp>
#include <cases/to_axial.hpp>

#include <property/support.hpp>

namespace {

using oracle::quad;
using property::joints;

using Model = axial::Model<12, axial::Gravity, axial::RotorInertia, axial::TipWrench>;

constexpr int chains = 150;
// Forward dynamics amplifies the rounding of its inputs by the conditioning of the chain (up to 1e4 here).
constexpr double torque_double = 1e-13, torque_float = 3e-6, acceleration_double = 1e-12, acceleration_float = 1e-4;

struct Sample {
  oracle::Chain<double> chain;
  oracle::Vector<double> q, qd, qdd;
  oracle::Load<double> load;
};

Sample sample(oracle::RandomChains& random, bool tree) {
  const int n = 1 + random.below(12);
  Sample s{
      tree ? random.tree(n) : random.chain(n), random.vector(n, 3.0), random.vector(n, 2.0), random.vector(n, 4.0), {}};
  s.load.tip = random.wrench(3.0);
  s.qdd[0] += s.qdd[0] < 0 ? -1.0 : 1.0;
  return s;
}

template <class T>
axial::Inputs<Model, T> inputs(const Sample& s) {
  const auto tip = oracle::convert<T>(s.load.tip);
  axial::Inputs<Model, T> in;
  in.tip_wrench = {{tip.moment.x, tip.moment.y, tip.moment.z}, {tip.force.x, tip.force.y, tip.force.z}};
  return in;
}

template <class T>
double torque_error(const Model& model, const Sample& s, const oracle::Vector<quad>& tau) {
  const auto ours = axial::inverse_dynamics(model, joints<Model, T>(s.q), joints<Model, T>(s.qd),
                                            joints<Model, T>(s.qdd), inputs<T>(s));
  return oracle::relative_error(property::vector(ours, model.size()), tau);
}
// Against the acceleration that the effort, rounded to T, really gives.
template <class T>
double acceleration_error(const Model& model, const Sample& s, const oracle::Vector<quad>& tau) {
  const auto effort = joints<Model, T>(oracle::convert<double>(tau));
  const auto ours = axial::forward_dynamics(model, joints<Model, T>(s.q), joints<Model, T>(s.qd), effort, inputs<T>(s));
  const auto exact = oracle::forward_dynamics(
      oracle::convert<quad>(s.chain), oracle::convert<quad>(s.q), oracle::convert<quad>(s.qd),
      oracle::convert<quad>(property::vector(effort, model.size())), oracle::convert<quad>(s.load));
  return oracle::relative_error(oracle::Vector<T>(ours.values, ours.values + model.size()), exact);
}

void expect_equal_to_oracle(bool tree) {
  oracle::RandomChains random(tree ? 20 : 10);
  for (int k = 0; k < chains; ++k) {
    const Sample s = sample(random, tree);
    SCOPED_TRACE(testing::Message() << "chain " << k << " of " << s.q.size() << " joints");
    const auto chain = oracle::convert<quad>(s.chain);
    const auto q = oracle::convert<quad>(s.q), qd = oracle::convert<quad>(s.qd);
    const auto tau =
        oracle::inverse_dynamics(chain, q, qd, oracle::convert<quad>(s.qdd), oracle::convert<quad>(s.load));
    const Model model = cases::to_model<Model>(s.chain);
    EXPECT_LE(torque_error<double>(model, s, tau), torque_double);
    EXPECT_LE(torque_error<float>(model, s, tau), torque_float);
    EXPECT_LE(acceleration_error<double>(model, s, tau), acceleration_double);
    EXPECT_LE(acceleration_error<float>(model, s, tau), acceleration_float);
    const auto m = property::matrix(axial::mass_matrix(model, joints<Model, double>(s.q), {}), model.size());
    EXPECT_LE(oracle::relative_error(oracle::convert<quad>(m), oracle::mass_matrix(chain, q)), torque_double);
  }
}

}  // namespace

TEST(RandomChains, EqualTheOracle) { expect_equal_to_oracle(false); }
TEST(RandomTrees, EqualTheOracle) { expect_equal_to_oracle(true); }

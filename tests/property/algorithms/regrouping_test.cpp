// Base parameters and folded rotors of 300 random chains and trees with slides and rotors: no joint feels a difference,
// on a fixed base or a moving one.
#include <axial/links/model.hpp>
#include <cases/to_axial.hpp>

#include <property/support.hpp>

namespace {

using namespace axial;
using property::joints;

constexpr int most = 12;
using Still = Model<most, Gravity, RotorInertia>;
using Moving = Model<most, Gravity, RotorInertia, BaseMotion>;

// Relative to the largest torque; regrouping adds and subtracts inertias of 12 links.
constexpr double torque_tolerance = 1e-12;
constexpr double acceleration_tolerance = 1e-9;

struct Table {
  TreeLinkConstants<double> links[most];
  int size;
};
template <class M>
Table table(const M& model) {
  Table t{};
  t.size = model.size();
  for (int i = 0; i < t.size; ++i)
    t.links[i] = model.constants(i);
  return t;
}

template <class M>
struct Case {
  Table full, base;
  Placement placement;
  Inputs<M, double> in;
  Joints<M, double> q, qd, qdd;

  auto view(const Table& t) const {
    return TableLinks<typename M::Scene, double, double, most>(t.links, nullptr, t.size, placement);
  }
  oracle::Vector<double> torque(const Table& t) const {
    Joints<M, double> tau{};
    execute<rnea::InverseDynamics>(view(t), in, q, qd, qdd, tau);
    return property::vector(tau, t.size);
  }
  oracle::Vector<double> acceleration(const Table& t, const oracle::Vector<double>& tau) const {
    Joints<M, double> result{};
    aba::run(view(t), in, q, qd, joints<M, double>(tau), result);
    return property::vector(result, t.size);
  }
};

template <class M>
Case<M> random_case(oracle::RandomChains& random, int k) {
  const int n = 1 + random.below(most);
  const auto chain = k % 3 == 0 ? random.tree(n) : k % 3 == 1 ? random.branched_tree(n) : random.chain(n);
  Case<M> c{};
  c.full = c.base = table(cases::to_model<M>(chain));
  c.placement.gravity = {chain.gravity.x, chain.gravity.y, chain.gravity.z};
  c.q = joints<M, double>(random.vector(n, 3.0)), c.qd = joints<M, double>(random.vector(n, 2.0));
  c.qdd = joints<M, double>(random.vector(n, 4.0));
  c.qdd[0] += 5.0;
  return c;
}

template <class M>
void expect_the_same(const Case<M>& c) {
  const auto tau = c.torque(c.full);
  EXPECT_LE(oracle::relative_error(c.torque(c.base), tau), torque_tolerance);
  EXPECT_LE(oracle::relative_error(c.acceleration(c.base, tau), c.acceleration(c.full, tau)), acceleration_tolerance);
}

}  // namespace

TEST(Regrouping, IsNotFeltOnAFixedBase) {
  oracle::RandomChains random(31);
  int folded = 0, slides = 0;
  for (int k = 0; k < 300; ++k) {
    SCOPED_TRACE(k);
    auto c = random_case<Still>(random, k);
    regroup(c.base.links, c.base.size, false);
    for (const auto& link : c.base.links)
      slides += link.prismatic && link.mass > 0.0 && link.parent >= 0 && link.hx == 0.0 && link.hz == 0.0 ? 1 : 0;
    expect_the_same(c);
    const auto unfolded = c.base;
    fold_rotors(c.base.links, c.base.size);
    for (int i = 0; i < c.base.size; ++i)
      folded += c.base.links[i].rotor < unfolded.links[i].rotor ? 1 : 0;
    expect_the_same(c);
  }
  EXPECT_GT(folded, 50);
  EXPECT_GT(slides, 50);
}

TEST(Regrouping, IsNotFeltOnAMovingBase) {
  oracle::RandomChains random(32);
  for (int k = 0; k < 300; ++k) {
    SCOPED_TRACE(k);
    auto c = random_case<Moving>(random, k);
    const auto v = random.vector(9, 3.0);
    c.in.base_motion = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}};
    regroup(c.base.links, c.base.size);
    expect_the_same(c);
  }
}

// The congruences that ours is compared with are right, cost what is published, and lose no digits: those are lost
// elsewhere.
#include <gtest/gtest.h>

#include <axial/dynamics/forward_dynamics.hpp>
#include <cases/scenarios.hpp>
#include <cases/to_axial.hpp>
#include <host_sim/figures/counts/congruence_rows.hpp>
#include <host_sim/figures/counts/congruences.hpp>

#include <cmath>
#include <memory>

namespace {

using namespace axial;

const std::vector<counts::CongruenceRow>& rows() {
  static const auto result = counts::congruence_rows();
  return result;
}
template <class Congruence>
const counts::CongruenceRow& row(int links) {
  for (const auto& r : rows())
    if (r.congruence == Congruence::name && r.links == links) return r;
  throw std::out_of_range(Congruence::name);
}

using Inertia = ArticulatedInertia<Sym3<double>, Mat3<Vec3<double>>, Sym3<double>>;
std::vector<double> elements(const Inertia& n) {
  const auto &a = n.angular, &l = n.linear;
  const auto& c = n.coupling;
  return {a.xx, a.yy,  a.zz,  a.xy,  a.xz,  a.yz,  l.xx,  l.yy,  l.zz,  l.xy, l.xz,
          l.yz, c.x.x, c.x.y, c.x.z, c.y.x, c.y.y, c.y.z, c.z.x, c.z.y, c.z.z};
}

}  // namespace

TEST(Congruences, AreOneCongruence) {
  constexpr double tolerance = 64 * std::numeric_limits<double>::epsilon();  // some roundings of numbers below 4
  const Inertia n{{0.9, 1.4, 1.1, 0.2, -0.3, 0.15},
                  {{0.1, -0.6, 0.3}, {0.5, 0.2, -0.4}, {-0.7, 0.8, 0.15}},
                  {2.1, 1.9, 2.4, -0.1, 0.25, 0.3}};
  const auto x = x_screw(std::cos(-2.1), std::sin(-2.1), -0.45);
  const auto joint = z_screw(std::cos(0.6), std::sin(0.6), 0.35);
  const auto ours = elements(counts::AxialScrews::to_parent<double>(x, joint, n));
  counts::for_each_congruence([&](auto way) {
    const auto other = elements(way.template to_parent<double>(x, joint, n));
    for (std::size_t i = 0; i < ours.size(); ++i)
      EXPECT_NEAR(other[i], ours[i], tolerance) << way.name << ' ' << i;
  });
}

TEST(Congruences, CostWhatIsPublishedAtMost) {
  const auto ours = row<counts::AxialScrews>(10).cost, planar = row<counts::PlanarRotations>(10).cost,
             dense = row<counts::DenseProduct>(10).cost;
  EXPECT_LE(ours.mul, 70);
  EXPECT_LE(ours.add, 71);
  EXPECT_EQ(planar, (Operations{89, 90, 0, 0}));  // the paper's first draft
  EXPECT_GE(dense.total(), 3 * ours.total());
}

TEST(Congruences, StayInsideTheGateOfLongChains) {
  for (const auto& scenario : cases::rods())
    for (const auto& r : rows())
      if (r.links == scenario.size()) {
        EXPECT_LE(r.in_float, scenario.in_float.forward) << r.congruence << ' ' << r.links;
        EXPECT_LE(r.in_double, scenario.in_double.forward) << r.congruence << ' ' << r.links;
        EXPECT_GT(r.in_float, 0.0) << r.congruence << ' ' << r.links;
      }
}

// So what the rows compare is the congruence and nothing else.
TEST(Congruences, ByAxialScrewsAreTheLibrarysForwardDynamicsToTheLastBit) {
  for (const auto& scenario : cases::rods()) {
    const auto model = std::make_unique<counts::LongChain>(cases::to_model<counts::LongChain>(scenario.chain));
    Joints<counts::LongChain, float> q{}, qd{}, tau{};
    for (int i = 0; i < scenario.size(); ++i) {
      const auto k = std::size_t(i);
      q[i] = float(scenario.q[k]), qd[i] = float(scenario.qd[k]), tau[i] = float(scenario.tau[k]);
    }
    const auto ours = counts::forward_dynamics_by<counts::AxialScrews>(*model, q, qd, tau);
    const auto library = forward_dynamics(*model, q, qd, tau);
    for (int i = 0; i < scenario.size(); ++i)
      ASSERT_EQ(ours[i], library[i]) << scenario.name << ' ' << i;
  }
}

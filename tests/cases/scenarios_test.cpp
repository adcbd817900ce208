// The generated scenarios against the ones of stiff_scenarios.json, and the quad reference against its 30 digits.
#include <gtest/gtest.h>

#include <cases/scenarios.hpp>
#include <oracle/compare.hpp>
#include <oracle/convert.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/recursive.hpp>

namespace cases {
namespace {

// World coordinates cost quad the square of the distance over the square of the lever: 2^28 for a centre of mass 4096 m
// away and a lever of 0.25 m, the worst here. Eleven digits more than the gates of double need.
constexpr double reference_digits = 1e-25;
constexpr double taper_digits = 1e-22;  // S03: link sizes over a range of 2^20

bool same(const oracle::Vec3<double>& a, const oracle::Vec3<double>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
bool same(const oracle::Link<double>& a, const oracle::Link<double>& b) {
  return a.type == b.type && a.parent == b.parent && a.alpha == b.alpha && a.a == b.a && a.d == b.d &&
         a.theta == b.theta && a.mass == b.mass && same(a.com, b.com) && same(a.inertia.c0, b.inertia.c0) &&
         same(a.inertia.c1, b.inertia.c1) && same(a.inertia.c2, b.inertia.c2) && a.rotor_inertia == b.rotor_inertia &&
         a.gear == b.gear;
}

void expect_same(const Scenario& generated, const StiffScenario& filed) {
  ASSERT_EQ(generated.size(), filed.chain.size());
  for (int i = 0; i < generated.size(); ++i)
    EXPECT_TRUE(same(generated.chain[i], filed.chain[i])) << "link " << i;
  EXPECT_TRUE(same(generated.chain.gravity, filed.chain.gravity));
  EXPECT_EQ(generated.q, filed.q);
  EXPECT_EQ(generated.qd, filed.qd);
  EXPECT_EQ(generated.tau, filed.tau);
}

TEST(Scenarios, GeneratorsReproduceTheFiledOnesBitByBit) {
  int found = 0;
  for (const Scenario& generated : scenarios())
    for (const StiffScenario& filed : load_stiff_scenarios())
      if (generated.name == filed.name) {
        SCOPED_TRACE(generated.name);
        expect_same(generated, filed);
        ++found;
      }
  EXPECT_EQ(found, static_cast<int>(load_stiff_scenarios().size()));
}

TEST(Scenarios, EveryNumberIsAFloat) {
  const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
  for (const Scenario& scenario : scenarios()) {
    for (const auto* values : {&scenario.q, &scenario.qd, &scenario.tau})
      for (const double x : *values)
        EXPECT_TRUE(is_float(x)) << scenario.name;
    for (const auto& link : scenario.chain.links)
      for (const double x : {link.a, link.d, link.mass, link.com.x, link.com.y, link.com.z, link.inertia.c0.x,
                             link.inertia.c1.y, link.inertia.c2.z, link.rotor_inertia})
        EXPECT_TRUE(is_float(x)) << scenario.name;
  }
}

/// Every scenario of the file that has an answer, the families that are not generated here included.
TEST(Scenarios, RecursiveOracleHasTheFiledDigits) {
  for (const StiffScenario& filed : load_stiff_scenarios()) {
    if (filed.qdd.empty() || filed.name == "S03_grow_N20") continue;  // cond(M) 6e26: quad has 7 digits left
    const auto chain = oracle::convert<quad>(filed.chain);
    const auto q = oracle::convert<quad>(filed.q), qd = oracle::convert<quad>(filed.qd);
    const auto qdd = oracle::recursive_forward_dynamics(chain, q, qd, oracle::convert<quad>(filed.tau));
    const double error = oracle::relative_error(qdd, filed.qdd);
    EXPECT_LE(error, filed.name == "S03_taper_N20" ? taper_digits : reference_digits) << filed.name;
  }
}

/// Also those that the file does not have: by Lagrange's equations and elimination, which share nothing with the
/// recursion. Elimination loses the condition of M, some ten digits of quad's 34 at most here.
TEST(Scenarios, RecursiveOracleAgreesWithLagrange) {
  constexpr double lagrange_digits = 1e-23;
  int compared = 0;
  for (const Scenario& scenario : scenarios()) {
    if (scenario.size() > 10 || scenario.singular) continue;
    const auto quads = [](const oracle::Vector<double>& v) { return oracle::convert<quad>(v); };
    const auto qdd = oracle::forward_dynamics(oracle::convert<quad>(scenario.chain), quads(scenario.q),
                                              quads(scenario.qd), quads(scenario.tau));
    EXPECT_LE(oracle::relative_error(reference_acceleration(scenario), qdd), lagrange_digits) << scenario.name;
    ++compared;
  }
  EXPECT_GE(compared, 50);
}

}  // namespace
}  // namespace cases

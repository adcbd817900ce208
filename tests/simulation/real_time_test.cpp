// Robots as boards integrate them, inside their gates: a second of a pick-and-place cycle, a minute's free swing.
#include <host_sim/plants/real_time/rows.hpp>

#include <gtest/gtest.h>

#include <algorithm>

using namespace host_sim::real_time;

namespace {

void expect_inside_gates(const std::vector<Row>& rows) {
  EXPECT_FALSE(rows.empty());
  for (const Row& r : rows) {
    EXPECT_TRUE(r.pass()) << r.robot << ", " << r.motion << ", " << r.method << ", " << r.scalar << ": " << r.error
                          << ", " << r.energy_drift << " (gate " << r.gate << ")" << (r.made ? "" : ", not made");
    EXPECT_GT(r.error + r.energy_drift, 0.0) << "something is left";
  }
}
double error_of(const std::vector<Row>& rows, const std::string& method, const std::string& scalar) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.method == method && r.scalar == scalar; });
  return found == rows.end() ? -1.0 : found->error;
}

}  // namespace

TEST(RealTime, AScaraIsWhereDoubleHasIt) { expect_inside_gates(scara_rows()); }

// What words lose is a thousandth of the gate, and what a step of Euler's loses is far more than that.
TEST(RealTime, APumaIsWhereDoubleHasIt) {
  const auto rows = puma560_rows();
  expect_inside_gates(rows);
  EXPECT_LE(error_of(rows, "runge_kutta_4", "fixed32"), 2e-6);
  EXPECT_NEAR(error_of(rows, "semi_implicit", "fixed32"), error_of(rows, "semi_implicit", "double"), 2e-6);
  EXPECT_GE(error_of(rows, "semi_implicit", "double"), 1e-5);
}

TEST(RealTime, AFreeSwingKeepsItsEnergy) { expect_inside_gates(swing_rows()); }

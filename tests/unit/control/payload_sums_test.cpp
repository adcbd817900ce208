// How much a sample counts, and how it is forgotten.
#include <gtest/gtest.h>
#include <axial/control/payload_sums.hpp>
#include <axial/robot/chain.hpp>
#include <cmath>

using namespace axial;

namespace {

struct Arm {  // the second joint declares no effort limit
  static constexpr auto chain = axial::chain(revolute().mass(1).com(1, 0, 0).effort_limit(50), revolute().mass(1));
};
struct Tuning {
  static constexpr double period = 1e-3, gain = 100.0, deviation = 0.02, memory = 0.5;
};
using Sums = detail::PayloadSums<Arm, double, Tuning>;

}  // namespace

TEST(PayloadSums, WeighResidualsByTheirVarianceAndByHowLongTheyLast) {
  // A residual follows noise with a lag: samples k apart correlate by (1 - share)^|k|, so that each counts as a part.
  const double share = 0.1 / 1.1;
  double like = 1.0;
  for (int k = 1; k < 2000; ++k)
    like += 2.0 * std::pow(1.0 - share, k);
  EXPECT_NEAR(Sums::weights.of[0] * 1.0 * 1.0 * like, 1.0, 1e-12) << "deviation: 2 % of 50 N m";
  EXPECT_NEAR(Sums::weights.of[1] * 0.02 * 0.02 * like, 1.0, 1e-12) << "no declared effort: of 1 N m";
}

TEST(PayloadSums, AddWhatAJointSees) {
  double information[4][4] = {}, moment[4] = {};
  information[1][0] = 5.0, moment[2] = 7.0;
  const detail::PayloadRow<double> row{{1.0, 2.0, -3.0, 4.0}};
  const double w = Sums::weights.of[1];
  Sums::add(information, moment, true, 1, row, 0.5);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(moment[i] - (i == 2 ? 7.0 : 0.0), -w * row.of[i] * 0.5, 1e-12 * w) << "columns are residuals of -1";
    for (int j = 0; j <= i; ++j)
      EXPECT_NEAR(information[i][j] - (i == 1 && j == 0 ? 5.0 : 0.0), w * row.of[i] * row.of[j], 1e-12 * w);
  }
}

TEST(PayloadSums, LeaveOutAFirstSample) {
  double information[4][4] = {}, moment[4] = {};
  Sums::add(information, moment, false, 0, {{1.0, 2.0, -3.0, 4.0}}, 0.5);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(moment[i], 0.0);
    EXPECT_EQ(information[i][0], 0.0);
  }
}

TEST(PayloadSums, ForgetAllButAnEthOfASampleWithinTheMemory) {
  double sum = 1.0;
  const int samples = static_cast<int>(Tuning::memory / Tuning::period);
  for (int k = 0; k < samples; ++k)
    Sums::forget(sum);
  EXPECT_NEAR(sum, std::exp(-1.0), 1e-3);
}

TEST(PayloadSums, LagColumnsAsTheObserverLagsItsResidual) {
  const double share = 0.1 / 1.1, r = 2.0, p = 0.31, p_last = 0.3, d = 4.0, d_last = 2.0;
  const double seen = (p - p_last) / Tuning::period - 0.5 * (d + d_last);
  EXPECT_NEAR(Sums::lagged(0, r, p, p_last, d, d_last), r + share * (seen - r), 1e-12);
}

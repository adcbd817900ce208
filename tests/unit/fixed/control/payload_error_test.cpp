// What words make of a payload estimator's equations, term by term: each against the step in words that it bounds.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>

#include <cmath>
#include <random>

namespace {

using namespace axial;

struct Tuning {
  static constexpr double period = 1e-3, gain = 50.0, deviation = 0.003, memory = 10.0;
};
struct LeaningLinks {
  static constexpr Link link(double speed) {
    return revolute().mass(1).inertia_com(0.1, 0.1, 0.1).speed_limit(speed).acceleration_limit(10).effort_limit(50);
  }
};
/// Speeds of unlike sizes, gravity along no axis.
struct Leaning : LeaningLinks {
  static constexpr auto chain = axial::chain(gravity(1.7, -3.1, -9.0), link(9.0), link(0.3).alpha_deg(90).a(0.4));
};
using S = Scene<Leaning, Gravity, RangeCheck>;
using Sums = detail::PayloadSums<S, Fixed32, Tuning>;
using F = detail::ColumnRounding<S, Fixed32>;
using Rounding = bounds::PayloadColumnRounding<S, std::int32_t>;
constexpr WordRounding rounding = rounding_of<detail::ArithmeticOf<S, std::int32_t>>();

constexpr double unit(int exponent) { return detail::power_of_two(-exponent); }
constexpr double root3 = 1.7320508075688772;

/// The largest error of words scaled by a factor, of what 1 / deviation makes of them in words at `exponent`.
double worst_scaled(std::int32_t factor, int own, int exponent, double deviation) {
  std::mt19937_64 random(31);
  double worst = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const auto near = static_cast<std::int32_t>(random() % 4096);
    const std::int32_t word = k % 2 == 0 ? INT32_MAX - near : near - INT32_MAX;
    const double wanted = word * unit(own) / deviation;
    worst = std::fmax(worst, std::fabs(Sums::scaled(word, factor) * unit(exponent) - wanted) * deviation);
  }
  return worst;
}

}  // namespace

// What is left where the columns are exact: the lag, and a weight to one unit of what is summed.
TEST(PayloadError, OfWeightsIsAUnitOfWhatIsSummed) {
  constexpr auto observed = error_bound<S>(algorithm::MomentumObserver<Tuning>{});
  constexpr auto bound = error_bound<S>(algorithm::PayloadEstimator<Tuning>{});
  constexpr detail::BoundedPayloadFormats<S, std::int32_t, Tuning> f{};
  for (int i = 0; i < 2; ++i) {
    const double deviation = detail::residual_deviation<S, Tuning>(i);
    EXPECT_DOUBLE_EQ(deviation, Tuning::deviation * 50.0);
    for (int k = 0; k < 4; ++k) {
      const double lagged = detail::lagged_error<Tuning>(f, k, 0.0, 0.0) * unit(Sums::formats.exponent[k]);
      const double weighed = detail::payload_entry_error<S, std::int32_t, Tuning>(i, k, 0.0, 0.0) - lagged;
      const double worst =
          worst_scaled(Sums::formats.row_factor[i], Sums::formats.exponent[k], Sums::formats.row[k], deviation);
      EXPECT_LE(worst, weighed) << i << k;
      EXPECT_GT(worst, 0.4 * weighed) << i << k;
    }
    const double worst = worst_scaled(Sums::formats.residual_factor[i], Residuals<S, Fixed32, Tuning>::exponent(i),
                                      Sums::formats.residual_exponent, deviation);
    EXPECT_LE(worst, bound.residual[i] - observed[i]);
    EXPECT_GT(worst, 0.4 * (bound.residual[i] - observed[i]));
  }
}

// Momenta that are off either way make a change that is off by twice as much per period; drifts count as they are.
TEST(PayloadError, OfColumnsPassesTheLag) {
  constexpr double off = 1e-3;
  for (int k : {0, 1}) {
    const auto entry = [k](double momentum, double drift) {
      return detail::payload_entry_error<S, std::int32_t, Tuning>(0, k, momentum, drift);
    };
    EXPECT_NEAR(entry(off, 0.0) - entry(0.0, 0.0), 2.0 * off / Tuning::period, 1e-6 * off / Tuning::period);
    EXPECT_NEAR(entry(0.0, off) - entry(0.0, 0.0), off, 1e-5 * off);
  }
}

TEST(PayloadError, OfSpeedsIsTheirShift) {
  const bounds::SpeedsOf<Leaning, joint_count<Leaning>> exact{};
  const auto fast = Rounding::speed(exact, 0), slow = Rounding::speed(exact, 1);
  EXPECT_EQ(fast.bound.error, 0.0);
  ASSERT_GT(F::Speeds::exponent(1), F::speed_exponent);
  F::Speeds speeds{};
  double worst = 0.0;
  for (int k = 0; k < 100; ++k) {
    speeds[1].raw = 123456 + k;
    worst = std::fmax(worst, std::fabs(F::speed(speeds, 1).raw * unit(F::speed_exponent) -
                                       speeds[1].raw * unit(F::Speeds::exponent(1))));
  }
  EXPECT_LE(worst, slow.bound.error);
  EXPECT_GT(worst, 0.5 * slow.bound.error);
  EXPECT_EQ(slow.bound.size, 0.3);
}

TEST(PayloadError, OfGravityIsHalfAUnitEach) {
  const auto word = F::gravity();
  const auto off = [](double raw, double exact) { return std::fabs(raw * unit(F::gravity_exponent) - exact); };
  const double worst = std::hypot(off(word.x.raw, 1.7), off(word.y.raw, -3.1), off(word.z.raw, -9.0));
  const auto bound = Rounding{&rounding}.gravity().bound.whole;
  EXPECT_LE(worst, bound.error);
  EXPECT_DOUBLE_EQ(bound.error, 0.5 * root3 * unit(F::gravity_exponent));
  EXPECT_DOUBLE_EQ(bound.size, std::hypot(1.7, 3.1, 9.0));
}

// Rows that are all off along one direction move what each of them multiplies that way.
TEST(PayloadError, OfATurnIsWhatItsRowsAreOff) {
  constexpr auto& ranges = detail::ranges_for<S, std::int32_t, FullParameters, recursion::Kinematics>;
  const auto axes = bounds::axes_of(ranges, 1, rounding);
  const double e = axes.x.bound.whole.error;
  EXPECT_EQ(e, ranges.range[1].rotation.error);
  EXPECT_GE(e, 2.0 * integer::sincos_error);  // two joints turn it
  const double size = 2.0, error = 1e-6;
  const bounds::BoundedVector v = bounds::detail::anywhere({size, error}, 24, &rounding);
  const auto turned = bounds::transpose_times(axes, v);
  EXPECT_DOUBLE_EQ(turned.bound.whole.size, size);
  EXPECT_NEAR(turned.bound.whole.error, root3 * e * size + error, 1e-3 * e * size);
  bounds::Terms three;
  for (int i = 0; i < 3; ++i)
    three.add_product(30 + 24);
  EXPECT_EQ(turned.across.rounding(20, rounding), three.rounding(20, rounding));
  EXPECT_EQ(turned.along.rounding(20, rounding), three.rounding(20, rounding));
}

// A word moved to fewer digits, and three of them.
TEST(PayloadError, OfARoundingIsHalfAUnitOfEachComponent) {
  const Rounding::To to{20, &rounding};
  EXPECT_DOUBLE_EQ(to(bounds::term_of(bounds::word_of({1.0, 0.25}, 24))).bound.error, 0.25 + 0.5 * unit(20));
  const auto v = to(bounds::vector_of(bounds::detail::anywhere({1.0, 0.0}, 24, &rounding)));
  EXPECT_NEAR(v.bound.whole.error, 0.5 * root3 * unit(20), 1e-12 * unit(20));
  EXPECT_EQ(v.exponent, 20);
}

// Words keep their digits where there is room for them, which constants of a model do not: they have no last one.
TEST(PayloadError, OfWordsThatHaveTheirDigitsIsNothing) {
  const auto word = bounds::vector_of(bounds::detail::anywhere({1.0, 0.0}, 24, &rounding));
  for (const int exponent : {24, 27})
    EXPECT_EQ((Rounding::To{exponent, &rounding}(word).bound.whole.error), 0.0);
}

// The equation of a payload, as one number for each joint.
TEST(PayloadError, OfAnEquationAddsUp) {
  constexpr auto bound = error_bound<S>(algorithm::PayloadEstimator<Tuning>{});
  constexpr auto of = bound.of(2.0, 0.5);
  for (int i = 0; i < 2; ++i)
    EXPECT_DOUBLE_EQ(of[i], 2.0 * bound.mass[i] + 0.5 * root3 * bound.first_moment[i] + bound.residual[i]);
}

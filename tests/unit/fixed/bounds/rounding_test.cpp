// How an arithmetic rounds, as the analysis has it, against words.
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace axial;

template <int degrees>
struct Arm {
  static constexpr auto chain = axial::chain(gravity(0, -9.81, 0), revolute().theta_deg(degrees).a(0.4).mass(2.0));
};
template <int degrees>
double turn_error() {
  using S = Scene<Arm<degrees>, Gravity, SineCosines>;
  return rounding_in<S, detail::ArithmeticOf<S, std::int32_t>>().turn_error;
}

// A pair of words of 2^-30 through a constant angle: two products of words and of constants a component, each rounded.
TEST(Rounding, PairsThatTheModelTurnsAreOffByTwoProductsMore) {
  std::mt19937_64 random{20261129};
  const double c = std::cos(40.0 * 3.14159265358979323846 / 180.0), s = std::sqrt(1.0 - c * c);
  const auto c_word = std::llrint(std::ldexp(c, 30)), s_word = std::llrint(std::ldexp(s, 30));
  double worst = 0.0;
  for (int k = 0; k < 100000; ++k) {
    const double angle = std::uniform_real_distribution<double>(0.0, 6.283185307179586)(random);
    const auto x = std::llrint(std::ldexp(std::cos(angle), 30)), y = std::llrint(std::ldexp(std::sin(angle), 30));
    const auto turned = std::llrint(std::ldexp(static_cast<double>(x * c_word - y * s_word), -30));
    const double exact = static_cast<double>(x) * c - static_cast<double>(y) * s;
    worst = std::fmax(worst, std::fabs(static_cast<double>(turned) - exact));
  }
  const double added = std::ldexp(turn_error<40>() - turn_error<0>(), 30);
  EXPECT_GE(added, worst);
  EXPECT_LE(added, 3.0);
}

}  // namespace

// Taylor numbers: Leibniz's rule on polynomials, and what does not change by type.
#include <gtest/gtest.h>
#include <axial/scalar/series.hpp>

using namespace axial;

namespace {

using T = Taylor<double, double, double>;
constexpr T a{3.0, -2.0, 5.0}, b{-1.0, 4.0, 7.0};

void expect_is(const T& x, double value, double linear, double quadratic) {
  EXPECT_EQ(x.value, value);
  EXPECT_EQ(x.linear, linear);
  EXPECT_EQ(x.quadratic, quadratic);
}

}  // namespace

TEST(Taylor, AddsCoefficients) {
  expect_is(a + b, 2, 2, 12);
  expect_is(a - b, 4, -6, -2);
  expect_is(-a, -3, 2, -5);
  expect_is(a + 1.0, 4, -2, 5);
  expect_is(1.0 - a, -2, 2, -5);
}
// (3 - 2 t + 5 t^2)(-1 + 4 t + 7 t^2) = -3 + 14 t + 8 t^2 + ...
TEST(Taylor, MultipliesAsPolynomialsDo) {
  expect_is(a * b, -3, 14, 8);
  expect_is(a * 2.0, 6, -4, 10);
  expect_is(2.0 * a, 6, -4, 10);
}
TEST(Taylor, WhatDoesNotChangeIsAPlainNumber) {
  static_assert(std::is_same_v<decltype(with_rates(1.0, Zero{}, Zero{})), double>);
  static_assert(std::is_same_v<decltype(Zero{} * a), Zero>);
  static_assert(std::is_same_v<decltype(a + Zero{}), T>);
  using Uniform = Taylor<double, double, Zero>;
  static_assert(std::is_same_v<decltype(Uniform{} + Uniform{}), Uniform>);
  static_assert(std::is_same_v<decltype(2.0 * Uniform{}), Uniform>);
  static_assert(std::is_same_v<decltype(Uniform{} * Uniform{}), T>);
}
TEST(Taylor, HoldsConstantsWhereALoopKeepsOneType) {
  expect_is(Holding<T>::of(One{}), 1, 0, 0);
  expect_is(Holding<T>::of(2.5), 2.5, 0, 0);
  expect_is(Holding<T>::of(Taylor{One{}, 2.0, Zero{}}), 1, 2, 0);
  expect_is(NumberTraits<T>::constant(0.5), 0.5, 0, 0);
}

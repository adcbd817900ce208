// Joint values of a SCARA and an elastic joint that tests give to every kernel, and how answers are compared.
#pragma once

#include <axial/axial.hpp>
#include <robots/scara.hpp>

#include <gtest/gtest.h>

namespace every_kernel {

using R = robots::Scara;
using Q = axial::Joints<R, float>;

inline constexpr Q joints{0.4F, -0.7F, 0.06F}, rates{1.1F, -0.3F, 0.2F}, loads{2.0F, -1.0F, 9.0F};

struct Elastic {
  static constexpr auto chain =
      axial::chain(axial::gravity(0.0, -9.81, 0.0), axial::revolute().mass(1).com(0.5, 0, 0).stiffness(4000.0));
};

template <class Left, class Right>
void expect_same(const Left& left, const Right& right) {
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(left[i], right[i]) << i;
}

}  // namespace every_kernel

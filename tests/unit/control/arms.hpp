// The arms that a loop's calls are tried on.
#pragma once
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

namespace control_tests {

#ifdef AXIAL_FEW_ROBOTS
/// A flat arm with a slide and one that turns every way, in float; words, whose borders differ.
template <template <class, class> class Case>
using Arms =
    testing::Types<Case<robots::Scara, float>, Case<robots::Puma560, float>, Case<robots::Scara, axial::Fixed32>>;
template <template <class, class> class Case>
using MoreArms = Arms<Case>;
#else
template <template <class, class> class Case>
using Arms =
    testing::Types<Case<robots::Scara, float>, Case<robots::Scara, double>, Case<robots::Scara, axial::Fixed32>,
                   Case<robots::Puma560, float>, Case<robots::Puma560, axial::Fixed32>>;
/// And one with more joints than it needs.
template <template <class, class> class Case>
using MoreArms =
    testing::Types<Case<robots::Scara, float>, Case<robots::Scara, double>, Case<robots::Scara, axial::Fixed32>,
                   Case<robots::Puma560, float>, Case<robots::Puma560, axial::Fixed32>, Case<robots::Panda, float>,
                   Case<robots::Panda, axial::Fixed32>>;
#endif

}  // namespace control_tests

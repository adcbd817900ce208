// Products of joint values, one per joint: power.
#pragma once

#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What actuators deliver: W.
template <class S, class T>
using PowersOf = Joints<subject_of<S, T>, T, typename detail::RoleOf<T, role::Power>::type>;

namespace detail {
/// Products of joint values over numbers T, one per joint; a number system with formats rounds each once.
template <class Scene, class T>
struct JointProducts {
  template <class A, class B, class Result>
  AXIAL_INLINE static constexpr void write(const A& a, const B& b, Result& products) {
    for (int i = 0; i < Result::size; ++i)
      products[i] = a[i] * b[i];
  }
};
}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>

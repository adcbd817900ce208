// Every robot that declares what fixed point needs, as a list of types.
#pragma once

#include <gtest/gtest.h>
#include <robots/robots.hpp>

namespace property {

template <class... Lists>
struct Joined;
template <class... A, class... B, class... Rest>
struct Joined<robots::List<A...>, robots::List<B...>, Rest...> : Joined<robots::List<A..., B...>, Rest...> {};
template <class... A>
struct Joined<robots::List<A...>> {
  using Types = testing::Types<A...>;
};
#ifdef AXIAL_FEW_ROBOTS
using EveryRobot = testing::Types<robots::Scara, robots::Puma560>;
#else
using EveryRobot = Joined<robots::All, robots::Published, robots::Trees>::Types;
#endif
using EveryArm = Joined<robots::All, robots::Published>::Types;

struct RobotName {
  template <class R>
  static std::string GetName(int) {
    return R::name;
  }
};

}  // namespace property

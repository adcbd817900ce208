// Every machine of robots/gallery; drawn_robot_test.cpp has one of them that the commit draws.
#include "machines.hpp"

namespace property {
namespace {

using Machines = Joined<robots::Gallery>::Types;
INSTANTIATE_TYPED_TEST_SUITE_P(Gallery, Machine, Machines, RobotName);

}  // namespace
}  // namespace property

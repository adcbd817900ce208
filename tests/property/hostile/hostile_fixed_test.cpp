// Any words in fixed point: a right answer or a status that says otherwise, and no overflow that is undefined (the
// sanitizers' build runs this too). AXIAL_HOSTILE_STATES=10000000 takes minutes in a release build.
#include "hostile_words.hpp"

namespace {

using namespace axial;
using property::Fixed;
using property::HostileWords;
using property::Wrong;
#ifdef AXIAL_FEW_ROBOTS
using Robots = testing::Types<property::SlidingTree, robots::Scara>;
#else
using Robots = testing::Types<property::SlidingTree, robots::Scara, robots::Puma560, robots::Panda>;
#endif
TYPED_TEST_SUITE(HostileWords, Robots, property::RobotName);

}  // namespace

TYPED_TEST(HostileWords, ForwardDynamicsIsRightOrSaysOtherwise) {
  using S = Fixed<TypeParam>;
  this->template run<S>(20000, [](const auto& state, std::uint64_t k, Wrong& wrong) {
    property::check_forward<S>(state, property::Expected<S>(state), k, wrong);
  });
}

TYPED_TEST(HostileWords, ForwardDerivativesAreWithinTheirBoundsOrHaveNone) {
  using S = Fixed<TypeParam>;
  this->template run<S>(10000, [](const auto& state, std::uint64_t k, Wrong& wrong) {
    property::check_forward_derivatives<S>(state, property::Expected<S>(state), k, wrong);
  });
}

TYPED_TEST(HostileWords, FeedforwardIsRightOrSaysOtherwise) {
  using S = Fixed<TypeParam>;
  FeedforwardState<S, Fixed32> memory{};
  this->template run<S>(20000, [&](const auto& state, std::uint64_t k, Wrong& wrong) {
    property::check_feedforward<S>(state, k, memory, wrong);
  });
}

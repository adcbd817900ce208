// Any words in fixed point: a right answer or a status that says otherwise, and no overflow that is undefined (the
// sanitizers' build runs this too). AXIAL_HOSTILE_STATES=10000000 takes minutes in a release build.
#include "hostile_fixed.hpp"

#include "fixed_robots.hpp"

namespace {

using namespace axial;
using property::Fixed;
using property::HostileState;
using property::Wrong;
constexpr std::uint64_t tests = 14;

template <class R>
class HostileWords : public testing::Test {
 protected:
  template <class S, class Check>
  void run(std::uint64_t few, const Check& check) {
    exhaustive::Random random(property::hostile_seed);
    Wrong wrong;
    const std::uint64_t states = property::hostile_states(few, tests);
    for (std::uint64_t k = 0; k < states; ++k)
      check(property::hostile_state<HostileState<S>>(random, k), k, wrong);
    EXPECT_EQ(wrong.count, 0U) << wrong.first;
    std::printf("%llu states\n", static_cast<unsigned long long>(states));
  }
};
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

template <class R>
class HostileWordsClassical : public HostileWords<R> {};
using Classical = testing::Types<property::SlidingTree, robots::Scara>;
TYPED_TEST_SUITE(HostileWordsClassical, Classical, property::RobotName);
TYPED_TEST(HostileWordsClassical, TheClassicalFormIsRightOrSaysOtherwise) {
  using S = Fixed<TypeParam, ArticulatedBody>;
  this->template run<S>(60000, [](const auto& state, std::uint64_t k, Wrong& wrong) {
    property::check_forward<S>(state, property::Expected<S>(state), k, wrong);
  });
}

TYPED_TEST(HostileWords, FeedforwardIsRightOrSaysOtherwise) {
  using S = Fixed<TypeParam>;
  FeedforwardState<S, Fixed32> memory{};
  this->template run<S>(20000, [&](const auto& state, std::uint64_t k, Wrong& wrong) {
    property::check_feedforward<S>(state, k, memory, wrong);
  });
}

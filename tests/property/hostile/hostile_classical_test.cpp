// Any words in fixed point, of forward dynamics in the classical form: apart from the others, for a compiler's memory.
#include "hostile_words.hpp"

namespace {

using namespace axial;
using property::Fixed;
using property::Wrong;

template <class R>
class HostileWordsClassical : public property::HostileWords<R> {};
using Robots = testing::Types<property::SlidingTree, robots::Scara>;
TYPED_TEST_SUITE(HostileWordsClassical, Robots, property::RobotName);

}  // namespace

TYPED_TEST(HostileWordsClassical, TheClassicalFormIsRightOrSaysOtherwise) {
  using S = Fixed<TypeParam, ArticulatedBody>;
  this->template run<S>(60000, [](const auto& state, std::uint64_t k, Wrong& wrong) {
    property::check_forward<S>(state, property::Expected<S>(state), k, wrong);
  });
}

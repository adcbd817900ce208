// Batches of states of elastic joints: the torques of their motors.
#include "batch_suite.hpp"

namespace property {
namespace {

/// Springs behind joints, every third of which is rigid.
struct Sprung {
  static constexpr auto chain = [] {
    auto chain = property::Everything::chain;
    for (int i = 0; i < chain.size; ++i)
      if (i % 3 != 2) chain.links[i].stiffness = 2048.0 * (1 + i % 4);
    return chain;
  }();
};

using Elastic = testing::Types<
    Case<Scene<Sprung, Gravity, RotorInertia, Friction, JointSprings, TipWrench, ElasticJoints>, float, 4>,
    Case<Scene<Sprung, Gravity, RotorInertia, ElasticJoints, Looped>, double, 4>>;
INSTANTIATE_TYPED_TEST_SUITE_P(ElasticJoints, Batches, Elastic);

}  // namespace
}  // namespace property

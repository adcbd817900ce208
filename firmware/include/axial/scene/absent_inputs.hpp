// Run-time inputs that a scene does not have: reaching for one does not compile, and the compiler's message names the
// feature to add.
#pragma once

#include <axial/scene/features.hpp>

#include <axial/options/begin.hpp>

namespace axial {

struct RuntimeTool;  // runtime_tool.hpp

/// Empty classes whose private member has the name of the absent input: "'payload' is a private member of
/// 'axial::absent::add_the_feature_axial_Payload_to_the_scene'". They hold nothing and cost no byte.
namespace absent {

template <class Tag>
struct Of;  ///< the class of a feature's input

#define AXIAL_ABSENT(Feature, input)                             \
  class add_the_feature_axial_##Feature##_to_the_scene {         \
    static void input();                                         \
  };                                                             \
  template <>                                                    \
  struct Of<Feature> {                                           \
    using type = add_the_feature_axial_##Feature##_to_the_scene; \
  }
AXIAL_ABSENT(RuntimeGravity, gravity);                       ///< in.gravity
AXIAL_ABSENT(BaseMotion, base_motion);                       ///< in.base_motion
AXIAL_ABSENT(BaseWrench, base_wrench);                       ///< in.base_wrench
AXIAL_ABSENT(VelocityThroughWater, velocity_through_water);  ///< in.velocity_through_water
AXIAL_ABSENT(TipWrench, tip_wrench);                         ///< in.tip_wrench
AXIAL_ABSENT(ExternalWrenches, wrenches);                    ///< in.wrenches
AXIAL_ABSENT(Payload, payload);                              ///< in.payload
AXIAL_ABSENT(RuntimeTool, tool);                             ///< in.tool
AXIAL_ABSENT(SineCosines, turns);                            ///< in.turns
#undef AXIAL_ABSENT

/// Stands where a scene has the input.
template <class Tag>
struct Present {};

}  // namespace absent

namespace detail {
template <class Scene, class Tag, class... Others>
using absent_unless_named = std::conditional_t<(Scene::template has<Tag> || ... || Scene::template has<Others>),
                                               absent::Present<Tag>, typename absent::Of<Tag>::type>;
template <class Scene, class... Tags>
struct AbsentUnlessNamed : absent_unless_named<Scene, Tags>... {};
}  // namespace detail

/// Every input that a scene lacks.
template <class Scene>
struct AbsentInputs : detail::AbsentUnlessNamed<Scene, RuntimeGravity, BaseWrench, VelocityThroughWater, TipWrench,
                                                ExternalWrenches, Payload, RuntimeTool, SineCosines>,
                      detail::absent_unless_named<Scene, BaseMotion, FloatingBase> {};

}  // namespace axial

#include <axial/options/end.hpp>

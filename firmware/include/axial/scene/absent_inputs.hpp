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

/// Add RuntimeGravity for in.gravity.
class add_the_feature_axial_RuntimeGravity_to_the_scene {
  static void gravity();
};
/// Add BaseMotion, or FloatingBase, for in.base_motion.
class add_the_feature_axial_BaseMotion_to_the_scene {
  static void base_motion();
};
/// Add BaseWrench for in.base_wrench.
class add_the_feature_axial_BaseWrench_to_the_scene {
  static void base_wrench();
};
/// Add VelocityThroughWater for in.velocity_through_water.
class add_the_feature_axial_VelocityThroughWater_to_the_scene {
  static void velocity_through_water();
};
/// Add TipWrench for in.tip_wrench.
class add_the_feature_axial_TipWrench_to_the_scene {
  static void tip_wrench();
};
/// Add ExternalWrenches for in.wrenches.
class add_the_feature_axial_ExternalWrenches_to_the_scene {
  static void wrenches();
};
/// Add Payload for in.payload.
class add_the_feature_axial_Payload_to_the_scene {
  static void payload();
};
/// Add RuntimeTool for in.tool.
class add_the_feature_axial_RuntimeTool_to_the_scene {
  static void tool();
};
/// Add SineCosines for in.turns.
class add_the_feature_axial_SineCosines_to_the_scene {
  static void turns();
};

/// Stands where a scene has the input.
template <class Tag>
struct Present {};

}  // namespace absent

namespace detail {
template <class Scene, class Tag, class Absent, class... Others>
using absent_unless_named =
    std::conditional_t<(Scene::template has<Tag> || ... || Scene::template has<Others>), absent::Present<Tag>, Absent>;
}

/// Every input that a scene lacks.
template <class Scene>
struct AbsentInputs
    : detail::absent_unless_named<Scene, RuntimeGravity, absent::add_the_feature_axial_RuntimeGravity_to_the_scene>,
      detail::absent_unless_named<Scene, BaseMotion, absent::add_the_feature_axial_BaseMotion_to_the_scene,
                                  FloatingBase>,
      detail::absent_unless_named<Scene, BaseWrench, absent::add_the_feature_axial_BaseWrench_to_the_scene>,
      detail::absent_unless_named<Scene, VelocityThroughWater,
                                  absent::add_the_feature_axial_VelocityThroughWater_to_the_scene>,
      detail::absent_unless_named<Scene, TipWrench, absent::add_the_feature_axial_TipWrench_to_the_scene>,
      detail::absent_unless_named<Scene, ExternalWrenches, absent::add_the_feature_axial_ExternalWrenches_to_the_scene>,
      detail::absent_unless_named<Scene, Payload, absent::add_the_feature_axial_Payload_to_the_scene>,
      detail::absent_unless_named<Scene, RuntimeTool, absent::add_the_feature_axial_RuntimeTool_to_the_scene>,
      detail::absent_unless_named<Scene, SineCosines, absent::add_the_feature_axial_SineCosines_to_the_scene> {};

}  // namespace axial

#include <axial/options/end.hpp>

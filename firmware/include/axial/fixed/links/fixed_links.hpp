// The links of a scene in fixed point: the plug-in's side of LinksOf.
#pragma once

#include <axial/fixed/formats/input_formats.hpp>
#include <axial/fixed/links/fixed_driven_links.hpp>
#include <axial/fixed/links/fixed_table.hpp>
#include <axial/links/links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

template <class X, class... Any>
inline constexpr bool is_one_of = (std::is_same_v<X, Any> || ...);
template <class Recursion>
inline constexpr bool is_articulated =
    is_one_of<Recursion, recursion::ArticulatedBodies, recursion::ArticulatedBodiesAtRest>;

/// Formats of an articulated body need a joint that its own link or rotor resists.
template <class Scene, class Recursion>
constexpr bool resisted_by_themselves() {
  bool all = true;
  if constexpr (is_articulated<Recursion>)
    for (int i = 0; i < Scene::Robot::chain.size; ++i)
      all = all && least_joint_inertia(mechanism_of<Scene, FullParameters>, i) > 0.0;
  return all;
}

/// Formats of articulated bodies hold for bodies that have the inertia that they say, which regrouped ones have not.
template <class Scene, class Recursion>
constexpr bool has_own_parameters() {
  return !Scene::template has<BaseParameters> || !is_articulated<Recursion>;
}

/// What formats of articulated bodies refuse (macros: static_assert takes a literal only).
///@{
#define AXIAL_OWN_PARAMETERS                                                                                        \
  "axial: forward dynamics in fixed point takes its formats from each link's own parameters, which BaseParameters " \
  "regroups; take BaseParameters out of the scene"
#define AXIAL_EVERY_LINK_RESISTS                                                                                    \
  "axial: forward dynamics in fixed point takes its formats from what each link resists by itself; give every "     \
  "link an inertia about its joint's axis (a slide: a mass), or rotor_inertia() and name RotorInertia; or compute " \
  "this scene in float"
///@}
/// Formats that follow from what each link resists.
template <class Scene, class Recursion>
constexpr void check_resistance() {
  static_assert(has_own_parameters<Scene, Recursion>(), AXIAL_OWN_PARAMETERS);
  static_assert(resisted_by_themselves<Scene, Recursion>(), AXIAL_EVERY_LINK_RESISTS);
}

/// The recursions whose quantities have room for one format all along an arm.
template <class Recursion>
inline constexpr bool has_looped_form =
    is_one_of<Recursion, recursion::NewtonEuler, recursion::CompositeBodies, recursion::Kinematics, recursion::Momenta,
              recursion::BaseForce, recursion::Derivatives>;
/// The recursion by which a refusal is said once: one for articulated bodies, one for all that have every form.
template <class Recursion>
using said_as = std::conditional_t<
    std::is_same_v<Recursion, recursion::BaseForce> || std::is_same_v<Recursion, recursion::Separation>, Recursion,
    std::conditional_t<has_looped_form<Recursion>, recursion::NewtonEuler, recursion::ArticulatedBodiesAtRest>>;
/// Whether a scene has a wrench that separated terms have no format for.
template <class Scene, class Recursion>
inline constexpr bool separates_wrenches =
    std::is_same_v<Recursion, recursion::Separation>&& Scene::template has<TipWrench>;

template <class Named, class Word>
struct Forms<Named, Stored<Word>> {
  template <class Recursion>
  static constexpr auto check() {
    using Scene = sound_scene<Named>;
    if constexpr (!shares_drives_in<typename Scene::Robot>) {
      static_assert(
          !Scene::template has<Looped> || has_looped_form<Recursion>,
          "axial: forward dynamics and separation in fixed point need a format per link, which the looped form has "
          "not; take Looped out (AXIAL_MULTIPLY_BY_CALL makes them smaller on a Cortex-M0)");
      static_assert(!separates_wrenches<Scene, Recursion>,
                    "axial: separate() in fixed point has no wrenches; take TipWrench out of the scene");
      static_assert(!std::is_same_v<Recursion, recursion::BaseForce> || Unranged<Named>::any,
                    "axial: base_wrench() has no formats in fixed point; compute it in float");
      static_assert(has_own_parameters<Scene, Recursion>(), AXIAL_OWN_PARAMETERS);
      static_assert(resisted_by_themselves<Scene, Recursion>(), AXIAL_EVERY_LINK_RESISTS);
    }
  }
};

/// The formats of links that have a type each, and how kernels read and write joint values there.
template <class Scene, class Parameters, class S, class Recursion>
struct LinkFormats : Formats<Scene, Parameters, S, Recursion> {
  using Base = Formats<Scene, Parameters, S, Recursion>;
  struct FormattedValues : FixedValues<Scene, S>, Base {
    /// Efforts to fill: what a motion needs has words of its own.
    AXIAL_INLINE static constexpr auto no_efforts() {
      if constexpr (std::is_same_v<Recursion, recursion::MotionEfforts>)
        return Joints<Scene, Stored<typename S::Word>, role::MotionEffort>{};
      else
        return FixedValues<Scene, S>::no_efforts();
    }
    /// A pose, or a motion, of kinematics as words.
    template <class V>
    AXIAL_INLINE static constexpr auto stored(const V& v) {
      return stored_at<Base::Table::value.format[0].length, S>(v);
    }
  };
  template <class, class>
  using Values = FormattedValues;
};
/// The recursions that go from joints to drives by a sum.
template <class Scene, class Recursion>
constexpr void check_shared_drives() {
  static_assert(is_one_of<Recursion, recursion::NewtonEuler, recursion::CompositeBodies, recursion::Kinematics,
                          recursion::Momenta, recursion::Separation, recursion::Derivatives>,
                "axial: joints that share drives have no formats of this recursion in fixed point");
}
}  // namespace detail

/// Joints that share drives: joint values by G, each in its own format.
template <class R, class... Features, class Word, class Parameters, class Recursion>
struct LinksOf<Scene<DriveCoordinates<R>, Features...>, Stored<Word>, Parameters, Recursion> {
  using Drives = Scene<DriveCoordinates<R>, Features...>;  ///< the scene
  static_assert((detail::check_fixed_scene<Drives, Word>(), detail::check_shared_drives<Drives, Recursion>(), true));
  using S = detail::ArithmeticOf<Drives, Word>;  ///< arithmetic

  /// joints and drives
  AXIAL_INLINE static constexpr auto links() {
    using Default = std::conditional_t<std::is_same_v<Parameters, FullParameters>, FullParameters, BaseParameters>;
    return FixedDrivenLinks<Drives, S, Default, Recursion>{};
  }
};

/// In fixed point: formats of the recursion, a table of integers where the scene is looped.
template <class Named, class Word, class Parameters, class Recursion>
struct LinksOf<Named, Stored<Word>, Parameters, Recursion> {
  static_assert((detail::check_fixed_scene<Named, Word>(),
                 detail::Forms<Named, Stored<Word>>::template check<detail::said_as<Recursion>>(), true));
  static constexpr bool offered = !Named::template has<Looped> || detail::has_looped_form<Recursion>;  ///< in this form
  /// whether kernels are to do nothing
  static constexpr bool refused = std::is_same_v<Recursion, recursion::BaseForce> ||
                                  detail::separates_wrenches<Named, Recursion> ||
                                  (std::is_same_v<Recursion, recursion::Separation> && !offered);
  /// the scene, or what stands for one that was refused
  using Scene = std::conditional_t<offered, detail::sound_scene<Named>,
                                   axial::Scene<typename Named::Robot, Gravity, RotorInertia>>;
  using S = detail::ArithmeticOf<Scene, Word>;  ///< arithmetic

  /// the links, in the form that the scene asks for
  AXIAL_INLINE static constexpr auto links() {
    if constexpr (refused)
      return RefusedLinks<Named>{};
    else if constexpr (Scene::template has<Looped>)
      return FixedTableLinks<Scene, S, Parameters, detail::SharedFormats<Scene, Parameters, S, Recursion>>{};
    else
      return StaticLinks<Scene, S, Parameters, detail::LinkFormats<Scene, Parameters, S, Recursion>>{};
  }
};

}  // namespace axial

#include <axial/options/end.hpp>

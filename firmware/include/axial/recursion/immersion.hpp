// Where water comes into an algorithm: nothing of it where the scene is dry. What it exerts is in base/water.hpp.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scene/features.hpp>
#include <axial/spatial/spatial_vector.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
/// Whether the header of what a scene wants is there.
template <class Wanted>
inline constexpr bool water_included = std::is_void_v<Wanted>;
}  // namespace detail

/// What stands for the immersion of all links where the scene is dry.
struct Dry {
  /// dry, whichever link
  template <class I>
  AXIAL_INLINE constexpr Dry operator[](I) const {
    return {};
  }
};

/// The water about link i; Dry where the scene is.
template <class Links, class I>
AXIAL_INLINE constexpr auto water_about(const Links& links, I i) {
  if constexpr (Links::Scene::template has<Underwater>)
    return water_of(links, i);
  else
    return Dry{};
}
/// The water about the base body.
template <class Links>
AXIAL_INLINE constexpr auto water_about_base(const Links& links) {
  if constexpr (Links::Scene::template has<Underwater>)
    return water_of_base(links);
  else
    return Dry{};
}

/// Immersions of all links, from the base outwards; Dry where the scene is.
template <class Links, class Input, class Screws, class V>
AXIAL_INLINE constexpr auto immersions(const Links& links, const Input& in, const Screws& screws, const V& qd) {
  constexpr bool wet = Links::Scene::template has<Underwater>;
  static_assert(detail::water_included<std::conditional_t<wet, Underwater, void>>,
                "axial: water is a header of its own: add #include <axial/base/water.hpp>");
  if constexpr (wet)
    return immersions_in_water(links, in, screws, qd);
  else
    return Dry{};
}

/// Force that link i must exert on the water, as water_force() has it; zero by type where the scene is dry.
template <class Links, class I, class Link, class Body, class State, class P, class U, class DW, class A>
AXIAL_INLINE constexpr auto force_on_water(const Links& links, I i, const Link& link, const Body& body,
                                           const State& state, const P& p, const U& rate, const DW& dw, const A& a) {
  if constexpr (Links::Scene::template has<Underwater>)
    return water_force(link, water_of(links, i), body, state, p, rate, dw, a);
  else
    return ForceVector<ZeroVec3, ZeroVec3>{};
}

}  // namespace axial

#include <axial/options/end.hpp>

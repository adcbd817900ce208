// Loads that a scene adds to the links: payload and wrenches.
#pragma once

#include <axial/model/links.hpp>

namespace axial {

/// Rigid-body inertia of a payload about the origin of the last link's frame (parallel-axis theorem): 12M 9A.
template <class T>
AXIAL_INLINE constexpr auto payload_inertia(const PayloadBody<T>& load) {
  const Vec3<T> h = load.mass * load.com;
  const Vec3<T> square{h.x * load.com.x, h.y * load.com.y, h.z * load.com.z};
  const Sym3<T>& c = load.inertia_com;
  return RigidInertia{load.mass, h,
                      Sym3{c.xx + (square.y + square.z), c.yy + (square.x + square.z), c.zz + (square.x + square.y),
                           c.xy - h.x * load.com.y, c.xz - h.x * load.com.z, c.yz - h.y * load.com.z}};
}

/// Run-time inputs seen by the links: what they carry besides themselves.
template <class Scene, class Input>
class TipLoads {
 public:
  constexpr explicit TipLoads(const Input& in) : in_(in) {}

  /// Inertia of a link with its payload.
  template <class Link>
  AXIAL_INLINE constexpr auto body(const Link& link) const {
    if constexpr (!Scene::template has<Payload>)
      return link.body();
    else
      return with_payload(link);
  }
  /// Force that the environment exerts on link i; zero by type where the scene has none.
  template <class I, class Link>
  AXIAL_INLINE constexpr auto wrench(I i, const Link& link) const {
    if constexpr (Scene::template has<ExternalWrenches>)
      return in_.wrenches[i] + at_tip(link);
    else
      return at_tip(link);
  }

 private:
  template <class Link>
  AXIAL_INLINE constexpr auto at_tip(const Link& link) const {
    constexpr ForceVector<ZeroVec3, ZeroVec3> none;
    if constexpr (!Scene::template has<TipWrench>) {
      return none;
    } else if constexpr (Link::unrolled) {
      if constexpr (Link::is_last)
        return in_.tip_wrench;
      else
        return none;
    } else {
      auto wrench = in_.tip_wrench;
      if (!link.is_last) wrench = link.shape(none);
      return wrench;
    }
  }
  template <class Link>
  AXIAL_INLINE constexpr auto with_payload(const Link& link) const {
    if constexpr (Link::unrolled) {
      if constexpr (Link::is_last)
        return link.body() + payload_inertia(in_.payload);
      else
        return link.body();
    } else {
      auto body = link.shape(link.body());
      if (link.is_last) body = body + payload_inertia(in_.payload);
      return body;
    }
  }

  const Input& in_;
};

/// (Jzz - Jyy, Jxx - Jzz, Jyy - Jxx) of a link as the scene loads it.
template <class Scene, class Link, class Body>
AXIAL_INLINE constexpr auto loaded_differences(const Link& link, const Body& body) {
  const auto& j = body.inertia;
  if constexpr (!Scene::template has<Payload>)
    return link.inertia_differences();
  else
    return Vec3{j.zz - j.yy, j.xx - j.zz, j.yy - j.xx};
}

}  // namespace axial

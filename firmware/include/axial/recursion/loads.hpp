// Loads that a scene adds to the links: payload and wrenches.
#pragma once

#include <axial/links/links.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Rigid-body inertia of a payload about the origin of the last link's frame (parallel-axis theorem): 12M 9A.
template <class Link, class Load>
AXIAL_INLINE constexpr auto payload_inertia(const Link& link, const Load& load) {
  using namespace quantity;
  auto h = link.sum(FirstMoment{}, load.mass * load.com);
  auto square = link.sum(RotationalInertia{}, Vec3{h.x * load.com.x, h.y * load.com.y, h.z * load.com.z});
  const auto& c = load.inertia_com;
  const RotationalInertia q;
  return RigidInertia{load.mass, h,
                      Sym3{link.sum(q, c.xx, square.y + square.z), link.sum(q, c.yy, square.x + square.z),
                           link.sum(q, c.zz, square.x + square.y), link.sum(q, c.xy, -(h.x * load.com.y)),
                           link.sum(q, c.xz, -(h.x * load.com.z)), link.sum(q, c.yz, -(h.y * load.com.z))}};
}

/// Run-time inputs seen by the links: what they carry besides themselves.
template <class Scene, class Input>
class TipLoads {
 public:
  constexpr explicit TipLoads(const Input& in) : in_(in) {}  ///< `in` is referred to

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
        return read_wrench<Scene, typename Link::Scalar>(in_.tip_wrench);
      else
        return none;
    } else {
      auto wrench = link.shape(link.subtract(read_wrench<Scene, typename Link::Scalar>(in_.tip_wrench), none));
      if (!link.is_last) wrench = link.shape(none);
      return wrench;
    }
  }
  template <class Link>
  AXIAL_INLINE constexpr decltype(auto) payload(const Link&) const {
    return read_payload<Scene, typename Link::Scalar>(in_.payload);
  }
  template <class Link>
  AXIAL_INLINE constexpr auto with_payload(const Link& link) const {
    if constexpr (Link::unrolled) {
      if constexpr (Link::is_last)
        return link.add(link.body(), payload_inertia(link, payload(link)));
      else
        return link.body();
    } else {
      auto body = link.shape(link.body());
      if (link.is_last) body = link.shape(link.add(body, payload_inertia(link, payload(link))));
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

#include <axial/options/end.hpp>

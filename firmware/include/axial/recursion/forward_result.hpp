// What forward dynamics answers: accelerations, and what the solver has to say about them.
#pragma once

#include <axial/links/links.hpp>
#include <axial/scalar/select.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Accelerations, one per joint, and what the solver has to say about them.
template <class S, class T>
struct ForwardDynamics : FreeAccelerations<S, T> {
  StatusOf<T> status{};  ///< first joint that is near singular, or beyond its formats
};
/// On a floating base also the base's own acceleration: angular (rad/s^2) and of the origin of frame 0 (m/s^2, gravity
/// included), in axes of frame 0. The status names joint -1 where the base itself is near singular.
template <class S, class T>
struct FloatingDynamics : ForwardDynamics<S, T> {
  MotionVector<Vec3<T>, Vec3<T>> base_acceleration{};  ///< in axes of frame 0
};
/// What `forward_dynamics<S>` over numbers T answers.
template <class S, class T>
using ForwardDynamicsOf =
    std::conditional_t<scene_of<S>::template has<FloatingBase>, FloatingDynamics<subject_of<S, T>, T>,
                       ForwardDynamics<subject_of<S, T>, T>>;

namespace aba {

/// What links call a joint whose answer is lost in rounding: near singular, unless they say otherwise.
template <class Links, class = void>
inline constexpr auto lost_code = Status::Code::near_singular;
template <class Links>
inline constexpr auto lost_code<Links, std::void_t<decltype(Links::lost_code)>> = Links::lost_code;

/// What became of a solve whose joint `lost` (-1: none) is near singular, or whatever these links call it.
template <class Links>
AXIAL_INLINE constexpr auto status_of(const Ordinal<typename Links::Scalar>& lost, bool scaled) {
  constexpr auto trouble = static_cast<int>(lost_code<Links>);
  const int otherwise = select(scaled, static_cast<int>(Status::Code::rescaled), static_cast<int>(Status::Code::ok));
  return status_from(select(!is_negative(lost), trouble, otherwise), lost);
}

/// A motion and what the joint adds to it, in the formats of the link.
template <class Link, class M, class J>
AXIAL_INLINE constexpr auto with_joint(const Link& link, const M& motion, const J& joint) {
  return MotionVector{link.sum(quantity::AngularAcceleration{}, motion.angular, joint.angular),
                      link.sum(quantity::LinearAcceleration{}, motion.linear, joint.linear)};
}

}  // namespace aba
}  // namespace axial

#include <axial/options/end.hpp>

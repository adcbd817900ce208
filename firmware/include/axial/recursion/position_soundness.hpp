// Whether kinematics and separation were asked at positions that are numbers, and from which nothing overflows.
#pragma once

#include <axial/recursion/forward_soundness.hpp>
#include <axial/scalar/math.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Whether what a robot's constants and slides of up to `slide` m make of each other stays below `most`: sums of masses
/// and inertias times squares of lengths.
template <class Robot>
constexpr bool stays_below(double most, double slide) {
  double mass = 1.0, length = 0.0;
  for (const auto& link : Robot::chain.links) {
    length += magnitude(link.a) + magnitude(link.d) + magnitude(link.b) + slide;
    mass += link.mass;
    for (double inertia : link.inertia_com)
      mass += magnitude(inertia);
    for (double way : link.com)
      length += magnitude(way);
  }
  constexpr double terms = 4096.0 * Robot::chain.size * Robot::chain.size;
  return 1.0 + length * length < most / (terms * mass);
}

/// What makes slides infinite from which something might overflow: some 1e15 m in float. Of a run-time model, whose
/// answers are looked at instead, 1.
template <class Robot, class T>
constexpr T slide_scale() {
  double farthest = 1.0;
  constexpr double most = static_cast<double>((std::numeric_limits<T>::max)());
  if constexpr (is_described<Robot>) {
    while (stays_below<Robot>(most, 4.0 * farthest))
      farthest *= 2.0;
    return static_cast<T>(most / farthest);
  } else {
    return T(1);
  }
}

/// Positions: angles small enough for their sines, slides from which nothing overflows; and all run-time inputs.
template <class Links, class T, class Input, class Q>
AXIAL_INLINE constexpr void judge_positions(Soundness<T>& all, const Links& links, const Input& in, const Q& q) {
  collect_inputs(all, links, in);
  if constexpr (std::is_floating_point_v<Lane<T>>) {
    constexpr Lane<T> scale = slide_scale<typename Links::Scene::Robot, Lane<T>>();
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      links.link(i).on_joint([&](auto kind) AXIAL_INLINE {
        if constexpr (std::is_same_v<decltype(kind), Prismatic>) {
          all.number(T(scale) * q[i]);
        } else if constexpr (!Links::Scene::template has<SineCosines>) {
          all.angle(q[i]);
        }
      });
    });
  }
}

/// What a number system with formats has to say of positions and inputs before a kernel: here nothing, for answers are
/// looked at.
template <class S, class T>
struct PositionCheck {
  AXIAL_INLINE static constexpr void name(StatusOf<T>&, const Inputs<S, T>&, const Positions<robot_of<S>, T>&) {}
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

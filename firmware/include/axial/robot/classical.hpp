// Robots written in classical (distal, standard) Denavit-Hartenberg frames, turned into MDH chains by the compiler.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/robot/chain.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Fluent builder of a link of classical_chain(); start with classical_revolute() or classical_prismatic(). Frame i is
/// fixed to link i at its far end, its z axis is joint i+1's: the transform from frame i-1 to frame i is
/// Rz(theta) Tz(d) Tx(a) Rx(alpha). Centre of mass and inertia are in that frame.
class ClassicalLink : public LinkBuilder<ClassicalLink> {
  template <class>
  static constexpr bool serial = false;

 public:
  using LinkBuilder<ClassicalLink>::LinkBuilder;

  /// Link length in m, along x of frame i.
  constexpr ClassicalLink a(double metres) const {
    return with(Quantity::a, [&](auto& p) { p.a = metres; });
  }
  /// Link twist in radians, about x of frame i. Use alpha_deg for right angles.
  constexpr ClassicalLink alpha(double radians) const {
    return with(Quantity::alpha, [&](auto& p) { p.alpha = Angle::from_radians(radians); });
  }
  /// Link twist in degrees; 0, 90, 180, -90 are exact and cost nothing.
  constexpr ClassicalLink alpha_deg(double degrees) const {
    return with(Quantity::alpha, [&](auto& p) { p.alpha = Angle::from_degrees(degrees); });
  }
  /// Refused: a frame at the far end of a link can stand on one next joint only.
  template <class Index>
  constexpr ClassicalLink parent(Index) const {
    static_assert(serial<Index>, "axial: a classical_chain is serial; describe a tree as a chain() of MDH links");
    return *this;
  }
};

/// A link that turns about z of the frame before it.
constexpr ClassicalLink classical_revolute() { return ClassicalLink(JointType::revolute); }
/// A link that slides along z of the frame before it.
constexpr ClassicalLink classical_prismatic() { return ClassicalLink(JointType::prismatic); }

namespace detail {

/// Rx(alpha) Tx(a): classical frame i in MDH frame i, both fixed to link i. Right angles move numbers about and round
/// nothing, so what was zero is zero (+ 0.0: never -0).
struct FarEnd {
  Angle alpha{};
  double a = 0.0;

  constexpr double turned_y(double y, double z) const { return alpha.cos * y - alpha.sin * z + 0.0; }
  constexpr double turned_z(double y, double z) const { return alpha.sin * y + alpha.cos * z + 0.0; }

  /// Centre of mass and inertia of a link in MDH frame i.
  constexpr void carry(LinkParameters& p) const {
    const double com[] = {p.com[0], p.com[1], p.com[2]};
    p.com[0] = com[0] + a, p.com[1] = turned_y(com[1], com[2]), p.com[2] = turned_z(com[1], com[2]);
    const double yy = p.inertia_com[1], zz = p.inertia_com[2], xy = p.inertia_com[3], xz = p.inertia_com[4],
                 yz = p.inertia_com[5], c = alpha.cos, s = alpha.sin;
    const double change = s * (s * (zz - yy) - 2.0 * c * yz);  // exactly 0 where yy = zz and yz = 0
    p.inertia_com[1] = c != 0.0 ? yy + change : zz;
    p.inertia_com[2] = c != 0.0 ? zz - change : yy;
    p.inertia_com[3] = turned_y(xy, xz), p.inertia_com[4] = turned_z(xy, xz);
    p.inertia_com[5] = c * s * (yy - zz) + (c * c - s * s) * yz + 0.0;
  }
  /// A pose in classical frame i, in MDH frame i.
  constexpr FixedPose carried(const FixedPose& pose) const {
    FixedPose result = pose;
    for (int j = 0; j < 3; ++j) {
      result.rotation[3 + j] = turned_y(pose.rotation[3 + j], pose.rotation[6 + j]);
      result.rotation[6 + j] = turned_z(pose.rotation[3 + j], pose.rotation[6 + j]);
    }
    result.position[0] = pose.position[0] + a;
    result.position[1] = turned_y(pose.position[1], pose.position[2]);
    result.position[2] = turned_z(pose.position[1], pose.position[2]);
    return result;
  }
};

template <class T>
inline constexpr bool is_classical_link = std::is_same_v<T, ClassicalLink>;

template <int N>
struct ClassicalBuilder {
  ChainBuilder<N> modified{};
  FarEnd end{};  ///< of the link before: what leads to the next joint

  constexpr void add(const ClassicalLink& link) {
    LinkParameters p = link.parameters();
    modified.note(modified.next, link_problem(p, link.given(), modified.next, modified.accepted));
    if (modified.broken.problem != Problem::none) return;  // numbers that mean nothing are not to be calculated with
    const FarEnd before = end;
    end = {p.alpha, p.a};
    end.carry(p);
    p.alpha = before.alpha, p.a = before.a;
    modified.chain.links[modified.next++] = p;
  }
  template <class Part>
  constexpr void add(const Part& part) {
    modified.add(part);
  }
  /// The chain with what was given in the last classical frame.
  constexpr Chain<N> chain() const {
    Chain<N> result = modified.chain;
    result.tool.pose = end.carried(result.tool.pose);
    const double further = end.a < 0.0 ? -end.a : end.a;
    result.payload_limit.com_reach += further, result.tool_limit.reach += further;
    return result;
  }
};

}  // namespace detail

/// Builds a robot from a classical table: links from the base outwards and, in any order, gravity(), base(),
/// base_body(), accept(as_published), tool(), payload_limit() and tool_limit(), the last three in the last classical
/// frame. The result is the MDH chain of the same robot: theta, d, drives and limits stay; a and alpha lead on to the
/// next joint, those of the last link to the tool; centres of mass and inertias are carried from classical frame i to
/// MDH frame i, which Rx(alpha) Tx(a) parts. Zeros and multiples of 90 degrees are exact, so that it costs what the MDH
/// description costs. Poses that algorithms return and run-time wrenches and payloads are in MDH frames
/// (doc/guides/conventions.md).
template <class... Parts>
constexpr auto classical_chain(const Parts&... parts) {
  constexpr int count = (0 + ... + static_cast<int>(detail::is_classical_link<Parts>));
  static_assert(!(false || ... || detail::is_link<Parts>),
                "axial: revolute() and prismatic() are MDH links; give classical_chain() classical_revolute() and "
                "classical_prismatic()");
  static_assert(count > 0,
                "axial: a classical_chain needs at least one link; add axial::classical_revolute() or "
                "axial::classical_prismatic()");
  detail::ClassicalBuilder<(count > 0 ? count : 1)> builder{{detail::accepts<Parts...>}};
  (builder.add(parts), ...);
  const auto stop = detail::Stops<count>::of(builder.modified.broken);
  if (stop != nullptr) stop();
  return builder.chain();
}

}  // namespace axial

#include <axial/options/end.hpp>

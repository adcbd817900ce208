// Run-time inputs of a scene in fixed point: their formats, from what the robot declares, and how kernels read them.
#pragma once

#include <axial/fixed/formats/joint_formats.hpp>
#include <axial/fixed/words/round.hpp>
#include <axial/links/plain_values.hpp>
#include <axial/recursion/tool_pose.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Exponents of the words that `Inputs<Scene, Stored<Word>>` holds: value = raw 2^-exponent, SI.
template <class Robot, class T>
struct InputFormats {
  /// largest raw value of a word
  static constexpr double capacity = static_cast<double>((std::numeric_limits<typename T::Word>::max)());
  /// The exponent of what reaches `most` (SI).
  static constexpr int of(double most) { return detail::fitting_exponent(most, capacity); }
  static constexpr PayloadLimit load = Robot::chain.payload_limit;  ///< as declared
  /// Exponents of a run-time payload: kg, m, kg m^2
  static constexpr int payload_mass = of(load.mass), payload_com = of(load.com_reach),
                       payload_inertia = of(load.inertia);
  static constexpr TipWrenchLimit wrench = Robot::chain.tip_wrench_limit;  ///< as declared
  /// Exponents of a wrench at the tip: N, N m
  static constexpr int tip_force = of(wrench.force), tip_moment = of(wrench.moment);
  static constexpr ToolLimit tool_limit = Robot::chain.tool_limit;  ///< as declared
  static constexpr int tool = of(tool_limit.reach);                 ///< exponent of a run-time tool's origin: m
  /// A gravity vector given at run time may be as long as the declared one.
  static constexpr int gravity =
      of(detail::length_of(Robot::chain.gravity.x, Robot::chain.gravity.y, Robot::chain.gravity.z));
  /// Exponent of sines and cosines, and of a run-time tool's axes
  static constexpr int sine_cosine = 8 * static_cast<int>(sizeof(typename T::Word)) - 2;
};

namespace detail {

/// A payload whose parts have their own formats.
template <class M, class C, class J>
struct FormattedPayload {
  M mass{};
  C com{};
  J inertia_com{};
};
template <class M, class C, class J>
FormattedPayload(M, C, J) -> FormattedPayload<M, C, J>;

template <int E, class S, class Word>
AXIAL_INLINE constexpr auto in_format(const Stored<Word>& x) {
  return Fx<E, S>{x.raw};
}
template <int E, class S, class Word>
AXIAL_INLINE constexpr auto in_format(const Vec3<Stored<Word>>& v) {
  return Vec3{in_format<E, S>(v.x), in_format<E, S>(v.y), in_format<E, S>(v.z)};
}
template <int E, class S, class Word>
AXIAL_INLINE constexpr auto in_format(const Sym3<Stored<Word>>& m) {
  return Sym3{in_format<E, S>(m.xx), in_format<E, S>(m.yy), in_format<E, S>(m.zz),
              in_format<E, S>(m.xy), in_format<E, S>(m.xz), in_format<E, S>(m.yz)};
}

template <class Scene, class Word>
using FormatsOfInputs = InputFormats<typename Scene::Robot, Stored<Word>>;

}  // namespace detail

/// A payload's words with their formats.
template <class Scene, class Scalar, class Word>
AXIAL_INLINE constexpr auto read_payload(const PayloadBody<Stored<Word>>& load) {
  using F = detail::FormatsOfInputs<Scene, Word>;
  return detail::FormattedPayload{detail::in_format<F::payload_mass, Scalar>(load.mass),
                                  detail::in_format<F::payload_com, Scalar>(load.com),
                                  detail::in_format<F::payload_inertia, Scalar>(load.inertia_com)};
}
/// A wrench's words with their formats.
template <class Scene, class Scalar, class Word>
AXIAL_INLINE constexpr auto read_wrench(const ForceVector<Vec3<Stored<Word>>, Vec3<Stored<Word>>>& wrench) {
  using F = detail::FormatsOfInputs<Scene, Word>;
  return ForceVector{detail::in_format<F::tip_moment, Scalar>(wrench.moment),
                     detail::in_format<F::tip_force, Scalar>(wrench.force)};
}
/// A tool's words with their formats.
template <class Scene, class Scalar, class Word>
AXIAL_INLINE constexpr auto read_tool(const Pose<Mat3<Vec3<Stored<Word>>>, Vec3<Stored<Word>>>& tool) {
  const auto& axes = tool.rotation;
  return Pose{Mat3{detail::in_format<Scalar::unit, Scalar>(axes.x), detail::in_format<Scalar::unit, Scalar>(axes.y),
                   detail::in_format<Scalar::unit, Scalar>(axes.z)},
              detail::in_format<detail::FormatsOfInputs<Scene, Word>::tool, Scalar>(tool.position)};
}
/// A gravity vector's words with their format.
template <class Scene, class Scalar, class Word>
AXIAL_INLINE constexpr auto read_gravity(const Vec3<Stored<Word>>& g) {
  return detail::in_format<detail::FormatsOfInputs<Scene, Word>::gravity, Scalar>(g);
}
/// A pair's words with their format.
template <class Scene, class Scalar, class Word>
AXIAL_INLINE constexpr auto read_turn(const SinCos<Stored<Word>>& turn) {
  return SinCos<Fx<Scalar::unit, Scalar>>{{turn.sin.raw}, {turn.cos.raw}};
}

namespace detail {

/// The gravity that a robot declares, as an input starts with it.
template <class Robot, class Word>
struct DeclaredGravity<Robot, Stored<Word>> {
  static constexpr Stored<Word> constant(double value) {
    constexpr int exponent = InputFormats<Robot, Stored<Word>>::gravity;
    return {static_cast<Word>(nearest_integer(value * power_of_two(exponent)))};
  }
};
/// The tool that a robot declares, as an input starts with it.
template <class Robot, class Word>
struct DeclaredTool<Robot, Stored<Word>> {
  static constexpr Pose<Mat3<Vec3<Stored<Word>>>, Vec3<Stored<Word>>> pose() {
    using F = InputFormats<Robot, Stored<Word>>;
    constexpr auto& of = Robot::chain.tool.pose;
    constexpr int turn = F::sine_cosine;
    return {{row(of.rotation, turn), row(of.rotation + 3, turn), row(of.rotation + 6, turn)},
            row(of.position, F::tool)};
  }

 private:
  static constexpr Vec3<Stored<Word>> row(const double* x, int exponent) {
    const auto nearest = [exponent](double value) {
      return Stored<Word>{static_cast<Word>(nearest_integer(value * power_of_two(exponent)))};
    };
    return {nearest(x[0]), nearest(x[1]), nearest(x[2])};
  }
};
template <class Word>
struct UnknownTurn<Stored<Word>> {
  static constexpr Stored<Word> value() { return {}; }
};

/// Whether the declared tool is within its declared reach.
constexpr bool is_within(const Tool& tool, const ToolLimit& limit) {
  const auto& origin = tool.pose.position;
  return !limit.declared || length_of(origin[0], origin[1], origin[2]) <= limit.reach * (1.0 + 1e-9);
}

/// What fixed point has no proved range for, yet (Unranged); with what to do about it. Said first, where a program
/// names the scene's inputs; every algorithm has them as an argument. All in one place, with no call between: each call
/// on the way is three lines of a compiler's.
template <class Scene, class Word>
struct Offered<Scene, Stored<Word>> {
  using No = Unranged<Scene>;
  static_assert(
      !No::model,
      "axial: a run-time Model has no formats for fixed point, which follow from a robot's type; describe the "
      "robot as a type, or compute in float");
  static_assert(!No::base_motion,
                "axial: fixed point needs a base at rest, for nothing declares how it moves; compute this scene in "
                "float");
  static_assert(!No::water, "axial: fixed point has no water; compute this scene in float");
  static_assert(!No::wrenches,
                "axial: fixed point has no ExternalWrenches; name TipWrench, or compute this scene in float");
  static_assert(!No::rotor_bodies,
                "axial: fixed point has no rotors as bodies; take RotorDynamics out of the scene, or compute in float");
  static_assert(!No::springs, "axial: fixed point has no JointSprings; compute them in float");
  static_assert(!No::composite_bodies,
                "axial: forward dynamics in fixed point is that of articulated bodies; take CompositeBody out");
  static_assert(!No::stribeck,
                "axial: fixed point has viscous and Coulomb friction, not stribeck(); compute this scene in float");
  static_assert(!No::smooth_speed, "axial: fixed point has no smooth_speed(); compute this scene in float");
  static constexpr bool leaves_room =
      !Scene::template has<Payload> || described_chain<typename Scene::Robot>.payload_limit.declared;
  static_assert(!Scene::template has<TipWrench> || described_chain<typename Scene::Robot>.tip_wrench_limit.declared,
                "axial: fixed point leaves room for the declared tip wrench; add axial::tip_wrench_limit(force, "
                "moment) to the robot's chain");
  static_assert(!Scene::template has<RuntimeTool> || described_chain<typename Scene::Robot>.tool_limit.declared,
                "axial: fixed point leaves room for the declared tool; add axial::tool_limit(reach) to the robot's "
                "chain");
  static_assert(!Scene::template has<RuntimeTool> || is_within(described_chain<typename Scene::Robot>.tool,
                                                               described_chain<typename Scene::Robot>.tool_limit),
                "axial: the robot's axial::tool() is beyond its axial::tool_limit(reach); give a reach that holds it");
};

/// Says it where no inputs are named.
template <class Scene, class Word>
constexpr void check_fixed_scene() {
  static_cast<void>(sizeof(Offered<Scene, Stored<Word>>));
  check_limits<Scene, Word>();
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

// Whether the run-time inputs that a scene names are there, are numbers and stand for what they are called: the one
// check of every call with a status. Fixed point has its own, on words (fixed/limits/inputs_check.hpp).
#pragma once

#include <axial/links/links.hpp>
#include <axial/links/soundness.hpp>
#include <axial/scene/joints.hpp>
#include <axial/scene/runtime_tool.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Whether a scene names a feature with a run-time input.
template <class S, class T>
inline constexpr bool has_run_time_inputs = !std::is_empty_v<detail::InputsOf<scene_of<S>, T>>;

/// Whether |x| > most >= 0, or x is NaN: numbers stand in the order of their bits. No comparison, which compilers may
/// make a branch or, for NaN, leave out.
template <class T, std::enable_if_t<std::is_floating_point_v<T>, int> = 0>
AXIAL_INLINE constexpr bool is_larger(const T& x, const T& most) {
  using Bits = typename detail::BitsOf<T>::type;
  constexpr int sign = 8 * static_cast<int>(sizeof(T)) - 1;
  const Bits size = (__builtin_bit_cast(Bits, x) << 1) >> 1;
  return static_cast<bool>((__builtin_bit_cast(Bits, most) - size) >> sign);
}
/// Whether x < 0, or NaN with a sign; -0 is not.
template <class T, std::enable_if_t<std::is_floating_point_v<T>, int> = 0>
AXIAL_INLINE constexpr bool is_below_zero(const T& x) {
  using Bits = typename detail::BitsOf<T>::type;
  constexpr int sign = 8 * static_cast<int>(sizeof(T)) - 1;
  const Bits bits = __builtin_bit_cast(Bits, x);
  return static_cast<bool>((bits & (bits - 1)) >> sign);
}

namespace detail {

/// What inputs may be at most where the robot declares nothing: no machine comes near.
namespace most {
inline constexpr double mass = 1e6, way = 1e3, inertia = 1e9, force = 1e9, moment = 1e9;  // kg, m, kg m^2, N, N m
inline constexpr double gravity = 1e3, speed = 1e3, turn_rate = 1e3, acceleration = 1e5;  // m/s^2, m/s, rad/s, per s
}  // namespace most

/// The limits of run-time inputs: as the robot declares them, where calls hold joints against declared limits too; else
/// `most`, and so for algorithms that take any state (Robot = void).
struct InputLimits {
  PayloadLimit load{most::mass, most::way, most::inertia, false};
  TipWrenchLimit wrench{most::force, most::moment, false};
  ToolLimit tool{most::way, false};
};
template <class Robot>
inline constexpr InputLimits input_limits = [] {
  InputLimits all;
  if constexpr (is_described<Robot>) {
    if (Robot::chain.payload_limit.declared) all.load = Robot::chain.payload_limit;
    if (Robot::chain.tip_wrench_limit.declared) all.wrench = Robot::chain.tip_wrench_limit;
    if (Robot::chain.tool_limit.declared) all.tool = Robot::chain.tool_limit;
  }
  return all;
}();

template <class T, class V>
AXIAL_INLINE constexpr void collect(Soundness<T>& all, const V& x) {
  all.number(x);
}
template <class T, class X, class Y, class Z>
AXIAL_INLINE constexpr void collect(Soundness<T>& all, const Vec3<X, Y, Z>& v) {
  all.number(v.x), all.number(v.y), all.number(v.z);
}
template <class T, class A, class B>
AXIAL_INLINE constexpr void collect(Soundness<T>& all, const ForceVector<A, B>& f) {
  collect(all, f.moment), collect(all, f.force);
}
template <class T, class A, class B>
AXIAL_INLINE constexpr void collect(Soundness<T>& all, const MotionVector<A, B>& m) {
  collect(all, m.angular), collect(all, m.linear);
}

/// The sine and cosine of an angle: on the circle to 2^-10, else as an angle without an exact sine.
template <class T>
AXIAL_INLINE constexpr void collect_pair(Soundness<T>& all, const SinCos<T>& pair) {
  all.angle(T(512) * T(largest_angles<Lane<T>>) * ((pair.sin * pair.sin - T(1)) + pair.cos * pair.cos));
}
/// A number that is at most `most` large in either direction; NaN is not.
template <class T>
AXIAL_INLINE constexpr void collect_magnitude(Soundness<T>& all, const T& x, double most) {
  constexpr double largest = static_cast<double>((std::numeric_limits<Lane<T>>::max)());
  all.range(is_larger(x, T(static_cast<Lane<T>>(most < largest ? most : largest))));
}
/// The square of what is at most `most` large, with room for its roundings.
template <class T>
AXIAL_INLINE constexpr void collect_square(Soundness<T>& all, const T& x, double most) {
  constexpr double slack = 1.0 + 4.0 * static_cast<double>(std::numeric_limits<Lane<T>>::epsilon());
  collect_magnitude(all, x, most * most * slack);
}

/// A vector of numbers, no longer than `longest`.
template <class T>
AXIAL_INLINE constexpr void collect_input(Soundness<T>& all, const Vec3<T>& v, double longest) {
  collect(all, v);
  collect_square(all, dot(v, v), longest);
}
template <class T>
AXIAL_INLINE constexpr void collect_wrench(Soundness<T>& all, const ForceVector<Vec3<T>, Vec3<T>>& f,
                                           const TipWrenchLimit& limit) {
  collect_input(all, f.moment, limit.moment), collect_input(all, f.force, limit.force);
}

/// A load: mass and moments of inertia not negative, nothing larger than declared.
template <class Robot, class T>
AXIAL_INLINE constexpr void collect_load(Soundness<T>& all, const PayloadBody<T>& load) {
  constexpr PayloadLimit limit = input_limits<Robot>.load;
  Soundness<T> body;
  const auto& j = load.inertia_com;
  const auto look = [&](double most, const auto&... x)
                        AXIAL_INLINE { ((body.number(x), collect_magnitude(body, x, most)), ...); };
  look(limit.mass, load.mass), look(limit.inertia, j.xx, j.yy, j.zz, j.xy, j.xz, j.yz);
  body.range(is_below_zero(load.mass)), body.range(is_below_zero(j.xx));
  body.range(is_below_zero(j.yy)), body.range(is_below_zero(j.zz));
  collect_input(body, load.com, limit.com_reach);
  all.load(body);
}

/// Axes that are a right-handed frame to a thousandth, an origin within the declared reach.
template <class Robot, class T>
AXIAL_INLINE constexpr void collect_tool(Soundness<T>& all, const Pose<Mat3<Vec3<T>>, Vec3<T>>& tool) {
  const auto& r = tool.rotation;
  const T off[] = {dot(r.x, r.x) - T(1), dot(r.y, r.y) - T(1), dot(r.z, r.z) - T(1),
                   dot(r.x, r.y),        dot(r.y, r.z),        dot(cross(r.x, r.y), r.z) - T(1)};
  T sum = T(0);
  for (const T& x : off)
    sum = sum + x * x;
  collect_magnitude(all, sum, 1e-6);
  collect_square(all, dot(tool.position, tool.position), input_limits<Robot>.tool.reach);
}

/// Run-time inputs of a scene, one after the other; sine-cosine pairs of its turning joints among them. `Robot` is
/// whose declared limits they are held against.
template <class Robot = void, class Links, class T, class Input>
AXIAL_INLINE constexpr void collect_inputs(Soundness<T>& all, const Links& links, const Input& in) {
  using Scene = typename Links::Scene;
  if constexpr (std::is_floating_point_v<Lane<T>>) {
    if constexpr (Scene::template has<RuntimeGravity>) collect_input(all, in.gravity, most::gravity);
    if constexpr (Scene::template has<BaseMotion> || Scene::template has<FloatingBase>)
      collect_input(all, in.base_motion.angular_velocity, most::turn_rate);
    if constexpr (Scene::template has<BaseMotion>) {  // a free base's accelerations are the answer, not asked for
      collect_input(all, in.base_motion.angular_acceleration, most::acceleration);
      collect_input(all, in.base_motion.linear_acceleration, most::acceleration);
    }
    constexpr TipWrenchLimit any{most::force, most::moment, false};
    if constexpr (Scene::template has<BaseWrench>) collect_wrench(all, in.base_wrench, any);
    if constexpr (Scene::template has<VelocityThroughWater>) collect_input(all, in.velocity_through_water, most::speed);
    if constexpr (Scene::template has<TipWrench>) collect_wrench(all, in.tip_wrench, input_limits<Robot>.wrench);
    if constexpr (Scene::template has<ExternalWrenches>)
      for (const auto& wrench : in.wrenches.values)
        collect_wrench(all, wrench, any);
    if constexpr (Scene::template has<Payload>) collect_load<Robot>(all, in.payload);
    if constexpr (Scene::template has<RuntimeTool>) collect_tool<Robot>(all, in.tool);
    if constexpr (Scene::template has<SineCosines>)
      for_each_link(links, [&](auto i) AXIAL_INLINE {
        links.link(i).on_joint([&](auto kind) AXIAL_INLINE {
          if constexpr (std::is_same_v<decltype(kind), Revolute>) collect_pair(all, in.turns[i]);
        });
      });
  }
}

/// The status of a scene's run-time inputs alone, held against what its robot declares.
template <class S, class T>
[[nodiscard]] AXIAL_INLINE constexpr StatusOf<T> inputs_status(const Inputs<S, T>& in) {
  Soundness<T> all;
  constexpr auto links = links_of<S, T>();
  collect_inputs<typename scene_of<S>::Robot>(all, execute<JointLinks>(links), in);
  auto status = all.status();
  put_where(status, all.is_load_beyond(), Status::Code::payload_limit);  // whatever it is, NaN too
  return status;
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>

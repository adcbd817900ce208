// What an algorithm costs for a scene, known to the compiler:
// static_assert(cost<Scene>(algorithm::inverse_dynamics).total() < 800, "my control tick").
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/algorithm.hpp>
#include <axial/scalar/counting.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

template <class V>
constexpr void need(const V& values) {
  for (const auto& value : values)
    value.need();
}
constexpr void need(const Vec3<Counting>& v) { v.x.need(), v.y.need(), v.z.need(); }
constexpr void need(const WorldPose<Counting>& p) {
  need(p.rotation.x), need(p.rotation.y), need(p.rotation.z), need(p.position);
}

template <class S>
constexpr void need_all(const Joints<S, Counting>& result) {
  need(result.values);
}
template <class S>
constexpr void need_all(const FloatingDynamics<S, Counting>& result) {
  need(result.values);
  need(result.base_acceleration.angular), need(result.base_acceleration.linear);
}
constexpr void need_all(const ForceVector<Vec3<Counting>, Vec3<Counting>>& f) { need(f.moment), need(f.force); }
template <class S>
constexpr void need_all(const MassMatrix<S, Counting>& result) {
  need(result.values);
}
template <class S>
constexpr void need_all(const ForwardKinematics<S, Counting>& result) {
  need(result.tool);
}
template <class S>
constexpr void need_all(const Jacobian<S, Counting>& result) {
  for (const auto& column : result.columns)
    need(column.angular), need(column.linear);
}

template <class S>
constexpr void need_all(const Separated<S, Counting>& result) {
  for (int i = 0; i < result.size; ++i)
    need(result.A[i]), need(result.B[i]), need(result.C[i]);
  need(result.G);
}

template <class S, class By>
constexpr void need_all(const JointMatrix<S, Counting, By>& result) {
  need(result.values);
}
template <class S, class... Wanted>
constexpr void need_all(const InverseDynamicsDerivatives<S, Counting, Wanted...>& result) {
  using R = InverseDynamicsDerivatives<S, Counting, Wanted...>;
  if constexpr (R::template has<with_efforts>) need_all(result.tau);
  if constexpr (R::template has<with_mass_matrix>) need_all(result.M);
  if constexpr (R::template has<with_position_jacobian>) need_all(result.dtau_dq);
  if constexpr (R::template has<with_velocity_jacobian>) need_all(result.dtau_dqd);
}

template <class S, class... Wanted>
constexpr void need_all(const ForwardDynamicsDerivatives<S, Counting, Wanted...>& result) {
  using R = ForwardDynamicsDerivatives<S, Counting, Wanted...>;
  need_all(result.qdd);
  if constexpr (R::template has<with_inverse_mass_matrix>) need_all(result.M_inverse);
  if constexpr (R::template has<with_acceleration_by_position>) need_all(result.dqdd_dq);
  if constexpr (R::template has<with_acceleration_by_velocity>) need_all(result.dqdd_dqd);
}

template <class S>
constexpr void need_all(const TorqueRegressor<S, Counting>& result) {
  need(result.values);
}
template <class S>
constexpr void need_all(const EffortsAlong<S, Counting>& result) {
  need_all(result.tau), need_all(result.dtau);
}
template <class S>
constexpr void need_all(const AccelerationsAlong<S, Counting>& result) {
  need_all(result.qdd), need_all(result.dqdd);
}

template <class S>
constexpr void need_all(const MomentumTerms<S, Counting>& result) {
  need_all(result.momentum), need_all(result.drift);
}
template <class S>
constexpr void need_all(const TorqueRates<S, Counting>& result) {
  need_all(result.tau), need_all(result.taud), need_all(result.taudd);
}
template <class S>
constexpr void need_all(const ElasticFeedforward<S, Counting>& result) {
  need_all(result.tau_m), need_all(result.theta), need_all(result.thetad), need_all(result.tau_l);
}

// Run-time inputs count as such.
constexpr void traced(Trace& trace, Counting& value) { value = Counting(trace); }
template <class... Parts>
constexpr void traced_all(Trace& trace, Parts&... parts);
constexpr void traced(Trace& trace, Vec3<Counting>& v) { traced_all(trace, v.x, v.y, v.z); }
constexpr void traced(Trace& trace, Sym3<Counting>& s) { traced_all(trace, s.xx, s.yy, s.zz, s.xy, s.xz, s.yz); }
constexpr void traced(Trace& trace, ForceVector<Vec3<Counting>, Vec3<Counting>>& f) {
  traced_all(trace, f.moment, f.force);
}
constexpr void traced(Trace& trace, SinCos<Counting>& pair) { traced_all(trace, pair.sin, pair.cos); }
constexpr void traced(Trace& trace, PayloadBody<Counting>& body) {
  traced_all(trace, body.mass, body.com, body.inertia_com);
}
constexpr void traced(Trace& trace, GivenMotion<Counting>& base) {
  traced_all(trace, base.angular_velocity, base.angular_acceleration, base.linear_acceleration);
}
template <class S, class V>
constexpr void traced(Trace& trace, Joints<S, V>& joints) {
  for (auto& value : joints.values)
    traced(trace, value);
}
template <class S>
constexpr void traced(Trace& trace, MotionDirection<S, Counting>& by) {
  traced_all(trace, by.dq, by.dqd, by.dqdd);
}
template <class S>
constexpr void traced(Trace& trace, StateDirection<S, Counting>& by) {
  traced_all(trace, by.dq, by.dqd, by.dtau);
}
template <class S>
constexpr void traced(Trace& trace, HigherDerivatives<S, Counting>& by) {
  traced_all(trace, by.q3, by.q4);
}
template <class S>
constexpr void traced(Trace& trace, Separated<S, Counting>& s) {
  for (int i = 0; i < s.size; ++i) {
    for (int j = 0; j < s.size; ++j)
      traced_all(trace, s.A[i][j], s.C[i][j]);
    for (auto& value : s.B[i])
      traced(trace, value);
    traced(trace, s.G[i]);
  }
}
template <class... Parts>
constexpr void traced_all(Trace& trace, Parts&... parts) {
  (traced(trace, parts), ...);
}

template <class S>
constexpr void trace_inputs(Inputs<S, Counting>& in, Trace& trace) {
  using Scene = scene_of<S>;
  if constexpr (Scene::template has<axial::RuntimeGravity>) traced(trace, in.gravity);
  if constexpr (Scene::template has<axial::BaseWrench>) traced(trace, in.base_wrench);
  if constexpr (Scene::template has<axial::BaseMotion> || Scene::template has<axial::FloatingBase>)
    traced(trace, in.base_motion);
  if constexpr (Scene::template has<axial::VelocityThroughWater>) traced(trace, in.velocity_through_water);
  if constexpr (Scene::template has<axial::TipWrench>) traced(trace, in.tip_wrench);
  if constexpr (Scene::template has<axial::ExternalWrenches>) traced(trace, in.wrenches);
  if constexpr (Scene::template has<axial::Payload>) traced(trace, in.payload);
  if constexpr (Scene::template has<axial::SineCosines>) traced(trace, in.turns);
}

template <class Algorithm, class = void>
inline constexpr bool takes_higher = false;
template <class Algorithm>
inline constexpr bool takes_higher<Algorithm, std::void_t<decltype(Algorithm::joint_values)>> =
    Algorithm::joint_values == 5;
template <class S, class Algorithm, class... Direction>
constexpr Operations counted(Algorithm, Direction... direction) {
  Trace trace;
  Joints<robot_of<S>, Counting> q{}, qd{}, x{};
  traced_all(trace, q, qd, x, direction...);
  Inputs<S, Counting> in{};
  trace_inputs<S>(in, trace);
  need_all(Algorithm::template run<S>(q, qd, x, direction..., in));
  return trace.operations();
}

}  // namespace detail

/// Multiplications, additions, divisions and sine-cosine pairs of an algorithm (`algorithm::inverse_dynamics`, ...) for
/// a scene or robot. Counted as an optimising compiler leaves them: see Operations. The robot's constants count as
/// numbers, whatever their values; 0 and +-1 cost nothing. Constant expression; clang's default limit of steps
/// (-fconstexpr-steps) suits about ten joints.
template <class S, class Algorithm>
[[nodiscard]] constexpr Operations cost(Algorithm algorithm) {
  constexpr bool solves = std::is_same_v<Algorithm, algorithm::ForwardDynamics>;
  if constexpr (solves) detail::check_resisted<scene_of<S>>();
  if constexpr (solves && !every_joint_is_resisted<S>())
    return {};  // the message alone
  else if constexpr (detail::takes_higher<Algorithm>)
    return detail::counted<S>(algorithm, HigherDerivatives<S, Counting>{});
  else
    return detail::counted<S>(algorithm);
}
/// Overloads for an algorithm along a direction.
///@{
template <class S>
[[nodiscard]] constexpr Operations cost(algorithm::InverseDynamicsAlong algorithm) {
  return detail::counted<S>(algorithm, MotionDirection<robot_of<S>, Counting>{});
}
template <class S>
[[nodiscard]] constexpr Operations cost(algorithm::ForwardDynamicsAlong algorithm) {
  return detail::counted<S>(algorithm, StateDirection<robot_of<S>, Counting>{});
}
///@}
/// Overload for a torque whose terms come from a separate() that was paid for before.
template <class S>
[[nodiscard]] constexpr Operations cost(algorithm::SeparatedTorque) {
  Trace trace;
  Separated<S, Counting> separated{};
  Joints<robot_of<S>, Counting> qd{}, qdd{};
  detail::traced_all(trace, separated, qd, qdd);
  detail::need_all(algorithm::SeparatedTorque::run(separated, qd, qdd));
  return trace.operations();
}

}  // namespace axial

#include <axial/options/end.hpp>

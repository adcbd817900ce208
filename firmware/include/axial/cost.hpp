// What an algorithm costs for a scene, known to the compiler:
// static_assert(cost<Scene>(algorithm::inverse_dynamics).total() < 800, "my control tick").
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/algorithm.hpp>
#include <axial/scalar/counting.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// Calls F for every number of what an algorithm takes or answers, whatever holds it.
template <class F>
class EachNumber {
 public:
  constexpr explicit EachNumber(const F& f) : f_(f) {}
  template <class... Parts>
  constexpr void operator()(Parts&... parts) const {
    (of(parts), ...);
  }

 private:
  constexpr void of(Counting& value) const { f_(value); }
  constexpr void of(Vec3<Counting>& v) const { (*this)(v.x, v.y, v.z); }
  constexpr void of(Sym3<Counting>& s) const { (*this)(s.xx, s.yy, s.zz, s.xy, s.xz, s.yz); }
  constexpr void of(Mat3<Vec3<Counting>>& rows) const { (*this)(rows.x, rows.y, rows.z); }
  constexpr void of(ForceVector<Vec3<Counting>, Vec3<Counting>>& f) const { (*this)(f.moment, f.force); }
  constexpr void of(MotionVector<Vec3<Counting>, Vec3<Counting>>& m) const { (*this)(m.angular, m.linear); }
  constexpr void of(SinCos<Counting>& pair) const { (*this)(pair.sin, pair.cos); }
  constexpr void of(PayloadBody<Counting>& body) const { (*this)(body.mass, body.com, body.inertia_com); }
  constexpr void of(GivenMotion<Counting>& base) const {
    (*this)(base.angular_velocity, base.angular_acceleration, base.linear_acceleration);
  }
  template <class V, std::size_t n>
  constexpr void of(V (&values)[n]) const {
    for (auto& value : values)
      of(value);
  }
  /// Of joint values and matrices.
  template <class V>
  constexpr auto of(V& held) const -> std::void_t<decltype(held.values)> {
    of(held.values);
  }
  template <class S>
  constexpr void of(FloatingDynamics<S, Counting>& result) const {
    (*this)(result.values, result.base_acceleration);
  }
  template <class S>
  constexpr void of(ForwardKinematics<S, Counting>& result) const {
    (*this)(result.tool.rotation, result.tool.position);
  }
  template <class S>
  constexpr void of(Jacobian<S, Counting>& result) const {
    of(result.columns);
  }
  template <class S>
  constexpr void of(Separated<S, Counting>& terms) const {
    (*this)(terms.A, terms.B, terms.C, terms.G);
  }
  template <class S, class... Wanted>
  constexpr void of(InverseDynamicsDerivatives<S, Counting, Wanted...>& result) const {
    using R = InverseDynamicsDerivatives<S, Counting, Wanted...>;
    if constexpr (R::template has<with_efforts>) of(result.tau);
    if constexpr (R::template has<with_mass_matrix>) of(result.M);
    if constexpr (R::template has<with_position_jacobian>) of(result.dtau_dq);
    if constexpr (R::template has<with_velocity_jacobian>) of(result.dtau_dqd);
  }
  template <class S, class... Wanted>
  constexpr void of(ForwardDynamicsDerivatives<S, Counting, Wanted...>& result) const {
    using R = ForwardDynamicsDerivatives<S, Counting, Wanted...>;
    of(result.qdd);
    if constexpr (R::template has<with_inverse_mass_matrix>) of(result.M_inverse);
    if constexpr (R::template has<with_acceleration_by_position>) of(result.dqdd_dq);
    if constexpr (R::template has<with_acceleration_by_velocity>) of(result.dqdd_dqd);
  }
  template <class S>
  constexpr void of(EffortsAlong<S, Counting>& result) const {
    (*this)(result.tau, result.dtau);
  }
  template <class S>
  constexpr void of(AccelerationsAlong<S, Counting>& result) const {
    (*this)(result.qdd, result.dqdd);
  }
  template <class S>
  constexpr void of(MomentumTerms<S, Counting>& result) const {
    (*this)(result.momentum, result.drift);
  }
  template <class S>
  constexpr void of(TorqueRates<S, Counting>& result) const {
    (*this)(result.tau, result.taud, result.taudd);
  }
  template <class S>
  constexpr void of(ElasticFeedforward<S, Counting>& result) const {
    (*this)(result.tau_m, result.theta, result.thetad, result.tau_l);
  }
  template <class S>
  constexpr void of(MotionDirection<S, Counting>& by) const {
    (*this)(by.dq, by.dqd, by.dqdd);
  }
  template <class S>
  constexpr void of(StateDirection<S, Counting>& by) const {
    (*this)(by.dq, by.dqd, by.dtau);
  }
  template <class S>
  constexpr void of(HigherDerivatives<S, Counting>& by) const {
    (*this)(by.q3, by.q4);
  }

  const F& f_;
};
/// Asks for every number of an answer.
template <class Answer>
constexpr void need_all(Answer answer) {
  const auto need = [](const Counting& value) { value.need(); };
  EachNumber{need}(answer);
}
/// Run-time inputs count as such.
template <class... Given>
constexpr void trace_all(Trace& trace, Given&... given) {
  const auto input = [&trace](Counting& value) { value = Counting(trace); };
  EachNumber{input}(given...);
}
template <class S>
constexpr void trace_inputs(Inputs<S, Counting>& in, Trace& trace) {
  using Scene = scene_of<S>;
  if constexpr (Scene::template has<axial::RuntimeGravity>) trace_all(trace, in.gravity);
  if constexpr (Scene::template has<axial::BaseWrench>) trace_all(trace, in.base_wrench);
  if constexpr (Scene::template has<axial::BaseMotion> || Scene::template has<axial::FloatingBase>)
    trace_all(trace, in.base_motion);
  if constexpr (Scene::template has<axial::VelocityThroughWater>) trace_all(trace, in.velocity_through_water);
  if constexpr (Scene::template has<axial::TipWrench>) trace_all(trace, in.tip_wrench);
  if constexpr (Scene::template has<axial::ExternalWrenches>) trace_all(trace, in.wrenches);
  if constexpr (Scene::template has<axial::Payload>) trace_all(trace, in.payload);
  if constexpr (Scene::template has<axial::SineCosines>) trace_all(trace, in.turns);
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
  trace_all(trace, q, qd, x, direction...);
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
  else if constexpr (std::is_same_v<Algorithm, algorithm::InverseDynamicsAlong>)
    return detail::counted<S>(algorithm, MotionDirection<robot_of<S>, Counting>{});
  else if constexpr (std::is_same_v<Algorithm, algorithm::ForwardDynamicsAlong>)
    return detail::counted<S>(algorithm, StateDirection<robot_of<S>, Counting>{});
  else
    return detail::counted<S>(algorithm);
}
/// Overload for a torque whose terms come from a separate() that was paid for before.
template <class S>
[[nodiscard]] constexpr Operations cost(algorithm::SeparatedTorque) {
  Trace trace;
  Separated<S, Counting> separated{};
  Joints<robot_of<S>, Counting> qd{}, qdd{};
  detail::trace_all(trace, separated, qd, qdd);
  detail::need_all(algorithm::SeparatedTorque::run(separated, qd, qdd));
  return trace.operations();
}

}  // namespace axial

#include <axial/options/end.hpp>

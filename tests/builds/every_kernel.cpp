// Every kernel that a user can call, instantiated over every kind of number: for what a compiler has to say about them.
// The build gives the headers (-include); robots are a planar arm, the SCARA of the closed form, a tree, and an arm
// whose joints share drives.
#include <robots/planar2r.hpp>
#include <robots/scara.hpp>
#include <robots/two_arm.hpp>
#include <robots/wrist_arm.hpp>

#ifndef AXIAL_KERNELS_OF
#define AXIAL_KERNELS_OF 0  // all; or 1 float, 2 double, 3 fixed point
#endif

namespace {

using namespace axial;

struct Drive {
  template <class Instant, class Tau, class In>
  constexpr void operator()(const Instant&, Tau&, In&) const {}
};

template <class S, class T>
bool kinematics(const Positions<robot_of<S>, T>& q, const Inputs<S, T>& in) {
  return check_finite(forward_kinematics<S>(q, in).tool).ok() && check_finite(jacobian<S>(q, in)).ok();
}

template <class S, class T>
bool dynamics(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
              const Accelerations<robot_of<S>, T>& qdd, const Inputs<S, T>& in) {
  auto tau = inverse_dynamics<S>(q, qd, qdd, in);
  tau[0] = joint_torque<S, 0>(q, qd, qdd, in);
  const auto m = mass_matrix<S>(q, in);
  const auto a = forward_dynamics<S, T>(q, qd, tau, in);
  const auto terms = momentum_terms<S>(q, qd, in);
  return gravity_torque<S>(q, in)[0] == bias_torque<S>(q, qd, in)[0] && check_finite(m).ok() && a.status.ok() &&
         terms.status.ok();
}

template <class S, class T>
bool separated(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
               const Accelerations<robot_of<S>, T>& qdd) {
  TwoRateState<S, T> slow{};
  return refresh<S>(slow, q).ok() && two_rate_feedforward<S>(slow, qd, qdd).status.ok() &&
         check_finite(torque(separate<S>(q), qd, qdd)).ok();
}

template <class S, class T>
bool differentiated(const Inputs<S, T>& in = {}) {
  const Joints<robot_of<S>, T> x{};
  const auto inverse = inverse_dynamics_derivatives<S>(x, x, x, in);
  const auto forward = forward_dynamics_derivatives<S>(x, x, x, in);
  const auto along = inverse_dynamics_along<S>(x, x, x, {x, x, x}, in);
  const auto driven = forward_dynamics_along<S>(x, x, x, {x, x, x}, in);
  const auto y = torque_regressor<S>(x, x, x, in);
  return check_finite(inverse.tau, along.tau).ok() && forward.qdd.status.ok() && driven.qdd.status.ok() &&
         y(0, 0, InertialParameter::xx) == along.dtau[0];
}

template <class S>
bool differentiated_in_words() {
  const Positions<S, Fixed32> q{};
  const Velocities<S, Fixed32> qd{};
  const auto inverse = inverse_dynamics_derivatives<S>(q, qd, Accelerations<S, Fixed32>{});
  return forward_dynamics_derivatives<S>(q, qd, inverse.tau).qdd.status.ok() &&
         certified_forward_dynamics_derivatives<S>(q, qd, inverse.tau).qdd.status.ok();
}

struct Harmonic {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -9.81, 0.0), revolute().mass(1).com(0.5, 0, 0).stiffness(4000.0));
};
template <class R, class T, class... Form>
bool rated() {
  using S = Scene<R, Gravity, RotorInertia, Form...>;
  const Joints<R, T> x{};
  return check_finite(torque_rates<S>(x, x, x, x).taud, torque_rates<S>(x, x, x, x, x).taudd).ok();
}
template <class T, class... Form>
bool elastic_joints() {
  using S = Scene<Harmonic, Gravity, RotorInertia, Friction, ElasticJoints, Form...>;
  const Joints<Harmonic, T> x{};
  return check_finite(elastic_feedforward<S>(x, x, x, x, x).tau_m).ok();
}

template <class S, class T>
bool control(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
             const Accelerations<robot_of<S>, T>& qdd, const Inputs<S, T>& in) {
  FeedforwardState<S, T> state{};
  FallBack<S, T> drives{FallBackTimes{}};
  drives.advance(1, in);
  return feedforward<S>(state, q, qd, qdd, in).status.ok() && clamped_request<S>(q, qd, qdd).status.ok() &&
         drives.hold_at(q, in);
}

struct Tuning {
  static constexpr double period = 1e-3, gain = 200.0;
  static constexpr double fraction = 0.025, uncertainty = 0.05, release = 0.5;
  static constexpr int confirm = 3, calm = 5;
  static constexpr double deviation = 0.001, memory = 100.0, mass_deviation = 0.02, moment_deviation = 0.01;
};

template <class S, class T>
bool observed(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd, const EffortsOf<S, T>& tau) {
  ObserverState<S, T, Tuning> observer{};
  CollisionState collision{};
  PayloadState<S, T> payload{};
  return observe<S, T, Tuning>(observer, q, qd, tau).ok() && detect(collision, observer.residual).status.ok() &&
         update_payload<S, T, Tuning>(payload, q, qd, observer.residual).ok() && estimate<Tuning>(payload).status.ok();
}

template <class T>
bool modelled() {
  using M = Model<2, Gravity, RotorInertia>;
  M model;
  const Positions<M, T> q{};
  const auto tau = inverse_dynamics(model, q, q, q);
  return model.add(robots::Planar2r::chain.links[0]) && check_finite(mass_matrix(model, q)).ok() &&
         forward_dynamics(model, q, q, tau).status.ok() && check_finite(forward_kinematics(model, q).tool).ok() &&
         check_finite(torque(model, separate(model, q), q, q)).ok();
}

// What the compiler computes of kernels.
template <class S>
bool counted() {
  constexpr Operations operations = cost<S>(algorithm::inverse_dynamics);
  return operations.total() > 0 && cost<S>(algorithm::forward_dynamics).total() > 0;
}
template <class S>
bool bounded() {
  constexpr auto bound = error_bound<S>(algorithm::inverse_dynamics);
  return bound.worst() < 1.0 && error_bound<S>(algorithm::mass_matrix).worst() < 1.0;
}

// The border of fixed point.
template <class S>
bool converted() {
  using Q = Positions<S, Fixed32>;
  const Joints<S, float> x{};
  const auto q = to_fixed<Q>(x);
  const auto request = to_fixed_request<S, std::int32_t>(x, x, x);
  using Values = Velocities<S, Fixed32>;
  return q.status.ok() && request.status.ok() && to_real<float>(q.values)[0] == x[0] &&
         RotaryEncoder<4096>::velocity<Values, 0>(1).status.ok();
}

// A wrench at the tip of a robot that declares one.
struct Pushed {
  static constexpr auto chain = [] {
    auto c = robots::Scara::chain;
    c.tip_wrench_limit = tip_wrench_limit(20.0, 5.0);
    c.payload_limit = payload_limit(2.0, 0.3, 0.05), c.tool_limit = tool_limit(0.3);
    return c;
  }();
};
template <class T>
bool pushed() {
  const auto columns = jacobian<Pushed>(Positions<Pushed, T>{});
  return columns.status.ok() && transpose_times(columns, {}).size == 3;
}
// A tool and a payload in its frame, in words.
[[maybe_unused]] bool held() {
  using S = Scene<Pushed, RuntimeTool, Payload>;
  Inputs<S, Fixed32> in;
  const auto tool = to_fixed_tool<S, std::int32_t>(Inputs<S, float>{}.tool);
  const auto payload = to_fixed_payload<S, std::int32_t>(PayloadBody<float>{});
  in.tool = tool.tool, in.payload = mounted_payload<S>(in.tool, payload.load).load;
  return tool.status.ok() && forward_kinematics<S>({}, in).status.ok();
}

// Called with every answer, so that none is left out behind one that is not ok: kernels run under sanitizers, too.
template <class... Ok>
bool all(Ok... ok) {
  return (ok && ...);
}

template <class S, class T>
bool all_of() {
  const Positions<robot_of<S>, T> q{};
  const Velocities<robot_of<S>, T> qd{};
  const Accelerations<robot_of<S>, T> qdd{};
  const Inputs<S, T> in{};
  bool observer = true;
  if constexpr (!std::is_same_v<T, Fixed16>) observer = observed<robot_of<S>, T>(q, qd, {});
  return all(observer, kinematics<S, T>(q, in), dynamics<S, T>(q, qd, qdd, in), control<S, T>(q, qd, qdd, in));
}

template <class S, class T>
bool simulated() {
  CompensatedMotion<S, T> x{};
  const T h = step_limit<SemiImplicitEuler, S>(x.q);
  return advance<SemiImplicitEuler>(x, h, Drive{}).ok() && advance<RungeKutta4>(x, h, Drive{}).ok() &&
         advance<LinearlyImplicitEuler>(x, h, Drive{}).ok();
}

template <class S, class T>
bool in_batches() {
  Joints<robot_of<S>, T> states[8] = {};
  const auto q = load<8>(states);
  const Inputs<S, std::decay_t<decltype(q[0])>> in{};
  store(inverse_dynamics<S>(q, q, q, in), states);
  const auto answer = forward_dynamics<S>(q, q, q, in);
  return check_request<S>(q, q, q).ok() && check_position<S>(q).ok() && check_finite(q, q).ok() && answer.status.ok() &&
         forward_kinematics<S>(q, in).status.ok() && jacobian<S>(q, in).status.ok() && separate<S>(q, in).status.ok() &&
         momentum_terms<S>(q, q, in).status.ok() && is_finite(mass_matrix<S>(q, in)(0, 0))[0] && lane(q, 0)[0] < T(1);
}

/// A step in words of joints that stick and that meet end stops.
struct Soft {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[5] = {}, damping[5] = {};
};
template <class S>
bool between_stops() {
  axial::Motion<S, Fixed32> x{};
  const Held<S, Fixed32> held{};
  return advance<StickingFor<Soft>>(x, WithEndStops<S, Fixed32, Held<S, Fixed32>>(held, {})).ok();
}

template <class Robot, class... Tags>
using Loaded = Scene<Robot, Gravity, RotorInertia, Friction, Payload, Tags...>;

}  // namespace

#if AXIAL_KERNELS_OF == 0 || AXIAL_KERNELS_OF == 1
AXIAL_C_DECLARE(arm, 3, float);
AXIAL_C_EXPORT(arm, robots::Scara, float)
AXIAL_C_DECLARE_DERIVATIVES(arm);
AXIAL_C_EXPORT_DERIVATIVES(arm, robots::Scara, float)

bool in_float();
bool in_float() {
  using robots::Planar2r, robots::Scara, robots::TwoArm;
  return all(all_of<Planar2r, float>(), all_of<TwoArm, float>(), all_of<Loaded<Scara>, float>(),
             all_of<Loaded<robots::WristArm>, float>(), separated<Scara, float>({}, {}, {}),
             simulated<Planar2r, float>(), differentiated<Planar2r, float>(), rated<Planar2r, float>(),
             elastic_joints<float>(), modelled<float>(), counted<Scara>(), in_batches<Planar2r, float>(),
             pushed<float>(),
             check_finite(closed_form::scara_torque<Scara>(Joints<Scara, float>{}, Joints<Scara, float>{},
                                                           Joints<Scara, float>{}))
                 .ok());
}
#endif

#if AXIAL_KERNELS_OF == 0 || AXIAL_KERNELS_OF == 2
AXIAL_C_DECLARE(springs, 1, double);
AXIAL_C_EXPORT(springs, Harmonic, double)
AXIAL_C_DECLARE_ELASTIC(springs);
AXIAL_C_EXPORT_ELASTIC(springs, Harmonic, double)

bool in_double();
bool in_double() {
  using robots::Planar2r, robots::Scara;
  return all(all_of<Planar2r, double>(), all_of<Loaded<Scara, Looped>, double>(), simulated<Planar2r, double>(),
             rated<Scara, double, Looped>(), elastic_joints<double, Looped>(),
             differentiated<Loaded<Scara, Looped>, double>(), modelled<double>(),
             in_batches<Loaded<Scara, Looped>, double>());
}
#endif

#if AXIAL_KERNELS_OF == 0 || AXIAL_KERNELS_OF == 3
AXIAL_C_DECLARE(fixed_arm, 3, fixed32);
AXIAL_C_EXPORT(fixed_arm, robots::Scara, fixed32)

bool in_fixed_point();
bool in_fixed_point() {
  using robots::Planar2r, robots::Scara;
  return all(all_of<Planar2r, Fixed32>(), all_of<Planar2r, Fixed16>(), all_of<Loaded<Scara>, Fixed32>(),
             all_of<Loaded<robots::WristArm>, Fixed32>(), between_stops<Loaded<robots::WristArm>>(),
             separated<Scara, Fixed32>({}, {}, {}), converted<Planar2r>(), bounded<Planar2r>(), pushed<Fixed32>(),
             held(), pushed<Fixed16>(), certified_forward_dynamics<Planar2r, Fixed32>({}, {}, {}).status.ok(),
             differentiated_in_words<Planar2r>(),
             closed_form::scara_torque<Scara>(Positions<Scara, Fixed32>{}, Velocities<Scara, Fixed32>{},
                                              Accelerations<Scara, Fixed32>{})[0]
                     .raw == 0);
}
#endif

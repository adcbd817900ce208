#pragma once
/// Every public call with a status, asked of hostile numbers: none may say ok where NaN or infinity went in or came
/// out.

#include <axial/batch.hpp>
#include <axial/c_interface/derivatives.hpp>
#include <axial/c_interface/export.hpp>
#include <axial/closed_form/scara.hpp>
#include <axial/control/collision.hpp>
#include <axial/control/current_limit.hpp>
#include <axial/control/fall_back.hpp>
#include <axial/control/payload_estimator.hpp>
#include <axial/control/position_command.hpp>
#include <axial/control/tracking.hpp>
#include <axial/control/two_rate.hpp>
#include <axial/derivatives/forward_dynamics_along.hpp>
#include <axial/derivatives/forward_dynamics_derivatives.hpp>
#include <axial/dynamics/check_finite.hpp>
#include <axial/fixed.hpp>
#include <axial/simulation/integrators.hpp>
#include <robots/scara.hpp>

#include "draw.hpp"

namespace axial::apps {

/// A tree of three joints that declares everything.
struct Hosted {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0), payload_limit(1.0, 0.1, 0.02),
                                             tip_wrench_limit(50.0, 20.0), tool_limit(0.3),
                                             revolute()
                                                 .mass(4)
                                                 .com(0.1, 0.0, 0.05)
                                                 .inertia_com(0.05, 0.06, 0.07)
                                                 .rotor_inertia(2e-5, 100.0)
                                                 .viscous(0.5)
                                                 .stiffness(8000.0)
                                                 .position_limits(-3, 3)
                                                 .speed_limit(4)
                                                 .acceleration_limit(20)
                                                 .effort_limit(100),
                                             prismatic()
                                                 .a(0.3)
                                                 .alpha_deg(90)
                                                 .mass(2)
                                                 .com(0.0, 0.02, 0.1)
                                                 .inertia_com(0.01, 0.01, 0.004)
                                                 .position_limits(-1, 1)
                                                 .speed_limit(1.5)
                                                 .acceleration_limit(10)
                                                 .effort_limit(80),
                                             revolute()
                                                 .a(0.1)
                                                 .alpha_deg(-90)
                                                 .mass(1)
                                                 .com(0.05, 0.01, 0.0)
                                                 .inertia_com(0.004, 0.003, 0.005)
                                                 .position_limits(-2, 2)
                                                 .speed_limit(6)
                                                 .acceleration_limit(40)
                                                 .effort_limit(30));
};
using Plain = Scene<Hosted, Gravity, RotorInertia>;
using Laden = Scene<Hosted, RuntimeGravity, RotorInertia, Friction, Payload, TipWrench>;
using Compact = Scene<Hosted, Gravity, RotorInertia, Looped>;
using Given = Scene<Hosted, Gravity, SineCosines, Payload>;
using Carried = Scene<Hosted, Gravity, BaseMotion, RuntimeTool>;

struct HostedTuning {
  static constexpr double period = 1e-3, gain = 200.0;
  static constexpr double fraction = 0.025, uncertainty = 0.05, release = 0.5;
  static constexpr int confirm = 3, calm = 5;
  static constexpr double deviation = 0.001, memory = 100.0, mass_deviation = 0.02, moment_deviation = 0.01;
};

}  // namespace axial::apps

AXIAL_C_DECLARE(hosted, 3, float);
AXIAL_C_DECLARE_DERIVATIVES(hosted);

namespace axial::apps {

/// Calls of a scene S over numbers T, each by a name.
template <class S, class T>
struct Calls {
  using R = robot_of<S>;
  using Q = Positions<R, T>;
  using Qd = Velocities<R, T>;
  using Qdd = Accelerations<R, T>;
  using Tau = EffortsOf<S, T>;

  /// What a tick is asked, in the order in which calls take it.
  struct Asked {
    explicit Asked(Draw& draw) : in(draw.inputs<S, T>()), q(positions(draw)) {}
    /// What is given as a pair is no position.
    static Q positions(Draw& draw) {
      Q q{};
      for (int i = 0; i < joint_count<S>; ++i)
        if (!(scene_of<S>::template has<SineCosines> && R::chain.links[i].type == JointType::revolute))
          q[i] = draw.number<T>(1.2);
      return q;
    }
    Inputs<S, T> in;
    Q q;
  };
  /// An answer whose numbers are `values`, behind which stands its status.
  template <class Answer>
  static Verdict answered(const Draw& draw, const Answer& answer) {
    return judged(answer.status, draw.finite(), all_finite<T>(answer.values));
  }

  static Verdict forward(Draw& draw) {
    const Asked x(draw);
    const Qd qd = draw.joints<Qd>(2.0);
    const Tau tau = draw.joints<Tau>(20.0);
    return answered(draw, forward_dynamics<S>(x.q, qd, tau, x.in));
  }
  template <class Route>
  static Verdict forward_by(Draw& draw) {
    const Q q = draw.joints<Q>(1.2);
    const Qd qd = draw.joints<Qd>(2.0);
    const Tau tau = draw.joints<Tau>(20.0);
    return answered(draw, forward_dynamics<Scene<Hosted, Gravity, RotorInertia, Route>>(q, qd, tau));
  }
  static Verdict poses(Draw& draw) {
    const Asked x(draw);
    const auto answer = forward_kinematics<S>(x.q, x.in);
    return judged(answer.status, draw.finite(), all_finite<T>(answer.tool, answer.frames));
  }
  static Verdict columns(Draw& draw) {
    const Asked x(draw);
    const auto answer = jacobian<S>(x.q, x.in);
    return judged(answer.status, draw.finite(), all_finite<T>(answer.columns));
  }
  static Verdict separated(Draw& draw) {
    const Asked x(draw);
    const auto answer = separate<S>(x.q, x.in);
    return judged(answer.status, draw.finite(), terms_finite(answer));
  }
  static Verdict momenta(Draw& draw) {
    const Asked x(draw);
    const auto answer = momentum_terms<S>(x.q, draw.joints<Qd>(2.0), x.in);
    return judged(answer.status, draw.finite(), all_finite<T>(answer.momentum.values, answer.drift.values));
  }
  static Verdict derivatives(Draw& draw) {
    const Asked x(draw);
    const Qd qd = draw.joints<Qd>(2.0);
    const auto answer = forward_dynamics_derivatives<S>(x.q, qd, draw.joints<Tau>(20.0), x.in);
    return judged(answer.qdd.status, draw.finite(),
                  all_finite<T>(answer.qdd.values, answer.dqdd_dq, answer.dqdd_dqd, answer.M_inverse));
  }
  static Verdict along(Draw& draw) {
    const Asked x(draw);
    const Qd qd = draw.joints<Qd>(2.0);
    const Tau tau = draw.joints<Tau>(20.0);
    const Joints<R, T> way = draw.joints<Joints<R, T>>(1.0);
    const auto answer = forward_dynamics_along<S>(x.q, qd, tau, {way, way, way}, x.in);
    return judged(answer.qdd.status, draw.finite(), all_finite<T>(answer.qdd.values, answer.dqdd.values));
  }

  static Verdict fed_forward(Draw& draw) {
    static FeedforwardState<S, T> state{};
    const Asked x(draw);
    const Qd qd = draw.joints<Qd>(2.0);
    const auto answer = feedforward<S>(state, x.q, qd, draw.joints<Qdd>(5.0), x.in);
    return safe(answer.status, answer.tau, draw.finite());
  }
  static Verdict held(Draw& draw) {
    static SafeLoopState<S, T> state{};
    const Asked x(draw);
    const auto answer = compensate_gravity<S>(state, x.q, x.in);
    return safe(answer.status, answer.tau, draw.finite());
  }
  static Verdict tracked(Draw& draw) {
    static SafeLoopState<S, T> state{};
    const Asked x(draw);
    const Request<S, T> desired{draw.joints<Q>(1.2), draw.joints<Qd>(1.0), draw.joints<Qdd>(5.0), {}};
    const MeasuredMotion<S, T> measured{x.q, draw.joints<Qd>(1.0), {}};
    TrackingGains<S, T> gains{};
    gains.stiffness[0] = draw.number<T>(5.0) + T(5), gains.damping[0] = draw.number<T>(0.5) + T(0.5);
    const bool finite = draw.finite() && all_finite<T>(gains);
    const auto answer = track<S>(state, desired, measured, gains, x.in);
    return safe(answer.status, answer.tau, finite);
  }
  static Verdict fallen_back(Draw& draw) {
    FallBack<S, T> drives{FallBackTimes{}};
    const Asked x(draw);
    const bool holds = drives.hold_at(x.q, x.in);
    drives.advance(1, draw.inputs<S, T>());
    return !all_finite<T>(drives.torque().values) ? Verdict::wrong : holds ? Verdict::right : Verdict::refused;
  }
  static Verdict two_rates(Draw& draw) {
    static TwoRateState<S, T> state{};
    const Asked x(draw);
    if (const Verdict slow = judged(refresh<S>(state, x.q, x.in), draw.finite()); slow != Verdict::right) return slow;
    const Qd qd = draw.joints<Qd>(1.0);
    const auto answer = two_rate_feedforward<S>(state, qd, draw.joints<Qdd>(5.0));
    return safe(answer.status, answer.tau, draw.finite());
  }
  static Verdict observed(Draw& draw) {
    static ObserverState<S, T, HostedTuning> state{};
    const Asked x(draw);
    const Qd qd = draw.joints<Qd>(1.0);
    const Status status = observe(state, x.q, qd, draw.joints<Tau>(10.0), x.in);
    const bool kept = all_finite<T>(state.residual.values);
    return !kept ? Verdict::wrong : judged(status, draw.finite());
  }
  static Verdict detected(Draw& draw) {
    static CollisionState state{};
    const auto residual = draw.joints<Residuals<S, T, HostedTuning>>(2.0);
    return judged(detect(state, residual).status, draw.finite());
  }
  static Verdict weighed(Draw& draw) {
    static PayloadState<S, T> state{};
    const Q q = draw.joints<Q>(1.2);
    const Qd qd = draw.joints<Qd>(1.0);
    const Status status = update_payload<S, T, HostedTuning>(state, q, qd, draw.joints<Joints<R, T>>(2.0));
    if (!status.ok()) return Verdict::refused;
    const auto answer = estimate<HostedTuning>(state);
    const bool number = !answer.status.ok() || all_finite<T>(answer.mass, answer.first_moment);
    return number && draw.finite() ? Verdict::right : Verdict::wrong;
  }
  static Verdict limited(Draw& draw) {
    constexpr DriveRating drive =
        DriveRating{}.continuous_current(4.0).peak_current(9.0).time_constant_s(30.0).torque_constant(5.0);
    static const auto limits = current_limits<S, T>({drive, drive, drive}, 1e-3);
    static WindingHeat<S, T> heat{};
    Tau tau = draw.joints<Tau>(10.0);
    const Status status = limit_currents(heat, limits, tau);
    return !all_finite<T>(tau.values) ? Verdict::wrong : judged(status, draw.finite());
  }
  static Verdict commanded(Draw& draw) {
    static PositionCommandState<S, T> state{};
    PositionLoop<S, T> loop{};
    for (int i = 0; i < joint_count<S>; ++i)
      loop.stiffness[i] = T(100), loop.largest_offset[i] = T(0.5);
    const Q q = draw.joints<Q>(1.2);
    const auto answer = position_command(state, loop, q, draw.joints<Tau>(10.0));
    return !all_finite<T>(answer.q.values) ? Verdict::wrong : judged(answer.status, draw.finite());
  }
  static Verdict requested(Draw& draw) {
    const Q q = draw.joints<Q>(1.2);
    const Qd qd = draw.joints<Qd>(1.0);
    const Qdd qdd = draw.joints<Qdd>(5.0);
    const bool agree = check_request<S>(q, qd, qdd).ok() == clamped_request<S>(q, qd, qdd).status.ok();
    return !agree ? Verdict::wrong : judged(check_request<S>(q, qd, qdd), draw.finite());
  }
  static Verdict positioned(Draw& draw) {
    const Q q = draw.joints<Q>(1.2);
    return judged(check_position<S>(q), draw.finite());
  }
  static Verdict loaded(Draw& draw) {
    const auto load = draw.load<T>();
    return judged(check_payload<S>(load), draw.finite());
  }
  static Verdict looked_at(Draw& draw) {
    const Q q = draw.joints<Q>(1.2);
    return judged(check_finite(q), draw.finite());
  }

  template <class Method>
  static Verdict stepped(Draw& draw) {
    Motion<S, T> x{};
    x.q = draw.joints<Q>(1.2), x.qd = draw.joints<Qd>(1.0);
    const T h = draw.number<T>(5e-4) + T(5e-4);
    const Held<S, T> drive{draw.joints<Tau>(10.0), draw.inputs<S, T>()};
    const Motion<S, T> before = x;
    const Status status = advance<Method>(x, h, drive);
    const bool finite = all_finite<T>(x.q.values, x.qd.values);
    const bool spoilt = !finite && all_finite<T>(before.q.values, before.qd.values);
    return spoilt ? Verdict::wrong : judged(status, draw.finite(), finite);
  }

  static Verdict batched(Draw& draw) {
    Joints<R, T> q[4], qd[4], tau[4];
    bool finite[4];
    for (int k = 0; k < 4; ++k) {
      draw.next();
      q[k] = draw.joints<Joints<R, T>>(1.2), qd[k] = draw.joints<Joints<R, T>>(2.0);
      tau[k] = draw.joints<Joints<R, T>>(20.0), finite[k] = draw.finite();
    }
    const auto batch = load<4>(q), rates = load<4>(qd);
    const auto answer = forward_dynamics<S>(batch, rates, load<4>(tau));
    const auto terms = momentum_terms<S>(batch, rates);
    const auto poses = forward_kinematics<S>(batch);
    Verdict verdict = Verdict::refused;
    for (int k = 0; k < 4; ++k) {
      const bool right = finite[k] && all_finite<T>(lane(answer, k).values);
      if ((answer.status[k].ok() && !right) || (terms.status[k].ok() && !all_finite<T>(q[k].values, qd[k].values)) ||
          (poses.status[k].ok() && !all_finite<T>(q[k].values)))
        return Verdict::wrong;
      if (answer.status[k].ok()) verdict = Verdict::right;
    }
    return verdict;
  }

  static Verdict modelled(Draw& draw) {
    using M = Model<3, Gravity, RotorInertia>;
    static const M model = [] {
      M made;
      for (const auto& link : Hosted::chain.links)
        if (!made.add(link)) __builtin_trap();
      return made;
    }();
    const auto q = draw.joints<Positions<M, T>>(1.2);
    const auto qd = draw.joints<Velocities<M, T>>(2.0);
    return answered(draw, forward_dynamics(model, q, qd, draw.joints<EffortsOf<M, T>>(20.0)));
  }
  static Verdict closed(Draw& draw) {
    using robots::Scara;
    const auto answer = closed_form::scara<Scara>(draw.joints<Positions<Scara, T>>(0.1));
    return judged(answer.status, draw.finite(), terms_finite(answer));
  }
  static Verdict converted(Draw& draw) {
    const auto q = draw.joints<Joints<R, T>>(1.0);
    const auto qd = draw.joints<Joints<R, T>>(1.0);
    const auto qdd = draw.joints<Joints<R, T>>(5.0);
    const bool wrong = to_fixed<Positions<R, Fixed32>>(q).status.ok() && !all_finite<T>(q.values);
    return wrong ? Verdict::wrong : judged(to_fixed_request<Hosted, std::int32_t>(q, qd, qdd).status, draw.finite());
  }
  static Verdict converted_load(Draw& draw) {
    using Words = Scene<Hosted, Gravity, Payload, RuntimeTool>;
    const auto load = draw.load<T>();
    Inputs<Words, T> in{};
    in.tool.position = draw.vector<T>(0.05);
    if (to_fixed_tool<Words, std::int32_t>(in.tool).status.ok() && !all_finite<T>(in.tool.position))
      return Verdict::wrong;
    return judged(to_fixed_payload<Words, std::int32_t>(load).status, all_finite<T>(load));
  }

 private:
  template <class Terms>
  static bool terms_finite(const Terms& terms) {
    return all_finite<T>(terms.A, terms.B, terms.C, terms.G);
  }
  /// What a safe call answers is a number whatever it says.
  static Verdict safe(const Status& status, const Tau& tau, bool finite) {
    return !all_finite<T>(tau.values) ? Verdict::wrong : judged(status, finite);
  }
};

/// The C interface, in float.
struct CalledFromC {
  static hosted_joints joints(Draw& draw, double size) {
    hosted_joints all{};
    for (float& x : all.of)
      x = draw.number<float>(size);
    return all;
  }
  template <class... Finite>
  static Verdict judged_in_c(const axial_status& status, Finite... finite) {
    return judged(Status{static_cast<Status::Code>(status.code), status.joint}, finite...);
  }
  static Verdict forward(Draw& draw) {
    const hosted_joints q = joints(draw, 1.2), qd = joints(draw, 2.0), tau = joints(draw, 20.0);
    hosted_joints qdd{};
    const axial_status status = hosted_forward_dynamics(&q, &qd, &tau, &qdd);
    return !all_finite<float>(qdd) ? Verdict::wrong : judged_in_c(status, draw.finite());
  }
  static Verdict inverse(Draw& draw) {
    const hosted_joints q = joints(draw, 1.2), qd = joints(draw, 2.0), qdd = joints(draw, 5.0);
    hosted_joints tau{};
    const axial_status status = hosted_inverse_dynamics(&q, &qd, &qdd, &tau);
    return judged_in_c(status, draw.finite(), all_finite<float>(tau));
  }
  static Verdict inverse_slopes(Draw& draw) {
    const hosted_joints q = joints(draw, 1.2), qd = joints(draw, 2.0), qdd = joints(draw, 5.0);
    hosted_inverse_derivatives all{};
    const axial_status status = hosted_inverse_dynamics_derivatives(&q, &qd, &qdd, &all);
    return judged_in_c(status, draw.finite(), all_finite<float>(all));
  }
  static Verdict forward_slopes(Draw& draw) {
    const hosted_joints q = joints(draw, 1.2), qd = joints(draw, 2.0), tau = joints(draw, 20.0);
    hosted_forward_derivatives all{};
    const axial_status status = hosted_forward_dynamics_derivatives(&q, &qd, &tau, &all);
    return !all_finite<float>(all) ? Verdict::wrong : judged_in_c(status, draw.finite());
  }
  static Verdict inertia(Draw& draw) {
    const hosted_joints q = joints(draw, 1.2);
    hosted_matrix m{};
    const axial_status status = hosted_mass_matrix(&q, &m);
    return judged_in_c(status, draw.finite(), all_finite<float>(m));
  }
  static Verdict pose(Draw& draw) {
    const hosted_joints q = joints(draw, 1.2);
    hosted_pose at{};
    const axial_status status = hosted_tool_pose(&q, &at);
    return judged_in_c(status, draw.finite(), all_finite<float>(at));
  }
};

struct Call {
  const char* name;
  Verdict (*run)(Draw&);
};

/// All calls over numbers T.
template <class T>
inline constexpr Call hostile_calls[] = {
    {"forward_dynamics", Calls<Plain, T>::forward},
    {"forward_dynamics, laden", Calls<Laden, T>::forward},
    {"forward_dynamics, looped", Calls<Compact, T>::forward},
    {"forward_dynamics, given pairs", Calls<Given, T>::forward},
    {"forward_dynamics, carried", Calls<Carried, T>::forward},
    {"forward_dynamics, ArticulatedBody", Calls<Plain, T>::template forward_by<ArticulatedBody>},
    {"forward_dynamics, SplitArticulatedBody", Calls<Plain, T>::template forward_by<SplitArticulatedBody>},
    {"forward_dynamics, CompositeBody", Calls<Plain, T>::template forward_by<CompositeBody>},
    {"forward_dynamics, Model", Calls<Plain, T>::modelled},
    {"forward_dynamics_derivatives", Calls<Plain, T>::derivatives},
    {"forward_dynamics_derivatives, laden", Calls<Laden, T>::derivatives},
    {"forward_dynamics_along", Calls<Plain, T>::along},
    {"forward_kinematics", Calls<Plain, T>::poses},
    {"forward_kinematics, carried", Calls<Carried, T>::poses},
    {"forward_kinematics, given pairs", Calls<Given, T>::poses},
    {"jacobian", Calls<Plain, T>::columns},
    {"jacobian, carried", Calls<Carried, T>::columns},
    {"separate", Calls<Plain, T>::separated},
    {"separate, laden", Calls<Laden, T>::separated},
    {"closed form", Calls<Plain, T>::closed},
    {"momentum_terms", Calls<Plain, T>::momenta},
    {"momentum_terms, laden", Calls<Laden, T>::momenta},
    {"feedforward", Calls<Plain, T>::fed_forward},
    {"feedforward, laden", Calls<Laden, T>::fed_forward},
    {"feedforward, given pairs", Calls<Given, T>::fed_forward},
    {"compensate_gravity", Calls<Plain, T>::held},
    {"compensate_gravity, laden", Calls<Laden, T>::held},
    {"track", Calls<Plain, T>::tracked},
    {"track, given pairs", Calls<Given, T>::tracked},
    {"FallBack", Calls<Laden, T>::fallen_back},
    {"two rates", Calls<Plain, T>::two_rates},
    {"two rates, laden", Calls<Laden, T>::two_rates},
    {"observe", Calls<Plain, T>::observed},
    {"observe, laden", Calls<Laden, T>::observed},
    {"detect", Calls<Plain, T>::detected},
    {"update_payload", Calls<Plain, T>::weighed},
    {"limit_currents", Calls<Plain, T>::limited},
    {"position_command", Calls<Plain, T>::commanded},
    {"check_request", Calls<Plain, T>::requested},
    {"check_position", Calls<Plain, T>::positioned},
    {"check_payload", Calls<Plain, T>::loaded},
    {"check_finite", Calls<Plain, T>::looked_at},
    {"SemiImplicitEuler", Calls<Plain, T>::template stepped<SemiImplicitEuler>},
    {"RungeKutta4", Calls<Plain, T>::template stepped<RungeKutta4>},
    {"LinearlyImplicitEuler", Calls<Plain, T>::template stepped<LinearlyImplicitEuler>},
    {"to_fixed, to_fixed_request", Calls<Plain, T>::converted},
    {"to_fixed_payload, to_fixed_tool", Calls<Plain, T>::converted_load},
    {"batches", Calls<Plain, T>::batched},
};
inline constexpr Call hostile_calls_from_c[] = {
    {"forward_dynamics from C", CalledFromC::forward},
    {"inverse_dynamics from C", CalledFromC::inverse},
    {"inverse_dynamics_derivatives from C", CalledFromC::inverse_slopes},
    {"forward_dynamics_derivatives from C", CalledFromC::forward_slopes},
    {"mass_matrix from C", CalledFromC::inertia},
    {"tool_pose from C", CalledFromC::pose},
};

}  // namespace axial::apps

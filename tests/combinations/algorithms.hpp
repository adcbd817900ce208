// Every algorithm of the library, called for a combination and compared with the reference or with another algorithm.
#pragma once

#include "combination.hpp"

namespace combinations {

/// axial::NAME of a combination: of its scene, or of its run-time model.
#define AXIAL_CALL(NAME)                             \
  template <class C, class... A>                     \
  auto NAME##_of(const At<C>& at, const A&... a) {   \
    if constexpr (At<C>::is_model)                   \
      return axial::NAME(at.model, a...);            \
    else                                             \
      return axial::NAME<typename C::Subject>(a...); \
  }
AXIAL_CALL(inverse_dynamics)
AXIAL_CALL(gravity_torque)
AXIAL_CALL(bias_torque)
AXIAL_CALL(mass_matrix)
AXIAL_CALL(forward_dynamics)
AXIAL_CALL(forward_kinematics)
AXIAL_CALL(jacobian)
AXIAL_CALL(separate)
AXIAL_CALL(base_wrench)
AXIAL_CALL(momentum_terms)
#undef AXIAL_CALL

/// What a result of fixed point may be off by, as certified; nothing in floating point, where it is not asked for.
template <class C, class Algorithm>
double certified(Algorithm algorithm, int i) {
  if constexpr (is_fixed<typename C::Number>)
    return axial::error_bound<typename C::Subject, typename C::Number>(algorithm)[i];
  else
    return 0.0;
}

/// Efforts against those of the reference, or of another situation.
template <class C, class Tau>
void expect_efforts(At<C>& at, const char* what, const Tau& tau, const Numbers& want, double of_bound = 1.0) {
  const auto got = real(tau);
  for (int i = 0; i < at.joints; ++i)
    at.expect(
        what, i, got[i], want.of[i],
        at.tolerance(256.0, at.scale(at.wanted)) + of_bound * certified<C>(axial::algorithm::inverse_dynamics, i));
}

template <class C>
Situation at_rest(const At<C>& at) {
  Situation rest = at.same;
  for (int i = 0; i < at.joints; ++i)
    rest.qd[i] = rest.qdd[i] = 0.0;
  return rest;
}

struct InverseDynamics {
  template <class C>
  static void run(At<C>& at) {
    expect_efforts(at, "inverse_dynamics", inverse_dynamics_of(at, at.q, at.qd, at.qdd, at.in), at.wanted);
  }
};

struct Gravity {
  template <class C>
  static void run(At<C>& at) {
    expect_efforts(at, "gravity_torque", gravity_torque_of(at, at.q, at.in), efforts(at_rest(at)));
  }
};

struct Bias {
  template <class C>
  static void run(At<C>& at) {
    Situation steady = at.same;
    for (double& a : steady.qdd)
      a = 0.0;
    expect_efforts(at, "bias_torque", bias_torque_of(at, at.q, at.qd, at.in), efforts(steady));
  }
};

struct JointTorque {
  template <class C>
  static void run(At<C>& at) {
    using S = typename C::Subject;
    constexpr int i = At<C>::joints - 1;
    const auto whole = inverse_dynamics_of(at, at.q, at.qd, at.qdd, at.in);
    const auto rest = gravity_torque_of(at, at.q, at.in);
    auto one = whole;
    auto resting = rest;
    if constexpr (At<C>::is_model)
      one[i] = axial::joint_torque(at.model, i, at.q, at.qd, at.qdd, at.in),
      resting[i] = axial::gravity_torque(at.model, i, at.q, at.in);
    else
      one[i] = axial::joint_torque<S, i>(at.q, at.qd, at.qdd, at.in),
      resting[i] = axial::gravity_torque<S, i>(at.q, at.in);
    expect_efforts(at, "joint_torque", one, at.wanted);
    expect_efforts(at, "gravity_torque of a joint", resting, efforts(at_rest(at)));
  }
};

struct MassMatrix {
  template <class C>
  static void run(At<C>& at) {
    const auto m = mass_matrix_of(at, at.q, at.in);
    for (int i = 0; i < at.joints; ++i)
      for (int j = 0; j <= i; ++j) {
        int exponent = 0;
        if constexpr (is_fixed<typename C::Number>) exponent = m.exponent(i, j);
        const double want = inertia(at.same, i, j);
        at.expect("mass_matrix", 10 * i + j, worth(m(i, j), exponent), want,
                  at.tolerance(256.0, 1.0 + std::fabs(want)) + certified<C>(axial::algorithm::mass_matrix, i));
      }
  }
};

/// forward_dynamics(inverse_dynamics(x)) is x: seen backwards, as the efforts that the reference finds for what
/// forward dynamics answered, so that no condition number is in the tolerance. In fixed point as accelerations.
struct ForwardDynamics {
  template <class C>
  static void run(At<C>& at) {
    using T = typename C::Number;
    using S = typename C::Subject;
    axial::Joints<typename At<C>::Owner, double> wanted{};
    for (int i = 0; i < at.joints; ++i)
      wanted[i] = at.wanted.of[i];
    const auto tau = in_numbers<axial::EffortsOf<S, T>>(wanted);
    const auto a = forward_dynamics_of(at, at.q, at.qd, tau, at.in);
    const auto given = real(tau);
    Numbers efforts_given;
    for (int i = 0; i < at.joints; ++i)
      efforts_given.of[i] = given[i];
    if constexpr (is_fixed<T>)
      expect_accelerations(at, a, accelerations(at.same, efforts_given));
    else
      expect_inverse(at, a, efforts_given);
  }
  template <class C, class A>
  static void expect_accelerations(At<C>& at, const A& a, const Numbers& want) {
    const auto got = real(static_cast<const axial::FreeAccelerations<typename C::Subject, typename C::Number>&>(a));
    const auto code = a.status.code;
    at.expect("status of forward_dynamics", code == axial::Status::Code::ok || code == axial::Status::Code::rescaled);
    for (int i = 0; i < at.joints; ++i)
      at.expect("forward_dynamics", i, got[i], want.of[i], certified<C>(axial::algorithm::forward_dynamics, i));
  }
  template <class C, class A>
  static void expect_inverse(At<C>& at, const A& a, const Numbers& given) {
    Situation found = at.same;
    for (int i = 0; i < at.joints; ++i)
      found.qdd[i] = static_cast<double>(a[i]);
    if constexpr (At<C>::template has<axial::FloatingBase>) {
      found.base_motion.angular_acceleration = worth(a.base_acceleration.angular, 0);
      found.base_motion.linear_acceleration = worth(a.base_acceleration.linear, 0);
    }
    const bool singular = a.status.code == axial::Status::Code::near_singular;
    at.expect("status of forward_dynamics", a.status.ok() || singular);
    if (singular) {
      at.expect("near_singular of forward_dynamics", accelerations(at.same, given).near_singular);
      return;
    }
    const Numbers got = efforts(found);
    for (int i = 0; i < at.joints; ++i)
      at.expect("forward_dynamics", i, got.of[i], given.of[i], at.tolerance(4096.0, at.scale(given)));
  }
};

/// Poses and columns are compared with those of the reference; in fixed point within what is certified of origins.
struct Kinematics {
  template <class C>
  static void run(At<C>& at) {
    using S = typename C::Subject;
    using T = typename C::Number;
    const auto poses = forward_kinematics_of(at, at.q, at.in);
    const auto columns = jacobian_of(at, at.q, at.in);
    const Poses want = combinations::poses(at.same);
    const Columns want_columns = combinations::jacobian(at.same);
    constexpr int last = At<C>::joints - 1;
    int length = 0, direction = 0;
    double most = at.tolerance(64.0, 4.0);
    if constexpr (is_fixed<T>) {
      length = axial::length_exponent<S, T>, direction = axial::direction_exponent<T>;
      most = 4.0 * certified<C>(axial::algorithm::forward_kinematics, last) + 64.0 * std::ldexp(1.0, -direction);
    }
    for (int i = 0; i <= last; ++i) {
      at.expect("forward_kinematics", i, worth(poses.frames[i].position.x, length), want.frames[i].position.x, most);
      at.expect("forward_kinematics, axis", i, worth(poses.frames[i].rotation.y.z, direction),
                want.frames[i].rotation.y.z, most);
      at.expect("jacobian", i, worth(columns[i].linear.y, length), want_columns.of[i].linear.y, most);
      at.expect("jacobian, axis", i, worth(columns[i].angular.z, direction), want_columns.of[i].angular.z, most);
    }
    at.expect("tool", 0, worth(poses.tool.position.z, length), want.tool.position.z, most);
    link_columns(at);
  }
  /// The joint's own column: it does not move the origin of its frame across its axis.
  template <class C, class Columns>
  static void expect_column(At<C>& at, const Columns& columns) {
    const auto& own = columns[At<C>::joints - 1];
    const auto w = worth(own.angular, 0), v = worth(own.linear, 0);
    at.expect("jacobian of a link", 0, dot(w, v), 0.0, 0.0);
  }
  template <class C>
  static void link_columns(At<C>& at) {
    constexpr int last = At<C>::joints - 1;
    if constexpr (At<C>::is_model)
      expect_column(at, axial::jacobian(at.model, last, at.q, at.in));
    else
      expect_column(at, axial::jacobian<typename C::Subject, last>(at.q, at.in));
  }
};

/// A, B, C and G together, and each alone; the torque from them.
struct Separation {
  template <class C>
  static void run(At<C>& at) {
    const auto terms = separate_of(at, at.q, at.in);
    if constexpr (At<C>::is_model) {
      expect_torque(at, axial::torque(at.model, terms, at.qd, at.qdd));
    } else {
      using S = typename C::Subject;
      expect_torque(at, axial::torque(terms, at.qd, at.qdd));
      auto parts = terms;
      static_cast<axial::SeparatedA<S, typename C::Number>&>(parts) = axial::separate_A<S>(at.q, at.in);
      static_cast<axial::SeparatedB<S, typename C::Number>&>(parts) = axial::separate_B<S>(at.q, at.in);
      static_cast<axial::SeparatedC<S, typename C::Number>&>(parts) = axial::separate_C<S>(at.q, at.in);
      static_cast<axial::SeparatedG<S, typename C::Number>&>(parts) = axial::separate_G<S>(at.q, at.in);
      expect_torque(at, axial::torque(parts, at.qd, at.qdd));
    }
  }
  /// No error is certified of separation: a 16-bit word's share of the largest effort in fixed point, as observed.
  template <class C, class Tau>
  static void expect_torque(At<C>& at, const Tau& tau) {
    const auto got = real(tau);
    double most = at.tolerance(512.0, at.scale(at.wanted));
    if constexpr (is_fixed<typename C::Number>)
      for (int i = 0; i < at.joints; ++i)
        most = std::fmax(most, 4.0 * certified<C>(axial::algorithm::inverse_dynamics, i));
    for (int i = 0; i < at.joints; ++i)
      at.expect("separate", i, got[i], at.wanted.of[i], most);
  }
};

/// Of a base that is told how to move: finite. Of a free one: nothing is missing for the motion that was found.
struct BaseWrench {
  template <class C>
  static void run(At<C>& at) {
    const auto w = base_wrench_of(at, at.q, at.qd, at.qdd, at.in);
    at.expect("base_wrench is finite", std::isfinite(worth(w.force.x, 0) + worth(w.moment.z, 0)));
  }
};

/// Momenta against M(q) qd, and their drift at rest against what holds the robot there.
struct Momentum {
  template <class C>
  static void run(At<C>& at) {
    const auto moving = momentum_terms_of(at, at.q, at.qd, at.in);
    auto resting = at.qd;
    for (auto& speed : resting.values)
      speed = {};
    const auto still = momentum_terms_of(at, at.q, resting, at.in);
    const Numbers p = momenta(at.same), hold = efforts(at_rest(at));
    const auto got = real(moving.momentum), drift = real(still.drift);
    for (int i = 0; i < at.joints; ++i) {
      const double bound = certified<C>(axial::algorithm::inverse_dynamics, i);
      at.expect("momentum", i, got[i], p.of[i], at.tolerance(256.0, at.scale(p)) + 2.0 * bound);
      at.expect("drift at rest", i, drift[i], -hold.of[i], at.tolerance(256.0, at.scale(hold)) + 2.0 * bound);
    }
  }
};

struct Feedforward {
  template <class C>
  static void run(At<C>& at) {
    using S = typename C::Subject;
    using T = typename C::Number;
    axial::FeedforwardState<S, T> state;
    const auto request = axial::clamped_request<S, T>(at.q, at.qd, at.qdd);
    const auto result = axial::feedforward<S, T>(state, request.q, request.qd, request.qdd, at.in);
    at.expect("status of feedforward", result.status.ok());
    expect_efforts(at, "feedforward", result.tau, at.wanted);
  }
};

struct TwoRate {
  template <class C>
  static void run(At<C>& at) {
    using S = typename C::Subject;
    using T = typename C::Number;
    axial::TwoRateState<S, T> state;
    at.expect("status of refresh", axial::refresh<S, T>(state, at.q, at.in).ok());
    const auto result = axial::two_rate_feedforward(state, at.qd, at.qdd);
    at.expect("status of two_rate_feedforward", result.status.ok());
    Separation::expect_torque(at, result.tau);
  }
};

struct Tuning {
  static constexpr double period = 1e-3, gain = 100.0;
  static constexpr double fraction = 0.1, uncertainty = 1.0, release = 0.5;
  static constexpr int confirm = 1, calm = 3;
  static constexpr double deviation = 0.01, memory = 1.0, mass_deviation = 1.0, moment_deviation = 1.0;
};

/// Observer, detector: two samples at rest, under the efforts that hold the robot there, leave no residual.
struct Observer {
  template <class C>
  static void run(At<C>& at) {
    using S = typename C::Subject;
    using T = typename C::Number;
    const auto tau = axial::gravity_torque<S>(at.q, at.in);
    axial::Velocities<typename At<C>::Owner, T> still{};
    axial::ObserverState<S, T, Tuning> state;
    axial::CollisionState detector;
    for (int sample = 0; sample < 2; ++sample)
      at.expect("status of observe", axial::observe<S, T, Tuning>(state, at.q, still, tau, at.in).ok());
    at.expect("no collision", !axial::detect(detector, state.residual).detected);
    for (int i = 0; i < at.joints; ++i) {
      int exponent = 0;
      if constexpr (is_fixed<T>) exponent = state.residual.exponent(i);
      at.expect("residual", i, worth(state.residual[i], exponent), 0.0,
                at.tolerance(256.0, at.scale(at.wanted)) + 2.0 * certified<C>(axial::algorithm::inverse_dynamics, i));
    }
  }
};

/// The payload estimator: two samples without a residual weigh nothing.
struct PayloadEstimator {
  template <class C>
  static void run(At<C>& at) {
    using S = typename C::Subject;
    using T = typename C::Number;
    axial::PayloadState<S, T> state;
    typename axial::detail::ResidualInput<S, T, Tuning>::type none{};
    for (int sample = 0; sample < 2; ++sample)
      at.expect("status of weigh", axial::update_payload<S, T, Tuning>(state, at.q, at.qd, none).ok());
    const auto estimate = axial::estimate<Tuning>(state);
    (void)estimate;
    bool finite = true;
    if constexpr (!is_fixed<T>)
      for (const auto& row : state.information)
        for (const T& x : row)
          finite = finite && std::isfinite(x);
    at.expect("information of the payload estimator is finite", finite);
  }
};

/// Integrators, with a drive that says the inputs of each instant; the first against forward dynamics.
struct Integrators {
  template <class C>
  static void run(At<C>& at) {
    using S = typename C::Subject;
    using T = typename C::Number;
    const auto drive = [&](const axial::Instant<S, T>& instant, axial::EffortsOf<S, T>& tau, axial::Inputs<S, T>& in) {
      for (int i = 0; i < at.joints; ++i)
        give(tau[i], at.wanted.of[i], 0);
      in = at.inputs_at(instant.q);
    };
    T h{};
    give(h, 1.0 / 1024, 0);
    const auto euler = moved<axial::SemiImplicitEuler>(at, h, drive);
    const auto runge = moved<axial::RungeKutta4>(at, h, drive);
    const auto implicit = moved<axial::LinearlyImplicitEuler>(at, h, drive);
    for (int i = 0; i < at.joints; ++i) {
      at.expect("RungeKutta4 is finite", std::isfinite(runge.q[i]));
      at.expect("LinearlyImplicitEuler is finite", std::isfinite(implicit.q[i]));
      at.expect("SemiImplicitEuler", i, euler.q[i], at.q[i] + h * euler.qd[i], at.tolerance(4.0, 1.0));
    }
    at.expect("step_limit is positive", step_limit(at) > T(0));
  }
  template <class Method, class C, class T, class Drive>
  static auto moved(At<C>& at, T h, const Drive& drive) {
    axial::CompensatedMotion<typename C::Subject, T> x;
    x.q = at.q, x.qd = at.qd;
    axial::Status status;
    if constexpr (At<C>::is_model)
      status = axial::advance<Method>(at.model, x, h, drive);
    else
      status = axial::advance<Method>(x, h, drive);
    at.expect("status of advance", status.ok() || status.code == axial::Status::Code::near_singular);
    return x;
  }
  template <class C>
  static auto step_limit(At<C>& at) {
    if constexpr (At<C>::is_model)
      return axial::step_limit<axial::RungeKutta4>(at.model, at.q, at.in);
    else
      return axial::step_limit<axial::RungeKutta4, typename C::Subject>(at.q, at.in);
  }
};

/// The SCARA's closed forms, for a bare robot: against inverse dynamics of it.
struct ClosedForm {
  template <class C>
  static void run(At<C>& at) {
    using Robot = typename C::Robot;
    const auto tau = real(axial::closed_form::scara_torque<Robot>(at.q, at.qd, at.qdd));
    const auto separated = axial::closed_form::scara<Robot>(at.q);
    const auto again = real(axial::torque(separated, at.qd, at.qdd));
    const auto want = real(axial::inverse_dynamics<Robot>(at.q, at.qd, at.qdd));
    for (int i = 0; i < at.joints; ++i) {
      double most = at.tolerance(64.0, at.scale(at.wanted));
      if constexpr (is_fixed<typename C::Number>)
        most = 8.0 * axial::error_bound<Robot, typename C::Number>(axial::algorithm::inverse_dynamics)[i];
      at.expect("scara_torque", i, tau[i], want[i], most);
      at.expect("torque of scara", i, again[i], want[i], most);
    }
  }
};

/// What is certified of every algorithm but forward dynamics: positive and finite.
struct ErrorBound {
  template <class C>
  static void run(At<C>& at) {
    using namespace axial::algorithm;
    certify(at, inverse_dynamics), certify(at, bias), certify(at, gravity);
    certify(at, mass_matrix), certify(at, forward_kinematics);
  }
  template <class C, class Algorithm>
  static void certify(At<C>& at, Algorithm algorithm) {
    constexpr auto bound = axial::error_bound<typename C::Subject, typename C::Number>(Algorithm{});
    at.expect(algorithm.name, bound.worst() > 0.0);
  }
};
/// The same of forward dynamics.
struct ForwardErrorBound {
  template <class C>
  static void run(At<C>& at) {
    ErrorBound::certify(at, axial::algorithm::forward_dynamics);
  }
};

/// Operations, counted by the compiler's own numbers.
struct Cost {
  template <class C>
  static void run(At<C>& at) {
    using S = typename C::Subject;
    at.expect("cost of inverse_dynamics", axial::cost<S>(axial::algorithm::inverse_dynamics).total() >= 0);
    at.expect("cost of forward_dynamics", axial::cost<S>(axial::algorithm::forward_dynamics).total() > 0);
  }
};

}  // namespace combinations

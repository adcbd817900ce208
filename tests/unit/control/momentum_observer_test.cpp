// Momenta against Lagrange's equations; what the observer and the detector answer, in float and fixed point.
#include <gtest/gtest.h>
#include <axial/control/collision.hpp>
#include <axial/cost.hpp>
#include <axial/fixed.hpp>
#include <axial/links/model.hpp>
#include <cases/to_axial.hpp>
#include <oracle/compare.hpp>
#include <oracle/convert.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/random_chain.hpp>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara_rrpr.hpp>

#include <cmath>
#include <limits>

namespace {

using namespace axial;
using oracle::quad;
using Robot = robots::Panda;
template <class R>
using Checked = Scene<R, Gravity, RotorInertia, RangeCheck>;

struct Tuning {
  static constexpr double period = 1e-3, gain = 200.0;
  static constexpr double fraction = 0.025, uncertainty = 0.05, release = 0.5;
  static constexpr int confirm = 3, calm = 5;
};

// Lagrange: p = M qd, drift = dT/dq - g - friction + J^T w.
struct Exact {
  oracle::Vector<quad> momentum, drift;
};
Exact exact(const oracle::Chain<quad>& chain, const oracle::Vector<quad>& q, const oracle::Vector<quad>& qd,
            const oracle::Wrench<quad>& tip) {
  const auto m = oracle::mass_matrix(chain, q);
  const auto slopes = oracle::mass_matrix_derivatives(chain, q);
  const auto g = oracle::gravity_torque(chain, q), f = oracle::friction_torque(chain, qd);
  const auto w = oracle::wrench_torque(chain, q, tip);
  const int n = chain.size();
  Exact result{oracle::Vector<quad>(q.size(), quad(0)), oracle::Vector<quad>(q.size(), quad(0))};
  for (int i = 0; i < n; ++i) {
    const auto k = std::size_t(i);
    for (int j = 0; j < n; ++j) {
      result.momentum[k] += m(i, j) * qd[std::size_t(j)];
      for (int l = 0; l < n; ++l)
        result.drift[k] += quad(0.5) * slopes[k](j, l) * qd[std::size_t(j)] * qd[std::size_t(l)];
    }
    result.drift[k] += w[k] - g[k] - f[k];
  }
  return result;
}

using Tree = Model<12, Gravity, RotorInertia, Friction, TipWrench>;

template <class T>
void expect_lagrange(const oracle::Chain<double>& chain, oracle::RandomChains& random, double tolerance) {
  const int n = chain.size();
  const auto q = random.vector(n, 3.0), qd = random.vector(n, 2.0);
  const auto tip = random.wrench(3.0);
  Joints<Tree, T> position{}, velocity{};
  for (int i = 0; i < n; ++i)
    position[i] = T(q[std::size_t(i)]), velocity[i] = T(qd[std::size_t(i)]);
  Inputs<Tree, T> in;
  const auto w = oracle::convert<T>(tip);
  in.tip_wrench = {{w.moment.x, w.moment.y, w.moment.z}, {w.force.x, w.force.y, w.force.z}};
  const auto ours = momentum_terms(cases::to_model<Tree>(chain), position, velocity, in);
  const auto truth = exact(oracle::convert<quad>(chain), oracle::convert<quad>(q), oracle::convert<quad>(qd),
                           oracle::convert<quad>(tip));
  using V = oracle::Vector<T>;
  EXPECT_LE(oracle::relative_error(V(ours.momentum.values, ours.momentum.values + n), truth.momentum), tolerance);
  EXPECT_LE(oracle::relative_error(V(ours.drift.values, ours.drift.values + n), truth.drift), tolerance);
}

// A state at a fraction of every limit; `corner` picks signs.
template <class R>
struct State {
  Joints<R, double> q{}, qd{};
  State(oracle::RandomChains& random, bool corner) {
    for (int i = 0; i < R::chain.size; ++i) {
      const auto& l = R::chain.links[i];
      q[i] = random.uniform(l.position_min, l.position_max);
      qd[i] =
          corner ? l.speed_limit * (random.below(2) == 0 ? 1.0 : -1.0) : random.uniform(-l.speed_limit, l.speed_limit);
    }
  }
};

template <class Values>
double real(const Values& values, int i) {
  return values[i].raw * detail::power_of_two(-values.exponent(i));
}

// Fixed point against double: no overflow, within roundings of the coarsest format on the way.
template <class R, class S>
void expect_exact_in_fixed_point() {
  oracle::RandomChains random(7);
  const std::uint64_t before = range_overflows;
  for (int k = 0; k < 2000; ++k) {
    const State<R> s(random, k % 2 == 0);
    const auto q = to_fixed<Positions<R, Fixed32>>(s.q), qd = to_fixed<Velocities<R, Fixed32>>(s.qd);
    const auto ours = momentum_terms<S>(q.values, qd.values);
    const auto truth = momentum_terms<R>(to_real<double>(q.values), to_real<double>(qd.values));
    for (int i = 0; i < R::chain.size; ++i) {
      ASSERT_NEAR(real(ours.momentum, i), truth.momentum[i], 2e-7) << k << ' ' << i;
      ASSERT_NEAR(real(ours.drift, i), truth.drift[i], 4e-6) << k << ' ' << i;
    }
  }
  EXPECT_EQ(range_overflows, before);
}

// The Panda at rest in a pose; what its drives must hold.
struct AtRest {
  Joints<Robot, double> q{0.3, -0.4, 0.5, -1.9, 0.2, 1.6, 0.1}, qd{}, hold = gravity_torque<Robot>(q);
};

// Feeds `samples` samples with an external effort on each joint of a 50th of its limit, by tau = hold - it.
template <class S, class T, class U>
Status push(ObserverState<S, T, U>& state, int samples, double share = 0.02) {
  const AtRest rest;
  Joints<Robot, double> tau = rest.hold;
  for (int i = 0; i < 7; ++i)
    tau[i] -= share * Robot::chain.links[i].effort_limit;
  Status status;
  for (int k = 0; k < samples; ++k)
    if constexpr (is_stored_v<T>) {
      status = observe(state, to_fixed<Positions<Robot, T>>(rest.q).values, Velocities<Robot, T>{},
                       to_fixed<EffortsOf<S, T>>(tau).values);
    } else {
      Joints<Robot, T> q{}, effort{};
      for (int i = 0; i < 7; ++i)
        q[i] = T(rest.q[i]), effort[i] = T(tau[i]);
      status = observe(state, q, Joints<Robot, T>{}, effort);
    }
  return status;
}
template <class S, class U>
double residual(const ObserverState<S, float, U>& state, int i) {
  return state.residual[i];
}
template <class S, class U>
double residual(const ObserverState<S, Fixed32, U>& state, int i) {
  return real(state.residual, i);
}

// After n samples a step x is x (1 - (1 + K dt)^-n); the first sample only starts the observer.
template <class T, class U>
void expect_step_response(double tolerance) {
  using S = Checked<Robot>;
  ObserverState<S, T, U> state;
  EXPECT_TRUE(push(state, 1).ok());
  for (int i = 0; i < 7; ++i)
    EXPECT_EQ(residual(state, i), 0.0) << i;
  for (const int samples : {1, 4, 45, 4950}) {
    static_cast<void>(push(state, samples));
    const int n = samples == 1 ? 1 : samples == 4 ? 5 : samples == 45 ? 50 : 5000;
    const double share = 1.0 - std::pow(1.0 + U::gain * U::period, -n);
    for (int i = 0; i < 7; ++i)
      EXPECT_NEAR(residual(state, i), 0.02 * share * Robot::chain.links[i].effort_limit, tolerance) << n << ' ' << i;
  }
}
struct Stiff {
  static constexpr double period = 1e-3, gain = 1e6;
};

}  // namespace

TEST(Momentum, OfChainsIsLagranges) {
  oracle::RandomChains random(31);
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    auto chain = k % 2 == 0 ? random.chain(1 + k % 12) : random.branched_tree(1 + k % 12);
    for (auto& link : chain.links)
      link.viscous = random.uniform(0.0, 2.0), link.coulomb_forward = 0.5, link.coulomb_backward = -0.25;
    expect_lagrange<double>(chain, random, 1e-13);
    expect_lagrange<float>(chain, random, 5e-6);
  }
}

TEST(Momentum, InFixedPointIsExactAndNeverOverflows) {
  expect_exact_in_fixed_point<Robot, Checked<Robot>>();
  expect_exact_in_fixed_point<robots::ScaraRrpr, Checked<robots::ScaraRrpr>>();
}

// Formats have a bit or a few to spare, not many: the bounds are not idle. Largest |M qd| of one joint's speed alone.
TEST(Momentum, FormatsAreUsed) {
  const Joints<Robot, double> q{0.0, 1.5, 0.0, -0.07, 0.0, 1.5, 0.0};
  Joints<Robot, double> qd{};
  for (int i = 0; i < 7; ++i)
    qd[i] = Robot::chain.links[i].speed_limit;
  const auto p = momentum_terms<Robot>(q, qd).momentum;
  double most = 0.0;
  for (int i = 0; i < 7; ++i)
    most =
        std::fmax(most, std::fabs(p[i]) / detail::power_of_two(31 - MomentaOf<Checked<Robot>, Fixed32>::exponent(i)));
  EXPECT_GT(most, 0.05);
  EXPECT_LT(most, 1.0);
}

TEST(Observer, FollowsAStepWithItsTimeConstant) {
  expect_step_response<float, Tuning>(3e-5);
  expect_step_response<Fixed32, Tuning>(6e-4);
}
TEST(Observer, IsStableForAnyGain) {
  expect_step_response<float, Stiff>(3e-5);
  expect_step_response<Fixed32, Stiff>(6e-4);
}

// The largest words that the formats hold: the residual still fits, and follows.
TEST(Observer, FitsWhateverTheWordsAre) {
  using S = Checked<Robot>;
  for (const bool up : {true, false}) {
    ObserverState<S, Fixed32, Stiff> state;
    MomentumTerms<S, Fixed32> now;
    EffortsOf<S, Fixed32> tau;
    state.ready = true;
    for (int i = 0; i < 7; ++i) {
      const std::int32_t most = up ? INT32_MAX : INT32_MIN, least = up ? INT32_MIN : INT32_MAX;
      now.momentum[i].raw = most, state.last.momentum[i].raw = least, tau[i].raw = least;
      now.drift[i].raw = least, state.last.drift[i].raw = least;
    }
    const auto before = state.last;
    detail::update(state, now, tau);
    for (int i = 0; i < 7; ++i) {
      const double e = (real(now.momentum, i) - real(before.momentum, i)) / Stiff::period - real(tau, i) -
                       0.5 * (real(now.drift, i) + real(before.drift, i));
      EXPECT_NEAR(residual(state, i), e, 0.0011 * std::fabs(e)) << i;  // share is 0.999
    }
  }
}

TEST(Observer, RefusesBadSamplesAndKeepsItsState) {
  using S = Checked<Robot>;
  ObserverState<S, float, Tuning> state;
  EXPECT_TRUE(push(state, 20).ok());
  const auto before = state;
  const AtRest rest;
  Joints<Robot, float> q{}, qd{}, tau{};
  for (int i = 0; i < 7; ++i)
    q[i] = float(rest.q[i]);
  const auto expect_refused = [&](Status::Code code, int joint) {
    const Status status = observe(state, q, qd, tau);
    EXPECT_EQ(status.code, code);
    EXPECT_EQ(status.joint, joint);
    for (int i = 0; i < 7; ++i) {
      EXPECT_EQ(state.residual[i], before.residual[i]);
      EXPECT_EQ(state.last.momentum[i], before.last.momentum[i]);
    }
  };
  tau[2] = std::numeric_limits<float>::quiet_NaN(), expect_refused(Status::Code::not_finite, 2);
  tau[2] = 88.0F, expect_refused(Status::Code::effort_limit, 2);
  tau[2] = 0.0F, qd[5] = 3.0F, expect_refused(Status::Code::speed_limit, 5);
  qd[5] = 0.0F, q[3] = 0.5F, expect_refused(Status::Code::position_limit, 3);
  ObserverState<S, Fixed32, Tuning> words;
  Velocities<Robot, Fixed32> fast{};
  fast[1].raw = INT32_MAX;
  EXPECT_EQ(observe(words, to_fixed<Positions<Robot, Fixed32>>(rest.q).values, fast, {}).code,
            Status::Code::speed_limit);
  EXPECT_FALSE(words.ready);
}

TEST(Observer, KeepsItsResidualOverAGap) {
  ObserverState<Checked<Robot>, float, Tuning> state;
  static_cast<void>(push(state, 100));
  const auto before = state.residual;
  state.ready = false;
  EXPECT_TRUE(push(state, 1, 0.5).ok());
  for (int i = 0; i < 7; ++i)
    EXPECT_EQ(state.residual[i], before[i]);
  EXPECT_TRUE(state.ready);
}

template <class T>
struct Value;
template <>
struct Value<float> {
  static float of(double x, int) { return float(x); }
};
template <>
struct Value<Fixed32> {
  static Fixed32 of(double x, int e) { return {std::int32_t(x * detail::power_of_two(e))}; }
};
// Thresholds of the Panda's joints are 2.225 and 0.35 N m.
template <class T>
void expect_hysteresis() {
  using R = Residuals<Checked<Robot>, T, Tuning>;
  const auto one = [](int joint, double x) {
    R r{};
    int exponent = 0;
    if constexpr (is_stored_v<T>) exponent = R::exponent(joint);
    r[joint] = Value<T>::of(x, exponent);
    return r;
  };
  CollisionState state;
  EXPECT_FALSE(detect(state, one(1, -2.3)).detected);
  EXPECT_FALSE(detect(state, one(1, -2.3)).detected);
  EXPECT_FALSE(detect(state, one(1, -2.2)).detected);  // confirmation starts anew
  for (int k = 0; k < 2; ++k)
    EXPECT_FALSE(detect(state, one(4, 0.36)).detected);
  const Collision found = detect(state, one(4, 0.36));
  EXPECT_TRUE(found.detected);
  EXPECT_EQ(found.joint, 4);
  for (int k = 0; k < 20; ++k)
    EXPECT_TRUE(detect(state, one(4, 0.18)).detected);  // above half the threshold
  for (int k = 0; k < 4; ++k)
    EXPECT_TRUE(detect(state, one(4, -0.17)).detected);
  EXPECT_FALSE(detect(state, one(4, -0.17)).detected);
}
TEST(Detector, ConfirmsAndHolds) {
  expect_hysteresis<float>();
  expect_hysteresis<Fixed32>();
}

// What a unit of the residual is, as the document says.
TEST(Observer, ResolvesWhatTheDocumentSays) {
  using R = Residuals<Checked<Robot>, Fixed32, Tuning>;
  EXPECT_EQ(R::exponent(0), 14);
  EXPECT_EQ(R::exponent(6), 21);
}

namespace {
template <class R>
constexpr Operations momentum_cost() {
  Trace trace;
  Joints<R, Counting> q{}, qd{};
  for (auto* joints : {&q, &qd})
    for (auto& value : joints->values)
      value = Counting(trace);
  const auto terms = momentum_terms<R>(q, qd);
  for (int i = 0; i < R::chain.size; ++i)
    terms.momentum[i].need(), terms.drift[i].need();
  return trace.operations();
}
}  // namespace

// As doc/guides/observer.md says: less than one inverse dynamics.
TEST(Momentum, CostsLessThanInverseDynamics) {
  constexpr Operations panda = momentum_cost<Robot>(), puma = momentum_cost<robots::Puma560>();
  EXPECT_TRUE((panda == Operations{267, 198, 0, 6}));
  EXPECT_TRUE((puma == Operations{154, 107, 0, 4}));
  EXPECT_LT(panda.total(), cost<Robot>(algorithm::inverse_dynamics).total());
  EXPECT_LT(puma.total(), cost<robots::Puma560>(algorithm::inverse_dynamics).total());
}

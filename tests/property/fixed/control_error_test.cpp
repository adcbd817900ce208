// What is certified of torques that real numbers ask for, of residuals and of a detector's comparisons: nothing exceeds
// it, and something comes near.
#include <robots/planar2r.hpp>
#include <robots/scara_rrpr.hpp>

#include "fixed_state.hpp"

namespace {

using namespace axial;
using property::real;

struct Tuning {
  static constexpr double period = 1e-3, gain = 200.0;
  static constexpr double fraction = 0.02, uncertainty = 0.1, release = 0.5;
  static constexpr int confirm = 3, calm = 5;
};
// So slow that drifts are what counts.
struct SlowTuning : Tuning {
  static constexpr double period = 1.0, gain = 3.0;
};
template <class R>
using SceneOf = Scene<R, Gravity, RotorInertia, Friction>;

template <class R>
class ControlErrors : public testing::Test {
 public:
  using S = SceneOf<R>;
  static constexpr int n = joint_count<R>;
  std::mt19937_64 generator{23};
  struct Motion {
    Joints<R, double> q{}, qd{}, qdd{};
  };
  double any() { return std::uniform_real_distribution<double>(-1.0, 1.0)(generator); }
  /// Any inside the declared limits.
  Motion motion() {
    Motion m;
    for (int i = 0; i < n; ++i) {
      const LinkParameters& link = R::chain.links[i];
      const double middle = 0.5 * (link.position_min + link.position_max);
      m.q[i] = detail::is_bounded(link.position_max) ? middle + any() * (link.position_max - middle) : 3.0 * any();
      m.qd[i] = any() * link.speed_limit, m.qdd[i] = any() * link.acceleration_limit;
    }
    return m;
  }
};
using Robots = testing::Types<robots::Planar2r, robots::ScaraRrpr>;
TYPED_TEST_SUITE(ControlErrors, Robots);

// The observer's difference equation in real numbers, as its source writes it.
template <class R, class Tuning>
struct RealObserver {
  double residual[joint_count<R>] = {};
  MomentumTerms<SceneOf<R>, double> last{};
  bool ready = false;

  void sample(const Joints<R, double>& q, const Joints<R, double>& qd, const Joints<R, double>& tau) {
    const auto now = momentum_terms<SceneOf<R>>(q, qd);
    const double share = Tuning::gain * Tuning::period / (1.0 + Tuning::gain * Tuning::period);
    for (int i = 0; ready && i < joint_count<R>; ++i) {
      const double change = (now.momentum[i] - last.momentum[i]) / Tuning::period;
      const double external = change - tau[i] - 0.5 * (now.drift[i] + last.drift[i]);
      residual[i] += share * (external - residual[i]);
    }
    last = now, ready = true;
  }
};

/// An arm of one turning joint and a slide on it, with friction: what its torque is, is known by hand.
struct Pendulum {
  static constexpr double mass = 2.0, viscous = 0.7;
  static constexpr auto chain = axial::chain(
      gravity(0, -9.81, 0),
      revolute()
          .mass(1)
          .inertia_com(0.5, 0.5, 0.5)
          .viscous(viscous)
          .speed_limit(3)
          .acceleration_limit(20)
          .effort_limit(200),
      prismatic().alpha_deg(90).mass(mass).position_limits(0.1, 0.7).speed_limit(1).acceleration_limit(5).effort_limit(
          100));
};

}  // namespace

TYPED_TEST(ControlErrors, TorquesOfRealRequestsStayInsideTheirBound) {
  using S = typename TestFixture::S;
  constexpr auto bound = error_bound<S>(algorithm::RequestedTorque{});
  constexpr auto words = error_bound<S>(algorithm::inverse_dynamics);
  double nearest = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const auto [q, qd, qdd] = this->motion();
    const auto request = to_fixed_request<S, std::int32_t>(q, qd, qdd);
    ASSERT_TRUE(request.status.ok());
    const auto tau = inverse_dynamics<S>(request.q, request.qd, request.qdd);
    const auto exact = inverse_dynamics<S>(q, qd, qdd);
    for (int i = 0; i < this->n; ++i) {
      const double off = std::fabs(real(tau[i], tau.exponent(i)) - exact[i]);
      EXPECT_LE(off, bound[i]) << i;
      nearest = std::fmax(nearest, off / bound[i]);
    }
  }
  for (int i = 0; i < this->n; ++i)
    EXPECT_GT(bound[i], words[i]);
  std::printf("torques of requests come to %.3f of their bound\n", nearest);
  EXPECT_GT(nearest, 0.1);
}

// With p the slide's reach, the turning joint's torque is (0.5 + m p^2) qdd + 2 m p qd v + m g p cos(q) + b qd: each
// conversion adds what its derivative makes of half a unit.
TEST(RequestedTorque, HasTheConversionOfEachValue) {
  using S = SceneOf<Pendulum>;
  using Q = Positions<Pendulum, Fixed32>;
  using V = Velocities<Pendulum, Fixed32>;
  constexpr auto request = error_bound<S>(algorithm::RequestedTorque{}),
                 words = error_bound<S>(algorithm::inverse_dynamics);
  constexpr double m = Pendulum::mass, p = 0.7, w = 3.0, v = 1.0, a = 20.0, g = 9.81;
  const auto half = [](int exponent) { return 0.5 * std::ldexp(1.0, -exponent); };
  const double by_angle = 3.141592653589793 / 4294967296.0 * m * g * p;
  const double by_slide = half(Q::exponent(1)) * (2.0 * m * p * a + 2.0 * m * w * v + m * g);
  const double by_rates =
      half(V::exponent(0)) * (2.0 * m * p * v + Pendulum::viscous) + half(V::exponent(1)) * 2.0 * m * p * w;
  const double by_pull = half(Accelerations<Pendulum, Fixed32>::exponent(0)) * (0.5 + m * p * p);
  const double added = request[0] - words[0];
  EXPECT_GE(added, by_angle + by_slide + by_rates + by_pull);
  EXPECT_LE(added, 1.7 * (by_angle + by_slide + by_rates + by_pull));
  std::printf("%.3e: angle %.2e slide %.2e rates %.2e pull %.2e\n", added, by_angle, by_slide, by_rates, by_pull);
}

// Samples are held for a while each: then the residual takes over what momenta and drifts are off.
template <class Tuning, class R, class Test>
double nearest_residual(Test& test) {
  using S = SceneOf<R>;
  constexpr auto bound = error_bound<S>(algorithm::MomentumObserver<Tuning>{});
  double nearest = 0.0;
  for (int run = 0; run < 60; ++run) {
    ObserverState<S, Fixed32, Tuning> state{};
    RealObserver<R, Tuning> exact;
    for (int sample = 0; sample < 8; ++sample) {
      const auto motion = test.motion();
      const auto at = to_fixed_request<S, std::int32_t>(motion.q, motion.qd, motion.qdd);
      const auto q = to_real<double>(at.q), qd = to_real<double>(at.qd);
      EffortsOf<S, Fixed32> tau{};
      Joints<R, double> tau_real{};
      for (int i = 0; i < joint_count<R>; ++i)
        property::put(tau[i], tau_real[i], 0.99 * test.any() * R::chain.links[i].effort_limit, tau.exponent(i));
      for (int held = 0; held < 30; ++held) {
        EXPECT_TRUE(observe(state, at.q, at.qd, tau).ok());
        exact.sample(q, qd, tau_real);
        for (int i = 0; i < joint_count<R>; ++i) {
          const double off = std::fabs(real(state.residual[i], state.residual.exponent(i)) - exact.residual[i]);
          EXPECT_LE(off, bound[i]) << i;
          nearest = std::fmax(nearest, off / bound[i]);
        }
      }
    }
  }
  std::printf("residuals come to %.3f of their bound\n", nearest);
  return nearest;
}
TYPED_TEST(ControlErrors, ResidualsStayInsideTheirBound) {
  using S = typename TestFixture::S;
  EXPECT_GT((nearest_residual<Tuning, TypeParam>(*this)), 0.05);
  EXPECT_GT((nearest_residual<SlowTuning, TypeParam>(*this)), 0.05);
  constexpr auto bound = error_bound<S>(algorithm::MomentumObserver<Tuning>{});
  constexpr auto compared = error_bound<S>(algorithm::CollisionDetector<Tuning>{});
  for (int i = 0; i < this->n; ++i)
    EXPECT_EQ(compared[i], bound[i] + std::ldexp(0.5, -Residuals<S, Fixed32, Tuning>::exponent(i)));
}

// The payload estimator's difference equation in real numbers: its columns behind the observer's lag.
template <class R, class Tuning>
struct RealRows {
  using Columns = detail::PayloadColumns<Scene<R, Gravity>, double>;
  double row[joint_count<R>][4] = {};
  Columns last{};
  bool ready = false;

  void sample(const Joints<R, double>& q, const Joints<R, double>& qd) {
    const auto now = detail::payload_columns<Scene<R, Gravity>, double>(q, qd);
    const double share = Tuning::gain * Tuning::period / (1.0 + Tuning::gain * Tuning::period);
    for (int i = 0; ready && i < joint_count<R>; ++i)
      for (int k = 0; k < 4; ++k) {
        const double change = (now.momentum[i].of[k] - last.momentum[i].of[k]) / Tuning::period;
        row[i][k] += share * (change - 0.5 * (now.drift[i].of[k] + last.drift[i].of[k]) - row[i][k]);
      }
    last = now, ready = true;
  }
};

/// How near rows come to what is certified of them: of masses, of first moments.
struct Nearest {
  double mass = 0.0, moment = 0.0;
};
template <class Tuning, class R, class Test>
Nearest nearest_row(Test& test) {
  using S = Scene<R, Gravity, RangeCheck>;
  using Sums = detail::PayloadSums<S, Fixed32, Tuning>;
  constexpr auto bound = error_bound<S>(algorithm::PayloadEstimator<Tuning>{});
  Nearest nearest;
  for (int run = 0; run < 60; ++run) {
    PayloadState<S, Fixed32> state{};
    RealRows<R, Tuning> exact;
    for (int sample = 0; sample < 8; ++sample) {
      const auto motion = test.motion();
      const auto at = to_fixed_request<S, std::int32_t>(motion.q, motion.qd, motion.qdd);
      for (int held = 0; held < 30; ++held) {
        EXPECT_TRUE((update_payload<S, Fixed32, Tuning>(state, at.q, at.qd, {}).ok()));
        exact.sample(to_real<double>(at.q), to_real<double>(at.qd));
        for (int i = 0; i < joint_count<R>; ++i)
          for (int k = 0; k < 4; ++k) {
            const double off = std::fabs(real(state.lagged[i].of[k], Sums::formats.exponent[k]) - exact.row[i][k]);
            const double most = k == 0 ? bound.mass[i] : bound.first_moment[i];
            EXPECT_LE(off, most) << i << k;
            double& part = k == 0 ? nearest.mass : nearest.moment;
            part = std::fmax(part, off / most);
          }
      }
    }
  }
  std::printf("rows come to %.3f of their bounds, %.3f along moments\n", nearest.mass, nearest.moment);
  return nearest;
}
struct Weighing : Tuning {
  static constexpr double deviation = 0.001, memory = 10.0, mass_deviation = 0.02, moment_deviation = 0.01;
};
struct SlowWeighing : SlowTuning {
  static constexpr double deviation = 0.001, memory = 100.0, mass_deviation = 0.02, moment_deviation = 0.01;
};
TYPED_TEST(ControlErrors, RowsOfAPayloadStayInsideTheirBounds) {
  for (const Nearest& of : {nearest_row<Weighing, TypeParam>(*this), nearest_row<SlowWeighing, TypeParam>(*this)}) {
    EXPECT_GT(of.mass, 0.02);
    EXPECT_GT(of.moment, 0.02);
  }
}

// One step of exact words at the ends of their range against the same step in real numbers.
TEST(Residuals, RoundAStepAsItsBoundSays) {
  using S = SceneOf<robots::ScaraRrpr>;
  constexpr const auto& f = detail::residual_formats<S, std::int32_t, Tuning>;
  constexpr detail::BoundedResidualFormats<S, std::int32_t, Tuning> in_bounds{};
  constexpr auto share = detail::shares_of<Tuning>();
  constexpr double taken = detail::residual_share<Tuning>() * 1073741824.0;
  constexpr detail::Shares<detail::RawFactor> shares{detail::raw_factor(share.taken, taken),
                                                     detail::raw_factor(share.kept, 1073741824.0 - taken)};
  std::mt19937_64 random(29);
  double nearest = 0.0;
  for (int i = 0; i < 4; ++i) {
    const detail::RawBound any{{2147483648.0, 0.0}};
    const double bound = detail::next_residual(in_bounds, i, shares, any, any, any, any, any, any).bound.error;
    for (int k = 0; k < 20000; ++k) {
      const auto end = [&random] {
        const auto near = static_cast<std::int32_t>(random() % 4096);
        return random() % 2 == 0 ? 2147483647 - near : -2147483647 + near;
      };
      const std::int32_t r = end(), p = end(), last = end(), tau = end(), d = end(), d_last = end();
      const std::int32_t next = detail::next_residual(f, i, share, r, p, last, tau, d, d_last);
      const auto exact_factor = [&](double signed_factor) { return static_cast<long double>(signed_factor); };
      const long double fm = exact_factor(in_bounds.momentum[i].bound.size), fe = in_bounds.effort[i].bound.size,
                        fd = in_bounds.half_drift[i].bound.size;
      const long double e = (fm * (1.0L * p - last) - fe * tau - fd * (1.0L * d + d_last)) / 2147483648.0L;
      const long double wanted = r + (e - r) * static_cast<long double>(taken) / 1073741824.0L;
      nearest = std::fmax(nearest, static_cast<double>(std::fabs(next - wanted)) / bound);
    }
  }
  EXPECT_LE(nearest, 1.0 + 1e-6);
  EXPECT_GT(nearest, 0.75);
  std::printf("a step comes to %.3f of its bound\n", nearest);
}
// Momenta that are off either way make a change that is off by twice as much per period; drifts count as they are.
TEST(Residuals, TakeOverWhatMomentaAndDriftsAreOff) {
  using S = SceneOf<robots::Planar2r>;
  constexpr double off = 1e-3, unit = detail::power_of_two(-Residuals<S, Fixed32, Tuning>::exponent(0));
  constexpr double exact = detail::residual_error<S, std::int32_t, Tuning>(0, 0.0, 0.0) * unit;
  constexpr double momenta = detail::residual_error<S, std::int32_t, Tuning>(0, off, 0.0) * unit - exact;
  constexpr double drifts = detail::residual_error<S, std::int32_t, Tuning>(0, 0.0, off) * unit - exact;
  EXPECT_NEAR(momenta, 2.0 * off / Tuning::period, 1e-6 * momenta);
  EXPECT_NEAR(drifts, off, 1e-6 * drifts);
}

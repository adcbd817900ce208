// Bad numbers in observer, detector and payload estimator: each is refused with a status, and nothing stays spoilt.
#include <gtest/gtest.h>
#include <axial/control/collision.hpp>
#include <axial/control/feedforward.hpp>
#include <axial/control/payload_estimator.hpp>
#include <axial/dynamics/check_finite.hpp>
#include <axial/fixed.hpp>
#include <axial/separation/separation.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <cmath>
#include <cstring>
#include <limits>

namespace {

using namespace axial;
using Code = Status::Code;
using robots::Puma560;

struct Tuning {
  static constexpr double period = 1e-3, gain = 200.0;
  static constexpr double fraction = 0.025, uncertainty = 0.05, release = 0.5;
  static constexpr int confirm = 3, calm = 5;
  static constexpr double deviation = 0.001, memory = 100.0, mass_deviation = 0.02, moment_deviation = 0.01;
};

/// No declared limits at all: whatever is finite is looked at.
struct Unlimited {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -9.81, 0.0), revolute().mass(2.0).com(0.3, 0.0, 0.0).inertia_com(0.01, 0.02, 0.02),
                   revolute().a(0.5).mass(1.0).com(0.2, 0.0, 0.0).inertia_com(0.01, 0.02, 0.02),
                   prismatic().a(0.4).alpha_deg(90).mass(0.5).inertia_com(0.001, 0.001, 0.001), tool(0.0, 0.0, 0.1));
};
using S = Scene<Unlimited, Gravity>;

template <class T>
struct Sample {
  Joints<Unlimited, T> q{}, qd{}, tau{};
  explicit Sample(int k) {
    for (int i = 0; i < 3; ++i) {
      const double w = 2.0 + i, t = 1e-3 * k;
      q[i] = static_cast<T>(0.3 * std::sin(w * t)), qd[i] = static_cast<T>(0.3 * w * std::cos(w * t));
      tau[i] = static_cast<T>(std::sin(3.0 * t + i));
    }
  }
  T& number(int k) { return (k < 3 ? q : k < 6 ? qd : tau)[k % 3]; }
};

/// Numbers that nobody wants to see: not finite, or so large that something made of them is not.
template <class T>
constexpr T hostile[] = {std::numeric_limits<T>::quiet_NaN(), -std::numeric_limits<T>::quiet_NaN(),
                         std::numeric_limits<T>::infinity(), -std::numeric_limits<T>::infinity(),
                         std::numeric_limits<T>::max(), std::numeric_limits<T>::lowest(),
                         std::numeric_limits<T>::max() / T(300), sizeof(T) == 4 ? T(1e25) : T(1e170),
                         sizeof(T) == 4 ? T(-1e18) : T(-1e120), T(1e12), std::numeric_limits<T>::denorm_min(),
                         // As a slide's speed these are taken, and what follows overflows: differences of momenta over
                         // a period, of the robot and of a kilogram of payload.
                         std::numeric_limits<T>::max() / T(526), std::numeric_limits<T>::max() / T(1050)};

template <class Values>
bool same(const Values& a, const Values& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

template <class T>
class HostileNumbers : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(HostileNumbers, Numbers);

}  // namespace

// Each number of a sample, by each hostile one, once: ok only with finite residuals; refused, the residual is the last
// one's; and good samples bring it back to within a thousandth of where it was.
TYPED_TEST(HostileNumbers, LeaveTheObserverWell) {
  using T = TypeParam;
  for (const T bad : hostile<T>)
    for (int number = 0; number < 9; ++number) {
      SCOPED_TRACE(testing::Message() << "number " << number << " is " << bad);
      ObserverState<S, T, Tuning> state, undisturbed;
      for (int k = 0; k < 50; ++k) {
        const Sample<T> sample(k);
        ASSERT_TRUE(observe(state, sample.q, sample.qd, sample.tau).ok());
      }
      undisturbed = state;
      const auto before = state.residual;
      Sample<T> sample(50);
      sample.number(number) = bad;
      const Status status = observe(state, sample.q, sample.qd, sample.tau);
      if (!std::isfinite(bad)) {
        EXPECT_EQ(status.code, Code::not_finite);
        EXPECT_EQ(status.joint, number % 3);
      }
      if (status.ok()) {
        EXPECT_TRUE(check_finite(state.residual).ok());
      } else {
        EXPECT_TRUE(same(before, state.residual));
        EXPECT_FALSE(state.ready) << "what was integrated up to a refused sample is not gone on from";
      }
      bool ready = false;
      for (int k = 51; k < 1500; ++k) {
        const Sample<T> good(k);
        ready = observe(state, good.q, good.qd, good.tau).ok();
        ASSERT_TRUE(observe(undisturbed, good.q, good.qd, good.tau).ok());
        if (k > 53) {
          ASSERT_TRUE(ready) << "sample " << k;
        }
        ASSERT_TRUE(check_finite(state.residual).ok());
      }
      for (int i = 0; i < 3 && !status.ok(); ++i)
        EXPECT_NEAR(state.residual[i], undisturbed.residual[i], 1e-3) << "joint " << i;
    }
}

// A gap belongs to no one sample: after a refused one the arm's motion is no false effort.
TYPED_TEST(HostileNumbers, MakeNoEffortOfAGap) {
  using T = TypeParam;
  const auto run = [](bool gap) {
    ObserverState<S, T, Tuning> state;
    double worst = 0.0;
    for (int k = 0; k < 400; ++k) {
      Sample<T> sample(k);
      sample.tau = inverse_dynamics<S>(sample.q, sample.qd, Joints<Unlimited, T>{});  // all that differs is smooth
      if (gap && k == 200) sample.qd[1] = std::numeric_limits<T>::quiet_NaN();
      EXPECT_EQ(observe(state, sample.q, sample.qd, sample.tau).ok(), !(gap && k == 200));
      if (k > 150) worst = std::fmax(worst, std::fabs(static_cast<double>(state.residual[1])));
    }
    return worst;
  };
  EXPECT_LE(run(true), 1.05 * run(false) + 0.01);
}

TYPED_TEST(HostileNumbers, LeaveTheDetectorWell) {
  using T = TypeParam;
  using R = Residuals<S, T, Tuning>;
  for (const T bad : {hostile<T>[0], hostile<T>[2], hostile<T>[3]})
    for (const bool collision : {false, true}) {
      CollisionState state{collision ? 3 : 1, collision ? 0 : 2, collision};
      R residual{};
      residual[1] = bad;
      for (int k = 0; k < 4; ++k) {
        const Collision found = detect(state, residual);
        EXPECT_EQ(found.status.code, Code::not_finite);
        EXPECT_EQ(found.detected, collision) << "neither begun nor ended by it";
        EXPECT_EQ(found.joint, -1);
        EXPECT_EQ(state.above, collision ? 3 : 1);
        EXPECT_EQ(state.below, collision ? 0 : 2);
      }
      EXPECT_TRUE(detect(state, R{}).status.ok());
    }
}

// The largest finite residuals are a collision as any other.
TYPED_TEST(HostileNumbers, AreACollisionWhereTheyAreNumbers) {
  using T = TypeParam;
  CollisionState state;
  Residuals<S, T, Tuning> residual{};
  residual[2] = std::numeric_limits<T>::max();
  for (int k = 0; k < 2; ++k)
    EXPECT_FALSE(detect(state, residual).detected);
  const Collision found = detect(state, residual);
  EXPECT_TRUE(found.detected && found.status.ok());
  EXPECT_EQ(found.joint, 2);
}

// The same of the estimator: what a bad sample meets stays as it was, sums and all, and the mass is found after it.
TYPED_TEST(HostileNumbers, LeaveTheEstimatorWell) {
  using T = TypeParam;
  const auto weighed = [](PayloadState<S, T>& state, const Sample<T>& s) {
    return update_payload<S, T, Tuning>(state, s.q, s.qd, s.tau);
  };
  for (const T bad : hostile<T>)
    for (int number = 0; number < 9; ++number) {
      SCOPED_TRACE(testing::Message() << "number " << number << " is " << bad);
      for (const int first : {0, 50}) {  // as the very first sample, and in the middle
        PayloadState<S, T> state;
        for (int k = 0; k < first; ++k)
          ASSERT_TRUE(weighed(state, Sample<T>(k)).ok());
        const auto before = state;
        Sample<T> sample(first);
        sample.number(number) = bad;
        const Status status = weighed(state, sample);
        if (!std::isfinite(bad)) {
          EXPECT_EQ(status.code, Code::not_finite);
        }
        if (!status.ok()) {
          EXPECT_TRUE(same(before.information, state.information) && same(before.moment, state.moment) &&
                      same(before.lagged, state.lagged));
          EXPECT_FALSE(state.ready);
        }
        for (int k = first + 1; k < first + 40; ++k) {
          const bool ok = weighed(state, Sample<T>(k)).ok();
          if (k > first + 3) {
            ASSERT_TRUE(ok) << "sample " << k;
          }
        }
        for (int i = 0; i < 4; ++i) {
          ASSERT_TRUE(is_finite(state.moment[i]));
          for (int j = 0; j <= i; ++j)
            ASSERT_TRUE(is_finite(state.information[i][j]));
        }
        const auto found = estimate<Tuning>(state);
        if (found.status.ok()) {
          EXPECT_TRUE(is_finite(found.mass) && check_finite(found.first_moment).ok());
        }
      }
    }
}

TYPED_TEST(HostileNumbers, InTheSumsAreNoEstimate) {
  using T = TypeParam;
  PayloadState<S, T> state;
  for (int i = 0; i < 4; ++i)
    state.information[i][i] = T(1e6), state.moment[i] = std::numeric_limits<T>::max();
  ASSERT_TRUE(estimate<Tuning>(state).status.ok());
  const auto& way = Unlimited::chain.tool.pose.position;
  ASSERT_GT(way[2], 0.0);
  for (int i = 0; i < 4; ++i)
    state.information[i][i] = T(1e4), state.moment[i] = std::numeric_limits<T>::infinity();
  EXPECT_EQ(estimate<Tuning>(state).status.code, Code::not_finite);
}

// Words beyond the declared limits wrap in the columns: refused, with the joint.
TEST(HostileWords, LeaveTheEstimatorWell) {
  using R = Scene<Puma560, Gravity>;
  PayloadState<R, Fixed32> state;
  Positions<Puma560, Fixed32> q = clamped_request<Puma560>(Positions<Puma560, Fixed32>{}, {}, {}).q;
  Velocities<Puma560, Fixed32> qd{};
  const Residuals<R, Fixed32, Tuning> residual{};
  ASSERT_TRUE((update_payload<R, Fixed32, Tuning>(state, q, qd, residual).ok()));
  const auto before = state;
  qd[4].raw = INT32_MAX;
  const Status status = update_payload<R, Fixed32, Tuning>(state, q, qd, residual);
  EXPECT_EQ(status.code, Code::speed_limit);
  EXPECT_EQ(status.joint, 4);
  EXPECT_FALSE(state.ready);
  EXPECT_TRUE(same(before.information, state.information) && same(before.last, state.last));
}

TYPED_TEST(HostileNumbers, AreFoundInAnswersWithoutAStatus) {
  using T = TypeParam;
  const Sample<T> sample(3);
  auto tau = inverse_dynamics<S>(sample.q, sample.qd, sample.tau);
  EXPECT_TRUE(check_finite(tau).ok());
  EXPECT_TRUE(check_finite(sample.q, sample.qd, tau).ok());
  for (const T bad : {hostile<T>[0], hostile<T>[2], hostile<T>[3]}) {
    auto qd = sample.qd;
    qd[2] = bad;
    EXPECT_EQ(check_finite(sample.q, qd, tau).joint, 2);
    qd[1] = bad;
    EXPECT_EQ(check_finite(sample.q, qd, tau).joint, 1);
    EXPECT_EQ(check_finite(qd).code, Code::not_finite);
    EXPECT_EQ(check_finite(bad).code, Code::not_finite);
    auto m = mass_matrix<S>(sample.q);
    EXPECT_TRUE(check_finite(m).ok());
    m(2, 1) = bad;
    EXPECT_EQ(check_finite(m).joint, 2);
    auto poses = forward_kinematics<S>(sample.q);
    EXPECT_TRUE(check_finite(poses.tool).ok());
    for (T* number : {&poses.tool.rotation.x.z, &poses.tool.rotation.y.y, &poses.tool.rotation.z.x,
                      &poses.tool.position.x, &poses.tool.position.z}) {
      const T kept = *number;
      *number = bad;
      EXPECT_EQ(check_finite(poses.tool).code, Code::not_finite);
      *number = kept;
    }
    auto columns = jacobian<S>(sample.q);
    EXPECT_TRUE(check_finite(columns).ok());
    columns[1].linear.y = bad;
    EXPECT_EQ(check_finite(columns).joint, 1);
    auto terms = momentum_terms<S>(sample.q, sample.qd);
    EXPECT_TRUE(check_finite(terms).ok());
    terms.drift[2] = bad;
    EXPECT_EQ(check_finite(terms).joint, 2);
    auto wrench = base_wrench<S>(sample.q, sample.qd, sample.tau);
    EXPECT_TRUE(check_finite(wrench).ok());
    wrench.force.z = bad;
    EXPECT_EQ(check_finite(wrench).code, Code::not_finite);
  }
  EXPECT_TRUE(check_finite(hostile<T>[4]).ok());
  EXPECT_TRUE(check_finite(hostile<T>[10]).ok());
}

// Angles of so many turns are inside no declared limit, and yet no answer to them is exact.
TYPED_TEST(HostileNumbers, OfTurnsAreRefusedWhereNothingLimitsThem) {
  using T = TypeParam;
  const Sample<T> sample(3);
  FeedforwardState<S, T> state;
  for (const int joint : {0, 1, 2}) {
    auto q = sample.q;
    q[joint] = T(0.999) * largest_angles<T>;
    EXPECT_TRUE((feedforward<S>(state, q, sample.qd, sample.tau).status.ok())) << joint;
    for (const T sign : {T(1), T(-1)}) {
      q[joint] = sign * T(1.001) * largest_angles<T>;
      const Status status = feedforward<S>(state, q, sample.qd, sample.tau).status;
      EXPECT_EQ(status.code, joint == 2 ? Code::ok : Code::angle_range) << "a slide has no turns";
      EXPECT_EQ(status.joint, joint == 2 ? -1 : joint);
      ObserverState<S, T, Tuning> observer;
      EXPECT_EQ((observe(observer, q, sample.qd, sample.tau).ok()), joint == 2);
      EXPECT_EQ((clamped_request<S>(q, sample.qd, sample.tau).q[joint]), q[joint]) << "it is its own nearest";
    }
  }
}

// In fixed point answers say what the words are beyond: a slide's end anywhere, a speed where there are speeds.
TEST(HostileWords, HaveAStatusInEveryAnswer) {
  using robots::Scara;
  const auto q = to_fixed<Positions<Scara, Fixed32>>(Joints<Scara, double>{0.5, -0.5, 0.1}).values;
  EXPECT_TRUE(forward_kinematics<Scara>(q).status.ok());
  EXPECT_TRUE(jacobian<Scara>(q).status.ok());
  EXPECT_TRUE((jacobian<Scara, 1>(q).status.ok()));
  EXPECT_TRUE(separate<Scara>(q).status.ok());
  EXPECT_TRUE(momentum_terms<Scara>(q, Velocities<Scara, Fixed32>{}).status.ok());
  for (const std::int32_t far : {INT32_MAX, INT32_MIN}) {
    auto beyond = q;
    beyond[2].raw = far;
    const Status all[] = {forward_kinematics<Scara>(beyond).status, jacobian<Scara>(beyond).status,
                          jacobian<Scara, 1>(beyond).status, separate<Scara>(beyond).status,
                          momentum_terms<Scara>(beyond, Velocities<Scara, Fixed32>{}).status};
    for (const Status& status : all) {
      EXPECT_EQ(status.code, Code::position_limit);
      EXPECT_EQ(status.joint, 2);
    }
    auto around = q;
    around[1].raw = far;  // half a turn: beyond the declared angles, and right all the same
    EXPECT_TRUE(forward_kinematics<Scara>(around).status.ok());
    EXPECT_TRUE(separate<Scara>(around).status.ok());
    Velocities<Scara, Fixed32> fast{};
    fast[1].raw = far;
    EXPECT_EQ(momentum_terms<Scara>(q, fast).status.code, Code::speed_limit);
    EXPECT_EQ(momentum_terms<Scara>(q, fast).status.joint, 1);
  }
}

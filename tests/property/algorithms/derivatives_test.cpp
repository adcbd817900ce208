// Derivatives of inverse and forward dynamics against differences of the oracle in 113-bit arithmetic.
#include <cases/to_axial.hpp>
#include <oracle/differences.hpp>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>
#include <robots/scara_rrpr.hpp>

#include "random_models.hpp"
#include "scene_robot.hpp"

namespace {

using namespace axial;
using oracle::Jacobians, oracle::differences;
using oracle::quad;
using property::Everything;
using property::Fill;
using property::joints;
using QuadVector = oracle::Vector<quad>;

// A block's largest difference and its largest exact entry, of one state or of several.
struct Block {
  quad difference = 0, largest = 0;
  template <class Ours>
  void see(const Ours& ours, const oracle::Matrix<quad>& exact, int n) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const quad e = exact(i, j);
        difference = std::max(difference, oracle::abs(quad(ours(i, j)) - e));
        largest = std::max(largest, oracle::abs(e));
      }
    }
  }
  double error() const { return static_cast<double>(difference / (largest > 0 ? largest : quad(1))); }
};
template <class Ours>
double block_error(const Ours& ours, const oracle::Matrix<quad>& exact, int n) {
  Block block;
  block.see(ours, exact, n);
  return block.error();
}

struct Errors {
  double position, velocity;
};
template <class Result>
Errors inverse_errors(const Result& ours, const Jacobians& exact, int n) {
  return {block_error(ours.dtau_dq, exact.by_position, n), block_error(ours.dtau_dqd, exact.by_velocity, n)};
}
template <class Result>
Errors forward_errors(const Result& ours, const Jacobians& exact, int n) {
  return {block_error(ours.dqdd_dq, exact.by_position, n), block_error(ours.dqdd_dqd, exact.by_velocity, n)};
}
void expect_below(const Errors& errors, double most) {
  EXPECT_LE(errors.position, most);
  EXPECT_LE(errors.velocity, most);
}

struct State {
  QuadVector q, qd, x;  // x: accelerations, or efforts
};
template <class T, class R>
State as_quad(const Joints<R, T>& q, const Joints<R, T>& qd, const Joints<R, T>& x, int n = joint_count<R>) {
  using oracle::convert;
  return {convert<quad>(property::vector(q, n)), convert<quad>(property::vector(qd, n)),
          convert<quad>(property::vector(x, n))};
}
Jacobians inverse_reference(const oracle::Chain<quad>& chain, const State& s, const oracle::Load<quad>& load = {}) {
  return differences(s.q, s.qd,
                     [&](const auto& q, const auto& qd) { return oracle::inverse_dynamics(chain, q, qd, s.x, load); });
}
Jacobians forward_reference(const oracle::Chain<quad>& chain, const State& s, const oracle::Load<quad>& load = {}) {
  return differences(s.q, s.qd,
                     [&](const auto& q, const auto& qd) { return oracle::forward_dynamics(chain, q, qd, s.x, load); });
}

// On a base that moves as it is told. Accelerations of given efforts solve M qdd = tau - tau at rest.
Jacobians moved_inverse_reference(const oracle::Chain<quad>& chain, const oracle::BaseMotion<quad>& base,
                                  const State& s, const oracle::Load<quad>& load) {
  return differences(s.q, s.qd, [&](const auto& q, const auto& qd) {
    return oracle::inverse_dynamics_on_moving_base(chain, base, q, qd, s.x, load);
  });
}
Jacobians moved_forward_reference(const oracle::Chain<quad>& chain, const oracle::BaseMotion<quad>& base,
                                  const State& s, const oracle::Load<quad>& load) {
  return differences(s.q, s.qd, [&](const auto& q, const auto& qd) {
    const QuadVector none(q.size(), quad(0));
    auto left = oracle::inverse_dynamics_on_moving_base(chain, base, q, qd, none, load);
    for (std::size_t i = 0; i < left.size(); ++i)
      left[i] = s.x[i] - left[i];
    return oracle::solve(oracle::mass_matrix(chain, q), left);
  });
}

// Not at rest, where dry friction jumps.
oracle::Vector<double> moving(oracle::RandomChains& random, std::size_t n) {
  auto qd = random.vector(static_cast<int>(n), 2.0);
  for (double& v : qd)
    v += v < 0 ? -0.0625 : 0.0625;
  return qd;
}

// ---- features

template <class... F>
struct Named {
  using Unrolled = Scene<Everything, F...>;
  using Compact = Scene<Everything, F..., Looped>;
};

template <class S, class T>
void expect_scene(oracle::RandomChains& random, double most_inverse, double most_forward) {
  const auto q = joints<Everything, T>(random.vector(4, 3.0)), qd = joints<Everything, T>(moving(random, 4)),
             x = joints<Everything, T>(random.vector(4, 4.0));
  const auto in = Fill::inputs<S, T>(q);
  const auto chain = Fill::chain<S, Everything>();
  const auto load = Fill::load<S>();
  const State s = as_quad(q, qd, x);
  const auto inverse = inverse_dynamics_derivatives<S>(q, qd, x, in);
  const auto forward = forward_dynamics_derivatives<S>(q, qd, x, in);
  EXPECT_TRUE(forward.qdd.status.ok());
  if constexpr (S::template has<BaseMotion>) {
    const auto base = Fill::base_motion<S>();
    expect_below(inverse_errors(inverse, moved_inverse_reference(chain, base, s, load), 4), most_inverse);
    expect_below(forward_errors(forward, moved_forward_reference(chain, base, s, load), 4), most_forward);
  } else {
    expect_below(inverse_errors(inverse, inverse_reference(chain, s, load), 4), most_inverse);
    expect_below(forward_errors(forward, forward_reference(chain, s, load), 4), most_forward);
  }
}

template <class N>
class DerivativesOfScenes : public testing::Test {};
using Scenes =
    testing::Types<Named<>, Named<Gravity, FullParameters>, Named<Payload, Gravity>, Named<Friction, JointSprings>,
                   Named<Gravity, RotorInertia, BaseMotion, TipWrench>,
                   Named<RuntimeGravity, RotorInertia, Friction, JointSprings, TipWrench, ExternalWrenches, Payload>>;
TYPED_TEST_SUITE(DerivativesOfScenes, Scenes);

// ---- robots

template <class R, class T>
void expect_robot(int states, double most_inverse, double most_forward, double most_of_one_state) {
  constexpr int n = R::chain.size;
  Block position, velocity;  // of all states
  oracle::RandomChains random(17);
  const auto chain = oracle::of_robot<quad, R>();
  for (int k = 0; k < states; ++k) {
    SCOPED_TRACE(k);
    const auto at = property::random_state<R>(random);
    const auto q = joints<R, T>(at.q), qd = joints<R, T>(at.qd), qdd = joints<R, T>(at.qdd);
    const auto ours = inverse_dynamics_derivatives<R>(q, qd, qdd);
    const State s = as_quad(q, qd, qdd);
    expect_below(inverse_errors(ours, inverse_reference(chain, s), n), most_inverse);
    const auto tau = inverse_dynamics<R>(q, qd, qdd);
    const auto m = mass_matrix<R>(q);
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(ours.tau[i], tau[i], most_inverse * 100);
      for (int j = 0; j <= i; ++j)
        EXPECT_NEAR(ours.M(i, j), m(i, j), most_inverse * 10);
    }
    const auto forward = forward_dynamics_derivatives<R>(q, qd, tau);
    const auto exact = forward_reference(chain, as_quad(q, qd, tau));
    expect_below(forward_errors(forward, exact, n), most_of_one_state);
    position.see(forward.dqdd_dq, exact.by_position, n), velocity.see(forward.dqdd_dqd, exact.by_velocity, n);
  }
  EXPECT_LE(position.error(), most_forward);
  EXPECT_LE(velocity.error(), most_forward);
}

template <int N>
struct Eye {
  // The largest entry of M M^-1 - 1.
  template <class M, class I>
  static double error(const M& m, const I& inverse) {
    double worst = 0;
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < N; ++j) {
        double sum = i == j ? -1 : 0;
        for (int k = 0; k < N; ++k)
          sum += double(m(i, k)) * double(inverse(k, j));
        worst = std::max(worst, std::abs(sum));
      }
    }
    return worst;
  }
};

}  // namespace

TYPED_TEST(DerivativesOfScenes, AreThoseOfTheOracleInEveryForm) {
  oracle::RandomChains random(31);
  for (int k = 0; k < 6; ++k) {
    SCOPED_TRACE(k);
    expect_scene<typename TypeParam::Unrolled, double>(random, 1e-13, 1e-11);
    expect_scene<typename TypeParam::Compact, double>(random, 1e-13, 1e-11);
  }
}

TEST(Derivatives, OfRobotsAreThoseOfTheOracle) {
  expect_robot<robots::Puma560, double>(10, 1e-13, 1e-12, 1e-12);
  expect_robot<robots::Panda, double>(10, 1e-13, 1e-11, 1e-11);
  expect_robot<robots::Scara, double>(20, 1e-13, 1e-12, 1e-12);
  expect_robot<robots::ScaraRrpr, double>(20, 1e-13, 1e-12, 1e-12);
}
TEST(Derivatives, OfRobotsInFloat) {
  expect_robot<robots::Puma560, float>(40, 1e-6, 1e-6, 1e-6);
  expect_robot<robots::Panda, float>(40, 1e-6, 5e-6, 5e-6);
  expect_robot<robots::Scara, float>(40, 1e-6, 1e-6, 2.5e-6);
}

TEST(Derivatives, OfRandomChainsAndTreesAreThoseOfTheOracle) {
  using M = Model<12, Gravity, RotorInertia>;
  property::expect_on_random_models<M>(40, 24, 8, [](auto& random, const M& model, const auto& chain, int n) {
    const auto q = joints<M, double>(random.vector(n, 3.0)), qd = joints<M, double>(random.vector(n, 2.0)),
               x = joints<M, double>(random.vector(n, 4.0));
    const State s = as_quad(q, qd, x, n);
    expect_below(inverse_errors(inverse_dynamics_derivatives(model, q, qd, x), inverse_reference(chain, s), n), 1e-13);
    const auto forward = forward_dynamics_derivatives(model, q, qd, x);
    EXPECT_TRUE(forward.qdd.status.ok() || forward.qdd.status.code == Status::Code::inaccurate);
    if (forward.qdd.status.ok()) expect_below(forward_errors(forward, forward_reference(chain, s), n), 1e-10);
    return forward.qdd.status.ok();
  });
}

TEST(Derivatives, TheInverseMassMatrixUndoesTheMassMatrix) {
  using R = robots::Puma560;
  oracle::RandomChains random(5);
  for (int k = 0; k < 20; ++k) {
    const auto at = property::random_state<R>(random);
    const auto q = joints<R, double>(at.q), qd = joints<R, double>(at.qd), tau = joints<R, double>(at.qdd);
    const auto d = forward_dynamics_derivatives<R>(q, qd, tau);
    EXPECT_LE(Eye<6>::error(mass_matrix<R>(q), d.M_inverse), 1e-13);
    const auto looped = forward_dynamics_derivatives<Scene<R, Gravity, RotorInertia, Looped>>(q, qd, tau);
    EXPECT_LE(Eye<6>::error(mass_matrix<R>(q), looped.M_inverse), 1e-13);
    const auto qdd = forward_dynamics<R>(q, qd, tau);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(d.qdd[i], qdd[i], 1e-11 * (1 + std::abs(qdd[i])));
  }
}

TEST(Derivatives, OfWhatIsAskedForAloneAreTheSameBits) {
  using R = robots::Puma560;
  oracle::RandomChains random(6);
  const auto at = property::random_state<R>(random);
  const auto q = joints<R, float>(at.q), qd = joints<R, float>(at.qd), qdd = joints<R, float>(at.qdd);
  const auto all = inverse_dynamics_derivatives<R>(q, qd, qdd);
  const auto position = inverse_dynamics_derivatives<R, with_position_jacobian>(q, qd, qdd);
  const auto velocity = inverse_dynamics_derivatives<R, with_velocity_jacobian, with_efforts>(q, qd, qdd);
  static_assert(sizeof position == sizeof all.dtau_dq, "nothing else has a member");
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(velocity.tau[i], all.tau[i]);
    for (int j = 0; j < 6; ++j) {
      EXPECT_EQ(position.dtau_dq(i, j), all.dtau_dq(i, j));
      EXPECT_EQ(velocity.dtau_dqd(i, j), all.dtau_dqd(i, j));
    }
  }
}

TEST(Derivatives, OfWhatIsNoNumberHaveAStatus) {
  using R = robots::Puma560;
  Joints<R, float> q{}, qd{}, tau{};
  q[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(forward_dynamics_derivatives<R>(q, qd, tau).qdd.status.code, Status::Code::not_finite);
}

// Dynamics along a direction against differences of the oracle in 113-bit arithmetic.
#include <cases/to_axial.hpp>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include "random_models.hpp"
#include "scene_robot.hpp"

namespace {

using namespace axial;
using oracle::quad;
using property::Everything;
using property::Fill;
using property::joints;
using QuadVector = oracle::Vector<quad>;

// A point, and where it goes.
template <class R, class T>
struct State {
  Joints<R, T> q, qd, x, dq, dqd, dx;  // x: accelerations, or efforts
  int n = joint_count<R>;

  QuadVector at(const Joints<R, T>& value, const Joints<R, T>& slope, quad step) const {
    using oracle::convert;
    auto result = convert<quad>(property::vector(value, n));
    const auto change = convert<quad>(property::vector(slope, n));
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] += step * change[i];
    return result;
  }
  // The slope of f(q, qd, x) along the direction: exact to some 20 digits.
  template <class F>
  QuadVector slope(const F& f) const {
    const quad h = quad(1) / quad(1LL << 36);
    QuadVector above = f(at(q, dq, h), at(qd, dqd, h), at(x, dx, h));
    const QuadVector below = f(at(q, dq, -h), at(qd, dqd, -h), at(x, dx, -h));
    for (std::size_t i = 0; i < above.size(); ++i)
      above[i] = (above[i] - below[i]) / (h + h);
    return above;
  }
};
template <class R, class T>
State<R, T> random_state(oracle::RandomChains& random, int n = joint_count<R>) {
  const auto values = [&](double most) { return joints<R, T>(random.vector(n, most)); };
  auto speeds = random.vector(n, 2.0);
  for (double& v : speeds)
    v += v < 0 ? -0.0625 : 0.0625;  // not at rest, where dry friction jumps
  return {values(3.0), joints<R, T>(speeds), values(4.0), values(1.0), values(1.0), values(1.0), n};
}

// The largest difference over the largest exact slope.
template <class Ours>
double error(const Ours& ours, const QuadVector& exact) {
  quad difference = 0, largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    difference = std::max(difference, oracle::abs(quad(ours[static_cast<int>(i)]) - exact[i]));
    largest = std::max(largest, oracle::abs(exact[i]));
  }
  return static_cast<double>(difference / (largest > 0 ? largest : quad(1)));
}

template <class S, class R, class T>
auto inverse_along(const State<R, T>& s, const Inputs<S, T>& in = {}) {
  return inverse_dynamics_along<S>(s.q, s.qd, s.x, {s.dq, s.dqd, s.dx}, in).dtau;
}
template <class S, class R, class T>
auto forward_along(const State<R, T>& s, const Inputs<S, T>& in = {}) {
  const auto result = forward_dynamics_along<S>(s.q, s.qd, s.x, {s.dq, s.dqd, s.dx}, in);
  EXPECT_TRUE(result.qdd.status.ok());
  return result.dqdd;
}

template <class... F>
struct Named {
  using Unrolled = Scene<Everything, F...>;
  using Compact = Scene<Everything, F..., Looped>;
};
template <class S>
void expect_scene(oracle::RandomChains& random) {
  const auto s = random_state<Everything, double>(random);
  const auto in = Fill::inputs<S, double>(s.q);
  const auto chain = Fill::chain<S, Everything>();
  const auto load = Fill::load<S>();
  if constexpr (S::template has<BaseMotion>) {
    const auto base = Fill::base_motion<S>();
    EXPECT_LE(error(inverse_along<S>(s, in), s.slope([&](const auto&... at) {
                return oracle::inverse_dynamics_on_moving_base(chain, base, at..., load);
              })),
              1e-13);
  } else {
    EXPECT_LE(error(inverse_along<S>(s, in),
                    s.slope([&](const auto&... at) { return oracle::inverse_dynamics(chain, at..., load); })),
              1e-13);
    EXPECT_LE(error(forward_along<S>(s, in),
                    s.slope([&](const auto&... at) { return oracle::forward_dynamics(chain, at..., load); })),
              1e-11);
  }
}

template <class N>
class AlongScenes : public testing::Test {};
using Scenes =
    testing::Types<Named<>, Named<Payload, Gravity>, Named<Friction, JointSprings>, Named<Gravity, BaseMotion>,
                   Named<RuntimeGravity, RotorInertia, Friction, JointSprings, TipWrench, ExternalWrenches>>;
TYPED_TEST_SUITE(AlongScenes, Scenes);

template <class R, class T>
void expect_robot(int states, double most_inverse, double most_forward) {
  oracle::RandomChains random(19);
  const auto chain = oracle::of_robot<quad, R>();
  for (int k = 0; k < states; ++k) {
    SCOPED_TRACE(k);
    const auto s = random_state<R, T>(random);
    EXPECT_LE(
        error(inverse_along<R>(s), s.slope([&](const auto&... at) { return oracle::inverse_dynamics(chain, at...); })),
        most_inverse);
    EXPECT_LE(
        error(forward_along<R>(s), s.slope([&](const auto&... at) { return oracle::forward_dynamics(chain, at...); })),
        most_forward);
  }
}

}  // namespace

TYPED_TEST(AlongScenes, AreTheOraclesInEveryForm) {
  oracle::RandomChains random(33);
  for (int k = 0; k < 8; ++k) {
    SCOPED_TRACE(k);
    expect_scene<typename TypeParam::Unrolled>(random);
    expect_scene<typename TypeParam::Compact>(random);
  }
}

TEST(Along, RobotsAreTheOracles) {
  expect_robot<robots::Puma560, double>(20, 1e-13, 1e-12);
  expect_robot<robots::Panda, double>(20, 1e-13, 1e-11);
  expect_robot<robots::Scara, double>(20, 1e-13, 1e-12);
}
TEST(Along, RobotsInFloat) {
  expect_robot<robots::Puma560, float>(40, 1e-6, 1e-6);
  expect_robot<robots::Panda, float>(40, 1e-6, 1e-5);
  expect_robot<robots::Scara, float>(40, 1e-6, 2.5e-6);
}

TEST(Along, RandomChainsAndTreesAreTheOracles) {
  using M = Model<12, Gravity, RotorInertia>;
  property::expect_on_random_models<M>(42, 24, 8, [](auto& random, const M& model, const auto& chain, int n) {
    const auto s = random_state<M, double>(random, n);
    EXPECT_LE(error(inverse_dynamics_along(model, s.q, s.qd, s.x, {s.dq, s.dqd, s.dx}).dtau,
                    s.slope([&](const auto&... at) { return oracle::inverse_dynamics(chain, at...); })),
              1e-13);
    const auto forward = forward_dynamics_along(model, s.q, s.qd, s.x, {s.dq, s.dqd, s.dx});
    if (!forward.qdd.status.ok()) return false;
    EXPECT_LE(error(forward.dqdd, s.slope([&](const auto&... at) { return oracle::forward_dynamics(chain, at...); })),
              1e-10);
    return true;
  });
}

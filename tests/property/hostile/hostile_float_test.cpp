// Any numbers in float and double: what is answered with ok is finite, and for states that a robot can be in it is
// right.
#include <axial/simulation/integrators.hpp>

#include <property/fixed/fixed_robots.hpp>
#include "hostile.hpp"

#include <axial/axial.hpp>

namespace {

using namespace axial;
using property::Wrong;
constexpr std::uint64_t tests = 28;

/// q, qd, qdd and efforts of a robot.
template <class R, class T>
struct Numbers {
  Joints<R, T> q{}, qd{}, qdd{}, tau{};
  bool moderate = true;  ///< no number is hostile, or hostile by name only

  /// All numbers hostile, all moderate (up to twice the limits, a few turns), one hostile, some, or huge but finite.
  Numbers(exhaustive::Random& random, std::uint64_t index) {
    const std::int64_t one = random.between(0, 4 * R::chain.size - 1);
    for (int i = 0; i < R::chain.size; ++i) {
      const auto& link = R::chain.links[i];
      const bool turns = link.type == JointType::revolute;
      const double scales[] = {
          turns ? 20.0 : 2.0 * std::fmax(std::fabs(link.position_max), std::fabs(link.position_min)),
          2.0 * link.speed_limit, 2.0 * link.acceleration_limit, 2.0 * link.effort_limit};
      T* const all[] = {&q[i], &qd[i], &qdd[i], &tau[i]};
      for (int k = 0; k < 4; ++k) {
        const double part = static_cast<double>(random.between(-1000000, 1000000)) * 1e-6;
        const T usual = static_cast<T>(part * scales[k]);
        const T hostile = index % 5 == 4
                              ? usual * static_cast<T>(std::pow(10.0, static_cast<double>(random.between(0, 30))))
                              : property::hostile_number<T>(random);
        const bool chosen = index % 5 == 0 || index % 5 == 4 || (index % 5 == 2 && 4 * i + k == one) ||
                            (index % 5 == 3 && random.between(0, 3) == 0);
        *all[k] = chosen ? hostile : usual;
        moderate = moderate && std::fabs(static_cast<double>(*all[k])) <= 1.0001 * scales[k];
      }
    }
  }
};

template <class R, class T>
bool are_finite(const Joints<R, T>& values) {
  for (const T& x : values.values)
    if (!std::isfinite(x)) return false;
  return true;
}
template <class R, class T>
Joints<R, double> in_double(const Joints<R, T>& values) {
  Joints<R, double> all{};
  for (int i = 0; i < R::chain.size; ++i)
    all[i] = static_cast<double>(values[i]);
  return all;
}
/// Largest difference, as a share of the largest value or of `least` where that is more.
template <class R, class T>
double share(const Joints<R, T>& seen, const Joints<R, double>& exact, double least) {
  double off = 0.0, size = least;
  for (int i = 0; i < R::chain.size; ++i)
    off = std::fmax(off, std::fabs(static_cast<double>(seen[i]) - exact[i])),
    size = std::fmax(size, std::fabs(exact[i]));
  return off / size;
}
/// What a well-conditioned arm may lose in T by any route.
template <class T>
constexpr double tolerance = sizeof(T) == 4 ? 2e-3 : 1e-10;

template <class R>
class HostileNumbers : public testing::Test {
 protected:
  template <class T, class Check>
  void run(std::uint64_t few, const Check& check) {
    exhaustive::Random random(property::hostile_seed);
    const std::uint64_t states = property::hostile_states(few, tests);
    for (std::uint64_t k = 0; k < states; ++k)
      check(Numbers<R, T>(random, k), k);
    EXPECT_EQ(wrong.count, 0U) << wrong.first;
    EXPECT_GT(met, states / 10);
  }
  /// One route over numbers T.
  template <class T, class... Tags>
  void forward(std::uint64_t few) {
    using S = Scene<R, Gravity, RotorInertia, Tags...>;
    using Exact = Scene<R, Gravity, RotorInertia, ArticulatedBody>;
    run<T>(few, [&](const Numbers<R, T>& x, std::uint64_t k) {
      const auto a = forward_dynamics<S>(x.q, x.qd, x.tau);
      if (!a.status.ok()) return;
      ++met;
      wrong.note(are_finite<R, T>(a), "finite accelerations", k, static_cast<double>(a[0]), 0.0);
      if (!x.moderate) return;
      const auto exact = forward_dynamics<Exact>(in_double(x.q), in_double(x.qd), in_double(x.tau));
      const double off = share<R, T>(a, exact, 1.0);
      wrong.note(off <= tolerance<T>, "accelerations", k, off, 0.0);
    });
  }
  Wrong wrong;
  std::uint64_t met = 0;
};
#ifdef AXIAL_FEW_ROBOTS
using Robots = testing::Types<property::SlidingTree, robots::Scara>;
#else
using Robots = testing::Types<property::SlidingTree, robots::Scara, robots::Puma560, robots::Panda>;
#endif
TYPED_TEST_SUITE(HostileNumbers, Robots, property::RobotName);

}  // namespace

TYPED_TEST(HostileNumbers, TheDefaultRouteIsRightOrSaysOtherwise) { this->template forward<float>(10000); }
TYPED_TEST(HostileNumbers, ArticulatedBodiesAreRightOrSayOtherwise) {
  this->template forward<float, ArticulatedBody>(10000);
}
TYPED_TEST(HostileNumbers, TheSplitFormIsRightOrSaysOtherwise) {
  this->template forward<float, SplitArticulatedBody>(10000);
}
TYPED_TEST(HostileNumbers, CompositeBodiesAreRightOrSayOtherwise) {
  this->template forward<float, CompositeBody>(10000);
}
TYPED_TEST(HostileNumbers, TheDefaultRouteInDoubleIsRightOrSaysOtherwise) { this->template forward<double>(5000); }

TYPED_TEST(HostileNumbers, FeedforwardIsRightOrSaysOtherwise) {
  using R = TypeParam;
  FeedforwardState<R, float> memory{};
  this->template run<float>(10000, [&](const Numbers<R, float>& x, std::uint64_t k) {
    const auto answer = feedforward<R>(memory, x.q, x.qd, x.qdd);
    this->met += 1;  // each is met or refused: what is answered is always safe
    for (int i = 0; i < R::chain.size; ++i)
      this->wrong.note(std::fabs(static_cast<double>(answer.tau[i])) <= R::chain.links[i].effort_limit * 1.0001,
                       "a safe effort", k, static_cast<double>(answer.tau[i]), 0.0);
    if (!answer.status.ok()) return;
    const auto exact = inverse_dynamics<R>(in_double(x.q), in_double(x.qd), in_double(x.qdd));
    const double off = share<R, float>(answer.tau, exact, 1.0);
    this->wrong.note(off <= 1e-5, "efforts", k, off, 0.0);
  });
}

TYPED_TEST(HostileNumbers, AStepIsFiniteOrSaysOtherwise) {
  using R = TypeParam;
  using S = Scene<R, Gravity, RotorInertia>;
  this->template run<float>(4000, [&](const Numbers<R, float>& x, std::uint64_t k) {
    Motion<S, float> motion{};
    motion.q = x.q, motion.qd = x.qd;
    const float h = k % 7 == 0 ? static_cast<float>(x.tau[0]) : 1e-3F;
    const Status status = k % 2 == 0 ? advance<SemiImplicitEuler>(motion, h, Held<S, float>{x.tau, {}})
                                     : advance<RungeKutta4>(motion, h, Held<S, float>{x.tau, {}});
    if (!status.ok()) return;
    this->met += 1;
    this->wrong.note(are_finite<R, float>(motion.q) && are_finite<R, float>(motion.qd), "a finite motion", k, 0.0, 0.0);
  });
}

// Hostile numbers in kinematics, separation and momenta: what says ok is finite and exact, and what is not says so.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/dynamics/momentum.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>
#include <robots/two_arm.hpp>

#include <cmath>
#include <limits>
#include <random>

#include "hostile.hpp"

namespace {

using namespace axial;
using Code = Status::Code;
using property::Wrong;

/// Draws numbers that nobody wants to see among numbers that everybody does.
template <class T>
class Hostile {
 public:
  explicit Hostile(unsigned seed) : engine_(seed) {}

  /// `share` of 8 are hostile.
  T number(double size, int share) {
    if (below(8) >= share) return static_cast<T>(size * unit());
    using L = std::numeric_limits<T>;
    const T all[] = {L::quiet_NaN(), L::infinity(),   -L::infinity(), L::max(),
                     L::lowest(),    L::denorm_min(), -L::min(),      T(0)};
    const int kind = below(16);
    if (kind < 8) return all[kind];
    const double most = sizeof(T) == 4 ? 38.0 : 307.0;
    return static_cast<T>((kind % 2 == 0 ? 1.0 : -1.0) *
                          std::pow(10.0, most * (kind < 12 ? (unit() + 1) / 2 : 0.2 * unit())));
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

 private:
  double unit() { return static_cast<double>(engine_()) / 2147483648.0 - 1.0; }
  std::mt19937 engine_;
};

/// What goes in, and whether all of it is finite and all angles have exact sines.
template <class S, class T>
struct Asked {
  using R = robot_of<S>;
  Positions<R, T> q{};
  Velocities<R, T> qd{};
  Inputs<S, T> in;
  bool finite = true;  ///< all but the speeds, which kinematics and separation do not take
  bool speeds_finite = true;
  double angles = 0.0;

  Asked(Hostile<T>& hostile, int share, int size) {
    for (int i = 0; i < size; ++i) {
      q[i] = hostile.number(3.0, share), qd[i] = hostile.number(2.0, share);
      speeds_finite = speeds_finite && std::isfinite(qd[i]);
      const bool turns = is_revolute(i);
      if (!turns || !scene_of<S>::template has<SineCosines>) static_cast<void>(take(q[i]));
      if constexpr (scene_of<S>::template has<SineCosines>) {
        in.turns[i] = sincos(static_cast<T>(hostile.number(3.0, 0)));
        if (hostile.below(8) < share) in.turns[i].sin = turns ? take(hostile.number(1.0, 8)) : in.turns[i].sin;
      } else if (turns) {
        angles += std::fabs(static_cast<double>(q[i]));
      }
    }
    if constexpr (scene_of<S>::template has<RuntimeGravity>) in.gravity = {vector(hostile, share)};
    if constexpr (scene_of<S>::template has<TipWrench>)
      in.tip_wrench = {vector(hostile, share), vector(hostile, share)};
    if constexpr (scene_of<S>::template has<Payload>) {
      in.payload.mass = take(std::fabs(hostile.number(2.0, share))), in.payload.com = vector(hostile, share);
      in.payload.inertia_com.xy = take(hostile.number(0.01, share));
    }
  }
  static bool is_revolute(int i) {
    if constexpr (detail::is_described<R>)
      return R::chain.links[i].type == JointType::revolute;
    else
      return i != 2;  // as model() makes it
  }

 private:
  T take(const T& x) {
    finite = finite && std::isfinite(x);
    return x;
  }
  Vec3<T> vector(Hostile<T>& hostile, int share) {
    const T x = take(hostile.number(3.0, share)), y = take(hostile.number(3.0, share));
    return {x, y, take(hostile.number(3.0, share))};
  }
};

/// How an answer fares whose status is given: it may say ok only where all is finite, and must where nothing is
/// hostile.
struct Judge {
  Wrong said_ok, refused;
  std::uint64_t ok = 0;
  template <class A>
  void judge(const A& asked, bool tame, const Status& status, bool finite, const char* what, std::uint64_t state) {
    constexpr double exact = sizeof(asked.q[0]) == 4 ? 8192.0 : 524288.0;
    const bool right = finite && asked.finite && asked.angles <= exact * (1.0 + 1e-3);
    said_ok.note(!status.ok() || right, what, state, status.ok(), right);
    said_ok.note(asked.finite || status.code == Code::not_finite, what, state, static_cast<int>(status.code), 2);
    refused.note(status.ok() || !tame, what, state, status.ok(), true);
    ok += status.ok() ? 1 : 0;
  }
};

template <class S, class T, class Terms>
bool all_finite(const Terms& s) {
  bool finite = true;
  for (int i = 0; i < s.size; ++i) {
    finite = finite && is_finite(s.G[i]);
    for (int j = 0; j < s.size; ++j)
      finite = finite && is_finite(s.A[i][j]) && is_finite(s.C[i][j]);
    for (const T& product : s.B[i])
      finite = finite && is_finite(product);
  }
  return finite;
}
template <class Poses>
bool all_poses_finite(const Poses& poses, int size) {
  bool finite = check_finite(poses.tool).ok();
  for (int i = 0; i < size; ++i)
    finite = finite && check_finite(poses.frames[i]).ok();
  return finite;
}

template <class T>
void expect_judged(const Judge& judge, std::uint64_t states) {
  EXPECT_EQ(judge.said_ok.count, 0u) << judge.said_ok.first;
  EXPECT_EQ(judge.refused.count, 0u) << judge.refused.first;
  EXPECT_GT(judge.ok, states / 16) << "then this tests nothing";
}

constexpr std::uint64_t programs = 24;  // of kernels, scenes and numbers that share the states asked for

/// Calls look(asked, tame, state) for each state: a quarter tame, the others more and more hostile.
template <class S, class T, class Look>
void for_states(int size, const Look& look, std::uint64_t states) {
  Hostile<T> hostile(static_cast<unsigned>(property::hostile_seed));
  for (std::uint64_t k = 0; k < states; ++k)
    look(Asked<S, T>(hostile, static_cast<int>(k % 4), size), k % 4 == 0, k);
}

template <class S, class T>
void expect_kinematics() {
  const std::uint64_t states = property::hostile_states(4000, programs);
  Judge judge;
  for_states<S, T>(
      joint_count<S>,
      [&](const auto& a, bool tame, std::uint64_t k) {
        const auto poses = forward_kinematics<S>(a.q, a.in);
        judge.judge(a, tame, poses.status, all_poses_finite(poses, joint_count<S>), "poses", k);
        const auto columns = jacobian<S>(a.q, a.in);
        judge.judge(a, tame, columns.status, check_finite(columns).ok(), "jacobian", k);
      },
      states);
  expect_judged<T>(judge, states);
}

template <class S, class T>
void expect_separation() {
  const std::uint64_t states = property::hostile_states(4000, programs);
  Judge judge;
  for_states<S, T>(
      joint_count<S>,
      [&](const auto& a, bool tame, std::uint64_t k) {
        const auto terms = separate<S>(a.q, a.in);
        judge.judge(a, tame, terms.status, all_finite<S, T>(terms), "separate", k);
      },
      states);
  expect_judged<T>(judge, states);
}

template <class S, class T>
void expect_momenta() {
  const std::uint64_t states = property::hostile_states(4000, programs);
  Judge judge;
  for_states<S, T>(
      joint_count<S>,
      [&](const auto& a, bool tame, std::uint64_t k) {
        const auto terms = momentum_terms<S>(a.q, a.qd, a.in);
        Asked<S, T> all = a;
        all.finite = a.finite && a.speeds_finite;
        judge.judge(all, tame, terms.status, check_finite(terms).ok(), "momenta", k);
      },
      states);
  expect_judged<T>(judge, states);
}

using property::SlidingTree;
using robots::Puma560;
using robots::Scara;
using Laden = Scene<SlidingTree, RuntimeGravity, RotorInertia, Payload, TipWrench>;
using Given = Scene<SlidingTree, Gravity, RotorInertia, SineCosines>;
using Compact = Scene<SlidingTree, Gravity, Looped>;

template <class T>
class HostileNumbers : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(HostileNumbers, Numbers);

}  // namespace

TYPED_TEST(HostileNumbers, InKinematics) {
  expect_kinematics<Scara, TypeParam>();
  expect_kinematics<Puma560, TypeParam>();
  expect_kinematics<SlidingTree, TypeParam>();
  expect_kinematics<Given, TypeParam>();
  expect_kinematics<Compact, TypeParam>();
}

TYPED_TEST(HostileNumbers, InSeparation) {
  expect_separation<Puma560, TypeParam>();
  expect_separation<SlidingTree, TypeParam>();
  expect_separation<Laden, TypeParam>();
  expect_separation<Given, TypeParam>();
  expect_separation<Compact, TypeParam>();
}

TYPED_TEST(HostileNumbers, InMomenta) {
  expect_momenta<SlidingTree, TypeParam>();
  expect_momenta<Laden, TypeParam>();
}

TYPED_TEST(HostileNumbers, InTheClosedForm) {
  using T = TypeParam;
  const std::uint64_t states = property::hostile_states(4000, programs);
  Judge judge;
  for_states<Scara, T>(
      3,
      [&](const auto& a, bool tame, std::uint64_t k) {
        const auto terms = closed_form::scara<Scara>(a.q);
        judge.judge(a, tame, terms.status, all_finite<Scara, T>(terms), "closed form", k);
      },
      states);
  expect_judged<T>(judge, states);
}

// A run-time model may be of any size: its answers are looked at.
TYPED_TEST(HostileNumbers, InRunTimeModels) {
  using T = TypeParam;
  using M = Model<4>;
  const std::uint64_t states = property::hostile_states(2000, programs);
  for (const double size : {1.0, 1e12, 1e30}) {
    M model;
    for (int i = 0; i < 3; ++i) {
      const Link link = i == 2 ? prismatic().alpha_deg(90) : revolute().alpha(0.4);
      ASSERT_TRUE(model.add(link.a(0.3 * size).mass(size).com(0.1 * size, 0.0, 0.1).inertia_com(size, size, size)));
    }
    Judge judge;
    for_states<M, T>(
        3,
        [&](const auto& a, bool tame, std::uint64_t k) {
          const auto poses = forward_kinematics(model, a.q);
          judge.judge(a, tame, poses.status, all_poses_finite(poses, 3), "poses", k);
          const auto columns = jacobian(model, a.q);
          bool finite = true;
          for (int j = 0; j < 3; ++j)
            finite = finite && check_finite(columns[j].angular).ok() && check_finite(columns[j].linear).ok();
          judge.judge(a, tame, columns.status, finite, "jacobian", k);
          const auto terms = separate(model, a.q);
          judge.judge(a, tame && size < 2.0, terms.status, all_finite<M, T>(terms), "separate", k);
        },
        states);
    expect_judged<T>(judge, states);
  }
}

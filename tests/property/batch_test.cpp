// Batches against one state at a time: every kernel, every lane; and what one lane holds reaches no other.
#include <axial/batch.hpp>

#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include "batch_lanes.hpp"
#include "scene_robot.hpp"

namespace {

using namespace axial;
using property::Fill;

/// Links on a body that floats.
struct OnBody {
  static constexpr auto chain = [] {
    auto chain = property::Everything::chain;
    chain.base_body = base_body().mass(12.0).com(0.125, -0.0625, 0.25).inertia_com(1.5, 2.25, 1.75).parameters();
    chain.has_base_body = true;
    return chain;
  }();
};

/// Springs behind joints, every third of which is rigid.
struct Sprung {
  static constexpr auto chain = [] {
    auto chain = property::Everything::chain;
    for (int i = 0; i < chain.size; ++i)
      if (i % 3 != 2) chain.links[i].stiffness = 2048.0 * (1 + i % 4);
    return chain;
  }();
};

/// S is a scene or a robot, or a model that is filled at run time.
template <class S, class T, int N>
struct Case {
  using Scene = S;
  using Number = T;
  static constexpr int lanes = N;
};

/// Calls of every kernel, over one state or a batch of them.
template <class S>
struct Kernels {
  template <class T, class Visit>
  static void visit(const Joints<robot_of<S>, T>& q, const Joints<robot_of<S>, T>& qd, const Joints<robot_of<S>, T>& x,
                    const Visit& visit) {
    const auto in = Fill::inputs<S, T>(q);
    if constexpr (!scene_of<S>::template has<FloatingBase>) {
      visit("inverse dynamics", inverse_dynamics<S>(q, qd, x, in));
      visit("gravity", gravity_torque<S>(q, in));
      visit("bias", bias_torque<S>(q, qd, in));
      visit("mass matrix", mass_matrix<S>(q, in));
      visit("separation", separate<S>(q, in));
      visit("momenta", momentum_terms<S>(q, qd, in));
    }
    if constexpr (scene_of<S>::template has<ElasticJoints>) {
      const auto motors = elastic_feedforward<S>(q, qd, x, qd, x, in);
      visit("motors' torques", motors.tau_m);
      visit("motors' positions", motors.theta);
      visit("motors' velocities", motors.thetad);
      visit("efforts of springs", motors.tau_l);
    }
    visit("poses", forward_kinematics<S>(q, in));
    visit("Jacobian", jacobian<S>(q, in));
    visit("forward dynamics", forward_dynamics<S>(q, qd, x, in));
  }
};

template <class C>
class Batches : public testing::Test {
 protected:
  using S = typename C::Scene;
  using T = typename C::Number;
  using R = robot_of<S>;
  using Many = Batch<T, C::lanes>;
  using State = Joints<R, T>;
  struct States {
    State q[C::lanes], qd[C::lanes], x[C::lanes];
  };

  States random_states() {
    States states;
    for (int k = 0; k < C::lanes; ++k) {
      states.q[k] = property::joints<R, T>(random_.vector(R::chain.size, 2.5));
      states.qd[k] = property::joints<R, T>(random_.vector(R::chain.size, 2.0));
      states.x[k] = property::joints<R, T>(random_.vector(R::chain.size, 4.0));
    }
    return states;
  }
  static property::Answers of_lane(const States& states, int lane) {
    property::Answers answers;
    Kernels<S>::visit(load<C::lanes>(states.q), load<C::lanes>(states.qd), load<C::lanes>(states.x),
                      [&](const char* name, const auto& answer) { answers.add(name, answer, lane); });
    return answers;
  }
  static property::Answers of_one(const States& states, int k) {
    property::Answers answers;
    Kernels<S>::visit(states.q[k], states.qd[k], states.x[k],
                      [&](const char* name, const auto& answer) { answers.add(name, answer, 0); });
    return answers;
  }

  oracle::RandomChains random_{2031};
};

template <class... Features>
using Everything = Scene<property::Everything, Features...>;
using All = testing::Types<
    Case<robots::Puma560, double, 4>,
    Case<Everything<Gravity, Friction, JointSprings, ArticulatedBody, Looped>, double, 4>,
    Case<Scene<OnBody, FloatingBase>, double, 4>
#ifndef AXIAL_FEW_ROBOTS
    ,
    Case<robots::Scara, float, 16>, Case<Scene<robots::Panda, Gravity, SplitArticulatedBody>, double, 8>,
    Case<Everything<RuntimeGravity, RotorInertia, Friction, TipWrench, ExternalWrenches, ArticulatedBody>, double, 2>,
    Case<Everything<Gravity, RotorInertia, Friction, CompositeBody, Looped>, float, 8>,
    Case<Everything<Gravity, SineCosines, SplitArticulatedBody, Looped>, double, 4>,
    Case<Scene<OnBody, FloatingBase, RuntimeGravity, RotorInertia, Looped>, float, 4>,
    Case<Scene<Sprung, Gravity, RotorInertia, Friction, JointSprings, TipWrench, ElasticJoints>, float, 16>,
    Case<Scene<Sprung, Gravity, RotorInertia, ElasticJoints, Looped>, double, 4>
#endif
    >;
TYPED_TEST_SUITE(Batches, All);

TYPED_TEST(Batches, EveryLaneIsOneState) {
  for (int round = 0; round < 20; ++round) {
    const auto states = this->random_states();
    for (int k = 0; k < TypeParam::lanes; ++k)
      property::expect_agreement(this->of_lane(states, k), this->of_one(states, k),
                                 sizeof(typename TypeParam::Number) == 4 ? 1e-3 : 1e-10);
  }
}

TYPED_TEST(Batches, WhatIsNoNumberStaysInItsLane) {
  using T = typename TypeParam::Number;
  const auto states = this->random_states();
  for (const T hostile : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(), T(1e30)})
    for (const int argument : {0, 1, 2}) {
      auto spoilt = states;
      const int spoilt_lane = argument % TypeParam::lanes;
      (argument == 0 ? spoilt.q : argument == 1 ? spoilt.qd : spoilt.x)[spoilt_lane][1] = hostile;
      for (int k = 0; k < TypeParam::lanes; ++k)
        if (k == spoilt_lane)
          property::expect_statuses(this->of_lane(spoilt, k), this->of_one(spoilt, k));
        else
          property::expect_same_bits(this->of_lane(spoilt, k), this->of_lane(states, k));
    }
}

// A last link of which nothing but a payload resists: without one its joint is held, in that lane alone.
struct Carrier {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -9.81, 0.0), revolute().mass(4.6).com(0.5, 0, 0).inertia_com(0.2, 0.3, 0.4),
                   revolute().a(0.5).mass(2.3).com(0.4, 0, 0).inertia_com(0.03, 0.03, 0.03), revolute().a(0.4));
};
using Routes = testing::Types<ArticulatedBody, SplitArticulatedBody, CompositeBody>;
template <class Route>
class HeldJoint : public testing::Test {};
TYPED_TEST_SUITE(HeldJoint, Routes);

template <class S, class T>
auto solved(const Joints<Carrier, T>& q, const T& mass) {
  Inputs<S, T> in;
  in.payload.mass = mass, in.payload.com = {T(0.25), T(Zero{}), T(Zero{})};
  return forward_dynamics<S>(q, q, q, in);
}
template <class S>
void expect_held_alone() {
  const Joints<Carrier, double> q[4] = {{0.1, 0.4, -0.2}, {0.2, 0.5, 0.3}, {-0.3, 0.7, 0.1}, {0.6, -0.5, 0.2}};
  const double masses[] = {2.0, 1.0, 0.0, 3.0};
  const auto all = solved<S>(load<4>(q), Batch<double, 4>::of([&](int k) { return masses[k]; }));
  for (int k = 0; k < 4; ++k) {
    const auto one = solved<S>(q[k], masses[k]);
    property::Answers got, wanted;
    got.add("forward dynamics", all, k), wanted.add("forward dynamics", one, 0);
    property::expect_agreement(got, wanted, 1e-9);
    EXPECT_EQ(all.status[k].code, k == 2 ? Status::Code::near_singular : Status::Code::ok);
    EXPECT_EQ(all.status[k].joint, k == 2 ? 2 : -1);
  }
  EXPECT_EQ(all[2][2], 0.0);
  EXPECT_FALSE(all.status.ok());
}
TYPED_TEST(HeldJoint, StaysInItsLane) {
  expect_held_alone<Scene<Carrier, Gravity, Payload, TypeParam>>();
  expect_held_alone<Scene<Carrier, Gravity, Payload, TypeParam, Looped>>();
}

// The entry checks' statuses: what each lane asks.
TEST(BatchChecks, SpeakOfEachLane) {
  using R = robots::Puma560;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Joints<R, double> q[4]{}, qd[4]{}, qdd[4]{};
  q[1][3] = 100.0, qd[2][4] = nan, qdd[3][5] = 1e9;
  const auto asked = check_request<R>(load<4>(q), load<4>(qd), load<4>(qdd));
  const auto placed = check_position<R>(load<4>(q));
  const auto finite = check_finite(load<4>(q), load<4>(qd), load<4>(qdd));
  for (int k = 0; k < 4; ++k) {
    const Status one = check_request<R>(q[k], qd[k], qdd[k]);
    EXPECT_EQ(asked[k].code, one.code) << k;
    EXPECT_EQ(asked[k].joint, one.joint) << k;
    EXPECT_EQ(placed[k].code, k == 1 ? Status::Code::position_limit : Status::Code::ok) << k;
    EXPECT_EQ(finite[k].code, k == 2 ? Status::Code::not_finite : Status::Code::ok) << k;
    EXPECT_EQ(finite[k].joint, k == 2 ? 4 : -1) << k;
  }
}

}  // namespace

// Batches against one state at a time: every kernel, every lane; and what one lane holds reaches no other. A source
// instantiates it for some scenes.
#pragma once

#include <axial/batch.hpp>

#include <property/algorithms/scene_robot.hpp>
#include "batch_lanes.hpp"

namespace property {

using namespace axial;

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
    if constexpr (scene_of<S>::template has<ElasticJoints>) {
      const auto motors = elastic_feedforward<S>(q, qd, x, qd, x, in);
      visit("motors' torques", motors.tau_m);
      visit("motors' positions", motors.theta);
      visit("motors' velocities", motors.thetad);
      visit("efforts of springs", motors.tau_l);
    } else {
      visit_rigid(q, qd, x, in, visit);
    }
  }

 private:
  template <class Q, class In, class Visit>
  static void visit_rigid(const Q& q, const Q& qd, const Q& x, const In& in, const Visit& visit) {
    if constexpr (!scene_of<S>::template has<FloatingBase>) {
      visit("inverse dynamics", inverse_dynamics<S>(q, qd, x, in));
      visit("gravity", gravity_torque<S>(q, in));
      visit("bias", bias_torque<S>(q, qd, in));
      visit("mass matrix", mass_matrix<S>(q, in));
      visit("separation", separate<S>(q, in));
      visit("momenta", momentum_terms<S>(q, qd, in));
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
      states.q[k] = joints<R, T>(random_.vector(R::chain.size, 2.5));
      states.qd[k] = joints<R, T>(random_.vector(R::chain.size, 2.0));
      states.x[k] = joints<R, T>(random_.vector(R::chain.size, 4.0));
    }
    return states;
  }
  static Answers of_lane(const States& states, int lane) {
    Answers answers;
    Kernels<S>::visit(load<C::lanes>(states.q), load<C::lanes>(states.qd), load<C::lanes>(states.x),
                      [&](const char* name, const auto& answer) { answers.add(name, answer, lane); });
    return answers;
  }
  static Answers of_one(const States& states, int k) {
    Answers answers;
    Kernels<S>::visit(states.q[k], states.qd[k], states.x[k],
                      [&](const char* name, const auto& answer) { answers.add(name, answer, 0); });
    return answers;
  }

  oracle::RandomChains random_{2031};
};

TYPED_TEST_SUITE_P(Batches);

TYPED_TEST_P(Batches, EveryLaneIsOneState) {
  for (int round = 0; round < 20; ++round) {
    const auto states = this->random_states();
    for (int k = 0; k < TypeParam::lanes; ++k)
      expect_agreement(this->of_lane(states, k), this->of_one(states, k),
                       sizeof(typename TypeParam::Number) == 4 ? 1e-3 : 1e-10);
  }
}

TYPED_TEST_P(Batches, WhatIsNoNumberStaysInItsLane) {
  using T = typename TypeParam::Number;
  const auto states = this->random_states();
  for (const T hostile : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(), T(1e30)})
    for (const int argument : {0, 1, 2}) {
      auto spoilt = states;
      const int spoilt_lane = argument % TypeParam::lanes;
      (argument == 0 ? spoilt.q : argument == 1 ? spoilt.qd : spoilt.x)[spoilt_lane][1] = hostile;
      for (int k = 0; k < TypeParam::lanes; ++k)
        if (k == spoilt_lane)
          expect_statuses(this->of_lane(spoilt, k), this->of_one(spoilt, k));
        else
          expect_same_bits(this->of_lane(spoilt, k), this->of_lane(states, k));
    }
}
REGISTER_TYPED_TEST_SUITE_P(Batches, EveryLaneIsOneState, WhatIsNoNumberStaysInItsLane);

}  // namespace property

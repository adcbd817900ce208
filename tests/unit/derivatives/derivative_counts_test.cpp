// What derivatives cost: operations of robots and of models without any zero.
#include <gtest/gtest.h>

#include <axial/cost.hpp>
#include <robots/models/models.hpp>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

namespace {

using namespace axial;

template <class R>
constexpr int inverse() {
  return cost<R>(algorithm::inverse_dynamics_derivatives).total();
}
template <class R>
constexpr int forward() {
  return cost<R>(algorithm::forward_dynamics_derivatives).total();
}

struct ElasticPuma {
  static constexpr auto chain = [] {
    auto chain = robots::Puma560::chain;
    for (auto& link : chain.links)
      link.stiffness = 12000.0;
    return chain;
  }();
};

// One of the results alone.
template <class Wanted>
struct Alone {
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const In& in) {
    return inverse_dynamics_derivatives<S, Wanted>(q, qd, qdd, in);
  }
};

}  // namespace

TEST(DerivativeCounts, OfInverseDynamicsWithTorqueAndMassMatrix) {
  EXPECT_EQ(inverse<robots::Scara>(), 47);
  EXPECT_EQ(inverse<robots::Puma560>(), 1590);
  EXPECT_EQ(inverse<robots::Panda>(), 2605);
  EXPECT_EQ(inverse<robots::ModelPuma560>(), 2072);
  EXPECT_EQ(inverse<robots::ModelGeneral6r>(), 3469);
}
TEST(DerivativeCounts, OfForwardDynamics) {
  EXPECT_EQ(forward<robots::Scara>(), 68);
  EXPECT_EQ(forward<robots::Puma560>(), 2594);
  EXPECT_EQ(forward<robots::Panda>(), 4619);
}
TEST(DerivativeCounts, AlongADirectionWithWhatIsDifferentiated) {
  EXPECT_EQ(cost<robots::Scara>(algorithm::inverse_dynamics_along).total(), 57);
  EXPECT_EQ(cost<robots::Puma560>(algorithm::inverse_dynamics_along).total(), 811);
  EXPECT_EQ(cost<robots::Panda>(algorithm::inverse_dynamics_along).total(), 1316);
  EXPECT_EQ(cost<robots::ModelPuma560>(algorithm::inverse_dynamics_along).total(), 1098);
  EXPECT_EQ(cost<robots::ModelGeneral6r>(algorithm::inverse_dynamics_along).total(), 1606);
  EXPECT_EQ(cost<robots::Scara>(algorithm::forward_dynamics_along).total(), 65);
  EXPECT_EQ(cost<robots::Puma560>(algorithm::forward_dynamics_along).total(), 1312);
  EXPECT_EQ(cost<robots::Panda>(algorithm::forward_dynamics_along).total(), 2348);
}
TEST(DerivativeCounts, OfTorqueRatesAndElasticJoints) {
  EXPECT_EQ(cost<robots::Scara>(algorithm::torque_rates).total(), 117);
  EXPECT_EQ(cost<robots::Puma560>(algorithm::torque_rates).total(), 1516);
  EXPECT_EQ(cost<robots::Panda>(algorithm::torque_rates).total(), 2389);
  EXPECT_EQ(cost<robots::ModelGeneral6r>(algorithm::torque_rates).total(), 2796);
  EXPECT_EQ(cost<ElasticPuma>(algorithm::elastic_feedforward).total(), 1534);
  EXPECT_LE(1534, 5 * cost<robots::Puma560>(algorithm::inverse_dynamics).total());
}
TEST(DerivativeCounts, OfTheTorqueRegressor) {
  EXPECT_EQ(cost<robots::Scara>(algorithm::torque_regressor).total(), 48);
  EXPECT_EQ(cost<robots::Puma560>(algorithm::torque_regressor).total(), 878);
  EXPECT_EQ(cost<robots::Panda>(algorithm::torque_regressor).total(), 1461);
}
TEST(DerivativeCounts, WhatIsNotAskedForIsFree) {
  using R = robots::Puma560;
  EXPECT_EQ(cost<R>(Alone<with_efforts>{}).total(), cost<R>(algorithm::inverse_dynamics).total());
  EXPECT_LE(cost<R>(Alone<with_mass_matrix>{}).total(), cost<R>(algorithm::mass_matrix).total());
  EXPECT_LT(cost<R>(Alone<with_velocity_jacobian>{}).total(), inverse<R>() / 2);
}

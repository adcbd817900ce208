// The ranges that are printed: those that the kernels' formats come from, each as tight as its word allows.
#include <gtest/gtest.h>

#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <host_sim/figures/ranges/rows.hpp>
#include <robots/gripper.hpp>
#include <robots/puma560.hpp>

#include <map>
#include <stdexcept>

namespace {

using ranges::Choice;
using ranges::Row;
using Puma = axial::scene_of<robots::Puma560>;
using Parameters = axial::detail::with_rotors<Puma, axial::BaseParameters>;
using Exact = axial::Arithmetic<std::int32_t, true, false>;

std::map<std::pair<int, std::string>, Row> by_place(const std::vector<Row>& rows) {
  std::map<std::pair<int, std::string>, Row> all;
  for (const Row& row : rows)
    all.emplace(std::pair{row.link, row.quantity}, row);
  return all;
}

TEST(Ranges, AreThoseOfTheKernel) {
  constexpr auto& wanted = axial::detail::ranges_of<Puma, Parameters, Exact, axial::recursion::NewtonEuler>;
  const auto found = by_place(ranges::rows("puma560", {}));
  for (int i = 0; i < 6; ++i) {
    const Row& effort = found.at({i, "joint effort"});
    EXPECT_EQ(effort.exponent, wanted.format[i].joint_effort);
    EXPECT_EQ(effort.bound, wanted.range[i].joint_effort.size);
    ASSERT_TRUE(effort.error.has_value());
    EXPECT_EQ(*effort.error, axial::error_bound<Puma>(axial::algorithm::inverse_dynamics)[i]);
    EXPECT_EQ(found.at({i, "angular velocity"}).exponent, wanted.format[i].angular_velocity);
  }
}

// Joints that share a drive are bounded as far as it takes them; what the drives answer stands after the links.
TEST(Ranges, OfSharedDrivesEndWithWhatDrivesAnswer) {
  using R = robots::Gripper;
  constexpr auto effort = axial::error_bound<R>(axial::algorithm::inverse_dynamics);
  constexpr auto inertia = axial::error_bound<R>(axial::algorithm::mass_matrix);
  const auto efforts = by_place(ranges::rows("gripper", {}));
  const auto inertias = by_place(ranges::rows("gripper", {"mass_matrix"}));
  EXPECT_NEAR(efforts.at({0, "angular velocity"}).bound, R::chain.links[0].speed_limit, 0.01);
  EXPECT_NEAR(efforts.at({2, "length"}).bound, 0.01 + R::chain.links[1].position_max, 1e-4)
      << "the follower, from its d";
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(*efforts.at({k, "drive effort"}).error, effort[k]);
    EXPECT_EQ(efforts.at({k, "drive effort"}).exponent, (axial::EffortsOf<R, axial::Fixed32>::exponent(k)));
    EXPECT_EQ(*inertias.at({k, "drive inertia"}).error, inertia[k]);
  }
  EXPECT_THROW(ranges::rows("gripper", {"forward_dynamics"}), std::runtime_error);
}

TEST(Ranges, TheFirstLinkTurnsAsItsJointIsAllowed) {
  const auto& link = robots::Puma560::chain.links[0];
  const auto found = by_place(ranges::rows("puma560", {}));
  EXPECT_DOUBLE_EQ(found.at({0, "angular velocity"}).bound, link.speed_limit);
  EXPECT_EQ(found.at({0, "angular velocity"}).unit, "rad/s");
}

// Motion is kept as fine as its word allows; what is sent on may be kept for a larger sum or for a declared effort, and
// in formats for the declared motion all that efforts can do fits after the halvings that the row names.
TEST(Ranges, FormatsHoldTheirBoundsAndWasteLittle) {
  const auto is_motion = [](const Row& row) {
    return row.unit == "rad/s" || row.unit == "rad/s^2" || row.unit == "m/s^2";
  };
  for (const std::string& algorithm : ranges::algorithms())
    for (int word : {16, 32})
      for (const std::string& robot : ranges::robots(algorithm))
        for (const Row& row : ranges::rows(robot, {algorithm, word, true, false})) {
          SCOPED_TRACE(robot + " " + algorithm + " " + row.quantity + " of link " + std::to_string(row.link));
          const double capacity = std::ldexp(1.0, word - 1);
          EXPECT_LT(row.bound, capacity * row.coarsest_resolution());
          if (is_motion(row)) {
            EXPECT_GT(row.bound, capacity / 16.0 * row.resolution());
          }
        }
}

// Every choice counts: a cheaper one certifies less.
TEST(Ranges, CheaperArithmeticIsLessExact) {
  const auto error = [](const Choice& choice) {
    return *by_place(ranges::rows("puma560", choice)).at({1, "joint effort"}).error;
  };
  const Choice exact{}, down{"inverse_dynamics", 32, false, false}, high{"inverse_dynamics", 32, true, true},
      narrow{"inverse_dynamics", 16, true, false};
  EXPECT_LT(error(exact), error(down));
  EXPECT_LT(error(down), error(high));
  EXPECT_LT(1000.0 * error(high), error(narrow));
}

std::string message(const std::string& robot, const Choice& choice) {
  try {
    ranges::rows(robot, choice);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(Ranges, WhatIsUnknownIsNamed) {
  EXPECT_EQ(message("puma", {}).find("unknown robot 'puma'; there are: scara, scara_rrpr, puma560, panda"), 0U);
  EXPECT_EQ(message("puma560", {"dance"}).find("unknown algorithm 'dance'; there are: inverse_dynamics, "), 0U);
  EXPECT_NE(message("puma560", {"mass_matrix", 24}).find("there are: 16, 32"), std::string::npos);
}

}  // namespace
